#include "bake/tile_kernels.h"

#include "bake/search_surface.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "bake/tile_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace reliefbake {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using D = HWY_CAPPED(float, 8);
using V = hn::Vec<D>;

/// Which displacements count: all, those of one quadrant, those of a wedge in it.
enum class Mode { all, quadrant, wedge };

/// The nearest image of a displacement along an axis of this period (+inf: there is one image).
HWY_INLINE V NearestImage(V e, float period) {
    const D d;
    const V p = hn::Set(d, period), half = hn::Set(d, 0.5f * period);
    e = hn::IfThenElse(hn::Gt(e, half), hn::Sub(e, p), e);
    return hn::IfThenElse(hn::Lt(e, hn::Neg(half)), hn::Add(e, p), e);
}
HWY_INLINE float NearestImage(float e, float period) {
    return e > 0.5f * period ? e - period : e < -0.5f * period ? e + period : e;
}

/// Displacement from a texel to a box centre, for the image of the box that counts: the nearest; or, directed, the first that
/// does not lie wholly behind the texel.
template <Mode kMode>
HWY_INLINE V Towards(V e, float half, float period) {
    if (kMode == Mode::all) return NearestImage(e, period);
    const D d;
    return hn::IfThenElse(hn::Lt(e, hn::Set(d, -half)), hn::Add(e, hn::Set(d, period)), e);
}
template <Mode kMode>
HWY_INLINE float Towards(float e, float half, float period) {
    if (kMode == Mode::all) return NearestImage(e, period);
    return e < -half ? e + period : e;
}

template <bool kL1>
HWY_INLINE V Length(V x, V y) {
    const D d;
    const V length = kL1 ? hn::Add(hn::Abs(x), hn::Abs(y)) : hn::Sqrt(hn::Add(hn::Mul(x, x), hn::Mul(y, y)));
    return hn::Max(length, hn::Set(d, 1e-6f));
}

/// slope times the derivative of the length along component `e`; per_length = slope / length (L1: the slope).
template <bool kL1>
HWY_INLINE V Direction(V e, V per_length) {
    return kL1 ? hn::CopySign(per_length, e) : hn::Mul(e, per_length);
}

/// The deflated distance for absolute displacements (dx, dy) >= 0; squared in the L2 metric.
template <bool kL1>
HWY_INLINE V Reach(const SearchSpace& space, V dx, V dy) {
    const D d;
    if (kL1) return hn::Max(hn::Add(dx, dy), hn::Sqrt(hn::Set(d, space.near_distance_sq)));
    const V sq = hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy));
    return hn::Sub(hn::Max(sq, hn::Set(d, space.near_distance_sq)), hn::Set(d, space.deflation));
}

/// Whether a texel above `slope` can lie at `reach`: L1 compares rises, L2 their squares.
template <bool kL1>
HWY_INLINE auto Exceeds(V rise, V slope, V reach) {
    if (kL1) return hn::Gt(rise, hn::Mul(slope, reach));
    return hn::Gt(hn::Mul(rise, rise), hn::Mul(hn::Mul(slope, slope), reach));
}

