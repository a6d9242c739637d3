#pragma once
// Slow truth for guarantee R: what a stretch of a ray does to the bilinear surface, counted patch by patch from the texels alone.

#include "bake/height_field.h"

namespace reliefbake::test {

/// A ray that goes down one unit of height for each unit of t: (u, v, h) + t (du, dv, -1).
struct DescendingRay {
    double u, v, h;
    double du, dv;
};

struct Stretch {
    int crossings = 0;  ///< times that the ray goes from above the surface to below it, or back
    double deepest = 0; ///< how far below the surface it comes, at most; height
};

/// The ray on [from, to], above the surface at `from`. Along a line a bilinear patch is a quadratic, so that three values fix
/// it; between its ends and its vertex the gap is monotone, and signs there count every crossing. Grazing to 1e-9 is none.
Stretch follow(const DepthMap& depth, const DescendingRay& ray, double from, double to);

/// Height of the surface at (u, v).
double surface_height(const DepthMap& depth, double u, double v);

} // namespace reliefbake::test
