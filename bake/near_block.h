#pragma once
// A block of the surface with a border of real neighbours, small enough to stay in the cache: what near slopes are made from.

#include "bake/search_surface.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace reliefbake {

/// The surface at texels and half texels: phase (sx, sy) is the plane sx + 2 sy, of points that lie sx/2, sy/2 beyond texels.
struct HalfTexels {
    std::size_t plane_size = 0;
    std::unique_ptr<float[]> storage; ///< not filled when made: zeroing what is written anyway took a tenth of a bake
    bool empty() const { return !storage; }
    const float* plane(int phase) const { return storage.get() + std::size_t(phase) * plane_size; }
    float* plane(int phase) { return storage.get() + std::size_t(phase) * plane_size; }
};

struct Block {
    /// Rows are padded so that every neighbour within the near radius, and a run of vectors beyond, can be loaded.
    static constexpr int pad = 48;
    static constexpr int halo = near_radius + 2;

    int x0, width, y0, y1; ///< texels [x0, x0 + width) of rows [y0, y1) are wanted
    int stride;
    HalfTexels height;
    HalfTexels raised;     ///< apexes, where the surface has some of its own
    HalfTexels masked;     ///< with ExitRule: heights of points that count; others are as low as the map's lowest texel
    HalfTexels masked_from; ///< with ExitRule::from_top: distance from which they count
    std::vector<float> fall; ///< with ExitRule, per cell: distance from which it counts, infinity where it never does
    float slack;           ///< largest rounding error of the difference of two half-texel heights

    /// Where texel (x0, y) lies in a plane.
    std::ptrdiff_t at(int y) const { return std::ptrdiff_t(y - (y0 - halo)) * stride + pad; }
    const HalfTexels& apex() const { return raised.empty() ? height : raised; }
    const HalfTexels& target() const { return masked.empty() ? height : masked; }
};

/// `lowest`: of the surface's heights. `with_half_texels`: else only phase 0 is made.
Block make_block(const SearchSurface& surface, int x0, int width, int y0, int y1, float lowest, bool with_half_texels);

} // namespace reliefbake
