#pragma once
// The exact solids of a binary shape: extruded (004 formulas 2-7) or revolved (003 formulas 1-13), each basic, extended,
// bevelled or chamfered, and where a ray first meets them. In double precision, from the pixel squares alone.
//
//     gap(P) = D(s, v) - e - b min(z, c),   the solid is where gap <= 0 within its domain
//
//   extrusion   P = (u, v, z): z is the depth, 0 at the polygon, 1 at the floor;   (s, v) = (u, v)
//   revolution  P = (X, Y, v): X, Y texture widths from the axis, v down the map;  (s, v) = (axis + |(X, Y)|, v),  z = v
//
// D: signed distance to the shape, texture widths. Lengths of P: (du, aspect dv) in the plane; (dX, dY, aspect dv) around an axis.
// World: extrusion (u, -aspect v, -depth_scale z); revolution (X, Y, -aspect v); z up.

#include "shaders-reference/oracle/pixel_shape.h"

#include <array>
#include <limits>
#include <optional>

namespace reliefbake {

using Point3 = std::array<double, 3>;

enum class SolidKind { extrusion, revolution };

struct ShapeSolid {
    SolidKind kind = SolidKind::extrusion;
    double outward = 0; ///< e: the shape grows by it, texture widths, >= 0 (--e)
    double bevel = 0;   ///< b: how much farther it grows per unit of depth, texture widths, >= 0 (--b)
    double chamfer = std::numeric_limits<double>::infinity(); ///< c: depth below which walls are upright again, >= 0 (--c)
    double axis = 0;        ///< revolution: u of the axis; what lies right of it is turned, 0 <= axis < 1 (--axis)
    double depth_scale = 0.1; ///< extrusion: depth of the whole relief, texture widths, > 0 (--depth-scale)
    int tiles = 1;      ///< repeats: per axis of the plane; along the axis of revolution. z goes on over all of them. (--tiles)
    bool endless = false; ///< extrusion on a repeated plane: the domain has no sides
};

struct SolidRay {
    Point3 origin, direction; ///< P = origin + t direction, 0 <= t
};

/// Parameter at which a ray that starts within the domain leaves it: [0, tiles]^2 x [0, 1], or the cylinder of radius
/// 1 - axis and height `tiles` maps. >= 0; +inf for a ray that never leaves.
double domain_exit(const ShapeSolid& solid, const SolidRay& ray);

double solid_gap(const PixelShape& shape, const ShapeSolid& solid, const Point3& point);

/// The unit normal of the level set of `gap` through a point, in the world, from the nearest point of the shape's outline; z
/// where that is undefined (on an edge between two squares, in an empty or full shape). On the axis x stands for all directions.
Point3 solid_normal(const PixelShape& shape, const ShapeSolid& solid, const Point3& point);

/// First 0 <= t <= t_max with gap(P(t)) + lowered_by <= 0 (lowered_by < 0: of a larger solid). Steps that cannot pass the
/// surface, then halving; a stretch of the ray inside the solid shorter than `chord_tolerance` texels may be overlooked, and no other.
std::optional<double> first_solid_hit(const PixelShape& shape, const ShapeSolid& solid, const SolidRay& ray, double lowered_by, double t_max);

constexpr double chord_tolerance = 1e-3;

} // namespace reliefbake
