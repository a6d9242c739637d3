#pragma once
// A file in memory.

#include "bake/error.h"

#include <filesystem>
#include <string>

namespace reliefbake {

/// Errors: no_input (cannot open, not a regular file), bad_data (more than `most` bytes).
Result<std::string> read_whole_file(const std::filesystem::path& path, std::uint64_t most);

} // namespace reliefbake
