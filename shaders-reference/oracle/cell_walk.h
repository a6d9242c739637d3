#pragma once
// The walk that the oracle's questions share: the cells under a straight line, in order, with empty blocks skipped by
// the max pyramid.

#include "shaders-reference/oracle/bilinear_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace reliefbake {

/// A line over the plane in texel units: (x, y) + t (dx, dy).
struct CellLine {
    double x, y, dx, dy;
};

/// Parameter at which a line leaves [low, high] on one axis; +inf when it never does.
inline double exit_parameter(double start, double direction, std::int64_t low, std::int64_t high) {
    if (direction == 0) return std::numeric_limits<double>::infinity();
    return (double(direction > 0 ? high : low) - start) / direction;
}

/// Asks the visitor about the cells under the line from t = 0 to visitor.end(), in order:
///   double end()                                   where to stop; may shrink on the way
///   bool   clears(t_in, t_out, highest)            true if a block this high cannot matter on [t_in, t_out]
///   bool   visit(patch, x_in, y_in, t_in, t_out)   a cell, entered at local (x_in, y_in); true stops the walk
/// Consecutive intervals share their end *value* and cells are counted, never recomputed from a rounded position, so
/// their closed union is [0, end]: nothing on an edge or a corner is lost.
template <class Visitor>
void walk_cells(const BilinearSurface& surface, const CellLine& line, Visitor&& visitor) {
    const int top = surface.levels() - 1;
    std::int64_t i = std::int64_t(std::floor(line.x));
    std::int64_t j = std::int64_t(std::floor(line.y));
    double t = 0;
    int level = top;
    while (t <= visitor.end()) {
        const CellBlock block = surface.block(i, j, level);
        const double exit_x = exit_parameter(line.x, line.dx, block.x_low, block.x_high);
        const double exit_y = exit_parameter(line.y, line.dy, block.y_low, block.y_high);
        const double t_exit = std::max(t, std::min(exit_x, exit_y));
        const double t_out = std::min(t_exit, visitor.end());
        if (!visitor.clears(t, t_out, block.highest)) {
            if (level > 0) {
                --level;
                continue;
            }
            const double x_in = line.x + (t > 0 ? t * line.dx : 0) - double(i);
            const double y_in = line.y + (t > 0 ? t * line.dy : 0) - double(j);
            if (visitor.visit(surface.patch(i, j), x_in, y_in, t, t_out)) return;
        }
        if (t_exit >= visitor.end()) return;

        // Step over the nearer wall; on the other axis stay within the block.
        if (exit_x <= exit_y) {
            i = line.dx > 0 ? block.x_high : block.x_low - 1;
            j = std::clamp(std::int64_t(std::floor(line.y + t_exit * line.dy)), block.y_low, block.y_high - 1);
        } else {
            j = line.dy > 0 ? block.y_high : block.y_low - 1;
            i = std::clamp(std::int64_t(std::floor(line.x + t_exit * line.dx)), block.x_low, block.x_high - 1);
        }
        t = t_exit;
        level = std::min(level + 1, top);
    }
}

} // namespace reliefbake
