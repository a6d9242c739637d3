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

constexpr std::size_t witness_count = 16;

class TileSearch {
  public:
    TileSearch(const SearchSurface& surface, const SearchTarget& target, const MaxPyramid& pyramid, const SearchSpace& space)
        : surface_(surface), target_(target), pyramid_(pyramid), space_(space), kernels_(tile_kernels(space)) {}

    /// Leaves in tile.found the largest far slope of each texel that exceeds its need; 0 where none does. `needs`: of the rows of
    /// tiles tile_y alone.
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
        const int width = std::min(tile_size, surface_.grid.width - x0), height = std::min(tile_size, surface_.grid.height - y0);
        for (int j = 0; j < tile_size; ++j) {
            // Lanes beyond the map repeat its last texel and never need anything.
            const int y = y0 + std::min(j, height - 1);
            float* own = tile_.height + j * tile_size;
            float* need = tile_.need + j * tile_size;
            std::copy_n(surface_.apexes().row(y) + x0, width, own);
            std::fill(own + width, own + tile_size, own[width - 1]);
            std::copy_n(needs.row(y - y0) + x0, width, need);
            std::fill(need + (j < height ? width : 0), need + tile_size, std::numeric_limits<float>::max());
            tile_.x[j] = float(x0 + j), tile_.y[j] = float(y0 + j);
        }
        std::fill(std::begin(tile_.found), std::end(tile_.found), 0.0f);
        tile_.centre_x = float(x0) + 0.5f * float(width - 1), tile_.half_x = 0.5f * float(width - 1);
        tile_.centre_y = float(y0) + 0.5f * float(height - 1), tile_.half_y = 0.5f * float(height - 1);
        kernels_.lay_floor(tile_);
        refresh_threshold();
    }

    void refresh_threshold() {
        least_need_ = kernels_.summarise_needs(tile_) * space_.tolerance_factor;
        threshold_ = least_need_ * least_need_;
    }

    /// From the tile's centre to a node's, for the nearest image; directed, for the first not wholly behind the tile.
    float towards(const MaxPyramid::Span& node, float centre, float half, float period) const {
        const float e = node.centre - centre;
        if (space_.directed) return e + node.half + half < 0 ? e + period : e;
        return e > 0.5f * period ? e - period : e < -0.5f * period ? e + period : e;
    }

    /// Queues those nodes of a quad of level k that may hold a slope above the tile's least need.
    void push_quad(int k, int i, int j) {
        QuadPlace place{};
        for (int c = 0; c < 2; ++c) {
            const MaxPyramid::Span x = MaxPyramid::span(k, 2 * i + c, surface_.grid.width);
            const MaxPyramid::Span y = MaxPyramid::span(k, 2 * j + c, surface_.grid.height);
            place.ex[c] = towards(x, tile_.centre_x, tile_.half_x, space_.period_x), place.half_x[c] = x.half;
            place.ey[c] = towards(y, tile_.centre_y, tile_.half_y, space_.period_y) * space_.aspect, place.half_y[c] = y.half * space_.aspect;
        }
        for (int c = 0; space_.wedged && c < 2; ++c) {
            const MaxPyramid::Span x = MaxPyramid::span(k, 2 * i + c, surface_.grid.width);
            const MaxPyramid::Span y = MaxPyramid::span(k, 2 * j + c, surface_.grid.height);
            place.images_x[c] = space_.images_x(x.centre + x.half), place.images_y[c] = space_.images_y(y.centre + y.half);
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
        for (const Opponent& witness : witnesses_) raised |= kernels_.compare_texel(space_, tile_, witness);
        if (raised) refresh_threshold();
    }

    void remember(const Opponent& texel) {
        if (witnesses_.size() < witness_count)
            witnesses_.push_back(texel);
        else
            witnesses_[next_witness_] = texel;
        next_witness_ = (next_witness_ + 1) % witness_count;
    }

    void compare_leaf(int i, int j) {
        constexpr int side = MaxPyramid::leaf_size;
        const int x0 = i * side, y0 = j * side;
        const int width = std::min(side, surface_.grid.width - x0), height = std::min(side, surface_.grid.height - y0);
        LeafTexels leaf{float(x0), float(y0), {}};
        std::fill(std::begin(leaf.height), std::end(leaf.height), -std::numeric_limits<float>::infinity());
        for (int y = 0; y < height; ++y) std::copy_n(target_.height.row(y0 + y) + x0, width, leaf.height + y * side);
        bool raised = false;
        for (std::uint32_t bits = kernels_.leaf_candidates(space_, tile_, leaf, threshold_); bits != 0; bits &= bits - 1) {
            const int at = std::countr_zero(bits);
            const int x = x0 + at % side, y = y0 + at / side;
            const Opponent texel{float(x), float(y), leaf.height[at], target_.from.empty() ? 0.0f : target_.from(x, y)};
            if (!kernels_.compare_texel(space_, tile_, texel)) continue;
            remember(texel);
            raised = true;
        }
        if (raised) refresh_threshold();
    }

    const SearchSurface& surface_;
    const SearchTarget& target_;
    const MaxPyramid& pyramid_;
    const SearchSpace& space_;
    const TileKernels kernels_;
    Tile tile_;
    float least_need_ = 0; ///< the least slope that still matters to the tile
    float threshold_ = 0;  ///< its square
    std::vector<NodeRef> stack_;
    std::vector<Opponent> witnesses_; ///< the last texels that raised a need
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
    space.directed = surface.wedge.has_value();
    const Wedge wedge = surface.wedge.value_or(Wedge());
    space.t0 = wedge.t0, space.t1 = wedge.t1;
    space.wedged = wedge.t0 > 0 || std::isfinite(wedge.t1);
    // Beyond a clamped border cones stand one texel farther out than the texel they are stored in.
    const bool clamped = grid.wrap_x == Wrap::clamp || grid.wrap_y == Wrap::clamp;
    space.step = !surface.has_footprint() ? 0 : clamped ? 2 : 1;
    space.last_x = float(grid.width - 1), space.last_y = float(grid.height - 1);
    space.widest_step = float(surface.widest_step());
    return space;
}

