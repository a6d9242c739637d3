#pragma once
// The far half of the bake: texels more than near_radius apart, through the pyramid.

#include "bake/max_pyramid.h"
#include "bake/search_surface.h"

#include <cstdint>

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

} // namespace reliefbake
