#pragma once
// Distances by trying every texel.

#include "bake/distance_transform.h"

#include <cstdint>

namespace reliefbake::test {

/// The same as distance_transform, from its definition.
Image<float> slow_distances(const Image<std::uint8_t>& picture, const DistanceOptions& options);

} // namespace reliefbake::test
