// For each tile of texels the pyramid is walked once, all texels of the tile in SIMD lanes. A node is left when no
// texel of the tile could get a narrower cone from it: by its maximum, or by its plane (MATHS section 2).
// Texels start from the slope that their neighbourhood needs anyway, so most walks only confirm it.

#include "bake/cone_search.h"

#include "bake/parallel.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "bake/cone_search.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#ifndef RELIEFBAKE_CONE_SEARCH_SHARED
#define RELIEFBAKE_CONE_SEARCH_SHARED
namespace reliefbake {

constexpr int tile_size = 8;
constexpr int tile_texels = tile_size * tile_size;

/// The metric, periods and limits of a search. Distances in texels; y is scaled by the pixel aspect.
struct SearchSpace {
    float aspect;
    float period_x, period_y; ///< texels until the map repeats; +inf when clamped
    float deflation;          ///< of squared distances
    float near_distance_sq;   ///< no far pair is closer
    float tolerance_factor;   ///< 1 + tolerance
    bool l1;
};

/// The state of one tile. `need` is the slope that a far texel must exceed to matter, `found` the largest that did.
struct alignas(32) Tile {
    float x[tile_size], y[tile_size];
    float height[tile_texels], need[tile_texels], found[tile_texels];
    float half_lowest[2 * tile_size], half_need[2 * tile_size]; ///< least of each half column
    float centre_x, centre_y, half_x, half_y, lowest;
};

} // namespace reliefbake
#endif

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

