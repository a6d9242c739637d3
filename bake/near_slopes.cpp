// The near half of the bake: docs/SAFETY.md derives each bound.
//   1. Points at most one texel apart (L2, bilinear): the exact supremum over the cell and its eight neighbours.
//   2. One to two texels apart: pairs of the half-texel lattice, distances deflated for what lies between.
//   3. Two to near_radius texels apart: pairs of texels, likewise. (L1 and texel cones: all near pairs this way.)

#include "bake/search_surface.h"

#include "bake/parallel.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <vector>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "bake/near_slopes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#ifndef RELIEFBAKE_NEAR_SLOPES_SHARED
#define RELIEFBAKE_NEAR_SLOPES_SHARED
namespace reliefbake {

/// Rows are padded so that every neighbour within the near radius, and a run of vectors beyond, can be loaded.
constexpr int pad = 48;
constexpr int halo = near_radius + 2;
constexpr int block_width = 1024, block_rows = 64; // fixed: results cannot depend on the number of threads

/// A block of texels with a border of real neighbours (wrapped or clamped). Small enough to stay in the cache.
struct Block {
    int x0, width, y0, y1; ///< texels [x0, x0 + width) of rows [y0, y1) are wanted
    int stride;
    std::vector<float> storage;
    const float* row(int y) const { return storage.data() + std::size_t(y - (y0 - halo)) * stride + pad; }
    float* row(int y) { return storage.data() + std::size_t(y - (y0 - halo)) * stride + pad; }
};

/// Neighbours at one distance: slope = (highest of them - own height) * inverse_distance.
struct Ring {
    float inverse_distance;
    std::size_t begin, end; ///< range of Rings::offsets
};
struct Rings {
    std::vector<Ring> rings;
    std::vector<std::ptrdiff_t> offsets; ///< of a neighbour, in floats
};

/// Planes of slopes for one block: texel rows y0-1 .. y1, columns -1 .. width of the block.
struct SlopePlanes {
    int y0, stride;
    std::vector<float> texels;     ///< from pairs of texels
    std::vector<float> lattice[4]; ///< from pairs of half-texel points; phase (sx, sy) of the lower one at sx + 2 sy
    std::vector<float> cells;      ///< squared, within one texel, per cell

    std::size_t at(int y) const { return std::size_t(y - (y0 - 1)) * stride + pad; }
};

} // namespace reliefbake
#endif

