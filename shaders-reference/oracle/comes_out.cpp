#include "shaders-reference/oracle/comes_out.h"

#include "shaders-reference/oracle/cell_walk.h"

#include <algorithm>

namespace reliefbake {
namespace {

struct AirVisitor {
    const BilinearSurface& surface;
    const CellLine& line;
    double h, dh, above, length;
    bool found = false;

    double end() const { return length; }
    bool clears(double, double, double) const { return false; }

    bool visit(const Patch& patch, double x, double y, double t_in, double t_out) {
        const double gap = h + dh * t_in - patch.height(x, y);
        const double b = dh - patch.slope(x, y, line.dx, line.dy), a = -patch.curvature(line.dx, line.dy);
        const double at_vertex = a < 0 ? std::clamp(-0.5 * b / a, 0.0, t_out - t_in) : 0;
        const auto widest = std::max({0.0, at_vertex, t_out - t_in}, [&](double s, double r) { return s * (b + a * s) < r * (b + a * r); });
        found = surface.is_open(patch) || gap + widest * (b + a * widest) > above;
        return found;
    }
};

} // namespace

bool comes_out(const BilinearSurface& surface, const ReliefRay& ray, double from, double to, double above) {
    if (to < from) return false;
    const TexelGrid& grid = surface.grid();
    const CellLine line{surface.to_x(ray.u + from * ray.du), surface.to_y(ray.v + from * ray.dv), ray.du * grid.width, ray.dv * grid.height};
    AirVisitor visitor{surface, line, ray.h + from * ray.dh, ray.dh, above, to - from};
    walk_cells(surface, line, visitor);
    return visitor.found;
}

} // namespace reliefbake
