#pragma once
// What one request may use of the machine.

#include <cstdint>

namespace reliefbake::worker {

/// For the life of the process: no core dumps, and a write over the file-size limit is an error, not a signal.
void limit_process();

/// For one request: `memory` bytes of address space above what the process has now, `cpu_seconds` of processor time above
/// what it has used, `file_bytes` bytes for any file it writes (shared memory counts as one).
void limit_request(std::uint64_t memory, std::uint64_t cpu_seconds, std::uint64_t file_bytes);

} // namespace reliefbake::worker
