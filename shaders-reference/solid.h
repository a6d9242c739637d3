#pragma once
// What is made of a binary shape: extruded (004 formulas 2-7) or revolved (003 formulas 1-13), each basic, extended, bevelled or
// chamfered. Oracle and renderer share the description and nothing else.

#include <limits>

namespace reliefbake {

enum class SolidKind { extrusion, revolution };

/// gap(P) = D(u, v) - e - b min(z, c); the solid is where gap <= 0 within its domain.
///
///   extrusion   P = (u, v, z): z is the depth, 0 at the polygon, 1 at the floor
///   revolution  P = (X, Y, v): X, Y texture widths from the axis, v down the map;  u = axis + |(X, Y)|,  z = v
///
/// D: signed distance to the shape, texture widths. Domain: the box [0, tiles]^2 x [0, 1], or the cylinder of radius 1 - axis and
/// height `tiles` maps. World: extrusion (u, -aspect v, -depth_scale z); revolution (X, Y, -aspect v); z up.
struct ShapeSolid {
    SolidKind kind = SolidKind::extrusion;
    double outward = 0; ///< e: the shape grows by it, texture widths, >= 0 (--e)
    double bevel = 0;   ///< b: how much farther it grows per unit of z, texture widths, 0 to most_bevel (--b)
    double chamfer = std::numeric_limits<double>::infinity(); ///< c: z from which on walls are upright again, >= 0 (--c)
    double axis = 0;          ///< revolution: u of the axis; what lies right of it is turned, 0 <= axis < 1 (--axis)
    double depth_scale = 0.1; ///< extrusion: depth of the whole relief, texture widths, > 0 (--depth-scale)
    int tiles = 1;            ///< repeats: per axis of the plane; along the axis of revolution, z going on over all of them (--tiles)
    bool on_plane = false;    ///< extrusion: on repeated axes the domain has no sides, and there is a floor at z = 1 (--on plane)
};

constexpr double most_bevel = 1e6; ///< more would leave float32 in a shader

} // namespace reliefbake