/// Least distances along x and y from a texel to a box: (ex, ey) to its centre, y scaled by the aspect. In a wedge, a box that
/// lies outside counts from its next image, and from where that is inside.
template <Mode kMode, class DX, class VX>
HWY_INLINE void WedgeGaps(DX d, const SearchSpace& space, VX ex, VX ey, VX half_x, VX half_y, VX images_x, VX images_y, VX& dx,
                          VX& dy) {
    const auto zero = hn::Zero(d), step_x = hn::Set(d, space.step), step_y = hn::Set(d, space.step * space.aspect);
    const auto low_x = hn::Sub(ex, half_x), low_y = hn::Sub(ey, half_y);
    dx = hn::Max(low_x, zero), dy = hn::Max(low_y, zero);
    if (kMode != Mode::wedge) return;
    const float slack = 1e-3f; // texels, more than rounding can misplace a box
    if (space.t1 < 1e30f) {
        const auto needed = hn::Sub(hn::Sub(hn::Mul(hn::Sub(dy, step_y), hn::Set(d, 1 / space.t1)), step_x), hn::Set(d, slack));
        const auto outside = hn::Gt(needed, hn::Add(ex, half_x));
        dx = hn::IfThenElse(outside, hn::Max(hn::Add(low_x, images_x), needed), dx);
    }
    if (space.t0 > 0) {
        const auto needed = hn::Sub(hn::Sub(hn::Mul(hn::Sub(dx, step_x), hn::Set(d, space.t0)), step_y), hn::Set(d, slack));
        const auto outside = hn::Gt(needed, hn::Add(ey, half_y));
        dy = hn::IfThenElse(outside, hn::Max(hn::Add(low_y, images_y), needed), dy);
    }
}

/// The displacement (dx, dy) to a texel's first image in the wedge; y scaled by the aspect.
HWY_INLINE void WedgeImage(const SearchSpace& space, const Opponent& texel, V& dx, V& dy) {
    const D d;
    const float slack = 1e-3f;
    const V one = hn::Set(d, 1.0f);
    const auto moved = [&](V at, V needed, float apart) {
        if (apart == 0) return hn::Max(at, needed);
        const V period = hn::Set(d, apart);
        const V images = hn::Max(hn::Ceil(hn::Div(hn::Sub(needed, at), period)), one);
        return hn::IfThenElse(hn::Gt(needed, at), hn::Add(at, hn::Mul(images, period)), at);
    };
    const V step_x = hn::Set(d, space.step + slack), step_y = hn::Set(d, (space.step + slack) * space.aspect);
    if (space.t1 < 1e30f)
        dx = moved(dx, hn::Sub(hn::Mul(hn::Sub(dy, step_y), hn::Set(d, 1 / space.t1)), step_x), space.images_x(texel.x));
    if (space.t0 > 0)
        dy = moved(dy, hn::Sub(hn::Mul(hn::Sub(dx, step_x), hn::Set(d, space.t0)), step_y),
                   space.images_y(texel.y) * space.aspect);
}

/// Whether a box of this height may matter to any texel of a strip's columns: the first, cheap test.
/// `dx`: distance along x to the box, whose centre and half extent along y are given.
template <bool kL1, Mode kMode>
HWY_INLINE bool StripNeeds(const SearchSpace& space, const Tile& tile, int strip, int i, const PyramidNode& node, V dx,
                           V factor) {
    const D d;
    const float half = node.half_y + 0.5f * (strip_rows - 1);
    const float ey = Towards<kMode>(node.cy - (tile.y[strip * strip_rows] + 0.5f * (strip_rows - 1)), half, space.period_y);
    const float gap = (kMode != Mode::all ? ey : std::fabs(ey)) - half;
    const V reach = Reach<kL1>(space, dx, hn::Set(d, std::max(gap, 0.0f) * space.aspect));
    const V lowest = hn::Load(d, tile.strip_lowest + strip * tile_size + i);
    const V need = hn::Mul(hn::Load(d, tile.strip_need + strip * tile_size + i), factor);
    const V rise = hn::Max(hn::Sub(hn::Set(d, node.max), lowest), hn::Zero(d));
    return !hn::AllFalse(d, Exceeds<kL1>(rise, need, reach));
}

