#pragma once
// Where a ray first meets the relief: the answer every rendering is judged by (MATHS section 9). It never sees a cone.

#include "shaders-reference/oracle/bilinear_surface.h"

#include <limits>
#include <optional>

namespace reliefbake {

/// A ray in texture space: (u, v, h) + t (du, dv, dh).
struct ReliefRay {
    double u, v, h;
    double du, dv, dh;
};

struct ReliefHit {
    double t;
    double u, v, h; ///< on the ray; u, v are unwrapped
};

/// First point, 0 <= t <= t_max, at which the ray is on or below the surface moved down by `lowered_by` (negative: up);
/// t = 0 when it starts there. Each cell's quadratic is solved in the cancellation-free form; intervals are closed.
/// With holes the relief ends at height 0: a ray that comes down to there met nothing, and fell through.
/// t_max must be finite for a level ray over a repeated surface: it may never arrive.
std::optional<ReliefHit> first_hit(const BilinearSurface& surface, const ReliefRay& ray, double lowered_by = 0,
                                   double t_max = std::numeric_limits<double>::infinity());

} // namespace reliefbake
