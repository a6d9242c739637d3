#pragma once
// CGAL's estimate of curvature, beside ours. Only in builds that chose it: its licence is the GPL, version 3 or later (README.md).

#include "mesh/surface_fit.h"

namespace reliefbake {

/// Whether this build holds it (CMake: RELIEFBAKE_CGAL).
bool has_jet_fit();

/// Monge forms of jets of degree 2 (Cazals & Pouget 2005) over each position's ring, over two rings where one has less than five
/// neighbours. Positions that have no normal or too few neighbours even so keep the form of `rings`, as do flags. The build must hold it.
SurfaceFit fit_jets(const WeldedSurface& surface, const SurfaceFit& rings, int threads);

} // namespace reliefbake