/// As its name in TileKernels. The plane of a node lies above its texels and the tile's floor below the tile's; both are
/// linear, and need |v| >= need u.v for any u no longer than 1 (u: from centre to centre), so that
///     need |v| - (rise from p to q) >= need u.e - (plane - floor) - |need u - g_node|.half_node - |need u - g_tile|.half_tile
/// over all texels p of the tile and q = p + v of the node.
template <bool kL1, Mode kMode>
std::uint32_t QuadNeeds(const SearchSpace& space, const Tile& tile, const PyramidQuad& quad, const QuadPlace& place,
                        float least_need, QuadBounds& bounds) {
    const HWY_CAPPED(float, 4) d;
    const auto zero = hn::Zero(d), inverse_aspect = hn::Set(d, 1.0f / space.aspect);
    const auto tile_x = hn::Set(d, tile.half_x), tile_y = hn::Set(d, tile.half_y * space.aspect);
    const auto need = hn::Set(d, least_need);
    std::uint32_t bits = 0;
    for (int c = 0; c < 4; c += int(hn::Lanes(d))) {
        // Node c stands in column c & 1 and row c >> 1. (Loading from memory just written lane by lane would stall.)
        const auto index = hn::Iota(d, float(c));
        const auto low = hn::Ge(index, hn::Set(d, 2.0f));
        const auto odd = hn::Eq(hn::IfThenElse(low, hn::Sub(index, hn::Set(d, 2.0f)), index), hn::Set(d, 1.0f));
        const auto column = [&](const float* v) { return hn::IfThenElse(odd, hn::Set(d, v[1]), hn::Set(d, v[0])); };
        const auto row = [&](const float* v) { return hn::IfThenElse(low, hn::Set(d, v[1]), hn::Set(d, v[0])); };
        const auto ex = column(place.ex), ey = row(place.ey), half_x = column(place.half_x), half_y = row(place.half_y);
        // The maximum.
        const auto both_x = hn::Add(half_x, tile_x), both_y = hn::Add(half_y, tile_y);
        auto gap_x = hn::Max(hn::Sub(hn::Abs(ex), both_x), zero), gap_y = hn::Max(hn::Sub(hn::Abs(ey), both_y), zero);
        if (kMode != Mode::all)
            WedgeGaps<kMode>(d, space, ex, ey, both_x, both_y, column(place.images_x), hn::Mul(row(place.images_y), hn::Set(d, space.aspect)),
                      gap_x, gap_y);
        const auto sum = hn::Add(gap_x, gap_y);
        const auto gap_sq = kL1 ? hn::Mul(sum, sum) : hn::Add(hn::Mul(gap_x, gap_x), hn::Mul(gap_y, gap_y));
        const auto plain = hn::Max(gap_sq, hn::Set(d, space.near_distance_sq));
        const auto deflated = hn::Sub(plain, hn::Set(d, space.deflation));
        const auto rise = hn::Max(hn::Sub(hn::Load(d, quad.max + c), hn::Set(d, tile.lowest)), zero);
        const auto rise_sq = hn::Mul(rise, rise);
        auto matters = hn::Gt(rise_sq, hn::Mul(hn::Mul(need, need), deflated));
        hn::Store(plain, d, bounds.distance_sq + c);
        hn::Store(hn::Div(rise_sq, deflated), d, bounds.slope_sq + c);
        // The plane, meant for one image of the node.
        const auto length = hn::Max(hn::Sqrt(hn::Add(hn::Mul(ex, ex), hn::Mul(ey, ey))), hn::Set(d, 1e-6f));
        const auto slope = kL1 ? need : hn::Mul(need, hn::Sqrt(hn::Div(deflated, plain)));
        const auto along = hn::Div(slope, length);
        const auto sx = kL1 ? hn::CopySign(slope, ex) : hn::Mul(along, ex), sy = kL1 ? hn::CopySign(slope, ey) : hn::Mul(along, ey);
        const auto reach = hn::Add(hn::Mul(sx, ex), hn::Mul(sy, ey));
        const auto spread = [&](auto gx, auto gy, auto hx, auto hy) {
            return hn::Add(hn::Mul(hn::Abs(hn::Sub(sx, gx)), hx), hn::Mul(hn::Abs(hn::Sub(sy, gy)), hy));
        };
        const auto node_spread = spread(hn::Load(d, quad.gx + c), hn::Mul(hn::Load(d, quad.gy + c), inverse_aspect), half_x, half_y);
        const auto tile_spread = spread(hn::Set(d, tile.gx), hn::Mul(hn::Set(d, tile.gy), inverse_aspect), tile_x, tile_y);
        const auto spare = hn::Sub(reach, hn::Sub(hn::Load(d, quad.plane + c), hn::Set(d, tile.floor)));
        const auto one_image =
            kMode != Mode::all ? hn::And(hn::Le(hn::Sub(both_x, ex), hn::Set(d, 0.5f * space.period_x)),
                                hn::Le(hn::Sub(both_y, ey), hn::Set(d, 0.5f * space.period_y * space.aspect)))
                      : hn::And(hn::Le(hn::Add(hn::Abs(ex), both_x), hn::Set(d, 0.5f * space.period_x)),
                                hn::Le(hn::Add(hn::Abs(ey), both_y), hn::Set(d, 0.5f * space.period_y * space.aspect)));
        const auto held = hn::And(hn::Ge(spare, hn::Add(node_spread, tile_spread)), one_image);
        matters = hn::AndNot(held, matters);
        std::uint8_t mask[8] = {};
        hn::StoreMaskBits(d, matters, mask);
        bits |= std::uint32_t(mask[0]) << c;
    }
    return bits;
}

