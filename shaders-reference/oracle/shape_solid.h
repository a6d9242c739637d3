#pragma once
// Where a ray first meets the exact solid of a binary shape (solid.h), and the normals there: in double precision, from the pixel
// squares alone.

#include "shaders-reference/oracle/pixel_shape.h"
#include "shaders-reference/solid.h"

#include <array>
#include <optional>

namespace reliefbake {

using Point3 = std::array<double, 3>;

struct SolidRay {
    Point3 origin, direction; ///< P = origin + t direction, 0 <= t
};

/// Parameter at which a ray that starts within the domain leaves it. >= 0; +inf for a ray that never leaves.
double domain_exit(const TexelGrid& grid, const ShapeSolid& solid, const SolidRay& ray);

double solid_gap(const PixelShape& shape, const ShapeSolid& solid, const Point3& point);

/// The unit normal of the level set of `gap` through a point, in the world, from the nearest point of the shape's outline; z
/// where that is undefined (on an edge between two squares, in an empty or full shape). On the axis x stands for all directions.
Point3 solid_normal(const PixelShape& shape, const ShapeSolid& solid, const Point3& point);

/// First 0 <= t <= t_max with gap(P(t)) + lowered_by <= 0 (lowered_by < 0: of a larger solid). Steps that cannot pass the
/// surface, then halving; a stretch of the ray inside the solid shorter than `chord_tolerance` texels may be overlooked, and no other.
std::optional<double> first_solid_hit(const PixelShape& shape, const ShapeSolid& solid, const SolidRay& ray, double lowered_by, double t_max);

constexpr double chord_tolerance = 1e-3;

} // namespace reliefbake
