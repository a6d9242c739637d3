#include "shaders-reference/oracle/cone_constraint.h"

#include "shaders-reference/oracle/cell_walk.h"

#include <cassert>
#include <cmath>

namespace reliefbake {
namespace {

struct ConstraintVisitor {
    const CellLine& line;
    double apex, highest, max_distance;
    Constraint best;

    /// Nothing farther than (highest - apex) / slope can beat the slope found.
    double end() const { return best.slope > 0 ? std::min(max_distance, (highest - apex) / best.slope) : max_distance; }

    bool clears(double s_in, double, double block_highest) const {
        return block_highest - apex <= best.slope * s_in;
    }

    bool visit(const Patch& patch, double x, double y, double s_in, double s_out) {
        const double start = patch.height(x, y) - apex;
        const double slope = patch.slope(x, y, line.dx, line.dy);
        const double c = patch.curvature(line.dx, line.dy);
        const double length = s_out - s_in;
        if (s_in == 0) {
            if (length <= 0) return false; // the point lies on this cell's wall and the line leaves at once
            offer(slope, 0);
            offer(slope + c * length, length);
            return false;
        }
        offer(start / s_in, s_in);
        offer((start + (slope + c * length) * length) / s_out, s_out);
        const double a = start - slope * s_in + c * s_in * s_in;
        if (a < 0 && c < 0) {
            const double s = std::sqrt(a / c);
            if (s > s_in && s < s_out) offer((start + (slope + c * (s - s_in)) * (s - s_in)) / s, s);
        }
        return false;
    }

    void offer(double slope, double distance) {
        if (slope > best.slope) best = {slope, distance};
    }
};

} // namespace

Heading Heading::from_angle(double radians) { return {std::cos(radians), std::sin(radians)}; }

Heading Heading::along(const TexelGrid& grid, double du, double dv) {
    const double y = dv * grid.aspect();
    const double length = std::hypot(du, y);
    assert(length > 0);
    return {du / length, y / length};
}

Constraint cone_constraint(const BilinearSurface& surface, double u, double v, const Heading& heading, double max_distance,
                           double at_least) {
    const TexelGrid& grid = surface.grid();
    const CellLine line{surface.to_x(u), surface.to_y(v), heading.x / grid.pitch_x(), heading.y / grid.pitch_y()};
    ConstraintVisitor visitor{line, surface.height(u, v), surface.highest(), max_distance, {at_least, 0}};
    walk_cells(surface, line, visitor);
    return visitor.best.slope > at_least ? visitor.best : Constraint{};
}

} // namespace reliefbake