/// Whether any texel of the tile may need the node. `shrink`: least ratio of deflated to plain distance between them.
template <bool kL1, Mode kMode>
bool TileNeeds(const SearchSpace& space, const Tile& tile, const PyramidNode& node, float shrink) {
    const D d;
    const V factor = hn::Set(d, space.tolerance_factor), zero = hn::Zero(d);
    const V half_x = hn::Set(d, node.half_x), half_y = hn::Set(d, node.half_y * space.aspect);
    const V gx = hn::Set(d, node.gx), gy = hn::Set(d, node.gy / space.aspect);
    for (int i = 0; i < tile_size; i += int(hn::Lanes(d))) {
        const V ex = Towards<kMode>(hn::Sub(hn::Set(d, node.cx), hn::Load(d, tile.x + i)), node.half_x, space.period_x);
        const V dx = hn::Max(hn::Sub(kMode != Mode::all ? ex : hn::Abs(ex), half_x), zero);
        // The plane is meant for one image of the node: not where another one may be nearer. Directed, texels of the node that
        // lie behind count from their next image, which is farther than this one while they lie less than half a period back.
        const auto one_image = kMode != Mode::all ? hn::Le(hn::Sub(half_x, ex), hn::Set(d, 0.5f * space.period_x))
                                         : hn::Le(hn::Add(hn::Abs(ex), half_x), hn::Set(d, 0.5f * space.period_x));
        for (int j = 0; j < tile_size; ++j) {
            if (j % strip_rows == 0 && !StripNeeds<kL1, kMode>(space, tile, j / strip_rows, i, node, dx, factor)) {
                j += strip_rows - 1;
                continue;
            }
            // The maximum.
            const int at = j * tile_size + i;
            const V need = hn::Mul(hn::Load(d, tile.need + at), factor);
            const V height = hn::Load(d, tile.height + at);
            const float ey = Towards<kMode>(node.cy - tile.y[j], node.half_y, space.period_y);
            V gap_x = dx, gap_y = hn::Set(d, std::max((kMode != Mode::all ? ey : std::fabs(ey)) - node.half_y, 0.0f) * space.aspect);
            if (kMode == Mode::wedge)
                WedgeGaps<kMode>(d, space, ex, hn::Set(d, ey * space.aspect), half_x, half_y, hn::Set(d, space.images_x(node.cx + node.half_x)),
                          hn::Set(d, space.images_y(node.cy + node.half_y) * space.aspect), gap_x, gap_y);
            const V rise = hn::Max(hn::Sub(hn::Set(d, node.max), height), zero);
            auto matters = Exceeds<kL1>(rise, need, Reach<kL1>(space, gap_x, gap_y));
            if (hn::AllFalse(d, matters)) continue;
            // The plane: F(v) = need |v| - (rise of the plane at v) is convex in v, so its tangent at the node's
            // centre bounds it from below over the whole node.
            if (kMode != Mode::all ? node.half_y - ey <= 0.5f * space.period_y : std::fabs(ey) + node.half_y <= 0.5f * space.period_y) {
                const V vy = hn::Set(d, ey * space.aspect);
                const V distance = Length<kL1>(ex, vy);
                const V slope = hn::Mul(need, hn::Set(d, shrink));
                const V spare = hn::Sub(hn::Mul(slope, distance), hn::Sub(hn::Set(d, node.plane), height));
                const V per_length = kL1 ? slope : hn::Div(slope, distance);
                const V fall_x = hn::Mul(hn::Abs(hn::Sub(Direction<kL1>(ex, per_length), gx)), half_x);
                const V fall_y = hn::Mul(hn::Abs(hn::Sub(Direction<kL1>(vy, per_length), gy)), half_y);
                const auto held = hn::Ge(spare, hn::Add(fall_x, fall_y));
                matters = hn::AndNot(hn::And(held, one_image), matters);
            }
            if (!hn::AllFalse(d, matters)) return true;
        }
    }
    return false;
}

