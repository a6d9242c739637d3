#pragma once
// The metadata of a freshly baked map.

#include "bake/cone.h"
#include "bake/relief_map.h"
#include "cli/cone/cone_options.h"
#include "cli/cone/stored_height.h"

namespace reliefbake {

/// Statistics: depth_min, depth_max, ratio_min, ratio_mean (before encoding), zero_codes; with holes hole_texels, open_cells.
ReliefMapInfo describe_cones(const ConePlan& plan, const BakeSource& source, const DepthMap& depth,
                             const std::vector<ConeMap>& cones, const std::vector<EncodedConeMap>& encoded);

} // namespace reliefbake
