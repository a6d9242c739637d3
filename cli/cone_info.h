#pragma once
// The metadata of a freshly baked map.

#include "bake/cone.h"
#include "bake/relief_map.h"
#include "cli/cone_options.h"
#include "formats/read_image.h"

namespace reliefbake {

/// Statistics: depth_min, depth_max, ratio_min, ratio_mean (before encoding), zero_codes.
ReliefMapInfo describe_cones(const ConePlan& plan, const SourceImage& source, const DepthMap& depth,
                             const std::vector<ConeMap>& cones, const std::vector<EncodedConeMap>& encoded);

} // namespace reliefbake
