#pragma once
// The far half of the bake: texels more than near_radius apart, through the pyramid.

#include "bake/max_pyramid.h"
#include "bake/search_surface.h"

#include <cstdint>

namespace reliefbake {

/// Raises `slopes` (as near_slopes made them) to what the far surface asks for. On return every cone is conservative;
/// a slope is at most (1 + tolerance) times larger than the exact far constraint asks. Returns the number of pyramid
/// nodes tested against a tile.
std::uint64_t search_far_slopes(const SearchSurface& surface, const MaxPyramid& pyramid, float tolerance, int threads,
                                Image<float>& slopes);

} // namespace reliefbake
