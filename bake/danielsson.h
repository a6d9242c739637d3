#pragma once
// P.-E. Danielsson, "Euclidean distance mapping" (1980), 8SED: the method of the papers on extrusion and revolution.

#include "bake/image.h"

#include <cstdint>

namespace reliefbake {

/// Distances, in texels, from texel centres to the centres of texels of 0: each texel takes the nearest of its neighbours' vectors, in
/// two sweeps down and up. Never too small; too large where the nearest texel is none of a neighbour's (statistics of the bake). inf
/// everywhere when no texel is 0. One thread.
Image<float> danielsson_distances(const Image<std::uint8_t>& picture);

} // namespace reliefbake
