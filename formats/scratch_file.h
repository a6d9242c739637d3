#pragma once
// Working space on a disk, gone with the process whatever ends it.

#include "bake/error.h"
#include "formats/unique_fd.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

namespace reliefbake {

/// A file without a name in `directory`, to read and write. Errors: cannot_create, write_failed (disk full).
Result<UniqueFd> open_scratch(const std::filesystem::path& directory);

/// The same with room for `bytes` that the disk has promised: writing through a mapping cannot meet a full disk then.
Result<UniqueFd> reserve_scratch(const std::filesystem::path& directory, std::uint64_t bytes);

/// Writes all of `bytes` at `offset`, or reads as many; false with errno, which is 0 where the file ends before.
bool write_at(int fd, std::uint64_t offset, std::span<const std::byte> bytes);
bool read_at(int fd, std::uint64_t offset, std::span<std::byte> bytes);

} // namespace reliefbake
