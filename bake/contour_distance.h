#pragma once
// Exact distances from texel centres to an anti-aliased shape.

#include "bake/image.h"
#include "bake/texel_grid.h"

namespace reliefbake {

/// Distances, in texels, to the union of the squares of texels with coverage 1 and the cut squares (cut_square) of those with less; 0
/// in it, inf everywhere when all coverage is 0. Every texel that can hold the nearest point is looked at, unlike in Gustavson &
/// Strand's propagation, which keeps a wrong one here and there. Time for a texel grows with its distance.
Image<float> contour_distances(const Image<float>& coverage, const TexelGrid& grid, int threads);

} // namespace reliefbake
