#pragma once
// Small binary shapes for tests: 1 inside, 0 outside.

#include "bake/shape_map.h"

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

/// The map of a shape (1 inside).
inline ShapeMap shape_map_of(const TexelGrid& grid, const Image<std::uint8_t>& inside, const ShapeMapOptions& options = {},
                             ShapeModel model = ShapeModel::squares) {
    Image<float> bright(grid.width, grid.height);
    for (std::size_t k = 0; k < bright.size(); ++k) bright[k] = inside[k] ? 0.0f : 1.0f;
    ShapeOptions door;
    door.wrap_x = grid.wrap_x == Wrap::repeat, door.wrap_y = grid.wrap_y == Wrap::repeat;
    door.model = model;
    return *bake_shape_map(*make_shape(std::move(bright), door, "test"), options);
}

} // namespace reliefbake::test
