#pragma once
// The metadata of a freshly baked map.

#include "bake/cone.h"
#include "bake/relief_map.h"
#include "cli/cone/cone_options.h"
#include "cli/cone/stored_height.h"

namespace reliefbake {

/// C: no surface in a cone. R: a step from outside ends with one crossing behind it at most. Others promise nothing.
std::string guarantee_of(const ConeOptions& options);

/// Sum of a row, from left to right: what means are made of, row by row, however a map is baked.
double sum_of_row(const Image<float>& plane, int y);

/// All but what the baked cones tell: their statistics, and the alpha's hash.
ReliefMapInfo describe_surface(const ConePlan& plan, const std::string& source_hash, const DepthMap& depth, const ConeOptions& options);

/// Statistics: depth_min, depth_max, ratio_min, ratio_mean (before encoding), zero_codes; with holes hole_texels, open_cells.
ReliefMapInfo describe_cones(const ConePlan& plan, const BakeSource& source, const DepthMap& depth,
                             const std::vector<ConeMap>& cones, const std::vector<EncodedConeMap>& encoded);

} // namespace reliefbake