/// Absolute displacements from the lanes of a tile row to a texel; y scaled by the aspect.
template <Mode kMode>
HWY_INLINE void Displacements(const SearchSpace& space, V lanes_x, float lane_y, const Opponent& texel, V& dx, V& dy) {
    const D d;
    dx = Towards<kMode>(hn::Sub(hn::Set(d, texel.x), lanes_x), 0, space.period_x);
    const float ey = Towards<kMode>(texel.y - lane_y, 0, space.period_y);
    if (kMode == Mode::all) dx = hn::Abs(dx);
    dy = hn::Set(d, std::fabs(ey) * space.aspect);
    if (kMode == Mode::wedge) WedgeImage(space, texel, dx, dy);
}

/// Whether a texel may raise any need of the tile: cheap, and true too often for near texels only.
template <bool kL1, Mode kMode>
HWY_INLINE bool MayRaise(const SearchSpace& space, const Tile& tile, const Opponent& texel) {
    const D d;
    const V high = hn::Set(d, texel.height), deflation = hn::Set(d, space.deflation);
    for (int i = 0; i < tile_size; i += int(hn::Lanes(d))) {
        const V lanes_x = hn::Load(d, tile.x + i);
        V dx, dy;
        Displacements<kMode>(space, lanes_x, tile.y[0], texel, dx, dy);
        const V along = kL1 ? dx : hn::Sub(hn::Mul(dx, dx), deflation); // of every row, but in a wedge
        auto better = hn::Gt(high, high);
        for (int j = 0; j < tile_size; ++j) {
            V reach;
            if (kMode == Mode::wedge) {
                Displacements<kMode>(space, lanes_x, tile.y[j], texel, dx, dy);
                reach = kL1 ? hn::Add(dx, dy) : hn::Sub(hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy)), deflation);
            } else {
                const float y = std::fabs(Towards<kMode>(texel.y - tile.y[j], 0, space.period_y)) * space.aspect;
                reach = hn::Add(along, hn::Set(d, kL1 ? y : y * y));
            }
            const V rise = hn::Max(hn::Sub(high, hn::Load(d, tile.height + j * tile_size + i)), hn::Zero(d));
            better = hn::Or(better, Exceeds<kL1>(rise, hn::Load(d, tile.need + j * tile_size + i), reach));
        }
        if (!hn::AllFalse(d, better)) return true;
    }
    return false;
}

