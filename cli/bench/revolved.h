#pragma once
// Surfaces of revolution with exact normals and texture coordinates: what curved relief is judged on.

#include "mesh/mesh.h"

#include <string>
#include <vector>

namespace reliefbake {

struct RevolvedSurface {
    std::string name;
    double (*r)(double v), (*z)(double v);   ///< distance from the axis z, and height, of the profile at v in [0, 1], upwards as seen from outside
    double (*dr)(double v), (*dz)(double v); ///< their derivatives
    double radius;                           ///< least radius of curvature where it bulges, to which depths relate
    double turn = 1;                         ///< share of a whole turn; less: open
    bool profile_closes = false;             ///< v = 0 and v = 1 are one place
};

/// "sphere", "torus" (closed); "cylinder", "torus-open" (three quarters of a ring), "vase".
const std::vector<RevolvedSurface>& revolved_surfaces();

/// A grid of `segments` around the axis and rows whose edges are about as long as those; vertices at seams are doubled, to the last bit at one place.
/// u runs around the axis and v up the profile, both from 0 to 1. `shear` is added to v on the way around, so that frames made from texture coordinates lie across the curvatures; whole, so
/// that a repeated map still meets itself. segments >= 3.
Mesh make_revolved(const RevolvedSurface& surface, int segments, int shear = 0);

} // namespace reliefbake
