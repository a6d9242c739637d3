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
    /// No texel lies below floor + gx (x - centre_x) + gy (y - centre_y); slopes per texel.
    float floor, gx, gy;
};

/// The texels of a leaf; -inf beyond the map.
struct alignas(16) LeafTexels {
    float x, y; ///< of the first
    alignas(16) float height[MaxPyramid::leaf_size * MaxPyramid::leaf_size];
};

/// Two columns and two rows of sibling nodes as a tile sees them. Distances in texels, y scaled by the pixel aspect.
struct QuadPlace {
    float ex[2], ey[2];         ///< from the tile's centre to the node's, for the nearest image
    float half_x[2], half_y[2]; ///< of the node's box
};

/// What bounds the four of them for the whole tile.
struct alignas(16) QuadBounds {
    float distance_sq[4]; ///< least squared distance between tile and node, not deflated
    float slope_sq[4];    ///< square of the steepest slope that the maximum allows
};

/// The kernels for the widest instruction set in use (bake/simd.h). Same bits for all of them.
struct TileKernels {
    /// Nodes of a quad that may hold a slope above `need`, the tile's least, as bits: the first, tile-wide test.
    std::uint32_t (*quad_needs)(const SearchSpace&, const Tile&, const PyramidQuad&, const QuadPlace&, float need,
                                QuadBounds&);
    /// Whether any texel of the tile may need the node. `shrink`: least ratio of deflated to plain distance between them.
    bool (*tile_needs)(const SearchSpace&, const Tile&, const PyramidNode&, float shrink);
    /// Compares one texel with the whole tile and keeps what it asks for. Returns whether anything was raised.
    bool (*compare_texel)(const SearchSpace&, Tile&, float x, float y, float height);
    /// Texels of a leaf that may exceed the tile's least need, as bits, row by row; `threshold` is that need squared.
    std::uint32_t (*leaf_candidates)(const SearchSpace&, const Tile&, const LeafTexels&, float threshold);
    /// Refreshes the strips' needs; returns the least of all.
    float (*summarise_needs)(Tile&);
};

TileKernels tile_kernels(bool l1);

} // namespace reliefbake
