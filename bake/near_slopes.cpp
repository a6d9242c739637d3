// The near half of the bake: docs/SAFETY.md derives each bound.
//   1. Points at most one texel apart (L2, bilinear): the exact supremum over the cell and its neighbours.
//   2. One to two texels apart: pairs of the half-texel lattice, distances deflated for what lies between.
//   3. Two to near_radius texels apart: pairs of texels, likewise. (L1 and texel cones: all near pairs this way.)

#include "bake/search_surface.h"

#include "bake/near_block.h"
#include "bake/near_kernels.h"
#include "bake/parallel.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

namespace reliefbake {

float SearchSurface::distance_deflation() const {
    if (model == SurfaceModel::texel || metric == Metric::l1) return 0;
    // A quarter of the larger pitch squared, with a margin for its proof (docs/SAFETY.md).
    const double a = grid.pixel_aspect;
    return float(0.2501 * std::max(1.0, a * a));
}

double deflated_distance(const SearchSurface& surface, double dx, double dy) {
    const double y = dy * surface.grid.pixel_aspect;
    if (surface.metric == Metric::l1) return std::fabs(dx) + std::fabs(y);
    return std::sqrt(dx * dx + y * y - double(surface.distance_deflation()));
}

bool is_in_wedge(const SearchSurface& surface, double dx, double dy) {
    if (!surface.wedge) return true;
    if (dx < 0 || dy < 0) return false;
    const Wedge& wedge = *surface.wedge;
    const double aspect = surface.grid.pixel_aspect, step = surface.has_footprint() ? 1 : 0;
    const bool low_enough = std::isinf(wedge.t1) || aspect * std::max(dy - step, 0.0) <= wedge.t1 * (dx + step);
    return low_enough && aspect * (dy + step) >= wedge.t0 * std::max(dx - step, 0.0);
}

double SearchSurface::widest_step() const { return metric == Metric::l1 ? 1 + grid.pixel_aspect : std::hypot(1.0, grid.pixel_aspect); }

namespace {

constexpr int block_width = 1024; // fixed, as near_block_rows is: results cannot depend on the number of threads

/// All displacements in the wedge with Chebyshev norm in [low, high] steps, joined by distance. `unit`: texels per step;
/// `offset(dx, dy)`: where that neighbour lies in memory.
template <class Offset>
Rings make_rings(const SearchSurface& surface, int low, int high, double unit, Offset offset) {
    std::map<double, std::vector<std::ptrdiff_t>> by_distance;
    for (int dy = -high; dy <= high; ++dy)
        for (int dx = -high; dx <= high; ++dx)
            if (std::max(std::abs(dx), std::abs(dy)) >= low && is_in_wedge(surface, dx, dy)) // the deflation scales with the lattice
                by_distance[deflated_distance(surface, dx, dy) * unit].push_back(offset(dx, dy));
    Rings out;
    for (const auto& [distance, offsets] : by_distance) {
        const std::size_t begin = out.offsets.size();
        out.offsets.insert(out.offsets.end(), offsets.begin(), offsets.end());
        const double plain = std::sqrt(distance * distance + double(surface.distance_deflation()) * unit * unit);
        out.rings.push_back({float(1 / distance), float(plain + unit * surface.widest_step()), begin, out.offsets.size()});
    }
    return out;
}

/// The exact half-texel and cell bounds are for the L2 metric; L1 pairs of texels bound the surface as they are.
bool has_cells(const SearchSurface& surface) {
    return surface.model == SurfaceModel::bilinear && surface.metric == Metric::l2;
}

/// Planes of slopes for one block: texel rows y0-1 .. y1, columns -1 .. width of the block.
struct SlopePlanes {
    int y0, stride;
    std::size_t size;
    std::vector<float> texels;     ///< from pairs of texels
    std::vector<float> lattice[4]; ///< from pairs of half-texel points; phase (sx, sy) of the lower one at sx + 2 sy
    std::vector<float> cells;      ///< squared, within one texel, per cell

