#pragma once
// One tile of texels against one node or texel, in SIMD lanes: the inner loops of the cone search.

#include "bake/max_pyramid.h"

#include <cstdint>

namespace reliefbake {

constexpr int tile_size = 8;
constexpr int tile_texels = tile_size * tile_size;
constexpr int strip_rows = 4; ///< rows of a strip: what a first, cheap test takes together, column by column
constexpr int tile_strips = tile_size / strip_rows;

/// The metric, periods and limits of a search. Distances in texels; y is scaled by the pixel aspect.
struct SearchSpace {
    float aspect;
    float period_x, period_y; ///< texels until the map repeats; +inf when clamped
    float deflation;          ///< of squared distances
    float near_distance_sq;   ///< no far pair is closer
    float tolerance_factor;   ///< 1 + tolerance
    bool l1;
};

/// The state of one tile. `need` is the slope that a far texel must exceed to matter, `found` the largest that did.
struct alignas(32) Tile {
    float x[tile_size], y[tile_size];
    float height[tile_texels], need[tile_texels], found[tile_texels];
    float strip_lowest[tile_strips * tile_size], strip_need[tile_strips * tile_size]; ///< least of each strip's columns
    float centre_x, centre_y, half_x, half_y, lowest;
};

/// The kernels for the widest instruction set in use (bake/simd.h). Same bits for all of them.
struct TileKernels {
    /// Whether any texel of the tile may need the node. `shrink`: least ratio of deflated to plain distance between them.
    bool (*tile_needs)(const SearchSpace&, const Tile&, const PyramidNode&, float shrink);
    /// Compares one texel with the whole tile and keeps what it asks for. Returns whether anything was raised.
    bool (*compare_texel)(const SearchSpace&, Tile&, float x, float y, float height);
    /// Texels of a row of a leaf that may exceed the tile's least need, as bits; `threshold` is that need squared.
    std::uint32_t (*leaf_candidates)(const SearchSpace&, const Tile&, const float* heights, float x, float y, float threshold);
    /// Refreshes the strips' needs; returns the least of all.
    float (*summarise_needs)(Tile&);
};

TileKernels tile_kernels(bool l1);

} // namespace reliefbake
