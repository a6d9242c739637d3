#include "bake/near_kernels.h"

#include <algorithm>
#include <cmath>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "bake/near_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace reliefbake {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using D = HWY_CAPPED(float, 8);
using V = hn::Vec<D>;

/// out[x] = slopes of a row's points towards their rings.
template <bool kFrom>
void RingSlopesOf(const RingRows& rows, const Rings& rings, int count, float* out) {
    const D d;
    const V slack = hn::Set(d, rows.slack);
    constexpr int run = 4; // vectors at a time: a neighbour's offset is loaded once for all
    const int lanes = int(hn::Lanes(d));
    for (int x = 0; x < count; x += run * lanes) {
        V own[run], best[run], high[run];
        for (int k = 0; k < run; ++k) own[k] = hn::LoadU(d, rows.own + x + k * lanes), best[k] = hn::Set(d, rows.least);
        for (const Ring& ring : rings.rings) {
            for (int k = 0; k < run; ++k) high[k] = own[k];
            for (std::size_t n = ring.begin; n < ring.end; ++n) {
                const float* other = rows.other + x + rings.offsets[n];
                const float* from = kFrom ? rows.from + x + rings.offsets[n] : nullptr;
                for (int k = 0; k < run; ++k) {
                    V h = hn::LoadU(d, other + k * lanes);
                    if (kFrom) h = hn::IfThenElse(hn::Lt(hn::LoadU(d, from + k * lanes), hn::Set(d, ring.reach)), h, own[k]);
                    high[k] = hn::Max(high[k], h);
                }
            }
            const V inverse = hn::Set(d, ring.inverse_distance);
            for (int k = 0; k < run; ++k) {
                const V rise = hn::Add(hn::Sub(high[k], own[k]), slack);
                best[k] = hn::Max(best[k], hn::Mul(rise, inverse));
            }
        }
        for (int k = 0; k < run; ++k) hn::StoreU(best[k], d, out + x + k * lanes);
    }
}

void RingSlopes(const RingRows& rows, const Rings& rings, int count, float* out) {
    if (rows.from) RingSlopesOf<true>(rows, rings, count, out);
    else RingSlopesOf<false>(rows, rings, count, out);
}

HWY_INLINE V Positive(V a) { return hn::Max(a, hn::Zero(D())); }
HWY_INLINE V Square(V a) { return hn::Mul(a, a); }
HWY_INLINE V NormSquare(V a, V b) { return hn::Add(Square(a), Square(b)); }

/// sup over t in [0, rho] of (a + t b) / sqrt(1 + t^2), positive part, squared: from a cell's corner to its far edge.
/// (WedgeSlope from 0; apart, because that costs the default bake 3 ns/texel more.)
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

/// sup over t0 <= t <= t1 of (a + t b) / sqrt(1 + t^2), positive part, squared: the steepest of the directions (1, t) on a plane
/// with gradient (a, b). The quotient rises up to t = b / a (a > 0), so it is largest there or at an end.
HWY_INLINE V WedgeSlope(V a, V b, float t0, float t1) {
    const D d;
    const auto at = [&](float t) {
        if (!(t < 1e30f)) return Square(Positive(b));
        const V rise = Positive(hn::Add(a, hn::Mul(hn::Set(d, t), b)));
        return hn::Mul(Square(rise), hn::Set(d, 1.0f / (1.0f + t * t)));
    };
    const V at_ends = hn::Max(at(t0), at(t1));
    auto inside = hn::And(hn::Gt(a, hn::Zero(d)), hn::Ge(b, hn::Mul(hn::Set(d, t0), a)));
    if (t1 < 1e30f) inside = hn::And(inside, hn::Le(b, hn::Mul(hn::Set(d, t1), a)));
    return hn::IfThenElse(inside, NormSquare(a, b), at_ends);
}

