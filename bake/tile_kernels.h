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
    /// How far apart the images of a box that reaches to `end` are, for a wedge: a period; any distance where a clamped border
    /// goes on beyond the map; else there is one.
    float images_x(float end) const { return period_x < 1e30f || end < last_x ? period_x : 0; }
    float images_y(float end) const { return period_y < 1e30f || end < last_y ? period_y : 0; }
    bool directed;            ///< only displacements with dx >= 0 and dy >= 0 count, and of them those in the wedge
    bool wedged;              ///< t0 > 0 or t1 < infinity
    float t0, t1;             ///< bounds of dy / dx (y scaled by the aspect)
    float step;               ///< texels by which a corner's displacement may leave the wedge on each axis (is_in_wedge)
    float last_x, last_y;     ///< the last texel on each axis
    float widest_step;        ///< how much farther apart than two texels points of cells around them can be
};

/// One texel of the surface, as a tile meets it.
struct Opponent {
    float x, y, height;
    float from; ///< distance from which it counts (ExitRule); 0: always
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
    float ex[2], ey[2];         ///< from the tile's centre to the node's, for the image that counts
    float half_x[2], half_y[2]; ///< of the node's box
    float images_x[2], images_y[2]; ///< SearchSpace::images_x, images_y, of the node's box
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
    bool (*compare_texel)(const SearchSpace&, Tile&, const Opponent&);
    /// Texels of a leaf that may exceed the tile's least need, as bits, row by row; `threshold` is that need squared.
    std::uint32_t (*leaf_candidates)(const SearchSpace&, const Tile&, const LeafTexels&, float threshold);
    /// Sets `lowest`, the strips' lowest, and the plane under the tile's texels from their heights.
    void (*lay_floor)(Tile&);
    /// Refreshes the strips' needs; returns the least of all.
    float (*summarise_needs)(Tile&);
};

TileKernels tile_kernels(const SearchSpace& space);

} // namespace reliefbake
