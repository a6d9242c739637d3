#include "bake/tile_kernels.h"

#include "bake/search_surface.h"

#include <algorithm>
#include <cmath>

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

/// Whether a box of this height may matter to any texel of a strip's columns: the first, cheap test.
/// `dx`: distance along x to the box, whose centre and half extent along y are given.
template <bool kL1>
HWY_INLINE bool StripNeeds(const SearchSpace& space, const Tile& tile, int strip, int i, const PyramidNode& node, V dx,
                           V factor) {
    const D d;
    const float middle = tile.y[strip * strip_rows] + 0.5f * (strip_rows - 1);
    const float gap = std::fabs(NearestImage(node.cy - middle, space.period_y)) - node.half_y - 0.5f * (strip_rows - 1);
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
template <bool kL1>
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
        const auto gap_x = hn::Max(hn::Sub(hn::Abs(ex), hn::Add(half_x, tile_x)), zero);
        const auto gap_y = hn::Max(hn::Sub(hn::Abs(ey), hn::Add(half_y, tile_y)), zero);
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
        const auto one_image = hn::And(hn::Le(hn::Add(hn::Abs(ex), hn::Add(half_x, tile_x)), hn::Set(d, 0.5f * space.period_x)),
                                       hn::Le(hn::Add(hn::Abs(ey), hn::Add(half_y, tile_y)),
                                              hn::Set(d, 0.5f * space.period_y * space.aspect)));
        const auto held = hn::And(hn::Ge(spare, hn::Add(node_spread, tile_spread)), one_image);
        matters = hn::AndNot(held, matters);
        std::uint8_t mask[8] = {};
        hn::StoreMaskBits(d, matters, mask);
        bits |= std::uint32_t(mask[0]) << c;
    }
    return bits;
}

