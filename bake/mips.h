#pragma once
// Mip chains of the stored surface (MATHS section 8): every level has heights of its own, and cones of its own.

#include "bake/cone.h"
#include "bake/height_field.h"

#include <vector>

namespace reliefbake {

/// Level 0 is `depth`; each further one is the box average of the one before, floor(n / 2) texels along an axis of n but at
/// least 1, down to 1 x 1. Averages are taken of unrounded averages and then rounded to codes of depth.bits, so no error
/// adds up. With holes they are averages of what is solid; a texel is a hole where less than half of it is. The pixel aspect of each level keeps the map's proportions, and may leave what bake_cones accepts.
std::vector<DepthMap> bake_depth_mips(const DepthMap& depth);

/// bake_cones for a level of any pixel aspect; same guarantee. Beyond 0.5 to 2 the cones get narrower than they need be.
/// Not for sectors: their bounds are angles, which another aspect would turn.
ConeMap bake_level_cones(const DepthMap& depth, const ConeOptions& options, ConeStatistics* statistics = nullptr,
                         SharedPyramids* shared = nullptr);

} // namespace reliefbake
