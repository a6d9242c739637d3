#include "bake/exits.h"

#include "bake/parallel.h"

#include <algorithm>
#include <cmath>

namespace reliefbake {

void exit_falls(const SearchSurface& surface, const ExitKernels& kernels, const float* row0, const float* row1, int count, float* out) {
    const ExitRule& rule = *surface.exits;
    const float inverse_pitch = float(1 / surface.grid.pixel_aspect);
    kernels.falling_cells(row0, row1, inverse_pitch, rule.least_fall * rule.least_fall, count, out);
    if (!rule.from_top) return;
    // A ray from height 0 on the axis meets a point at height h and distance d with slope -h / d.
    const bool l1 = surface.metric == Metric::l1; // falls, too, are counted in the lengths of the metric
    for (int x = 0; x < count; ++x) {
        if (std::isinf(out[x])) continue;
        const float a = std::max({row0[x] - row0[x + 1], row1[x] - row1[x + 1], 0.0f});
        const float b = std::max({row0[x] - row1[x], row0[x + 1] - row1[x + 1], 0.0f}) * inverse_pitch;
        const float fall = l1 ? std::max(a, b) : std::sqrt(a * a + b * b);
        const float highest = std::max({row0[x], row0[x + 1], row1[x], row1[x + 1]});
        out[x] = -highest / fall * (1 - 0x1p-20f);
    }
}

ExitTexels exit_texels(const SearchSurface& surface, int threads) {
    const TexelGrid& grid = surface.grid;
    const float lowest = *std::min_element(surface.height.begin(), surface.height.end());
    // Cell (i, j) of this plane is the one between texels i - 1, i and j - 1, j.
    Image<float> falls(grid.width + 1, grid.height + 1);
    const ExitKernels kernels = exit_kernels();
    parallel_for(grid.height + 1, threads, [&](int j) {
        std::vector<float> rows[2];
        for (int k = 0; k < 2; ++k) {
            const float* source = surface.height.row(grid.address_y(j - 1 + k));
            rows[k].reserve(std::size_t(grid.width) + 2);
            rows[k].push_back(source[grid.address_x(-1)]);
            rows[k].insert(rows[k].end(), source, source + grid.width);
            rows[k].push_back(source[grid.address_x(grid.width)]);
        }
        exit_falls(surface, kernels, rows[0].data(), rows[1].data(), grid.width + 1, falls.row(j));
    });
    ExitTexels out{Image<float>(grid.width, grid.height), {}};
    if (surface.exits->from_top) out.from = Image<float>(grid.width, grid.height);
    parallel_for(grid.height, threads, [&](int j) {
        // Cell (i + 1, j + 1) of the plane, and those one back, touch texel (i, j).
        const CellPoints texels{falls.row(j + 1) + 1, surface.height.row(j), 1, falls.row(j + 1) - falls.row(j), lowest};
        kernels.mask_points(texels, grid.width, out.height.row(j), out.from.empty() ? nullptr : out.from.row(j));
    });
    return out;
}

} // namespace reliefbake
