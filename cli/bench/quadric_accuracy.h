#pragma once
// How far baked quadrics are from the known curvature of a surface.

#include "cli/bench/surfaces.h"
#include "mesh/quadric_bake.h"

namespace reliefbake {

struct CurvatureError {
    double rms = 0, max = 0; ///< of the form's difference (Frobenius norm), over the surface's largest principal curvature
};

/// In the frames of the bake. A fit without c is charged for the c it lacks.
CurvatureError curvature_error(const SurfaceMesh& surface, const QuadricBake& bake);

} // namespace reliefbake