/// Compares one texel with the whole tile and keeps what it asks for. Returns whether anything was raised.
template <bool kL1, Mode kMode>
bool CompareTexel(const SearchSpace& space, Tile& tile, const Opponent& texel) {
    if (!MayRaise<kL1, kMode>(space, tile, texel)) return false;
    const D d;
    bool raised = false;
    const float near = float(near_radius) + 0.5f;
    for (int i = 0; i < tile_size; i += int(hn::Lanes(d))) {
        for (int j = 0; j < tile_size; ++j) {
            const int at = j * tile_size + i;
            V dx, dy;
            Displacements<kMode>(space, hn::Load(d, tile.x + i), tile.y[j], texel, dx, dy);
            const V need = hn::Load(d, tile.need + at);
            const V rise = hn::Max(hn::Sub(hn::Set(d, texel.height), hn::Load(d, tile.height + at)), hn::Zero(d));
            const V reach = Reach<kL1>(space, dx, dy);
            auto counts = hn::Or(hn::Gt(dx, hn::Set(d, near)), hn::Gt(dy, hn::Set(d, near * space.aspect)));
            if (texel.from > 0) {
                const V farthest = hn::Add(Length<kL1>(dx, dy), hn::Set(d, space.widest_step));
                counts = hn::And(counts, hn::Gt(farthest, hn::Set(d, texel.from)));
            }
            const auto better = hn::And(Exceeds<kL1>(rise, need, reach), counts);
            if (hn::AllFalse(d, better)) continue;
            const V slope = hn::IfThenElseZero(better, hn::Div(rise, kL1 ? reach : hn::Sqrt(reach)));
            hn::Store(hn::Max(slope, need), d, tile.need + at);
            hn::Store(hn::Max(slope, hn::Load(d, tile.found + at)), d, tile.found + at);
            raised = true;
        }
    }
    return raised;
}

/// Texels of a leaf that may exceed the tile's least need, as bits, row by row.
template <Mode kMode>
std::uint32_t LeafCandidatesOf(const SearchSpace& space, const Tile& tile, const LeafTexels& leaf, float threshold) {
    const HWY_CAPPED(float, MaxPyramid::leaf_size) d;
    static_assert(MaxPyramid::leaf_size == 4);
    std::uint32_t bits = 0;
    for (int i = 0; i < MaxPyramid::leaf_size; i += int(hn::Lanes(d))) {
        const auto period = hn::Set(d, space.period_x), half = hn::Set(d, tile.half_x);
        auto dx = hn::Sub(hn::Iota(d, leaf.x + float(i)), hn::Set(d, tile.centre_x));
        if (kMode != Mode::all) dx = hn::IfThenElse(hn::Lt(hn::Add(dx, half), hn::Zero(d)), hn::Add(dx, period), dx);
        else dx = hn::Abs(dx), dx = hn::Min(dx, hn::Sub(period, dx));
        dx = hn::Max(hn::Sub(dx, half), hn::Zero(d));
        for (int j = 0; j < MaxPyramid::leaf_size; ++j) {
            float dy = leaf.y + float(j) - tile.centre_y;
            if (kMode != Mode::all) dy = dy + tile.half_y < 0 ? dy + space.period_y : dy;
            else dy = std::fabs(dy), dy = std::min(dy, space.period_y - dy);
            dy = std::max(dy - tile.half_y, 0.0f) * space.aspect;
            const auto height = hn::Load(d, leaf.height + j * MaxPyramid::leaf_size + i);
            const auto rise = hn::Max(hn::Sub(height, hn::Set(d, tile.lowest)), hn::Zero(d));
            const auto sum = hn::Add(dx, hn::Set(d, dy));
            auto sq = space.l1 ? hn::Mul(sum, sum) : hn::Add(hn::Mul(dx, dx), hn::Set(d, dy * dy));
            sq = hn::Sub(hn::Max(sq, hn::Set(d, space.near_distance_sq)), hn::Set(d, space.deflation));
            std::uint8_t mask[8] = {};
            hn::StoreMaskBits(d, hn::Gt(hn::Mul(rise, rise), hn::Mul(hn::Set(d, threshold), sq)), mask);
            bits |= std::uint32_t(mask[0]) << (j * MaxPyramid::leaf_size + i);
        }
    }
    return bits;
}

