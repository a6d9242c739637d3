#pragma once
// Whether a ray that entered the relief left it again: what tells geometry that was skipped from a hit that lies a little deep
// (001 sec. 4.1 and 5.2 leave such a measure as future work).

#include "shaders-reference/oracle/first_hit.h"

namespace reliefbake {

/// True if the ray is more than `above` above the surface somewhere on [from, to]; 0 <= from, to finite. An open cell is air at any height.
/// Each cell's quadratic is asked at its ends and its vertex, in double precision.
bool comes_out(const BilinearSurface& surface, const ReliefRay& ray, double from, double to, double above);

} // namespace reliefbake
