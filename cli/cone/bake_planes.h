#pragma once
// The planes of cones that a plan asks for: one, or one per sector, level or piece.

#include "bake/cone.h"
#include "cli/cone/cone_options.h"

#include <vector>

namespace reliefbake {

/// Bakes them for `depth`, of any level of a mip chain. `shared`: pyramids of this depth, or null.
std::vector<ConeMap> bake_planes(const ConePlan& plan, const DepthMap& depth, ConeStatistics* statistics, SharedPyramids* shared);

} // namespace reliefbake
