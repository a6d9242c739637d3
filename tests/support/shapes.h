#pragma once
// Small binary shapes for tests: 1 inside, 0 outside.

#include "bake/image.h"
#include "bake/texel_grid.h"

#include <cstdint>
#include <functional>
#include <random>

namespace reliefbake::test {

inline Image<std::uint8_t> shape_of(const TexelGrid& grid, const std::function<bool(int, int)>& inside) {
    Image<std::uint8_t> shape(grid.width, grid.height);
    for (int j = 0; j < grid.height; ++j)
        for (int i = 0; i < grid.width; ++i) shape(i, j) = inside(i, j);
    return shape;
}

/// Each square inside with the given probability, in 256ths.
inline Image<std::uint8_t> random_shape(const TexelGrid& grid, std::uint32_t seed, unsigned share) {
    std::mt19937 random(seed);
    return shape_of(grid, [&](int, int) { return random() % 256 < share; });
}

} // namespace reliefbake::test
