#pragma once
// The depth plane of a map, as the oracle takes it.

#include "bake/height_field.h"
#include "bake/relief_map.h"

namespace reliefbake {

/// The levels that a map's depth channel stores; exact for every bit depth.
DepthMap stored_depth(const ReliefMap& map);

} // namespace reliefbake
