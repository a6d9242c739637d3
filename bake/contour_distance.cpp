#include "bake/contour_distance.h"

#include "bake/cut_square.h"
#include "bake/distance_transform.h"
#include "bake/parallel.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>

namespace reliefbake {

namespace {

constexpr int none = -1;

class Contour {
  public:
    Contour(const Image<float>& coverage, const TexelGrid& grid, int threads)
        : coverage_(coverage), grid_(grid), next_(grid.width, grid.height), previous_(grid.width, grid.height) {
        parallel_for(grid.height, threads, [&](int y) { find_touched(y); });
    }

    /// `bound`: a distance that the nearest point does not exceed.
    double distance(int x, int y, double bound) const {
        double best = bound;
        if (visit_row(x, y, 0, best); best == 0) return 0;
        for (int dy = 1; dy - 0.5 < best && dy < 2 * grid_.height; ++dy) {
            visit_row(x, y, dy, best);
            visit_row(x, y, -dy, best);
        }
        return best;
    }

  private:
    void find_touched(int y) {
        const auto mark = [&](Image<std::int32_t>& nearest, int from, int to, int step) {
            std::int32_t seen = none;
            // Twice around, where the row goes on at its other end.
            for (int turn = grid_.wrap_x == Wrap::repeat ? 0 : 1; turn < 2; ++turn)
                for (int x = from; x != to; x += step) nearest(x, y) = seen = coverage_(x, y) > 0 ? x : seen;
        };
        mark(next_, grid_.width - 1, -1, -1);
        mark(previous_, 0, grid_.width, 1);
    }

    /// Lowers `best` by what lies dy rows below, going to both sides while a square can be nearer.
    void visit_row(int x, int y, int dy, double& best) const {
        const int row = grid_.wrap_y == Wrap::repeat ? grid_.address_y(y + dy) : y + dy;
        if (row < 0 || row >= grid_.height) return;
        visit_side(next_, x, row, dy, 1, best);
        visit_side(previous_, x, row, dy, -1, best);
    }

    void visit_side(const Image<std::int32_t>& nearest, int x, int row, int dy, int side, double& best) const {
        const double across = std::max(std::abs(dy) - 0.5, 0.0);
        int at = x, dx = 0; // columns gone to that side
        while (dx <= grid_.width) {
            const std::int32_t touched = nearest(at, row);
            if (touched == none) return;
            int step = side * (touched - at);
            if (step < 0) step += grid_.width;
            dx += step;
            const double along = std::max(dx - 0.5, 0.0);
            if (along * along + across * across >= best * best) return;
            const CutSquare square = cut_square(coverage_, grid_, touched, row);
            best = std::min(best, square.distance(-double(side) * dx, -double(dy)));
            if (square.is_whole()) return;
            ++dx;
            at = touched + side;
            if (at < 0 || at >= grid_.width) {
                if (grid_.wrap_x == Wrap::clamp) return;
                at = grid_.address_x(at);
            }
        }
    }

    const Image<float>& coverage_;
    const TexelGrid& grid_;
    Image<std::int32_t> next_, previous_; ///< the first touched column from here on, to the right and to the left
};

} // namespace

Image<float> contour_distances(const Image<float>& coverage, const TexelGrid& grid, int threads) {
    // The squares of all touched texels are the nearest that the shape can be; their farthest corners the farthest.
    Image<std::uint8_t> untouched(grid.width, grid.height);
    for (std::size_t k = 0; k < coverage.size(); ++k) untouched[k] = !(coverage[k] > 0);
    DistanceOptions options;
    options.to = DistanceTo::squares;
    options.wrap_x = grid.wrap_x == Wrap::repeat, options.wrap_y = grid.wrap_y == Wrap::repeat;
    options.threads = threads;
    Image<float> distance = distance_transform(untouched, options);
    if (std::isinf(distance[0])) return distance;
    const double diagonal = std::sqrt(2.0) + 1e-3; // and the rounding of distances
    const Contour contour(coverage, grid, threads);
    parallel_for(grid.height, threads, [&](int y) {
        for (int x = 0; x < grid.width; ++x) distance(x, y) = float(contour.distance(x, y, double(distance(x, y)) * 1.000001 + diagonal));
    });
    return distance;
}

} // namespace reliefbake