HWY_BEFORE_NAMESPACE();
namespace reliefbake {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using D = HWY_CAPPED(float, 8);
using V = hn::Vec<D>;

/// out[x] = slopes of a row's points towards their rings, at least `least`; `slack` covers the rounding of heights.
void RingSlopes(const float* centre, const Rings& rings, float least, float slack, int count, float* out) {
    const D d;
    constexpr int run = 4; // vectors at a time: a neighbour's offset is loaded once for all
    const int lanes = int(hn::Lanes(d));
    for (int x = 0; x < count; x += run * lanes) {
        V own[run], best[run], high[run];
        for (int k = 0; k < run; ++k) own[k] = hn::LoadU(d, centre + x + k * lanes), best[k] = hn::Set(d, least);
        for (const Ring& ring : rings.rings) {
            for (int k = 0; k < run; ++k) high[k] = own[k];
            for (std::size_t n = ring.begin; n < ring.end; ++n) {
                const float* other = centre + x + rings.offsets[n];
                for (int k = 0; k < run; ++k) high[k] = hn::Max(high[k], hn::LoadU(d, other + k * lanes));
            }
            const V inverse = hn::Set(d, ring.inverse_distance);
            for (int k = 0; k < run; ++k) {
                const V rise = hn::Add(hn::Sub(high[k], own[k]), hn::Set(d, slack));
                best[k] = hn::Max(best[k], hn::Mul(rise, inverse));
            }
        }
        for (int k = 0; k < run; ++k) hn::StoreU(best[k], d, out + x + k * lanes);
    }
}

HWY_INLINE V Positive(V a) { return hn::Max(a, hn::Zero(D())); }
HWY_INLINE V Square(V a) { return hn::Mul(a, a); }
HWY_INLINE V NormSquare(V a, V b) { return hn::Add(Square(a), Square(b)); }

/// sup over t in [0, rho] of (a + t b) / sqrt(1 + t^2), positive part, squared: from a cell's corner to its far edge.
HWY_INLINE V ToFarEdge(V a, V b, float rho) {
    const D d;
    const V end = Square(Positive(hn::Add(a, hn::Mul(hn::Set(d, rho), b))));
    const V at_end = hn::Mul(end, hn::Set(d, 1.0f / (1.0f + rho * rho)));
    const V inside = NormSquare(a, Positive(b));
    const auto peak_inside = hn::And(hn::Gt(a, hn::Zero(d)), hn::Le(b, hn::Mul(hn::Set(d, rho), a)));
    return hn::IfThenElse(peak_inside, inside, hn::Max(at_end, Square(Positive(a))));
}

/// Gradients of a bilinear cell along its four edges, seen from a neighbour: `a` leads away from it. a0, a1: along
/// the two edges that lead away; b_near, b_far: along the shared edge and the far one (positive from edge 0 to 1).
HWY_INLINE V SideCell(V a0, V a1, V b_near, V b_far, float rho) {
    const V spread = NormSquare(Positive(hn::Max(a0, a1)), b_near);
    return hn::Max(spread, hn::Max(ToFarEdge(a0, b_far, rho), ToFarEdge(a1, hn::Neg(b_far), rho)));
}

/// Likewise for a cell that shares one corner: all four gradients lead away from that corner.
HWY_INLINE V CornerCell(V a_near, V a_far, V b_near, V b_far, float rho) {
    const V at_corner = NormSquare(Positive(a_near), Positive(b_near));
    return hn::Max(at_corner, hn::Max(ToFarEdge(a_near, b_far, rho), ToFarEdge(b_near, a_far, 1.0f / rho)));
}

/// Squared supremum of the slope from any point of a cell to any point at most one texel away (in x and in y).
/// rows[1] and rows[2] hold the corners of the cells, rows[0] and rows[3] those of the neighbours.
void CellSlopes(const float* const* rows, float aspect, int count, float* out) {
    const D d;
    const V inv_pitch_y = hn::Set(d, 1.0f / aspect);
    for (int x = 0; x < count; x += int(hn::Lanes(d))) {
        // Gradients along x of the four rows, and along y of the four columns, around the cell.
        V gx[4][3], gy[4][3];
        V h[4][4];
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 4; ++i) h[j][i] = hn::LoadU(d, rows[j] + x - 1 + i);
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 3; ++i) gx[j][i] = hn::Sub(h[j][i + 1], h[j][i]);
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 3; ++j) gy[i][j] = hn::Mul(hn::Sub(h[j + 1][i], h[j][i]), inv_pitch_y);
        const auto n = [](V v) { return hn::Neg(v); };
        const float rx = aspect, ry = 1.0f / aspect;
        // Own cell.
        V best = hn::Max(hn::Max(NormSquare(gx[1][1], gy[1][1]), NormSquare(gx[1][1], gy[2][1])),
                         hn::Max(NormSquare(gx[2][1], gy[1][1]), NormSquare(gx[2][1], gy[2][1])));
        // Right, left, below, above.
        best = hn::Max(best, SideCell(gx[1][2], gx[2][2], gy[2][1], gy[3][1], rx));
        best = hn::Max(best, SideCell(n(gx[1][0]), n(gx[2][0]), gy[1][1], gy[0][1], rx));
        best = hn::Max(best, SideCell(gy[1][2], gy[2][2], gx[2][1], gx[3][1], ry));
        best = hn::Max(best, SideCell(n(gy[1][0]), n(gy[2][0]), gx[1][1], gx[0][1], ry));
        // The four corners.
        best = hn::Max(best, CornerCell(gx[2][2], gx[3][2], gy[2][2], gy[3][2], rx));
        best = hn::Max(best, CornerCell(n(gx[2][0]), n(gx[3][0]), gy[1][2], gy[0][2], rx));
        best = hn::Max(best, CornerCell(gx[1][2], gx[0][2], n(gy[2][0]), n(gy[3][0]), rx));
        best = hn::Max(best, CornerCell(n(gx[1][0]), n(gx[0][0]), n(gy[1][0]), n(gy[0][0]), rx));
        hn::StoreU(best, d, out + x);
    }
}

