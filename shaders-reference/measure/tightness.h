#pragma once
// What safety costs: baked cones beside the best that one value per texel can do (MATHS section 2, "Tightness").

#include "bake/relief_map.h"
#include "shaders-reference/oracle/bilinear_surface.h"

namespace reliefbake {

struct TightnessOptions {
    int crop = 64;     ///< side of the square of texels judged, at the map's centre; cost grows with its square
    int steps = 4;     ///< cells are sampled at (steps + 1)^2 points; cost grows with its square
    int headings = 32; ///< directions per point, beside the limiting texel and the gradients, which are exact
    int threads = 0;   ///< 0: all; the result does not depend on it
};

/// Footprint-exact L2 cones of texels [x, x + width) x [y, y + height): the least cone of the bilinear surface over the four
/// cells around each texel centre, capped. Brute force; sampling makes it too wide by a few tenths of a per cent.
Image<double> footprint_cones(const BilinearSurface& surface, int x, int y, int width, int height, double ratio_max,
                              const TightnessOptions& options);

/// Mean over the crop of r / r_footprint, both capped at cone_max (and at 64); an L1 cone t counts as 0.7935 t, its reach averaged over
/// directions. Below 1: safe but narrow; above 1: somewhere too wide. `radius` does not count where the
/// depth is 0. The whole surface limits the crop's cones.
double tightness(const ReliefMap& map, const BilinearSurface& surface, const TightnessOptions& options = {});

} // namespace reliefbake
