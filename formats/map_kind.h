#pragma once
// What kind of map a file holds.

#include "bake/error.h"

#include <cstdint>
#include <filesystem>
#include <string>

namespace reliefbake {

/// "shape", "cone", ...: what a map's file says it is, from its header alone; "" where it says nothing.
/// Errors: no_input, bad_data (undecodable).
Result<std::string> kind_of_map(const std::filesystem::path& path, std::uint64_t max_bytes = 0);

} // namespace reliefbake
