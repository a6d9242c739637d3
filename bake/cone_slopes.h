#pragma once
// Between stored levels and ratios: what every bake of cones, whole or by bands, sets up and ends with.

#include "bake/search_surface.h"

#include <algorithm>
#include <limits>

namespace reliefbake {

/// Float rounding of a slope, all stages together, is below 2^-20 of it.
constexpr double slope_rounding_margin = 1 + 0x1p-20;

/// Levels per texel to height per texture width.
inline double slope_unit(const TexelGrid& grid, BitDepth bits) { return double(grid.width) / max_code(bits); }

/// All of a search surface but its heights.
inline SearchSurface surface_without_heights(const TexelGrid& grid, BitDepth bits, const ConeOptions& options) {
    constexpr double widest_ratio = 0x1p40; // "no cap": wider than any march can use, and still far from overflow when squared
    SearchSurface surface{};
    surface.grid = grid, surface.metric = options.metric, surface.model = options.surface;
    const double cap = std::min(double(options.ratio_max), widest_ratio);
    surface.slope_floor = float(1 / (cap * slope_unit(grid, bits) * (1 + double(options.tolerance)) * slope_rounding_margin));
    if (options.surface == SurfaceModel::bilinear) {
        const int low = options.lookup == ConeLookup::cell ? 0 : -1;
        surface.footprint = {low, 1, low, 1};
    }
    return surface;
}

/// Turns a row of slopes into ratios, in place.
inline void slopes_to_ratios(const TexelGrid& grid, BitDepth bits, const ConeOptions& options, float* row) {
    const double unit = slope_unit(grid, bits) * (1 + double(options.tolerance)) * slope_rounding_margin;
    for (float* value = row; value != row + grid.width; ++value)
        *value = float(std::min(double(options.ratio_max), 1 / (double(*value) * unit)));
}

/// Without a cap, a texel of row y that has nothing above its whole footprint gets an unbounded cone. `top`: the largest height.
inline void open_topmost_cones(const SearchSurface& surface, float top, int y, float* ratios) {
    const TexelGrid& g = surface.grid;
    const int reach = surface.has_footprint() ? 1 : 0;
    for (int x = 0; x < g.width; ++x) {
        bool topmost = true;
        for (int j = -reach; j <= reach; ++j)
            for (int i = -reach; i <= reach; ++i) topmost &= surface.height(g.address_x(x + i), g.address_y(y + j)) == top;
        if (topmost) ratios[x] = std::numeric_limits<float>::infinity();
    }
}

} // namespace reliefbake
