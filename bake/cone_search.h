#pragma once
// The far half of the bake: texels more than near_radius apart, through the pyramid.

#include "bake/max_pyramid.h"
#include "bake/search_surface.h"

#include <cstdint>
#include <functional>

namespace reliefbake {

/// The texels that a search looks at: the surface's own, or those that exits touch (bake/exits.h).
struct SearchTarget {
    const Image<float>& height;
    const Image<float>& from; ///< distance from which each counts; empty: always
};

/// Raises `slopes` (as near_slopes made them) to what the far surface asks for. On return every cone whose slope is multiplied
/// by 1 + tolerance keeps its guarantee. `pyramid` is that of target.height. Returns the number of pyramid nodes tested
/// against a tile.
std::uint64_t search_far_slopes(const SearchSurface& surface, const SearchTarget& target, const MaxPyramid& pyramid, float tolerance,
                                int threads, Image<float>& slopes);

/// Where row y of a plane lies, 0 <= y < height of the map.
using RowOf = std::function<const float*(int y)>;

/// The two halves of search_far_slopes, row by row. First: the far slopes that texels [tile_rows first .. first + tile_rows) ask for,
/// of which `near` (rows one above and one below included) are the near ones; as many rows into `found` as the map has.
constexpr int far_tile_rows = 8;
std::uint64_t search_tile_row(const SearchSurface& surface, const SearchTarget& target, const MaxPyramid& pyramid, float tolerance,
                              int tile_row, const RowOf& near, Image<float>& found);

/// Second: raises row y of slopes, near ones so far, by what was found (rows one above and one below included).
void raise_row_by_found(const SearchSurface& surface, int y, const RowOf& found, float* slopes);

} // namespace reliefbake