/// Refreshes the strips' needs; returns the least of all.
float SummariseNeeds(Tile& tile) {
    const D d;
    V least = hn::Load(d, tile.need);
    for (int strip = 0; strip < tile_strips; ++strip)
        for (int i = 0; i < tile_size; i += int(hn::Lanes(d))) {
            const float* column = tile.need + strip * strip_rows * tile_size + i;
            V low = hn::Load(d, column);
            for (int j = 1; j < strip_rows; ++j) low = hn::Min(low, hn::Load(d, column + j * tile_size));
            hn::Store(low, d, tile.strip_need + strip * tile_size + i);
            least = hn::Min(least, low);
        }
    return hn::GetLane(hn::MinOfLanes(d, least));
}

/// Sets the lowest heights and a plane under the tile's texels. Any slopes are right; good ones are those between the means of
/// its halves.
void LayFloor(Tile& tile) {
    const D d;
    constexpr float between_halves = 0.5f * tile_size * (0.5f * tile_texels);
    alignas(32) float columns[2][tile_size]; // sums down each column, of the upper and the lower strip
    V low = hn::Load(d, tile.height), high = low;
    for (int strip = 0; strip < tile_strips; ++strip)
        for (int i = 0; i < tile_size; i += int(hn::Lanes(d))) {
            const float* rows = tile.height + strip * strip_rows * tile_size + i;
            V sum = hn::Zero(d), strip_low = hn::Load(d, rows);
            for (int j = 0; j < strip_rows; ++j) {
                const V h = hn::Load(d, rows + j * tile_size);
                sum = hn::Add(sum, h), strip_low = hn::Min(strip_low, h), high = hn::Max(high, h);
            }
            hn::Store(strip_low, d, tile.strip_lowest + strip * tile_size + i);
            hn::Store(sum, d, columns[strip] + i);
            low = hn::Min(low, strip_low);
        }
    tile.lowest = hn::GetLane(hn::MinOfLanes(d, low));
    const float largest = std::max(std::fabs(tile.lowest), std::fabs(hn::GetLane(hn::MaxOfLanes(d, high))));
    float halves_x[2] = {}, halves_y[2] = {};
    for (int i = 0; i < tile_size; ++i)
        for (int strip = 0; strip < tile_strips; ++strip) halves_x[2 * i / tile_size] += columns[strip][i], halves_y[strip] += columns[strip][i];
    tile.gx = (halves_x[1] - halves_x[0]) / between_halves, tile.gy = (halves_y[1] - halves_y[0]) / between_halves;
    V floor = hn::Set(d, std::numeric_limits<float>::infinity());
    for (int i = 0; i < tile_size; i += int(hn::Lanes(d))) {
        const V along = hn::Mul(hn::Set(d, tile.gx), hn::Sub(hn::Load(d, tile.x + i), hn::Set(d, tile.centre_x)));
        for (int j = 0; j < tile_size; ++j) {
            const V plane = hn::Add(along, hn::Set(d, tile.gy * (tile.y[j] - tile.centre_y)));
            floor = hn::Min(floor, hn::Sub(hn::Load(d, tile.height + j * tile_size + i), plane));
        }
    }
    // With the plane's own rise, rounding is up to three times as high.
    tile.floor = hn::GetLane(hn::MinOfLanes(d, floor)) - 2 * plane_slack * largest;
}

