#include "shaders-reference/oracle/steepest_texel.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <queue>

namespace reliefbake {
namespace {

/// A texel centre this close, in texels, is the point itself: rounding divided by a smaller distance is no slope.
constexpr double coincident = 1e-5;

class TexelSearch {
  public:
    TexelSearch(const BilinearSurface& surface, double u, double v, Metric metric, double at_least)
        : surface_(surface), grid_(surface.grid()), x_(surface.to_x(u)), y_(surface.to_y(v)), apex_(surface.height(u, v)),
          metric_(metric) {
        best_.slope = at_least;
    }

    void add_block(std::int64_t i, std::int64_t j, int level) {
        const CellBlock block = surface_.block(i, j, level);
        const double rise = block.highest - apex_;
        if (rise <= 0) return;
        const double dx = std::max({double(block.x_low) - x_, x_ - double(block.x_high), 0.0});
        const double dy = std::max({double(block.y_low) - y_, y_ - double(block.y_high), 0.0});
        const double distance = length(dx, dy);
        const double bound = distance > 0 ? rise / distance : std::numeric_limits<double>::infinity();
        if (bound > best_.slope) queue_.push({bound, block.x_low, block.y_low, level});
    }

    SteepestTexel run() {
        while (!queue_.empty() && queue_.top().bound > best_.slope) {
            const Entry entry = queue_.top();
            queue_.pop();
            if (entry.level == 0) offer_corners(entry.i, entry.j);
            else open(entry);
        }
        return found_ ? best_ : SteepestTexel{};
    }

  private:
    struct Entry {
        double bound;
        std::int64_t i, j;
        int level;
        bool operator<(const Entry& other) const { return bound < other.bound; }
    };

    double length(double dx, double dy) const {
        const double x = dx * grid_.pitch_x();
        const double y = dy * grid_.pitch_y();
        return metric_ == Metric::l1 ? std::abs(x) + std::abs(y) : std::hypot(x, y);
    }

    void open(const Entry& entry) {
        const CellBlock block = surface_.block(entry.i, entry.j, entry.level);
        for (std::int64_t j = block.y_low; j < block.y_high; j = surface_.block(entry.i, j, entry.level - 1).y_high)
            for (std::int64_t i = block.x_low; i < block.x_high; i = surface_.block(i, j, entry.level - 1).x_high)
                add_block(i, j, entry.level - 1);
    }

    void offer_corners(std::int64_t i, std::int64_t j) {
        // The border cells of a clamped axis reach to infinity; their near corners are the border texels.
        const CellBlock cell = surface_.block(i, j, 0);
        for (const std::int64_t b : {cell.y_low, cell.y_high})
            for (const std::int64_t a : {cell.x_low, cell.x_high}) {
                const double dx = double(a) - x_;
                const double dy = double(b) - y_;
                if (std::max(std::abs(dx), std::abs(dy)) < coincident) continue;
                const double distance = length(dx, dy);
                const double rise = surface_.texel(a, b) - apex_;
                if (rise > best_.slope * distance) {
                    best_ = {rise / distance, dx / grid_.width, dy / grid_.height};
                    found_ = true;
                }
            }
    }

    const BilinearSurface& surface_;
    const TexelGrid& grid_;
    double x_, y_, apex_;
    Metric metric_;
    SteepestTexel best_;
    bool found_ = false;
    std::priority_queue<Entry> queue_;
};

} // namespace

SteepestTexel steepest_texel(const BilinearSurface& surface, double u, double v, Metric metric, double at_least, int tiles) {
    assert(at_least > 0);
    const TexelGrid& grid = surface.grid();
    TexelSearch search(surface, u, v, metric, at_least);
    const int tiles_x = grid.wrap_x == Wrap::repeat ? tiles : 0;
    const int tiles_y = grid.wrap_y == Wrap::repeat ? tiles : 0;
    const auto i = std::int64_t(std::floor(surface.to_x(u)));
    const auto j = std::int64_t(std::floor(surface.to_y(v)));
    for (int b = -tiles_y; b <= tiles_y; ++b)
        for (int a = -tiles_x; a <= tiles_x; ++a)
            search.add_block(i + std::int64_t(a) * grid.width, j + std::int64_t(b) * grid.height, surface.levels() - 1);
    return search.run();
}

} // namespace reliefbake
