#pragma once
// How much memory this machine, or this process's share of it, has left.

#include <cstdint>

namespace reliefbake {

/// Bytes: what the kernel says can be had without swapping (MemAvailable), cut to what the process's cgroups have left. 4 GB where
/// neither can be told.
std::uint64_t available_memory();

} // namespace reliefbake