/// Squared supremum of the slope from any point of a cell to any point at most one texel away in the wedge (dx, dy >= 0). With
/// `fall`, only where the cell of the second point, or one that shares its wall or corner with it, counts.
void WedgeCellSlopes(const WedgeCells& cells, int count, float* out) {
    const D d;
    const float t0 = cells.t0, t1 = cells.t1, rx = cells.aspect, ry = 1.0f / cells.aspect;
    // In (1, t) with t along y a far wall on the right is reached up to t = rx; one below from 1 / t = ry down, t = rx up.
    const float side_end = std::min(t1, rx), below_start = std::max(t0, rx);
    const bool to_side = t0 <= rx, to_below = t1 >= rx;
    const V inv_pitch_y = hn::Set(d, ry);
    for (int x = 0; x < count; x += int(hn::Lanes(d))) {
        V h[4][4], gx[4][3], gy[4][3]; // only [1..3] are used: the cell and its neighbours right and below
        for (int j = 1; j < 4; ++j)
            for (int i = 1; i < 4; ++i) h[j][i] = hn::LoadU(d, cells.rows[j] + x - 1 + i);
        for (int j = 1; j < 4; ++j)
            for (int i = 1; i < 3; ++i) gx[j][i] = hn::Sub(h[j][i + 1], h[j][i]);
        for (int i = 1; i < 4; ++i)
            for (int j = 1; j < 3; ++j) gy[i][j] = hn::Mul(hn::Sub(h[j + 1][i], h[j][i]), inv_pitch_y);
        const auto slope = [&](V a, V b) { return WedgeSlope(a, b, t0, t1); };
        const auto far_side = [&](V a, V b) { return to_side ? WedgeSlope(a, b, t0, side_end) : hn::Zero(d); };
        const auto far_below = [&](V a, V b) { return to_below ? WedgeSlope(a, b, below_start, t1) : hn::Zero(d); };
        // Own cell; right; below; the corner between (docs/SAFETY.md, "Up to one texel", one quadrant of it).
        V own = hn::Max(hn::Max(slope(gx[1][1], gy[1][1]), slope(gx[1][1], gy[2][1])),
                        hn::Max(slope(gx[2][1], gy[1][1]), slope(gx[2][1], gy[2][1])));
        V right = hn::Max(slope(hn::Max(gx[1][2], gx[2][2]), gy[2][1]), far_side(gx[1][2], gy[3][1]));
        V below = hn::Max(slope(gx[2][1], hn::Max(gy[1][2], gy[2][2])), far_below(gx[3][1], gy[1][2]));
        V corner = hn::Max(slope(gx[2][2], gy[2][2]), hn::Max(far_side(gx[2][2], gy[3][2]), far_below(gx[3][2], gy[2][2])));
        if (cells.fall) {
            const V never = hn::Set(d, std::numeric_limits<float>::infinity()), zero = hn::Zero(d);
            const auto counts = [&](int j, int i) { return hn::Lt(hn::LoadU(d, cells.fall[j] + x + i), never); };
            const auto at_own = counts(0, 0), at_right = counts(0, 1), at_below = counts(1, 0), at_corner = counts(1, 1);
            // A chord within the own cell that ends on a wall counts for the cell beyond. One that peaks inside is a parabola,
            // whose chord from the start to the peak is half as steep as its start.
            const auto beyond = hn::Or(at_right, hn::Or(at_below, at_corner));
            own = hn::IfThenElse(beyond, own, hn::IfThenElseZero(at_own, hn::Mul(own, hn::Set(d, 0.25f))));
            right = hn::IfThenElse(hn::Or(at_right, at_corner), right, zero);
            below = hn::IfThenElse(hn::Or(at_below, at_corner), below, zero);
            corner = hn::IfThenElseZero(at_corner, corner);
        }
        hn::StoreU(hn::Max(hn::Max(own, right), hn::Max(below, corner)), d, out + x);
    }
}

/// out[x] = the largest of the slopes over the footprint of texel x: its texels, half texels and cells.
void FootprintSlopes(const FootprintRows& s, int first, int count, float* out) {
    const D d;
    const Footprint f = s.footprint;
    for (int x = first; x < first + count; x += int(hn::Lanes(d))) {
        V best = hn::Zero(d), square = hn::Zero(d);
        const auto take = [&](const float* plane, int i, int j) {
            best = hn::Max(best, hn::LoadU(d, plane + j * s.stride + x + i));
        };
        for (int j = f.y_low; j <= f.y_high; ++j)
            for (int i = f.x_low; i <= f.x_high; ++i) {
                take(s.texels, i, j);
                if (!s.cells) continue;
                take(s.lattice[0], i, j);
                if (i < f.x_high) take(s.lattice[1], i, j);
                if (j < f.y_high) take(s.lattice[2], i, j);
                if (i == f.x_high || j == f.y_high) continue;
                take(s.lattice[3], i, j);
                square = hn::Max(square, hn::LoadU(d, s.cells + j * s.stride + x + i));
            }
        hn::StoreU(hn::Max(best, hn::Sqrt(square)), d, out + x - first);
    }
}

} // namespace HWY_NAMESPACE
} // namespace reliefbake
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace reliefbake {
HWY_EXPORT(RingSlopes);
HWY_EXPORT(CellSlopes);
HWY_EXPORT(WedgeCellSlopes);
HWY_EXPORT(FootprintSlopes);

NearKernels near_kernels() {
    hwy::GetChosenTarget().Update(hwy::SupportedTargets()); // so that the addresses are final
    return {&HWY_DYNAMIC_DISPATCH(RingSlopes), &HWY_DYNAMIC_DISPATCH(CellSlopes), &HWY_DYNAMIC_DISPATCH(WedgeCellSlopes),
            &HWY_DYNAMIC_DISPATCH(FootprintSlopes)};
}

} // namespace reliefbake
#endif // HWY_ONCE
