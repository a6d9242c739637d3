#include "shaders-reference/oracle/contour_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace reliefbake {

ContourShape::ContourShape(const TexelGrid& grid, const Image<float>& coverage) : grid_(grid), rows_(std::size_t(grid.height)) {
    std::vector<Touched> all;
    for (int y = 0; y < grid.height; ++y)
        for (int x = 0; x < grid.width; ++x) {
            if (!(coverage(x, y) > 0)) continue;
            const Touched touched{x, y, cut_square(coverage, grid, x, y)};
            rows_[std::size_t(y)].push_back(touched);
            all.push_back(touched);
            if (!touched.square.is_whole()) cut_.push_back(touched);
        }
    if (cut_.empty()) cut_ = std::move(all);
}

double ContourShape::distance(double u, double v) const {
    const double x = u * grid_.width, y = v * grid_.height;
    double best = std::numeric_limits<double>::infinity();
    const auto try_square = [&](const Touched& t, double cx, double cy) { best = std::min(best, t.square.distance(x - cx, y - cy)); };
    const auto gap = [](double from, double to) { return std::max(std::fabs(from - to) - 0.5, 0.0); };
    const auto try_row = [&](int row) {
        const bool tiles = grid_.wrap_y == Wrap::repeat;
        if (!tiles && (row < 0 || row >= grid_.height)) return;
        const std::vector<Touched>& touched = rows_[std::size_t(tiles ? grid_.address_y(row) : row)];
        const double cy = row + 0.5, far_y = gap(y, cy);
        const int copies = grid_.wrap_x == Wrap::repeat ? 1 : 0;
        for (int copy = -copies; copy <= copies; ++copy) {
            const double offset = 0.5 + double(copy) * grid_.width;
            const auto start = std::lower_bound(touched.begin(), touched.end(), x, [&](const Touched& t, double at) { return t.x + offset < at; });
            for (auto t = start; t != touched.end() && std::hypot(gap(x, t->x + offset), far_y) < best; ++t) try_square(*t, t->x + offset, cy);
            for (auto t = start; t != touched.begin() && std::hypot(gap(x, std::prev(t)->x + offset), far_y) < best; --t)
                try_square(*std::prev(t), std::prev(t)->x + offset, cy);
        }
    };
    const int own = int(std::floor(y));
    try_row(own);
    for (int k = 1; k <= 2 * grid_.height && k - 1 < best; ++k) try_row(own - k), try_row(own + k);
    return best / grid_.width;
}

void ContourShape::near_shape(std::size_t pick, double du, double dv, double& u, double& v) const {
    u = v = 0.5;
    if (cut_.empty()) return;
    const Touched& t = cut_[pick % cut_.size()];
    u = std::clamp((t.x + 0.5 + du) / grid_.width, 0.0, 1.0);
    v = std::clamp((t.y + 0.5 + dv) / grid_.height, 0.0, 1.0);
}

} // namespace reliefbake