/// Whether a box of this height may matter to any texel of a half column; a first, cheap test for four rows.
/// `dx`: distance along x to the box, whose centre and half extent along y are given.
template <bool kL1>
HWY_INLINE bool HalfColumnsNeed(const SearchSpace& space, const Tile& tile, int half, int i, float height, V dx,
                                float centre_y, float half_y, V factor) {
    const D d;
    constexpr int rows = tile_size / 2;
    const float middle = 0.5f * (tile.y[half * rows] + tile.y[half * rows + rows - 1]);
    const float gap = std::fabs(NearestImage(centre_y - middle, space.period_y)) - half_y - 0.5f * (rows - 1);
    const V reach = Reach<kL1>(space, dx, hn::Set(d, std::max(gap, 0.0f) * space.aspect));
    const V lowest = hn::Load(d, tile.half_lowest + half * tile_size + i);
    const V need = hn::Mul(hn::Load(d, tile.half_need + half * tile_size + i), factor);
    const V rise = hn::Max(hn::Sub(hn::Set(d, height), lowest), hn::Zero(d));
    return !hn::AllFalse(d, Exceeds<kL1>(rise, need, reach));
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
            if (j % (tile_size / 2) == 0 && !HalfColumnsNeed<kL1>(space, tile, j / (tile_size / 2), i, node.max, dx,
                                                                  node.cy, node.half_y, factor)) {
                j += tile_size / 2 - 1;
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

/// Compares one texel with the whole tile and keeps what it asks for. Returns whether anything was raised.
template <bool kL1>
bool CompareTexel(const SearchSpace& space, Tile& tile, float bx, float by, float height) {
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

/// Texels of a leaf row that may exceed the tile's least need, as bits.
std::uint32_t LeafCandidates(const SearchSpace& space, const Tile& tile, const float* heights, float x, float y,
                             float threshold) {
    const HWY_CAPPED(float, MaxPyramid::leaf_size) d;
    using W = hn::Vec<decltype(d)>;
    static_assert(MaxPyramid::leaf_size == 4);
    float dy = std::fabs(y - tile.centre_y);
    dy = std::max(std::min(dy, space.period_y - dy) - tile.half_y, 0.0f) * space.aspect;
    std::uint32_t bits = 0;
    for (int i = 0; i < MaxPyramid::leaf_size; i += int(hn::Lanes(d))) {
        const W rise = hn::Max(hn::Sub(hn::LoadU(d, heights + i), hn::Set(d, tile.lowest)), hn::Zero(d));
        W dx = hn::Abs(hn::Sub(hn::Iota(d, x + float(i)), hn::Set(d, tile.centre_x)));
        dx = hn::Max(hn::Sub(hn::Min(dx, hn::Sub(hn::Set(d, space.period_x), dx)), hn::Set(d, tile.half_x)), hn::Zero(d));
        const W sum = hn::Add(dx, hn::Set(d, dy));
        W sq = space.l1 ? hn::Mul(sum, sum) : hn::Add(hn::Mul(dx, dx), hn::Set(d, dy * dy));
        sq = hn::Sub(hn::Max(sq, hn::Set(d, space.near_distance_sq)), hn::Set(d, space.deflation));
        const auto matters = hn::Gt(hn::Mul(rise, rise), hn::Mul(hn::Set(d, threshold), sq));
        std::uint8_t mask[8] = {};
        hn::StoreMaskBits(d, matters, mask);
        bits |= std::uint32_t(mask[0]) << i;
    }
    return bits;
}

/// Refreshes the half columns' needs; returns the least of all.
float SummariseNeeds(Tile& tile) {
    const D d;
    V least = hn::Load(d, tile.need);
    for (int half = 0; half < 2; ++half)
        for (int i = 0; i < tile_size; i += int(hn::Lanes(d))) {
            constexpr int rows = tile_size / 2;
            V low = hn::Load(d, tile.need + half * rows * tile_size + i);
            for (int j = 1; j < rows; ++j) low = hn::Min(low, hn::Load(d, tile.need + (half * rows + j) * tile_size + i));
            hn::Store(low, d, tile.half_need + half * tile_size + i);
            least = hn::Min(least, low);
        }
    return hn::GetLane(hn::MinOfLanes(d, least));
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
HWY_EXPORT(TileNeedsL2);
HWY_EXPORT(TileNeedsL1);
HWY_EXPORT(CompareTexelL2);
HWY_EXPORT(CompareTexelL1);
HWY_EXPORT(SummariseNeeds);
HWY_EXPORT(LeafCandidates);

namespace {

struct NodeRef {
    int level, i, j;
    float slope_sq;          ///< square of the tile-wide bound of the slope; the steepest is visited first
    float distance_sq;       ///< least squared distance between tile and node, not deflated
};

struct Witness {
    float x, y, height;
};
constexpr std::size_t witness_count = 16;

class TileSearch {
  public:
    TileSearch(const SearchSurface& surface, const MaxPyramid& pyramid, const SearchSpace& space)
        : surface_(surface), pyramid_(pyramid), space_(space),
          tile_needs_(space.l1 ? &HWY_DYNAMIC_DISPATCH(TileNeedsL1) : &HWY_DYNAMIC_DISPATCH(TileNeedsL2)),
          compare_texel_(space.l1 ? &HWY_DYNAMIC_DISPATCH(CompareTexelL1) : &HWY_DYNAMIC_DISPATCH(CompareTexelL2)),
          summarise_needs_(&HWY_DYNAMIC_DISPATCH(SummariseNeeds)), leaf_candidates_(&HWY_DYNAMIC_DISPATCH(LeafCandidates)) {}

    /// Leaves in tile.found the largest far slope of each texel that exceeds its need; 0 where none does.
    void run(int tile_x, int tile_y, const Image<float>& needs) {
        load(tile_x, tile_y, needs);
        compare_witnesses();
        stack_.clear();
        push_quad(pyramid_.level_count() - 1, 0, 0);
        while (!stack_.empty()) {
            const NodeRef ref = stack_.back();
            stack_.pop_back();
            if (ref.slope_sq <= threshold_) continue; // the needs have risen since
            ++visits_;
            const PyramidNode node = pyramid_.node(ref.level, ref.i, ref.j);
            const float shrink = std::sqrt((ref.distance_sq - space_.deflation) / ref.distance_sq);
            if (!tile_needs_(space_, tile_, node, shrink)) continue;
            if (ref.level == 0)
                compare_leaf(ref.i, ref.j);
            else
                push_quad(ref.level - 1, ref.i, ref.j);
        }
    }

    const Tile& tile() const { return tile_; }
    std::uint64_t visits() const { return visits_; }

  private:
    void load(int tile_x, int tile_y, const Image<float>& needs) {
        const int x0 = tile_x * tile_size, y0 = tile_y * tile_size;
        const int w = surface_.grid.width, h = surface_.grid.height;
        tile_.lowest = std::numeric_limits<float>::infinity();
        for (int j = 0; j < tile_size; ++j) {
            tile_.x[j] = float(x0 + j), tile_.y[j] = float(y0 + j);
            for (int i = 0; i < tile_size; ++i) {
                // Lanes beyond the map repeat its last texel and never need anything.
                const int x = std::min(x0 + i, w - 1), y = std::min(y0 + j, h - 1), at = j * tile_size + i;
                const bool inside = x0 + i < w && y0 + j < h;
                tile_.height[at] = surface_.height(x, y);
                tile_.need[at] = inside ? needs(x, y) : std::numeric_limits<float>::max();
                tile_.found[at] = 0;
                tile_.lowest = std::min(tile_.lowest, tile_.height[at]);
            }
        }
        for (int k = 0; k < 2 * tile_size; ++k) {
            const float* column = tile_.height + (k / tile_size) * (tile_texels / 2) + k % tile_size;
            tile_.half_lowest[k] = std::min({column[0], column[8], column[16], column[24]});
        }
        const int x1 = std::min(x0 + tile_size, w) - 1, y1 = std::min(y0 + tile_size, h) - 1;
        tile_.centre_x = 0.5f * float(x0 + x1), tile_.half_x = 0.5f * float(x1 - x0);
        tile_.centre_y = 0.5f * float(y0 + y1), tile_.half_y = 0.5f * float(y1 - y0);
        refresh_threshold();
    }

    void refresh_threshold() {
        const float need = summarise_needs_(tile_) * space_.tolerance_factor;
        threshold_ = need * need;
    }

    /// Distance along one axis from the tile to a node, for the nearest image.
    static float gap(const MaxPyramid::Span& node, float centre, float half, float period) {
        const float e = std::fabs(node.centre - centre);
        return std::max(std::min(e, period - e) - (node.half + half), 0.0f);
    }

    /// Queues those nodes of a quad of level k whose steepest slope between the boxes of tile and node exceeds some need.
    void push_quad(int k, int i, int j) {
        const PyramidQuad& quad = pyramid_.quad(k, i, j);
        const std::size_t first = stack_.size();
        float dx[2], dy[2];
        for (int c = 0; c < 2; ++c) {
            dx[c] = gap(MaxPyramid::span(k, 2 * i + c, surface_.grid.width), tile_.centre_x, tile_.half_x, space_.period_x);
            dy[c] = gap(MaxPyramid::span(k, 2 * j + c, surface_.grid.height), tile_.centre_y, tile_.half_y, space_.period_y) *
                    space_.aspect;
        }
        for (int c = 0; c < 4; ++c) {
            const float x = dx[c & 1], y = dy[c >> 1];
            const float plain = std::max(space_.l1 ? (x + y) * (x + y) : x * x + y * y, space_.near_distance_sq);
            const float rise = std::max(quad.max[c] - tile_.lowest, 0.0f), deflated = plain - space_.deflation;
            if (rise * rise <= threshold_ * deflated) continue;
            stack_.push_back({k, 2 * i + (c & 1), 2 * j + (c >> 1), rise * rise / deflated, plain});
        }
        // The steepest goes on top: an insertion sort of four at most.
        for (std::size_t a = first + 1; a < stack_.size(); ++a)
            for (std::size_t b = a; b > first && stack_[b].slope_sq < stack_[b - 1].slope_sq; --b)
                std::swap(stack_[b], stack_[b - 1]);
    }

    /// What limited the tile to the left most likely limits this one too. Results do not depend on it, work does.
    void compare_witnesses() {
        bool raised = false;
        for (const Witness& w : witnesses_) raised |= compare_texel_(space_, tile_, w.x, w.y, w.height);
        if (raised) refresh_threshold();
    }

    void remember(float x, float y, float height) {
        if (witnesses_.size() < witness_count)
            witnesses_.push_back({x, y, height});
        else
            witnesses_[next_witness_] = {x, y, height};
        next_witness_ = (next_witness_ + 1) % witness_count;
    }

    void compare_leaf(int i, int j) {
        constexpr int s = MaxPyramid::leaf_size;
        const int x0 = i * s, width = std::min(s, surface_.grid.width - x0);
        for (int y = j * s; y < std::min(j * s + s, surface_.grid.height); ++y) {
            float heights[s];
            for (int k = 0; k < s; ++k) heights[k] = surface_.height(x0 + std::min(k, width - 1), y);
            std::uint32_t bits = leaf_candidates_(space_, tile_, heights, float(x0), float(y), threshold_);
            bool raised = false;
            for (bits &= (1u << width) - 1; bits != 0; bits &= bits - 1) {
                const int k = std::countr_zero(bits);
                if (!compare_texel_(space_, tile_, float(x0 + k), float(y), heights[k])) continue;
                remember(float(x0 + k), float(y), heights[k]);
                raised = true;
            }
            if (raised) refresh_threshold();
        }
    }

    const SearchSurface& surface_;
    const MaxPyramid& pyramid_;
    const SearchSpace& space_;
    bool (*tile_needs_)(const SearchSpace&, const Tile&, const PyramidNode&, float shrink);
    bool (*compare_texel_)(const SearchSpace&, Tile&, float x, float y, float height);
    float (*summarise_needs_)(Tile&);
    std::uint32_t (*leaf_candidates_)(const SearchSpace&, const Tile&, const float*, float x, float y, float threshold);
    Tile tile_;
    float threshold_ = 0; ///< square of the least slope that still matters to the tile
    std::vector<NodeRef> stack_;
    std::vector<Witness> witnesses_; ///< the last texels that raised a need
    std::size_t next_witness_ = 0;
    std::uint64_t visits_ = 0;
};

SearchSpace make_space(const SearchSurface& surface, float tolerance) {
    const TexelGrid& grid = surface.grid;
    const float inf = std::numeric_limits<float>::infinity();
    SearchSpace space{};
    space.aspect = float(grid.pixel_aspect);
    space.period_x = grid.wrap_x == Wrap::repeat ? float(grid.width) : inf;
    space.period_y = grid.wrap_y == Wrap::repeat ? float(grid.height) : inf;
    space.deflation = surface.distance_deflation();
    const float nearest = float(near_radius + 1) * std::min(1.0f, space.aspect);
    space.near_distance_sq = nearest * nearest;
    space.tolerance_factor = 1 + tolerance;
    space.l1 = surface.metric == Metric::l1;
    return space;
}

/// Smallest of the 3x3 values around a texel (its own outside footprints): what a far slope there must exceed before
/// it can raise any cone.
Image<float> footprint_minimum(const SearchSurface& surface, const Image<float>& slopes, int threads) {
    Image<float> out(slopes.width(), slopes.height());
    const TexelGrid& g = surface.grid;
    parallel_for(g.height, threads, [&](int y) {
        const float* rows[3] = {slopes.row(g.address_y(y - 1)), slopes.row(y), slopes.row(g.address_y(y + 1))};
        for (int x = 0; x < g.width; ++x) {
            const int xs[3] = {g.address_x(x - 1), x, g.address_x(x + 1)};
            float least = slopes(x, y);
            for (const float* row : rows)
                for (int i : xs) least = std::min(least, row[i]);
            out(x, y) = least;
        }
    });
    return out;
}

/// slopes = factor * max(slopes, largest of the footprint's far slopes).
void raise_by_footprint(const SearchSurface& surface, const Image<float>& found, float factor, int threads,
                        Image<float>& slopes) {
    const TexelGrid& g = surface.grid;
    parallel_for(g.height, threads, [&](int y) {
        const float* rows[3] = {found.row(g.address_y(y - 1)), found.row(y), found.row(g.address_y(y + 1))};
        for (int x = 0; x < g.width; ++x) {
            const int xs[3] = {g.address_x(x - 1), x, g.address_x(x + 1)};
            float most = found(x, y);
            if (surface.has_footprint())
                for (const float* row : rows)
                    for (int i : xs) most = std::max(most, row[i]);
            slopes(x, y) = factor * std::max(slopes(x, y), most);
        }
    });
}

} // namespace

std::uint64_t search_far_slopes(const SearchSurface& surface, const MaxPyramid& pyramid, float tolerance, int threads,
                                Image<float>& slopes) {
    hwy::GetChosenTarget().Update(hwy::SupportedTargets()); // so that the kernels' addresses are final
    const SearchSpace space = make_space(surface, tolerance);
    const int width = surface.grid.width, height = surface.grid.height;
    const Image<float> needs = surface.has_footprint() ? footprint_minimum(surface, slopes, threads) : slopes;
    Image<float> found(width, height);
    std::atomic<std::uint64_t> visits = 0;
    const int tiles_x = (width + tile_size - 1) / tile_size, tiles_y = (height + tile_size - 1) / tile_size;
    parallel_for(tiles_y, threads, [&](int ty) {
        TileSearch search(surface, pyramid, space);
        for (int tx = 0; tx < tiles_x; ++tx) {
            search.run(tx, ty, needs);
            for (int j = 0; j < tile_size && ty * tile_size + j < height; ++j)
                for (int i = 0; i < tile_size && tx * tile_size + i < width; ++i)
                    found(tx * tile_size + i, ty * tile_size + j) = search.tile().found[j * tile_size + i];
        }
        visits += search.visits();
    });
    // What was pruned may exceed what was needed or found by the tolerance.
    raise_by_footprint(surface, found, space.tolerance_factor, threads, slopes);
    return visits;
}

} // namespace reliefbake
#endif // HWY_ONCE
