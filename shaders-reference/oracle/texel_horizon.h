#pragma once
// How steeply the relief rises before the sky, seen from a texel centre: the answer that horizon maps are judged by.

#include "shaders-reference/oracle/cone_constraint.h"

namespace reliefbake {

/// sup over 0 < s of (H(p + s heading) - H(p)) / s at the centre of texel (i, j), at least 0; height per texture width. Slopes
/// up to `at_least` may come out as 0; then, and on clamped maps, nothing farther than the highest point could hide is asked.
double texel_horizon(const BilinearSurface& surface, int i, int j, const Heading& heading, double at_least);

} // namespace reliefbake
