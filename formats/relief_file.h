#pragma once
// Depth and normals for a map that holds cones alone, out of a second file.

#include "formats/map_file.h"

#include <filesystem>

namespace reliefbake {

/// Fills depth and normals of a map that lacks them from hints.relief, a map of kind cone; does nothing to a map that holds
/// its own. The relief must be the one the cones were baked for: same size, wrap, pixel aspect, bits and source pixels, or
/// the cones would guarantee nothing about it. `path` is the map, for messages.
/// Errors: usage (hints.relief missing, or given to a map that needs none); bad_data (it does not fit); those of read_map.
Result<void> take_relief(ReliefMap& map, const std::filesystem::path& path, const MapHints& hints);

} // namespace reliefbake
