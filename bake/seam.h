#pragma once
// Does a map tile? The step across the border against the steps inside.

#include "bake/image.h"
#include "bake/texel_grid.h"

namespace reliefbake {

/// Mean |first - last| column (row) over the mean difference of neighbours along that axis. About 1 where a
/// map tiles; 0 on an axis without any step.
struct Seams {
    double x = 0, y = 0;
};

Seams measure_seams(const Image<float>& plane);

/// Repeat below this seam, clamp from it on. Of 20 real maps whose kind is known, those that tile have seams
/// up to 2.4 (hand-made 8-bit stone walls), those that do not from 4.9 (docs/TERMINOLOGY.md, seam).
inline constexpr double seam_threshold = 3;

inline Wrap wrap_for_seam(double seam) { return seam < seam_threshold ? Wrap::repeat : Wrap::clamp; }

} // namespace reliefbake
