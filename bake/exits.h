#pragma once
// Where a ray can leave the relief again: the cells that fall along a wedge (MATHS section 3; docs/FAMILIES.md).

#include "bake/exit_kernels.h"
#include "bake/search_surface.h"

namespace reliefbake {

/// For `count` cells between two rows of texels: the distance, in texels, from which a point of the cell counts as an exit
/// for cones whose wedge is (dx, dy >= 0); infinity where the cell does not fall that way. Without ExitRule::from_top that
/// distance is 0. A cell of a bilinear surface can fall along some direction of the quadrant only if one of its edges does.
void exit_falls(const SearchSurface& surface, const ExitKernels& kernels, const float* row0, const float* row1, int count, float* out);

/// The texels that the far search must look at.
struct ExitTexels {
    Image<float> height; ///< those that no exit touches are as low as the map's lowest texel
    Image<float> from;   ///< distance from which each counts; empty without ExitRule::from_top
};
ExitTexels exit_texels(const SearchSurface& surface, int threads);

} // namespace reliefbake
