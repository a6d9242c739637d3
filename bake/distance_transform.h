#pragma once
// Exact Euclidean distances from texel centres to a set of texels.
// Column distances, then the lower envelope of each row, as Meijster, Roerdink, Hesselink, "A general algorithm for computing distance
// transforms in linear time" (2000), have it; the envelope is found by halving spans (distance_kernels), which vectors can do.

#include "bake/image.h"

#include <cstdint>

namespace reliefbake {

/// What a texel of the set is.
enum class DistanceTo {
    centres, ///< its centre: distance sqrt(dx^2 + dy^2)
    squares, ///< its square: distance sqrt(p^2 + q^2), p = max(0, |dx| - 1/2), q = max(0, |dy| - 1/2)
};

struct DistanceOptions {
    DistanceTo to = DistanceTo::centres;
    std::uint8_t set = 0;                ///< texels of this value are the set (outside it only 0 and 1 may occur)
    bool wrap_x = false, wrap_y = false; ///< toroidal: the nearest of all copies of the picture
    int threads = 0;                     ///< 0: as many as the process may use; the result does not depend on it
};

/// Distances in texels, each the exact one correctly rounded to float; inf everywhere when the set is empty.
/// `picture` holds 0 and 1; sides up to 65536. `out` has its size. Memory beside them: a 16th to a 4th of the picture's texels, in
/// bytes, and 0.4 MB a thread for 8192 columns.
void distance_transform(const Image<std::uint8_t>& picture, const DistanceOptions& options, Image<float>& out);
Image<float> distance_transform(const Image<std::uint8_t>& picture, const DistanceOptions& options = {});

} // namespace reliefbake
