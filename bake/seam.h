#pragma once
// Does a map tile? The step across the border against the steps inside.

#include "bake/image.h"
#include "bake/texel_grid.h"

namespace reliefbake {

/// Steps along one axis, as multiples of the mean step between neighbouring columns (rows); 0 on an axis
/// without any.
struct Seam {
    double border = 0;   ///< from the last column (row) to the first
    double steepest = 0; ///< the largest between two neighbouring ones inside
};

struct Seams {
    Seam x, y;
};

/// A step between two columns (rows) is the mean |difference| of their texels.
Seams measure_seams(const Image<float>& plane);

/// Repeat where the border is no steeper than 3 mean steps, or than some place inside (a tile's edge may run
/// along the border); else clamp. Of 20 real maps whose kind is known, those that tile have borders up to 2.4
/// mean steps (hand-made 8-bit stone walls), those that do not from 4.9, each steeper than all inside.
Wrap wrap_for_seam(const Seam& seam);

} // namespace reliefbake
