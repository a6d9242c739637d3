// For each tile of texels the pyramid is walked once, all texels of the tile in SIMD lanes. A node is left when no
// texel of the tile could get a narrower cone from it: by its maximum, or by its plane (MATHS section 2; docs/SAFETY.md).
// Texels start from the slope that their neighbourhood needs anyway, so most walks only confirm it.

#include "bake/cone_search.h"

#include "bake/parallel.h"
#include "bake/tile_kernels.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

namespace reliefbake {
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
        : surface_(surface), pyramid_(pyramid), space_(space), kernels_(tile_kernels(space.l1)) {}

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
            if (!kernels_.tile_needs(space_, tile_, node, shrink)) continue;
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
        for (int k = 0; k < tile_strips * tile_size; ++k) {
            const float* column = tile_.height + k / tile_size * strip_rows * tile_size + k % tile_size;
            tile_.strip_lowest[k] = std::min({column[0], column[tile_size], column[2 * tile_size], column[3 * tile_size]});
        }
        const int x1 = std::min(x0 + tile_size, w) - 1, y1 = std::min(y0 + tile_size, h) - 1;
        tile_.centre_x = 0.5f * float(x0 + x1), tile_.half_x = 0.5f * float(x1 - x0);
        tile_.centre_y = 0.5f * float(y0 + y1), tile_.half_y = 0.5f * float(y1 - y0);
        lay_floor();
        refresh_threshold();
    }

    /// A plane under the tile's texels. Any slopes are right; good ones are those between the means of its halves.
    void lay_floor() {
        float left = 0, right = 0, top = 0, bottom = 0, largest = 0;
        for (int at = 0; at < tile_texels; ++at) {
            (at % tile_size < tile_size / 2 ? left : right) += tile_.height[at];
            (at < tile_texels / 2 ? top : bottom) += tile_.height[at];
            largest = std::max(largest, std::fabs(tile_.height[at]));
        }
        constexpr float between_halves = 0.5f * tile_size * (0.5f * tile_texels);
        tile_.gx = (right - left) / between_halves, tile_.gy = (bottom - top) / between_halves;
        tile_.floor = std::numeric_limits<float>::infinity();
        for (int at = 0; at < tile_texels; ++at) {
            const float dx = tile_.x[at % tile_size] - tile_.centre_x, dy = tile_.y[at / tile_size] - tile_.centre_y;
            tile_.floor = std::min(tile_.floor, tile_.height[at] - (tile_.gx * dx + tile_.gy * dy));
        }
        tile_.floor -= 2 * plane_slack * largest; // with the plane's own rise, up to three times as high
    }

    void refresh_threshold() {
        least_need_ = kernels_.summarise_needs(tile_) * space_.tolerance_factor;
        threshold_ = least_need_ * least_need_;
    }

    /// From the tile's centre to a node's, for the nearest image.
    static float towards(const MaxPyramid::Span& node, float centre, float period) {
        const float e = node.centre - centre;
        return e > 0.5f * period ? e - period : e < -0.5f * period ? e + period : e;
    }

    /// Queues those nodes of a quad of level k that may hold a slope above the tile's least need.
    void push_quad(int k, int i, int j) {
        QuadPlace place;
        for (int c = 0; c < 2; ++c) {
            const MaxPyramid::Span x = MaxPyramid::span(k, 2 * i + c, surface_.grid.width);
            const MaxPyramid::Span y = MaxPyramid::span(k, 2 * j + c, surface_.grid.height);
            place.ex[c] = towards(x, tile_.centre_x, space_.period_x), place.half_x[c] = x.half;
            place.ey[c] = towards(y, tile_.centre_y, space_.period_y) * space_.aspect, place.half_y[c] = y.half * space_.aspect;
        }
        QuadBounds bounds;
        std::uint32_t bits = kernels_.quad_needs(space_, tile_, pyramid_.quad(k, i, j), place, least_need_, bounds);
        const std::size_t first = stack_.size();
        for (; bits != 0; bits &= bits - 1) {
            const int c = std::countr_zero(bits);
            stack_.push_back({k, 2 * i + (c & 1), 2 * j + (c >> 1), bounds.slope_sq[c], bounds.distance_sq[c]});
        }
        // The steepest goes on top: an insertion sort of four at most.
        for (std::size_t a = first + 1; a < stack_.size(); ++a)
            for (std::size_t b = a; b > first && stack_[b].slope_sq < stack_[b - 1].slope_sq; --b)
                std::swap(stack_[b], stack_[b - 1]);
    }

    /// What limited the tile to the left most likely limits this one too. Results do not depend on it, work does.
    void compare_witnesses() {
        bool raised = false;
        for (const Witness& w : witnesses_) raised |= kernels_.compare_texel(space_, tile_, w.x, w.y, w.height);
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
        constexpr int side = MaxPyramid::leaf_size;
        const int x0 = i * side, y0 = j * side;
        const int width = std::min(side, surface_.grid.width - x0), height = std::min(side, surface_.grid.height - y0);
        LeafTexels leaf{float(x0), float(y0), {}};
        std::fill(std::begin(leaf.height), std::end(leaf.height), -std::numeric_limits<float>::infinity());
        for (int y = 0; y < height; ++y) std::copy_n(surface_.height.row(y0 + y) + x0, width, leaf.height + y * side);
        bool raised = false;
        for (std::uint32_t bits = kernels_.leaf_candidates(space_, tile_, leaf, threshold_); bits != 0; bits &= bits - 1) {
            const int at = std::countr_zero(bits);
            const float x = float(x0 + at % side), y = float(y0 + at / side);
            if (!kernels_.compare_texel(space_, tile_, x, y, leaf.height[at])) continue;
            remember(x, y, leaf.height[at]);
            raised = true;
        }
        if (raised) refresh_threshold();
    }

    const SearchSurface& surface_;
    const MaxPyramid& pyramid_;
    const SearchSpace& space_;
    const TileKernels kernels_;
    Tile tile_;
    float least_need_ = 0; ///< the least slope that still matters to the tile
    float threshold_ = 0;  ///< its square
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