    std::size_t at(int y) const { return std::size_t(y - (y0 - 1)) * stride + Block::pad; }
};

/// What all steps of one block need.
struct Pass {
    const SearchSurface& surface;
    const NearKernels& kernels;
    const Block& block;
};

/// One row's points of one phase towards their rings, into a plane of slopes.
void compare_row(const Pass& pass, int y, int phase, const Rings& rings, float least, float slack, float* out) {
    const Block& block = pass.block;
    const std::ptrdiff_t row = block.at(y) - 1;
    const bool late = !block.masked_from.empty();
    pass.kernels.ring_slopes({block.apex().plane(phase) + row, block.target().plane(phase) + row,
                              late ? block.masked_from.plane(phase) + row : nullptr, least, slack},
                             rings, block.width + 2, out - 1);
}

std::vector<float> compare_texels(const Pass& pass, const SlopePlanes& planes) {
    const SearchSurface& surface = pass.surface;
    const Block& block = pass.block;
    const Rings rings = make_rings(surface, has_cells(surface) ? 2 : 1, near_radius, 1.0,
                                   [stride = block.stride](int dx, int dy) { return dx + std::ptrdiff_t(dy) * stride; });
    std::vector<float> out(planes.size);
    for (int y = block.y0 - 1; y <= block.y1; ++y)
        compare_row(pass, y, 0, rings, surface.slope_floor, 0, out.data() + planes.at(y));
    return out;
}

std::vector<float> compare_half_texels(const Pass& pass, int phase, const SlopePlanes& planes) {
    const Block& block = pass.block;
    const int sx = phase & 1, sy = phase >> 1;
    const Rings rings = make_rings(pass.surface, 2, 4, 0.5, [&](int dx, int dy) {
        const int px = sx + dx, py = sy + dy, other = (px & 1) + 2 * (py & 1);
        return (other - phase) * std::ptrdiff_t(block.height.plane_size) + (py >> 1) * std::ptrdiff_t(block.stride) + (px >> 1);
    });
    std::vector<float> out(planes.size);
    for (int y = block.y0 - 1; y <= block.y1; ++y)
        compare_row(pass, y, phase, rings, 0, block.slack, out.data() + planes.at(y));
    return out;
}

/// A cone that stands higher than the surface by `lift` in its whole cell asks for less of points at most one texel away:
/// (rise - lift) / length <= slope - lift / longest.
void lower_by_lift(const SearchSurface& surface, const Block& block, int y, float* squares) {
    const float inverse_longest = float(1 / surface.widest_step()) * (1 - 0x1p-20f);
    const float* low[2] = {block.height.plane(0) + block.at(y) - 1, block.height.plane(0) + block.at(y + 1) - 1};
    const float* high[2] = {block.raised.plane(0) + block.at(y) - 1, block.raised.plane(0) + block.at(y + 1) - 1};
    for (int x = 0; x < block.width + 2; ++x) {
        const float lift = std::min(std::min(high[0][x] - low[0][x], high[0][x + 1] - low[0][x + 1]),
                                    std::min(high[1][x] - low[1][x], high[1][x + 1] - low[1][x + 1]));
        const float slope = std::max(std::sqrt(squares[x]) - std::max(lift, 0.0f) * inverse_longest, 0.0f);
        squares[x] = slope * slope;
    }
}

std::vector<float> bound_cells(const Pass& pass, const SlopePlanes& planes) {
    const SearchSurface& surface = pass.surface;
    const Block& block = pass.block;
    std::vector<float> out(planes.size);
    const float aspect = float(surface.grid.pixel_aspect);
    for (int y = block.y0 - 1; y < block.y1; ++y) {
        const float* rows[4];
        for (int j = 0; j < 4; ++j) rows[j] = block.height.plane(0) + block.at(y - 1 + j) - 1;
        const float* fall[2] = {};
        if (surface.exits)
            for (int j = 0; j < 2; ++j) fall[j] = block.fall.data() + block.at(y + j) - 1;
        float* squares = out.data() + planes.at(y) - 1;
        if (surface.wedge)
            pass.kernels.wedge_cell_slopes({rows, surface.exits ? fall : nullptr, aspect, surface.wedge->t0, surface.wedge->t1},
                                             block.width + 2, squares);
        else
            pass.kernels.cell_slopes(rows, aspect, block.width + 2, squares);
        if (!surface.apex.empty()) lower_by_lift(surface, block, y, squares);
    }
    return out;
}

/// Row 0 of `out` is row `top` of the map.
void near_slopes_of_block(const SearchSurface& surface, const NearKernels& kernels, int x0, int y0, float lowest, int top,
                          Image<float>& out) {
    const int width = std::min(block_width, surface.grid.width - x0), y1 = std::min(y0 + near_block_rows, surface.grid.height);
    const Block block = make_block(surface, x0, width, y0, y1, lowest, has_cells(surface));
    SlopePlanes planes{y0, block.stride, std::size_t(y1 - y0 + 2) * block.stride, {}, {}, {}};
    const Pass pass{surface, kernels, block};
    planes.texels = compare_texels(pass, planes);
    if (has_cells(surface)) {
        for (int phase = 0; phase < 4; ++phase) planes.lattice[phase] = compare_half_texels(pass, phase, planes);
        planes.cells = bound_cells(pass, planes);
    }
    std::vector<float> row(std::size_t(block.stride));
    for (int y = y0; y < y1; ++y) {
        const std::size_t at = planes.at(y);
        FootprintRows rows{planes.texels.data() + at, {}, nullptr, block.stride, {}};
        if (has_cells(surface)) {
            for (int phase = 0; phase < 4; ++phase) rows.lattice[phase] = planes.lattice[phase].data() + at;
            rows.cells = planes.cells.data() + at;
        }
        // Columns on the border may have a wider footprint than the rest.
        const Footprint inside = surface.footprint_at(std::min(1, surface.grid.width - 1), y);
        rows.footprint = {surface.footprint.x_low, surface.footprint.x_high, inside.y_low, inside.y_high};
        kernels.footprint_slopes(rows, 0, block.width, row.data());
        std::copy_n(row.data(), block.width, out.row(y - top) + x0);
        for (int x : {0, surface.grid.width - 1}) {
            if (x < x0 || x >= x0 + block.width) continue;
            rows.footprint = surface.footprint_at(x, y);
            kernels.footprint_slopes(rows, x - x0, 1, row.data());
            out(x, y - top) = row[0];
        }
    }
}

int blocks_across(const SearchSurface& surface) { return (surface.grid.width + block_width - 1) / block_width; }

float lowest_for_exits(const SearchSurface& surface) {
    return surface.exits ? *std::min_element(surface.height.begin(), surface.height.end()) : 0.0f;
}

} // namespace

Image<float> near_slopes(const SearchSurface& surface, int threads) {
    const int height = surface.grid.height, blocks_x = blocks_across(surface), blocks_y = (height + near_block_rows - 1) / near_block_rows;
    const float lowest = lowest_for_exits(surface);
    const NearKernels kernels = near_kernels();
    Image<float> out(surface.grid.width, height);
    parallel_for(blocks_x * blocks_y, threads, [&](int b) {
        near_slopes_of_block(surface, kernels, b % blocks_x * block_width, b / blocks_x * near_block_rows, lowest, 0, out);
    });
    return out;
}

std::vector<Image<float>> near_slopes_of_block_rows(const SearchSurface& surface, std::span<const int> block_rows, int threads) {
    const int blocks_x = blocks_across(surface);
    const float lowest = lowest_for_exits(surface);
    const NearKernels kernels = near_kernels();
    std::vector<Image<float>> out;
    for (const int row : block_rows)
        out.push_back(Image<float>(surface.grid.width, std::min(near_block_rows, surface.grid.height - row * near_block_rows)));
    parallel_for(blocks_x * int(block_rows.size()), threads, [&](int b) {
        const std::size_t k = std::size_t(b / blocks_x);
        const int top = block_rows[k] * near_block_rows;
        near_slopes_of_block(surface, kernels, b % blocks_x * block_width, top, lowest, top, out[k]);
    });
    return out;
}

} // namespace reliefbake