/// Whether any texel of the tile may need the node. `shrink`: least ratio of deflated to plain distance between them.
template <bool kL1>
bool TileNeeds(const SearchSpace& space, const Tile& tile, const PyramidNode& node, float shrink) {
    const D d;
    const V factor = hn::Set(d, space.tolerance_factor), zero = hn::Zero(d);
    const V half_x = hn::Set(d, node.half_x), half_y = hn::Set(d, node.half_y * space.aspect);
    const V gx = hn::Set(d, node.gx), gy = hn::Set(d, node.gy / space.aspect);
    for (int i = 0; i < tile_size; i += int(hn::Lanes(d))) {
        const V ex = NearestImage(hn::Sub(hn::Set(d, node.cx), hn::Load(d, tile.x + i)), space.period_x);
        const V dx = hn::Max(hn::Sub(hn::Abs(ex), half_x), zero);
        // The plane is meant for one image of the node: not where another one may be as near.
        const auto one_image = hn::Le(hn::Add(hn::Abs(ex), half_x), hn::Set(d, 0.5f * space.period_x));
        for (int j = 0; j < tile_size; ++j) {
            if (j % strip_rows == 0 && !StripNeeds<kL1>(space, tile, j / strip_rows, i, node, dx, factor)) {
                j += strip_rows - 1;
                continue;
            }
            // The maximum.
            const int at = j * tile_size + i;
            const V need = hn::Mul(hn::Load(d, tile.need + at), factor);
            const V height = hn::Load(d, tile.height + at);
            const float ey = NearestImage(node.cy - tile.y[j], space.period_y);
            const float dy = std::max(std::fabs(ey) - node.half_y, 0.0f) * space.aspect;
            const V rise = hn::Max(hn::Sub(hn::Set(d, node.max), height), zero);
            auto matters = Exceeds<kL1>(rise, need, Reach<kL1>(space, dx, hn::Set(d, dy)));
            if (hn::AllFalse(d, matters)) continue;
            // The plane: F(v) = need |v| - (rise of the plane at v) is convex in v, so its tangent at the node's
            // centre bounds it from below over the whole node.
            if (std::fabs(ey) + node.half_y <= 0.5f * space.period_y) {
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

/// Whether a texel may raise any need of the tile: cheap, and true too often for near texels only.
template <bool kL1>
HWY_INLINE bool MayRaise(const SearchSpace& space, const Tile& tile, float bx, float by, float height) {
    const D d;
    const V high = hn::Set(d, height);
    for (int i = 0; i < tile_size; i += int(hn::Lanes(d))) {
        const V dx = hn::Abs(NearestImage(hn::Sub(hn::Set(d, bx), hn::Load(d, tile.x + i)), space.period_x));
        const V along = kL1 ? dx : hn::Sub(hn::Mul(dx, dx), hn::Set(d, space.deflation));
        auto better = hn::Gt(high, high);
        for (int j = 0; j < tile_size; ++j) {
            const float dy = std::fabs(NearestImage(by - tile.y[j], space.period_y)) * space.aspect;
            const V reach = hn::Add(along, hn::Set(d, kL1 ? dy : dy * dy));
            const V rise = hn::Max(hn::Sub(high, hn::Load(d, tile.height + j * tile_size + i)), hn::Zero(d));
            better = hn::Or(better, Exceeds<kL1>(rise, hn::Load(d, tile.need + j * tile_size + i), reach));
        }
        if (!hn::AllFalse(d, better)) return true;
    }
    return false;
}

/// Compares one texel with the whole tile and keeps what it asks for. Returns whether anything was raised.
template <bool kL1>
bool CompareTexel(const SearchSpace& space, Tile& tile, float bx, float by, float height) {
    if (!MayRaise<kL1>(space, tile, bx, by, height)) return false;
    const D d;
    bool raised = false;
    const V near = hn::Set(d, float(near_radius) + 0.5f);
    for (int i = 0; i < tile_size; i += int(hn::Lanes(d))) {
        const V dx = hn::Abs(NearestImage(hn::Sub(hn::Set(d, bx), hn::Load(d, tile.x + i)), space.period_x));
        for (int j = 0; j < tile_size; ++j) {
            const int at = j * tile_size + i;
            const float dy = std::fabs(NearestImage(by - tile.y[j], space.period_y));
            const V need = hn::Load(d, tile.need + at);
            const V rise = hn::Max(hn::Sub(hn::Set(d, height), hn::Load(d, tile.height + at)), hn::Zero(d));
            const V reach = Reach<kL1>(space, dx, hn::Set(d, dy * space.aspect));
            const auto far = hn::Gt(hn::Max(dx, hn::Set(d, dy)), near);
            const auto better = hn::And(Exceeds<kL1>(rise, need, reach), far);
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
std::uint32_t LeafCandidates(const SearchSpace& space, const Tile& tile, const LeafTexels& leaf, float threshold) {
    const HWY_CAPPED(float, MaxPyramid::leaf_size) d;
    static_assert(MaxPyramid::leaf_size == 4);
    std::uint32_t bits = 0;
    for (int i = 0; i < MaxPyramid::leaf_size; i += int(hn::Lanes(d))) {
        auto dx = hn::Abs(hn::Sub(hn::Iota(d, leaf.x + float(i)), hn::Set(d, tile.centre_x)));
        dx = hn::Max(hn::Sub(hn::Min(dx, hn::Sub(hn::Set(d, space.period_x), dx)), hn::Set(d, tile.half_x)), hn::Zero(d));
        for (int j = 0; j < MaxPyramid::leaf_size; ++j) {
            float dy = std::fabs(leaf.y + float(j) - tile.centre_y);
            dy = std::max(std::min(dy, space.period_y - dy) - tile.half_y, 0.0f) * space.aspect;
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

std::uint32_t QuadNeedsL2(const SearchSpace& s, const Tile& t, const PyramidQuad& q, const QuadPlace& p, float need,
                          QuadBounds& b) {
    return QuadNeeds<false>(s, t, q, p, need, b);
}
std::uint32_t QuadNeedsL1(const SearchSpace& s, const Tile& t, const PyramidQuad& q, const QuadPlace& p, float need,
                          QuadBounds& b) {
    return QuadNeeds<true>(s, t, q, p, need, b);
}
bool TileNeedsL2(const SearchSpace& s, const Tile& t, const PyramidNode& n, float shrink) {
    return TileNeeds<false>(s, t, n, shrink);
}
bool TileNeedsL1(const SearchSpace& s, const Tile& t, const PyramidNode& n, float shrink) {
    return TileNeeds<true>(s, t, n, shrink);
}
bool CompareTexelL2(const SearchSpace& s, Tile& t, float x, float y, float h) { return CompareTexel<false>(s, t, x, y, h); }
bool CompareTexelL1(const SearchSpace& s, Tile& t, float x, float y, float h) { return CompareTexel<true>(s, t, x, y, h); }

} // namespace HWY_NAMESPACE
} // namespace reliefbake
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace reliefbake {
HWY_EXPORT(QuadNeedsL2);
HWY_EXPORT(QuadNeedsL1);
HWY_EXPORT(TileNeedsL2);
HWY_EXPORT(TileNeedsL1);
HWY_EXPORT(CompareTexelL2);
HWY_EXPORT(CompareTexelL1);
HWY_EXPORT(SummariseNeeds);
HWY_EXPORT(LeafCandidates);

TileKernels tile_kernels(bool l1) {
    hwy::GetChosenTarget().Update(hwy::SupportedTargets()); // so that the addresses are final
    return {l1 ? &HWY_DYNAMIC_DISPATCH(QuadNeedsL1) : &HWY_DYNAMIC_DISPATCH(QuadNeedsL2),
            l1 ? &HWY_DYNAMIC_DISPATCH(TileNeedsL1) : &HWY_DYNAMIC_DISPATCH(TileNeedsL2),
            l1 ? &HWY_DYNAMIC_DISPATCH(CompareTexelL1) : &HWY_DYNAMIC_DISPATCH(CompareTexelL2),
            &HWY_DYNAMIC_DISPATCH(LeafCandidates), &HWY_DYNAMIC_DISPATCH(SummariseNeeds)};
}

} // namespace reliefbake
#endif // HWY_ONCE
