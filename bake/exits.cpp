#include "bake/exits.h"

#include "bake/parallel.h"

#include <algorithm>
#include <cmath>

namespace reliefbake {

void exit_falls(const SearchSurface& surface, const float* row0, const float* row1, int count, float* out) {
    const ExitRule& rule = *surface.exits;
    const float inverse_pitch = float(1 / surface.grid.pixel_aspect), infinity = std::numeric_limits<float>::infinity();
    const float least_sq = rule.least_fall * rule.least_fall;
    // Steepest fall along x and y: every point of the cell falls between its edges. (Plain loops, for the compiler's vectors.)
    const auto fall_x = [&](int x) { return std::max(std::max(row0[x] - row0[x + 1], row1[x] - row1[x + 1]), 0.0f); };
    const auto fall_y = [&](int x) { return std::max(std::max(row0[x] - row1[x], row0[x + 1] - row1[x + 1]), 0.0f) * inverse_pitch; };
    for (int x = 0; x < count; ++x) {
        const float a = fall_x(x), b = fall_y(x), fall_sq = a * a + b * b;
        out[x] = fall_sq * (1 + 0x1p-20f) > least_sq ? 0 : infinity;
    }
    if (!rule.from_top) return;
    // A ray from height 0 on the axis meets a point at height h and distance d with slope -h / d.
    const bool l1 = surface.metric == Metric::l1; // falls, too, are counted in the lengths of the metric
    for (int x = 0; x < count; ++x) {
        if (std::isinf(out[x])) continue;
        const float a = fall_x(x), b = fall_y(x), fall = l1 ? std::max(a, b) : std::sqrt(a * a + b * b);
        const float highest = std::max(std::max(row0[x], row0[x + 1]), std::max(row1[x], row1[x + 1]));
        out[x] = -highest / fall * (1 - 0x1p-20f);
    }
}

ExitTexels exit_texels(const SearchSurface& surface, int threads) {
    const TexelGrid& grid = surface.grid;
    const float lowest = *std::min_element(surface.height.begin(), surface.height.end());
    // Cell (i, j) of this plane is the one between texels i - 1, i and j - 1, j.
    Image<float> falls(grid.width + 1, grid.height + 1);
    parallel_for(grid.height + 1, threads, [&](int j) {
        std::vector<float> rows[2];
        for (int k = 0; k < 2; ++k) {
            const float* source = surface.height.row(grid.address_y(j - 1 + k));
            rows[k].reserve(std::size_t(grid.width) + 2);
            rows[k].push_back(source[grid.address_x(-1)]);
            rows[k].insert(rows[k].end(), source, source + grid.width);
            rows[k].push_back(source[grid.address_x(grid.width)]);
        }
        exit_falls(surface, rows[0].data(), rows[1].data(), grid.width + 1, falls.row(j));
    });
    ExitTexels out{Image<float>(grid.width, grid.height), {}};
    if (surface.exits->from_top) out.from = Image<float>(grid.width, grid.height);
    parallel_for(grid.height, threads, [&](int j) {
        for (int i = 0; i < grid.width; ++i) {
            const float from = std::min(std::min(falls(i, j), falls(i + 1, j)), std::min(falls(i, j + 1), falls(i + 1, j + 1)));
            out.height(i, j) = std::isinf(from) ? lowest : surface.height(i, j);
            if (surface.exits->from_top) out.from(i, j) = from;
        }
    });
    return out;
}

} // namespace reliefbake
