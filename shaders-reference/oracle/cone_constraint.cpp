#include "shaders-reference/oracle/cone_constraint.h"

#include "shaders-reference/oracle/cell_walk.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace reliefbake {
namespace {

/// Closer than this, in texels, only the point's own cell is asked: a position of thousands of texels is known to 1e-12,
/// which divided by a smaller distance would pass for a slope. Beyond a nearer wall the quotient is taken from here on.
constexpr double nearest_wall = 1e-5;

struct ConstraintVisitor {
    const CellLine& line;
    double apex, highest, max_distance, nearest;
    ConstraintRule rule;
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
        if (rule.exits_only) {
            visit_exits(start, slope, c, s_in, s_out);
            return false;
        }
        if (s_in == 0 && rule.lift == 0) {
            if (length <= 0) return false; // the point lies on this cell's wall and the line leaves at once
            offer(slope, 0);
            offer(slope + c * length, length);
            return false;
        }
        const double s_near = std::max(s_in, nearest);
        if (s_near >= s_out) return false;
        const auto offer_at = [&](double s) {
            const double beyond = s - s_in;
            offer((start + (slope + c * beyond) * beyond) / s, s);
        };
        offer_at(s_near);
        offer_at(s_out);
        const double a = start - slope * s_in + c * s_in * s_in;
        if (a < 0 && c < 0) {
            const double s = std::sqrt(a / c);
            if (s > s_near && s < s_out) offer_at(s);
        }
        return false;
    }

    /// H - apex = start + slope b + c b^2 at b = s - s_in. On a falling stretch the quotient only falls, so its start decides.
    void visit_exits(double start, double slope, double c, double s_in, double s_out) {
        const auto rise = [&](double s) { return start + (slope + c * (s - s_in)) * (s - s_in); };
        const auto fall = [&](double s) { return -(slope + 2 * c * (s - s_in)); };
        if (rule.from_top) {
            constexpr int samples = 16;
            for (int k = 0; k < samples; ++k) {
                const double s = std::max(s_in + (s_out - s_in) * k / samples, nearest);
                if (s < s_out && fall(s) > (1 - apex - rise(s)) / s) offer(rise(s) / s, s);
            }
            return;
        }
        double s = s_in;
        if (!(fall(s) > rule.least_fall)) {
            if (c >= 0) return;
            s = s_in - (rule.least_fall + slope) / (2 * c);
        }
        s = std::max(s, nearest);
        if (s < s_out) offer(rise(s) / s, s);
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
                           double at_least, const ConstraintRule& rule) {
    const TexelGrid& grid = surface.grid();
    const CellLine line{surface.to_x(u), surface.to_y(v), heading.x / grid.pitch_x(), heading.y / grid.pitch_y()};
    ConstraintVisitor visitor{line, surface.height(u, v) + rule.lift, surface.highest(), max_distance,
                              nearest_wall * std::min(grid.pitch_x(), grid.pitch_y()), rule, {at_least, 0}};
    walk_cells(surface, line, visitor);
    return visitor.best.slope > at_least ? visitor.best : Constraint{};
}

} // namespace reliefbake
