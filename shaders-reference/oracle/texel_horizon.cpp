#include "shaders-reference/oracle/texel_horizon.h"

namespace reliefbake {

double texel_horizon(const BilinearSurface& surface, int i, int j, const Heading& heading, double max_distance) {
    // A texel centre, rounded, may lie in the cell behind it, whose slope is not that of the walk: stand a billionth of a
    // texel ahead.
    const TexelGrid& grid = surface.grid();
    const double ahead = 1e-9 * grid.pitch_x();
    const double u = TexelGrid::centre(i, grid.width) + ahead * heading.x;
    const double v = TexelGrid::centre(j, grid.height) + ahead * heading.y / grid.aspect();
    return cone_constraint(surface, u, v, heading, max_distance).slope;
}

} // namespace reliefbake
