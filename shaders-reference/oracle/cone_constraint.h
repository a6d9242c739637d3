#pragma once
// The tool that proves a cone wrong: the steepest straight line from a surface point up to the surface, along one
// horizontal direction.

#include "shaders-reference/oracle/bilinear_surface.h"

namespace reliefbake {

/// A horizontal direction in the isotropic metric of MATHS section 1: (x, y) has length 1, (du, dv) = (x, y / R).
struct Heading {
    double x, y;

    static Heading from_angle(double radians);
    /// Towards (u, v) + (du, dv); the two must not both be 0.
    static Heading along(const TexelGrid& grid, double du, double dv);
};

struct Constraint {
    double slope = 0;    ///< height per texture width; 0 when nothing on the line is higher
    double distance = 0; ///< where it is attained, texture widths; 0: the limit towards the point (a gradient)
};

/// Which points of the surface limit a cone, and where it stands.
struct ConstraintRule {
    double lift = 0;         ///< height of the apex above the surface
    bool exits_only = false; ///< only points from which the surface falls, going on along the heading (relaxed cones)
    double least_fall = 0;   ///< only falls steeper than this, height per texture width
    bool from_top = false;   ///< only falls steeper than the ray to them from height 1 on the cone's axis (sampled, not exact)
};

/// sup over 0 < s <= max_distance of (H(p + s heading) - H(p) - lift) / s, and at least 0; p = (u, v). A conservative cone at p has
/// ratio <= 1 / slope. Exact per crossed cell:
///
///     (a + b s + c s^2) / s  on [s0, s1]  is greatest at s0, at s1, or, for a < 0 and c < 0, at sqrt(a/c)
///
/// Where the point lies within 1e-5 texels of a wall, the cells beyond count from that distance on. max_distance is finite
/// on a repeated surface: nothing else ends a line that never rises.
/// `at_least` is a slope already known: only steeper ones are sought (much faster), and slope 0 is the answer if none is.
Constraint cone_constraint(const BilinearSurface& surface, double u, double v, const Heading& heading, double max_distance,
                           double at_least = 0, const ConstraintRule& rule = {});

} // namespace reliefbake
