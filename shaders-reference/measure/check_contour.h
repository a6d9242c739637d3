#pragma once
// Guarantee S of a shape map of model contour, point by point.

#include "shaders-reference/measure/compare_solid.h"
#include "shaders-reference/oracle/contour_shape.h"

namespace reliefbake {

/// The shape that a map of model contour stores: its shape channel is 1 - coverage.
ContourShape stored_contour(const ShapeMap& map);

/// As check_distances: texel centres, middles of edges, corners; points close to the contour; anywhere. Deterministic in its seed.
DistanceCheck check_contour(const ShapeMap& map, const ContourShape& shape, int points, std::uint64_t seed, int threads = 0);

} // namespace reliefbake
