#pragma once
// How steeply the relief rises before the sky, seen from a texel centre: the answer that horizon maps are judged by.

#include "shaders-reference/oracle/cone_constraint.h"

namespace reliefbake {

/// sup over 0 < s <= max_distance of (H(p + s heading) - H(p)) / s at the centre of texel (i, j), at least 0; height per texture
/// width. max_distance, texture widths, is finite: nothing else ends a line that never rises.
double texel_horizon(const BilinearSurface& surface, int i, int j, const Heading& heading, double max_distance);

} // namespace reliefbake
