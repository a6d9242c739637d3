#include "shaders-reference/oracle/first_hit.h"

#include "shaders-reference/oracle/cell_walk.h"

#include <cassert>
#include <cmath>

namespace reliefbake {
namespace {

/// Smallest s > 0 with c + b s + a s^2 = 0, for c > 0; +inf when there is none.
///
///     q = -(b + sign(b) sqrt(b^2 - 4ac)) / 2,   roots  c / q  and  q / a
///
/// Both terms of q have one sign, so nothing cancels. For b < 0, q > 0 and c / q is the smaller positive root; for
/// b >= 0, q < 0 and only q / a can be positive, when a < 0.
double first_positive_root(double a, double b, double c) {
    constexpr double none = std::numeric_limits<double>::infinity();
    const double discriminant = b * b - 4 * a * c;
    if (discriminant < 0) return none;
    const double root = std::sqrt(discriminant);
    if (b < 0) return c / (0.5 * (root - b));
    return a < 0 ? -0.5 * (b + root) / a : none;
}

struct HitVisitor {
    const BilinearSurface& surface;
    const CellLine& line;
    double h, dh, lowered_by, t_end;
    std::optional<double> hit;

    double height_at(double t) const { return dh == 0 ? h : h + dh * t; }
    double end() const { return t_end; }

    bool clears(double t_in, double t_out, double highest) const {
        return std::min(height_at(t_in), height_at(t_out)) > highest - lowered_by;
    }

    // Gap between ray and surface on [t_in, t_out], s = t - t_in:  gap + b s + a s^2.
    bool visit(const Patch& patch, double x, double y, double t_in, double t_out) {
        if (surface.is_open(patch)) return false;
        const double gap = height_at(t_in) - (patch.height(x, y) - lowered_by);
        if (gap <= 0) return stop_at(t_in);
        const double b = dh - patch.slope(x, y, line.dx, line.dy);
        const double a = -patch.curvature(line.dx, line.dy);
        const double length = t_out - t_in;
        const double s = first_positive_root(a, b, gap);
        if (s <= length && std::isfinite(s)) return stop_at(t_in + s);
        // Rounding may push the root just past the wall while the ray is below the surface at the wall.
        if (std::isfinite(length) && gap + (b + a * length) * length <= 0) return stop_at(t_out);
        return false;
    }

    bool stop_at(double t) {
        hit = t;
        return true;
    }
};

} // namespace

std::optional<ReliefHit> first_hit(const BilinearSurface& surface, const ReliefRay& ray, double lowered_by, double t_max) {
    assert(ray.dh != 0 || std::isfinite(t_max) || ray.h > surface.highest() - lowered_by);
    double t_end = t_max;
    if (ray.dh > 0) t_end = std::min(t_end, (surface.highest() - lowered_by - ray.h) / ray.dh);
    if (surface.has_holes() && ray.dh < 0) t_end = std::min(t_end, -ray.h / ray.dh);
    if (ray.dh >= 0 && ray.h > surface.highest() - lowered_by) return std::nullopt;

    const TexelGrid& grid = surface.grid();
    const CellLine line{surface.to_x(ray.u), surface.to_y(ray.v), ray.du * grid.width, ray.dv * grid.height};
    HitVisitor visitor{surface, line, ray.h, ray.dh, lowered_by, t_end, std::nullopt};
    walk_cells(surface, line, visitor);
    if (!visitor.hit) return std::nullopt;
    const double t = *visitor.hit;
    return ReliefHit{t, ray.u + t * ray.du, ray.v + t * ray.dv, visitor.height_at(t)};
}

} // namespace reliefbake