/// Joins into `best` each value of row y with those at the offsets of `f`, by `join` (a minimum or a maximum).
template <class Join>
void join_offsets(const TexelGrid& g, const RowOf& values, Footprint f, int y, Join join, float* best) {
    std::vector<float> row(std::size_t(g.width) + 2);
    for (int j = f.y_low; j <= f.y_high; ++j) {
        const float* source = values(g.address_y(y + j));
        std::copy_n(source, g.width, row.data() + 1);
        row.front() = source[g.address_x(-1)], row.back() = source[g.address_x(g.width)];
        for (int i = f.x_low; i <= f.x_high; ++i)
            for (int x = 0; x < g.width; ++x) best[x] = join(best[x], row[std::size_t(x + 1 + i)]);
    }
}

/// Smallest near slope of the texels whose cones a far slope at a texel of these rows would narrow: what it must exceed to matter.
Image<float> needs_of_rows(const SearchSurface& surface, const RowOf& near, int y0, int rows) {
    const Footprint f = surface.footprint, narrowed{-f.x_high, -f.x_low, -f.y_high, -f.y_low};
    Image<float> needs(surface.grid.width, rows);
    for (int j = 0; j < rows; ++j) {
        std::copy_n(near(y0 + j), surface.grid.width, needs.row(j));
        if (surface.has_footprint())
            join_offsets(surface.grid, near, narrowed, y0 + j, [](float a, float b) { return std::min(a, b); }, needs.row(j));
    }
    return needs;
}

} // namespace

static_assert(far_tile_rows == tile_size);

std::uint64_t search_tile_row(const SearchSurface& surface, const SearchTarget& target, const MaxPyramid& pyramid, float tolerance,
                              int tile_row, const RowOf& near, Image<float>& found) {
    const int y0 = tile_row * tile_size, rows = std::min(tile_size, surface.grid.height - y0), width = surface.grid.width;
    const Image<float> needs = needs_of_rows(surface, near, y0, rows);
    const SearchSpace space = make_space(surface, tolerance);
    TileSearch search(surface, target, pyramid, space);
    for (int tile = 0; tile * tile_size < width; ++tile) {
        search.run(tile, tile_row, needs);
        const int x0 = tile * tile_size;
        for (int j = 0; j < rows; ++j) std::copy_n(search.tile().found + j * tile_size, std::min(tile_size, width - x0), found.row(j) + x0);
    }
    return search.visits();
}

void raise_row_by_found(const SearchSurface& surface, int y, const RowOf& found, float* slopes) {
    // Beyond a clamped border lies the border's own texel.
    join_offsets(surface.grid, found, surface.footprint, y, [](float a, float b) { return std::max(a, b); }, slopes);
}

std::uint64_t search_far_slopes(const SearchSurface& surface, const SearchTarget& target, const MaxPyramid& pyramid, float tolerance,
                                int threads, Image<float>& slopes) {
    const int height = surface.grid.height, tile_rows = (height + tile_size - 1) / tile_size;
    std::vector<Image<float>> found;
    found.resize(std::size_t(tile_rows));
    std::atomic<std::uint64_t> visits = 0;
    parallel_for(tile_rows, threads, [&](int row) {
        Image<float>& own = found[std::size_t(row)] = Image<float>(surface.grid.width, std::min(tile_size, height - row * tile_size));
        visits += search_tile_row(surface, target, pyramid, tolerance, row, [&](int y) { return slopes.row(y); }, own);
    });
    const RowOf found_row = [&](int y) { return found[std::size_t(y / tile_size)].row(y % tile_size); };
    parallel_for(height, threads, [&](int y) { raise_row_by_found(surface, y, found_row, slopes.row(y)); });
    return visits;
}

} // namespace reliefbake
