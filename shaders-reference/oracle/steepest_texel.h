#pragma once
// The texel centre that limits a cone most: where to look when a cone is to be proven wrong.

#include "bake/cone.h"
#include "shaders-reference/oracle/bilinear_surface.h"

namespace reliefbake {

struct SteepestTexel {
    double slope = 0;       ///< height per texture width in `metric`; 0: nothing steeper than `at_least` was found
    double du = 0, dv = 0;  ///< from the point to the texel centre, unwrapped
};

/// Texel centre q with the greatest (H(q) - H(p)) / |q - p|, among those above `at_least` > 0 and no farther than
/// `tiles` repeats of the map; p = (u, v), itself no such q (within 1e-5 texels). Best-first descent of the max pyramid.
SteepestTexel steepest_texel(const BilinearSurface& surface, double u, double v, Metric metric, double at_least, int tiles = 1);

} // namespace reliefbake
