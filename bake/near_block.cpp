#include "bake/near_block.h"

#include "bake/exits.h"

#include <algorithm>
#include <cmath>

namespace reliefbake {
namespace {

/// Copies the block's texels and their neighbours (wrapped or clamped) into phase 0.
void copy_texels(const Block& block, const TexelGrid& grid, const Image<float>& image, HalfTexels& out) {
    for (int y = block.y0 - Block::halo; y < block.y1 + Block::halo; ++y) {
        const float* source = image.row(grid.address_y(y));
        float* row = out.plane(0) + block.at(y);
        std::copy_n(source + block.x0, block.width, row);
        for (int x = 1; x <= Block::pad; ++x) {
            row[-x] = source[grid.address_x(block.x0 - x)];
            row[block.width + x - 1] = source[grid.address_x(block.x0 + block.width + x - 1)];
        }
    }
}

/// Fills phases 1 to 3. Returns the largest rounding error of a difference of two half-texel heights.
float fill_half_texels(const Block& block, HalfTexels& points) {
    const int rows = block.y1 - block.y0 + 2 * Block::halo - 1;
    bool exact = true;
    float largest = 0;
    for (int r = 0; r < rows; ++r) {
        const float* h0 = points.plane(0) + std::size_t(r) * block.stride;
        const float* h1 = h0 + block.stride;
        float* out[4];
        for (int k = 1; k < 4; ++k) out[k] = points.plane(k) + std::size_t(r) * block.stride;
        for (int x = 0; x < block.stride - 1; ++x) {
            const float top = h0[x] + h0[x + 1], left = h0[x] + h1[x], bottom = h1[x] + h1[x + 1];
            out[1][x] = 0.5f * top, out[2][x] = 0.5f * left, out[3][x] = 0.25f * (top + bottom);
            exact &= (top - h0[x] == h0[x + 1]) & (left - h0[x] == h1[x]) & (bottom - h1[x] == h1[x + 1]) &
                     ((top + bottom) - top == bottom);
            largest = std::max(largest, std::fabs(h0[x]));
        }
    }
    return exact ? 0.0f : largest * 0x1p-22f;
}

HalfTexels make_points(const Block& block, bool with_half_texels) {
    const std::size_t plane_size = std::size_t(block.y1 - block.y0 + 2 * Block::halo) * block.stride;
    return {plane_size, std::make_unique_for_overwrite<float[]>((with_half_texels ? 4 : 1) * plane_size)};
}

/// Masks the points of each phase; one of phase (sx, sy) touches the cells up to one back where its s is 0.
void mask(const SearchSurface& surface, Block& block, float lowest, bool with_half_texels) {
    const ExitKernels kernels = exit_kernels();
    const int rows = block.y1 - block.y0 + 2 * Block::halo, stride = block.stride;
    block.fall.assign(block.height.plane_size, std::numeric_limits<float>::infinity());
    for (int r = 0; r + 1 < rows; ++r) {
        const float* h0 = block.height.plane(0) + std::size_t(r) * stride;
        exit_falls(surface, kernels, h0, h0 + stride, stride - 1, block.fall.data() + std::size_t(r) * stride);
    }
    block.masked = make_points(block, with_half_texels);
    if (surface.exits->from_top) block.masked_from = make_points(block, with_half_texels);
    const std::ptrdiff_t first = stride + 1, count = std::ptrdiff_t(block.fall.size()) - first; // the halo's first row serves no one
    for (int phase = 0; phase < (with_half_texels ? 4 : 1); ++phase) {
        const CellPoints points{block.fall.data() + first, block.height.plane(phase) + first, phase & 1 ? 0 : 1, phase >> 1 ? 0 : stride, lowest};
        float* from = block.masked_from.empty() ? nullptr : block.masked_from.plane(phase) + first;
        kernels.mask_points(points, count, block.masked.plane(phase) + first, from);
    }
}

} // namespace

Block make_block(const SearchSurface& surface, int x0, int width, int y0, int y1, float lowest, bool with_half_texels) {
    Block block{x0, width, y0, y1, width + 2 * Block::pad, {}, {}, {}, {}, {}, 0};
    block.height = make_points(block, with_half_texels);
    copy_texels(block, surface.grid, surface.height, block.height);
    if (!surface.apex.empty()) {
        block.raised = make_points(block, with_half_texels);
        copy_texels(block, surface.grid, surface.apex, block.raised);
    }
    if (with_half_texels) {
        block.slack = fill_half_texels(block, block.height);
        if (!surface.apex.empty()) block.slack = std::max(block.slack, fill_half_texels(block, block.raised));
    }
    if (surface.exits) mask(surface, block, lowest, with_half_texels);
    return block;
}

} // namespace reliefbake
