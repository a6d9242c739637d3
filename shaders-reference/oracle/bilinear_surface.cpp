#include "shaders-reference/oracle/bilinear_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace reliefbake {
namespace {

constexpr std::int64_t far_away = std::int64_t(1) << 40; ///< "infinity" in cells; small enough to convert exactly

/// Distinct cells on an axis. A clamped axis has one more: cell -1, which stands for all before it.
int cell_count(int texels, Wrap wrap) { return wrap == Wrap::repeat ? texels : texels + 1; }

std::int64_t wrapped_texel(std::int64_t i, int count, Wrap wrap) {
    if (wrap == Wrap::clamp) return std::clamp<std::int64_t>(i, 0, count - 1);
    const std::int64_t m = i % count;
    return m < 0 ? m + count : m;
}

/// Smallest float that is not below `value`.
float round_up(double value) {
    const float nearest = float(value);
    return nearest < value ? std::nextafter(nearest, std::numeric_limits<float>::infinity()) : nearest;
}

/// One axis of a block: its position in the pyramid and the unwrapped cells it spans.
struct Span {
    int node;
    std::int64_t low, high;
};

Span span_of(std::int64_t cell, int texels, Wrap wrap, int level) {
    const int count = cell_count(texels, wrap);
    const std::int64_t first = wrap == Wrap::repeat ? 0 : -1;
    std::int64_t local = cell - first;
    std::int64_t origin = first;
    if (wrap == Wrap::repeat) {
        local = wrapped_texel(cell, count, wrap);
        origin = cell - local;
    } else {
        local = std::clamp<std::int64_t>(local, 0, count - 1);
    }
    const std::int64_t node = local >> level;
    const std::int64_t low = node << level;
    const std::int64_t high = std::min<std::int64_t>((node + 1) << level, count);
    Span span{int(node), origin + low, origin + high};
    if (wrap == Wrap::clamp && low == 0) span.low = -far_away;
    if (wrap == Wrap::clamp && high == count) span.high = far_away;
    return span;
}

} // namespace

double Patch::highest() const { return std::max(std::max(h00, h10), std::max(h01, h11)); }

BilinearSurface::BilinearSurface(const DepthMap& depth)
    : grid_(depth.grid), heights_(depth.grid.width, depth.grid.height), has_holes_(depth.holes) {
    for (int j = 0; j < grid_.height; ++j)
        for (int i = 0; i < grid_.width; ++i) heights_(i, j) = 1.0 - depth.depth(i, j);
    highest_ = *std::max_element(heights_.begin(), heights_.end());

    // Level 1 from the patches, each further level from the one before, up to a single node.
    const int cells_x = cell_count(grid_.width, grid_.wrap_x);
    const int cells_y = cell_count(grid_.height, grid_.wrap_y);
    const int first_x = grid_.wrap_x == Wrap::repeat ? 0 : -1;
    const int first_y = grid_.wrap_y == Wrap::repeat ? 0 : -1;
    if (cells_x == 1 && cells_y == 1) return;
    Image<float> level((cells_x + 1) / 2, (cells_y + 1) / 2, 0);
    for (int j = 0; j < cells_y; ++j)
        for (int i = 0; i < cells_x; ++i) {
            float& node = level(i / 2, j / 2);
            node = std::max(node, round_up(patch(i + first_x, j + first_y).highest()));
        }
    pyramid_.push_back(std::move(level));
    while (pyramid_.back().size() > 1) {
        const Image<float>& below = pyramid_.back();
        Image<float> above((below.width() + 1) / 2, (below.height() + 1) / 2, 0);
        for (int j = 0; j < below.height(); ++j)
            for (int i = 0; i < below.width(); ++i) above(i / 2, j / 2) = std::max(above(i / 2, j / 2), below(i, j));
        pyramid_.push_back(std::move(above));
    }
}

double BilinearSurface::texel(std::int64_t i, std::int64_t j) const {
    return heights_(int(wrapped_texel(i, grid_.width, grid_.wrap_x)), int(wrapped_texel(j, grid_.height, grid_.wrap_y)));
}

Patch BilinearSurface::patch(std::int64_t i, std::int64_t j) const {
    const int i0 = int(wrapped_texel(i, grid_.width, grid_.wrap_x));
    const int i1 = int(wrapped_texel(i + 1, grid_.width, grid_.wrap_x));
    const double* top = heights_.row(int(wrapped_texel(j, grid_.height, grid_.wrap_y)));
    const double* bottom = heights_.row(int(wrapped_texel(j + 1, grid_.height, grid_.wrap_y)));
    return {top[i0], top[i1], bottom[i0], bottom[i1]};
}

double BilinearSurface::height(double u, double v) const {
    const double x = to_x(u);
    const double y = to_y(v);
    const double i = std::floor(x);
    const double j = std::floor(y);
    return patch(std::int64_t(i), std::int64_t(j)).height(x - i, y - j);
}

CellBlock BilinearSurface::block(std::int64_t i, std::int64_t j, int level) const {
    const Span x = span_of(i, grid_.width, grid_.wrap_x, level);
    const Span y = span_of(j, grid_.height, grid_.wrap_y, level);
    const double highest = level == 0 ? patch(i, j).highest() : double(pyramid_[level - 1](x.node, y.node));
    return {x.low, x.high, y.low, y.high, highest};
}

} // namespace reliefbake