/// out[x] = the largest of the slopes over the footprint of texel x: 3x3 texels, 5x5 half texels, 2x2 cells.
void FootprintSlopes(const SlopePlanes& s, int y, bool cells, int count, float* out) {
    const D d;
    const float* texels = s.texels.data();
    for (int x = 0; x < count; x += int(hn::Lanes(d))) {
        V best = hn::Zero(d), square = hn::Zero(d);
        const auto take = [&](const float* plane, int i, int j) {
            best = hn::Max(best, hn::LoadU(d, plane + s.at(y + j) + x + i));
        };
        for (int j = -1; j <= 1; ++j)
            for (int i = -1; i <= 1; ++i) {
                take(texels, i, j);
                if (!cells) continue;
                take(s.lattice[0].data(), i, j);
                if (i < 1) take(s.lattice[1].data(), i, j);
                if (j < 1) take(s.lattice[2].data(), i, j);
                if (i == 1 || j == 1) continue;
                take(s.lattice[3].data(), i, j);
                square = hn::Max(square, hn::LoadU(d, s.cells.data() + s.at(y + j) + x + i));
            }
        hn::StoreU(hn::Max(best, hn::Sqrt(square)), d, out + x);
    }
}

} // namespace HWY_NAMESPACE
} // namespace reliefbake
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace reliefbake {
HWY_EXPORT(RingSlopes);
HWY_EXPORT(CellSlopes);
HWY_EXPORT(FootprintSlopes);

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

namespace {

/// All displacements with Chebyshev norm in [low, high], joined by distance. `unit`: texels per step; `offset(dx, dy)`:
/// where that neighbour lies in memory.
template <class Offset>
Rings make_rings(const SearchSurface& surface, int low, int high, double unit, Offset offset) {
    std::map<double, std::vector<std::ptrdiff_t>> by_distance;
    for (int dy = -high; dy <= high; ++dy)
        for (int dx = -high; dx <= high; ++dx)
            if (std::max(std::abs(dx), std::abs(dy)) >= low) // the deflation scales with the lattice
                by_distance[deflated_distance(surface, dx, dy) * unit].push_back(offset(dx, dy));
    Rings out;
    for (const auto& [distance, offsets] : by_distance) {
        const std::size_t begin = out.offsets.size();
        out.offsets.insert(out.offsets.end(), offsets.begin(), offsets.end());
        out.rings.push_back({float(1 / distance), begin, out.offsets.size()});
    }
    return out;
}

Block make_block(const SearchSurface& surface, int x0, int y0) {
    const TexelGrid& grid = surface.grid;
    const int width = std::min(block_width, grid.width - x0), y1 = std::min(y0 + block_rows, grid.height);
    Block block{x0, width, y0, y1, width + 2 * pad, {}};
    block.storage.resize(std::size_t(y1 - y0 + 2 * halo) * block.stride);
    for (int y = y0 - halo; y < y1 + halo; ++y) {
        const float* source = surface.height.row(grid.address_y(y));
        float* row = block.row(y);
        std::copy_n(source + x0, width, row);
        for (int x = 1; x <= pad; ++x) {
            row[-x] = source[grid.address_x(x0 - x)];
            row[width + x - 1] = source[grid.address_x(x0 + width + x - 1)];
        }
    }
    return block;
}

/// The surface at half texels: phase (sx, sy) in plane sx + 2 sy, rows as in the block.
struct Midpoints {
    std::vector<float> storage;
    std::size_t plane_size;
    float slack; ///< largest rounding error of the difference of two of them
};

Midpoints make_midpoints(const Block& block) {
    const int rows = block.y1 - block.y0 + 2 * halo - 1;
    Midpoints m{{}, std::size_t(rows + 1) * block.stride, 0};
    m.storage.resize(4 * m.plane_size);
    bool exact = true;
    float largest = 0;
    for (int r = 0; r < rows; ++r) {
        const float* h0 = block.storage.data() + std::size_t(r) * block.stride;
        const float* h1 = h0 + block.stride;
        float* out[4];
        for (int k = 0; k < 4; ++k) out[k] = m.storage.data() + k * m.plane_size + std::size_t(r) * block.stride;
        for (int x = 0; x < block.stride - 1; ++x) {
            const float top = h0[x] + h0[x + 1], left = h0[x] + h1[x], bottom = h1[x] + h1[x + 1];
            out[0][x] = h0[x], out[1][x] = 0.5f * top, out[2][x] = 0.5f * left, out[3][x] = 0.25f * (top + bottom);
            exact &= (top - h0[x] == h0[x + 1]) & (left - h0[x] == h1[x]) & (bottom - h1[x] == h1[x + 1]) &
                     ((top + bottom) - top == bottom);
            largest = std::max(largest, std::fabs(h0[x]));
        }
    }
    m.slack = exact ? 0.0f : largest * 0x1p-22f;
    return m;
}

/// The exact half-texel and cell bounds are for the L2 metric; L1 pairs of texels bound the surface as they are.
bool has_cells(const SearchSurface& surface) {
    return surface.model == SurfaceModel::bilinear && surface.metric == Metric::l2;
}

std::vector<float> compare_texels(const SearchSurface& surface, const Block& block, const SlopePlanes& planes) {
    const Rings rings = make_rings(surface, has_cells(surface) ? 2 : 1, near_radius, 1.0,
                                   [&](int dx, int dy) { return dx + std::ptrdiff_t(dy) * block.stride; });
    std::vector<float> out(std::size_t(block.y1 - block.y0 + 2) * block.stride);
    for (int y = block.y0 - 1; y <= block.y1; ++y)
        HWY_DYNAMIC_DISPATCH(RingSlopes)(block.row(y) - 1, rings, surface.slope_floor, 0, block.width + 2,
                                         out.data() + planes.at(y) - 1);
    return out;
}

std::vector<float> compare_half_texels(const SearchSurface& surface, const Block& block, const Midpoints& points,
                                       int phase, const SlopePlanes& planes) {
    const int sx = phase & 1, sy = phase >> 1;
    const Rings rings = make_rings(surface, 2, 4, 0.5, [&](int dx, int dy) {
        const int px = sx + dx, py = sy + dy, other = (px & 1) + 2 * (py & 1);
        return (other - phase) * std::ptrdiff_t(points.plane_size) + (py >> 1) * std::ptrdiff_t(block.stride) + (px >> 1);
    });
    std::vector<float> out(std::size_t(block.y1 - block.y0 + 2) * block.stride);
    for (int y = block.y0 - 1; y <= block.y1; ++y) {
        const float* row = points.storage.data() + std::size_t(phase) * points.plane_size +
                           std::size_t(y - (block.y0 - halo)) * block.stride + pad;
        HWY_DYNAMIC_DISPATCH(RingSlopes)(row - 1, rings, 0, points.slack, block.width + 2, out.data() + planes.at(y) - 1);
    }
    return out;
}

std::vector<float> bound_cells(const SearchSurface& surface, const Block& block, const SlopePlanes& planes) {
    std::vector<float> out(std::size_t(block.y1 - block.y0 + 2) * block.stride);
    for (int y = block.y0 - 1; y < block.y1; ++y) {
        const float* rows[4];
        for (int j = 0; j < 4; ++j) rows[j] = block.row(y - 1 + j) - 1;
        HWY_DYNAMIC_DISPATCH(CellSlopes)(rows, float(surface.grid.pixel_aspect), block.width + 2,
                                         out.data() + planes.at(y) - 1);
    }
    return out;
}

void near_slopes_of_block(const SearchSurface& surface, int x0, int y0, Image<float>& out) {
    const Block block = make_block(surface, x0, y0);
    SlopePlanes planes{y0, block.stride, {}, {}, {}};
    planes.texels = compare_texels(surface, block, planes);
    if (has_cells(surface)) {
        const Midpoints points = make_midpoints(block);
        for (int phase = 0; phase < 4; ++phase)
            planes.lattice[phase] = compare_half_texels(surface, block, points, phase, planes);
        planes.cells = bound_cells(surface, block, planes);
    }
    std::vector<float> row(std::size_t(block.stride));
    for (int y = y0; y < block.y1; ++y) {
        if (surface.has_footprint())
            HWY_DYNAMIC_DISPATCH(FootprintSlopes)(planes, y, has_cells(surface), block.width, row.data());
        else
            std::copy_n(planes.texels.data() + planes.at(y), block.width, row.data());
        std::copy_n(row.data(), block.width, out.row(y) + x0);
    }
}

} // namespace

Image<float> near_slopes(const SearchSurface& surface, int threads) {
    const int width = surface.grid.width, height = surface.grid.height;
    const int blocks_x = (width + block_width - 1) / block_width, blocks_y = (height + block_rows - 1) / block_rows;
    Image<float> out(width, height);
    parallel_for(blocks_x * blocks_y, threads, [&](int b) {
        near_slopes_of_block(surface, b % blocks_x * block_width, b / blocks_x * block_rows, out);
    });
    return out;
}

} // namespace reliefbake
#endif // HWY_ONCE
