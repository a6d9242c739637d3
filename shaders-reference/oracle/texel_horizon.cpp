#include "shaders-reference/oracle/texel_horizon.h"

#include <cassert>

namespace reliefbake {

double texel_horizon(const BilinearSurface& surface, int i, int j, const Heading& heading, double at_least) {
    assert(at_least > 0);
    const TexelGrid& grid = surface.grid();
    // A texel centre, rounded, may lie in the cell behind it, whose slope is not that of the walk: stand a billionth of a
    // texel ahead.
    const double ahead = 1e-9 * grid.pitch_x();
    const double u = TexelGrid::centre(i, grid.width) + ahead * heading.x;
    const double v = TexelGrid::centre(j, grid.height) + ahead * heading.y / grid.aspect();
    const double rise = surface.highest() - surface.height(u, v);
    if (rise <= 0) return 0;
    return cone_constraint(surface, u, v, heading, rise / at_least, at_least).slope;
}

} // namespace reliefbake
