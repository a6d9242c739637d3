#pragma once
// Piecewise cones (kind cone-pieces) against the surface: check_cones' question for them.

#include "bake/relief_map.h"
#include "shaders-reference/measure/adversarial_points.h"

#include <span>

namespace reliefbake {

/// Radius of a piecewise cone at `share` of the height above its apex, in units of that height (bake/cone.h). As in the shader,
/// radii that codes rounded down below those of lower ends are those.
double piece_radius(std::span<const double> ratios, double share);

/// At a point, along a heading: the greatest radius over the distance to the first point as high, at the ends of all pieces and
/// at one random height in each; read with bilinear and (except `radius`) nearest filtering. Above 1: it holds some surface.
double piece_excess(const ReliefMap& map, const BilinearSurface& surface, const MapPoint& point, const Heading& heading,
                    double heading_length, SplitMix& random);

} // namespace reliefbake
