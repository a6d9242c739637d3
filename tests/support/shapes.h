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

/// How much of each texel is inside: none and all of the most, and everything between.
inline Image<float> random_coverage(const TexelGrid& grid, std::uint32_t seed, unsigned share) {
    std::mt19937 random(seed);
    Image<float> coverage(grid.width, grid.height, 0);
    for (float& c : coverage)
        if (random() % 256 < share) c = random() % 2 ? 1.0f : float(random() % 256) / 255;
    return coverage;
}

/// The map of an anti-aliased shape.
inline ShapeMap contour_map_of(const TexelGrid& grid, Image<float> coverage, const ShapeMapOptions& options = {}) {
    ShapeOptions door;
    door.bright_is_inside = true;
    door.wrap_x = grid.wrap_x == Wrap::repeat, door.wrap_y = grid.wrap_y == Wrap::repeat;
    door.model = ShapeModel::contour;
    return *bake_shape_map(*make_shape(std::move(coverage), door, "test"), options);
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
