#pragma once
// The two-term fit of the published methods, kept beside ours.

#include "mesh/surface_fit.h"

namespace reliefbake {

/// z = a x² + b y² over the ring in each vertex's own frame (normals, tangents of `mesh`; `source` as in QuadricBake):
/// formula (6) of Ouazzani Chahdi et al., which fits no xy and trusts the normal. Rings that cannot carry both terms
/// (x² proportional to y² everywhere) give the shortest solution. c is 0.
std::vector<Quadric> fit_as_printed(const Mesh& mesh, const std::vector<std::uint32_t>& source, const WeldedSurface& surface, int threads);

} // namespace reliefbake
