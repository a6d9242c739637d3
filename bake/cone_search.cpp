// For each tile of texels the pyramid is walked once, all texels of the tile in SIMD lanes. A node is left when no
// texel of the tile could get a narrower cone from it: by its maximum, or by its plane (MATHS section 2).
// Texels start from the slope that their neighbourhood needs anyway, so most walks only confirm it.

#include "bake/cone_search.h"

#include "bake/parallel.h"

#include <algorithm>
#include <atomic>
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

/// Derivative of the length along one component `e`.
template <bool kL1>
HWY_INLINE V Direction(V e, V length) {
    const D d;
    return kL1 ? hn::CopySign(hn::Set(d, 1.0f), e) : hn::Div(e, length);
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

/// The rows of the tile, among `rows`, with a texel that may need the node.
template <bool kL1>
std::uint32_t RowsThatNeed(const SearchSpace& space, const Tile& tile, const PyramidNode& node, std::uint32_t rows) {
    const D d;
    const V factor = hn::Set(d, space.tolerance_factor), zero = hn::Zero(d);
    const V half_x = hn::Set(d, node.half_x), half_y = hn::Set(d, node.half_y * space.aspect);
    const V gx = hn::Set(d, node.gx), gy = hn::Set(d, node.gy / space.aspect);
    std::uint32_t found = 0;
    for (int i = 0; i < tile_size; i += int(hn::Lanes(d))) {
        const V ex = NearestImage(hn::Sub(hn::Set(d, node.cx), hn::Load(d, tile.x + i)), space.period_x);
        const V dx = hn::Max(hn::Sub(hn::Abs(ex), half_x), zero);
        // The plane is meant for one image of the node: not where another one may be as near.
        const auto one_image = hn::Le(hn::Add(hn::Abs(ex), half_x), hn::Set(d, 0.5f * space.period_x));
        for (std::uint32_t left = rows & ~found; left != 0; left &= left - 1) {
            const int j = int(hwy::Num0BitsBelowLS1Bit_Nonzero32(left)), at = j * tile_size + i;
            const V need = hn::Mul(hn::Load(d, tile.need + at), factor);
            const V height = hn::Load(d, tile.height + at);
            const float ey = NearestImage(node.cy - tile.y[j], space.period_y);
            const float dy = std::max(std::fabs(ey) - node.half_y, 0.0f) * space.aspect;
            const V reach = Reach<kL1>(space, dx, hn::Set(d, dy));
            const V rise = hn::Max(hn::Sub(hn::Set(d, node.max), height), zero);
            auto matters = Exceeds<kL1>(rise, need, reach);
            if (hn::AllFalse(d, matters)) continue;
            // Second chance, the plane: F(v) = need |v| - (rise of the plane at v) is convex in v, so its tangent at
            // the node's centre bounds it from below over the whole node.
            if (std::fabs(ey) + node.half_y <= 0.5f * space.period_y) {
                const V vy = hn::Set(d, ey * space.aspect);
                const V distance = Length<kL1>(ex, vy);
                const V slope = kL1 ? need : hn::Mul(need, hn::Sqrt(hn::Div(reach, hn::Add(reach, hn::Set(d, space.deflation)))));
                const V spare = hn::Sub(hn::Mul(slope, distance), hn::Sub(hn::Set(d, node.plane), height));
                const V fall_x = hn::Mul(hn::Abs(hn::Sub(hn::Mul(slope, Direction<kL1>(ex, distance)), gx)), half_x);
                const V fall_y = hn::Mul(hn::Abs(hn::Sub(hn::Mul(slope, Direction<kL1>(vy, distance)), gy)), half_y);
                const auto held = hn::Ge(spare, hn::Add(fall_x, fall_y));
                matters = hn::AndNot(hn::And(held, one_image), matters);
            }
            if (!hn::AllFalse(d, matters)) found |= 1u << j;
        }
    }
    return found;
}

/// Compares one texel with the tile's `rows` and keeps what it asks for. Returns whether anything was raised.
template <bool kL1>
bool CompareTexel(const SearchSpace& space, Tile& tile, float bx, float by, float height, std::uint32_t rows) {
    const D d;
    bool raised = false;
    const V near = hn::Set(d, float(near_radius) + 0.5f);
    for (int i = 0; i < tile_size; i += int(hn::Lanes(d))) {
        const V dx = hn::Abs(NearestImage(hn::Sub(hn::Set(d, bx), hn::Load(d, tile.x + i)), space.period_x));
        for (std::uint32_t left = rows; left != 0; left &= left - 1) {
            const int j = int(hwy::Num0BitsBelowLS1Bit_Nonzero32(left)), at = j * tile_size + i;
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

float LeastNeed(const Tile& tile) {
    const D d;
    V least = hn::Load(d, tile.need);
    for (int at = 0; at < tile_texels; at += int(hn::Lanes(d))) least = hn::Min(least, hn::Load(d, tile.need + at));
    return hn::GetLane(hn::MinOfLanes(d, least));
}

std::uint32_t RowsThatNeedL2(const SearchSpace& s, const Tile& t, const PyramidNode& n, std::uint32_t rows) {
    return RowsThatNeed<false>(s, t, n, rows);
}
std::uint32_t RowsThatNeedL1(const SearchSpace& s, const Tile& t, const PyramidNode& n, std::uint32_t rows) {
    return RowsThatNeed<true>(s, t, n, rows);
}
bool CompareTexelL2(const SearchSpace& s, Tile& t, float x, float y, float h, std::uint32_t rows) {
    return CompareTexel<false>(s, t, x, y, h, rows);
}
bool CompareTexelL1(const SearchSpace& s, Tile& t, float x, float y, float h, std::uint32_t rows) {
    return CompareTexel<true>(s, t, x, y, h, rows);
}

} // namespace HWY_NAMESPACE
} // namespace reliefbake
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace reliefbake {
HWY_EXPORT(RowsThatNeedL2);
HWY_EXPORT(RowsThatNeedL1);
HWY_EXPORT(CompareTexelL2);
HWY_EXPORT(CompareTexelL1);
HWY_EXPORT(LeastNeed);

namespace {

constexpr std::uint32_t all_rows = (1u << tile_size) - 1;

struct NodeRef {
    int level, i, j;
    float rise_sq_per_reach; ///< tile-wide bound of the slope; the steepest is visited first
    std::uint32_t rows;      ///< rows of the tile that its parent mattered to
};

class TileSearch {
  public:
    TileSearch(const SearchSurface& surface, const MaxPyramid& pyramid, const SearchSpace& space)
        : surface_(surface), pyramid_(pyramid), space_(space),
          rows_that_need_(space.l1 ? &HWY_DYNAMIC_DISPATCH(RowsThatNeedL1) : &HWY_DYNAMIC_DISPATCH(RowsThatNeedL2)),
          compare_texel_(space.l1 ? &HWY_DYNAMIC_DISPATCH(CompareTexelL1) : &HWY_DYNAMIC_DISPATCH(CompareTexelL2)),
          least_need_(&HWY_DYNAMIC_DISPATCH(LeastNeed)) {}

    /// Leaves in tile.found the largest far slope of each texel that exceeds its need; 0 where none does.
    void run(int tile_x, int tile_y, const Image<float>& needs) {
        load(tile_x, tile_y, needs);
        stack_.clear();
        push_if_it_matters(pyramid_.level_count() - 1, 0, 0, all_rows);
        while (!stack_.empty()) {
            const NodeRef ref = stack_.back();
            stack_.pop_back();
            if (ref.rise_sq_per_reach <= threshold_) continue; // the needs have risen since
            ++visits_;
            const PyramidNode& node = pyramid_.level(ref.level).at(ref.i, ref.j);
            const std::uint32_t rows = rows_that_need_(space_, tile_, node, ref.rows);
            if (rows == 0) continue;
            if (ref.level == 0)
                compare_leaf(ref.i, ref.j, rows);
            else
                push_children(ref, rows);
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
        const int x1 = std::min(x0 + tile_size, w) - 1, y1 = std::min(y0 + tile_size, h) - 1;
        tile_.centre_x = 0.5f * float(x0 + x1), tile_.half_x = 0.5f * float(x1 - x0);
        tile_.centre_y = 0.5f * float(y0 + y1), tile_.half_y = 0.5f * float(y1 - y0);
        refresh_threshold();
    }

    void refresh_threshold() {
        const float need = least_need_(tile_) * space_.tolerance_factor;
        threshold_ = need * need;
    }

    /// Bound over the tile and the node of (rise / distance)^2.
    float tile_bound(float height, float cx, float cy, float half_x, float half_y) const {
        float dx = std::fabs(cx - tile_.centre_x), dy = std::fabs(cy - tile_.centre_y);
        dx = std::max(std::min(dx, space_.period_x - dx) - (half_x + tile_.half_x), 0.0f);
        dy = std::max(std::min(dy, space_.period_y - dy) - (half_y + tile_.half_y), 0.0f) * space_.aspect;
        const float rise = std::max(height - tile_.lowest, 0.0f);
        const float sq = space_.l1 ? (dx + dy) * (dx + dy) : dx * dx + dy * dy;
        return rise * rise / (std::max(sq, space_.near_distance_sq) - space_.deflation);
    }

    void push_if_it_matters(int level, int i, int j, std::uint32_t rows) {
        const PyramidNode& node = pyramid_.level(level).at(i, j);
        const float bound = tile_bound(node.max, node.cx, node.cy, node.half_x, node.half_y);
        if (bound > threshold_) stack_.push_back({level, i, j, bound, rows});
    }

    void push_children(const NodeRef& ref, std::uint32_t rows) {
        const MaxPyramid::Level& below = pyramid_.level(ref.level - 1);
        const std::size_t first = stack_.size();
        for (int j = 2 * ref.j; j < std::min(2 * ref.j + 2, below.height); ++j)
            for (int i = 2 * ref.i; i < std::min(2 * ref.i + 2, below.width); ++i)
                push_if_it_matters(ref.level - 1, i, j, rows);
        std::sort(stack_.begin() + std::ptrdiff_t(first), stack_.end(),
                  [](const NodeRef& a, const NodeRef& b) { return a.rise_sq_per_reach < b.rise_sq_per_reach; });
    }

    void compare_leaf(int i, int j, std::uint32_t rows) {
        constexpr int s = MaxPyramid::leaf_size;
        bool raised = false;
        for (int y = j * s; y < std::min(j * s + s, surface_.grid.height); ++y)
            for (int x = i * s; x < std::min(i * s + s, surface_.grid.width); ++x) {
                const float height = surface_.height(x, y);
                if (tile_bound(height, float(x), float(y), 0, 0) > threshold_)
                    raised |= compare_texel_(space_, tile_, float(x), float(y), height, rows);
            }
        if (raised) refresh_threshold();
    }

    const SearchSurface& surface_;
    const MaxPyramid& pyramid_;
    const SearchSpace& space_;
    std::uint32_t (*rows_that_need_)(const SearchSpace&, const Tile&, const PyramidNode&, std::uint32_t rows);
    bool (*compare_texel_)(const SearchSpace&, Tile&, float x, float y, float height, std::uint32_t rows);
    float (*least_need_)(const Tile&);
    Tile tile_;
    float threshold_ = 0; ///< square of the least slope that still matters to the tile
    std::vector<NodeRef> stack_;
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
