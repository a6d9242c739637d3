#pragma once
// Small depth maps for tests, made from a formula or from noise.

#include "bake/height_field.h"

#include <cstdint>
#include <functional>
#include <random>

namespace reliefbake::test {

/// Stores height(i, j) as float32 depth.
inline DepthMap depth_of(const TexelGrid& grid, const std::function<double(int, int)>& height) {
    DepthMap map{grid, BitDepth::float32, Image<float>(grid.width, grid.height)};
    for (int j = 0; j < grid.height; ++j)
        for (int i = 0; i < grid.width; ++i) map.level(i, j) = float(1 - height(i, j));
    return map;
}

/// Independent uniform heights, rounded to 8-bit codes.
inline DepthMap noise(const TexelGrid& grid, std::uint32_t seed) {
    std::mt19937 random(seed);
    DepthMap map{grid, BitDepth::unorm8, Image<float>(grid.width, grid.height)};
    for (float& level : map.level) level = float(random() % 256);
    return map;
}

/// Uniform in [low, high), the same on every platform.
inline double uniform(std::mt19937& random, double low, double high) { return low + (high - low) * random() / 4294967296.0; }

} // namespace reliefbake::test