// Highway exports functions, not templates: three for each metric and mode.
#define RELIEFBAKE_TILE_KERNELS(Kind, kL1, kMode)                                                                                 \
    std::uint32_t QuadNeeds##Kind(const SearchSpace& s, const Tile& t, const PyramidQuad& q, const QuadPlace& p, float need,      \
                                  QuadBounds& b) {                                                                                \
        return QuadNeeds<kL1, kMode>(s, t, q, p, need, b);                                                                        \
    }                                                                                                                             \
    bool TileNeeds##Kind(const SearchSpace& s, const Tile& t, const PyramidNode& n, float shrink) {                               \
        return TileNeeds<kL1, kMode>(s, t, n, shrink);                                                                            \
    }                                                                                                                             \
    bool CompareTexel##Kind(const SearchSpace& s, Tile& t, const Opponent& texel) { return CompareTexel<kL1, kMode>(s, t, texel); }
RELIEFBAKE_TILE_KERNELS(L2, false, Mode::all)
RELIEFBAKE_TILE_KERNELS(L2Quadrant, false, Mode::quadrant)
RELIEFBAKE_TILE_KERNELS(L2Wedge, false, Mode::wedge)
RELIEFBAKE_TILE_KERNELS(L1, true, Mode::all)
RELIEFBAKE_TILE_KERNELS(L1Quadrant, true, Mode::quadrant)
#undef RELIEFBAKE_TILE_KERNELS

std::uint32_t LeafCandidates(const SearchSpace& s, const Tile& t, const LeafTexels& leaf, float threshold) {
    return s.directed ? LeafCandidatesOf<Mode::quadrant>(s, t, leaf, threshold) : LeafCandidatesOf<Mode::all>(s, t, leaf, threshold);
}

} // namespace HWY_NAMESPACE
} // namespace reliefbake
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace reliefbake {
#define RELIEFBAKE_EXPORT(Kind)   \
    HWY_EXPORT(QuadNeeds##Kind);  \
    HWY_EXPORT(TileNeeds##Kind);  \
    HWY_EXPORT(CompareTexel##Kind)
RELIEFBAKE_EXPORT(L2);
RELIEFBAKE_EXPORT(L2Quadrant);
RELIEFBAKE_EXPORT(L2Wedge);
RELIEFBAKE_EXPORT(L1);
RELIEFBAKE_EXPORT(L1Quadrant);
#undef RELIEFBAKE_EXPORT
HWY_EXPORT(LayFloor);
HWY_EXPORT(SummariseNeeds);
HWY_EXPORT(LeafCandidates);

TileKernels tile_kernels(const SearchSpace& space) {
    hwy::GetChosenTarget().Update(hwy::SupportedTargets()); // so that the addresses are final
    TileKernels kernels{};
    kernels.leaf_candidates = &HWY_DYNAMIC_DISPATCH(LeafCandidates);
    kernels.lay_floor = &HWY_DYNAMIC_DISPATCH(LayFloor);
    kernels.summarise_needs = &HWY_DYNAMIC_DISPATCH(SummariseNeeds);
#define RELIEFBAKE_CHOOSE(Kind)                                      \
    kernels.quad_needs = &HWY_DYNAMIC_DISPATCH(QuadNeeds##Kind);     \
    kernels.tile_needs = &HWY_DYNAMIC_DISPATCH(TileNeeds##Kind);     \
    kernels.compare_texel = &HWY_DYNAMIC_DISPATCH(CompareTexel##Kind)
    assert(!(space.l1 && space.wedged)); // octants are angles, which L1 does not know
    if (space.l1 && space.directed) { RELIEFBAKE_CHOOSE(L1Quadrant); }
    else if (space.l1) { RELIEFBAKE_CHOOSE(L1); }
    else if (space.wedged) { RELIEFBAKE_CHOOSE(L2Wedge); }
    else if (space.directed) { RELIEFBAKE_CHOOSE(L2Quadrant); }
    else { RELIEFBAKE_CHOOSE(L2); }
#undef RELIEFBAKE_CHOOSE
    return kernels;
}

} // namespace reliefbake
#endif // HWY_ONCE
