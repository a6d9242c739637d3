#pragma once
// Guarantee C (MATHS section 2) tested directly, beside any rendering: cones that a shader would decode against
// the oracle's constraints, at random points and at the worst ones known.

#include "bake/relief_map.h"
#include "shaders-reference/oracle/bilinear_surface.h"

#include <cstdint>

namespace reliefbake {

struct ConeCheckOptions {
    int points = 20000;     ///< cost: about 30 us each
    std::uint64_t seed = 1; ///< same seed, same points
    int threads = 0;        ///< 0: all; the result does not depend on it
    /// How far ratio * constraint may exceed 1: 16 roundings of float32, what sampling and decoding in a shader cost.
    double slack = 1e-6;
};

struct ConeCheck {
    std::uint64_t points = 0;     ///< points checked, each with the wider of a bilinear and a nearest fetch
    std::uint64_t violations = 0; ///< points with a cone that holds a point of the surface
    double worst = 0;             ///< greatest ratio * constraint, times the heading's length; above 1: overstepped
    double u = 0, v = 0;          ///< where
    double heading = 0;           ///< direction of the worst, radians from +u towards +v, in the isotropic metric
};

/// Bilinear maps: every cone, read with bilinear and (except `radius`) nearest filtering, against the surface, at texel
/// centres, edges, cell centres, points 1e-6 texels off edges, steepest cells, local minima and random points; towards
/// the limiting texel, its sides, the neighbouring texels, up the gradient, axes, diagonals and at random.
/// Texel maps: texel centres against texel centres, as their definition says.
/// Deterministic in its seed, for every thread count.
ConeCheck check_cones(const ReliefMap& map, const BilinearSurface& surface, const ConeCheckOptions& options = {});

} // namespace reliefbake
