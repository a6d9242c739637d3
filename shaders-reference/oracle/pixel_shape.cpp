#include "shaders-reference/oracle/pixel_shape.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

namespace reliefbake {
namespace {

/// Into [0, count) on a repeated axis; how many whole tiles were taken off.
double whole_tiles(double x, int count, Wrap wrap) { return wrap == Wrap::repeat ? std::floor(x / count) : 0; }

/// A block of the pyramid to be looked at, and the square of its distance, texels.
struct Block {
    double distance2;
    int level, i, j, tile_x, tile_y;
};

/// How far x is from [low, high].
double clamped_gap(double x, double low, double high) { return std::max({low - x, x - high, 0.0}); }

} // namespace

PixelShape::PixelShape(const TexelGrid& grid, const Image<std::uint8_t>& inside, ShapeModel model)
    : grid_(grid), margin_(model == ShapeModel::centres ? 0.5 : 0) {
    assert(model != ShapeModel::contour);
    assert(inside.width() == grid.width && inside.height() == grid.height);
    Image<std::uint8_t> squares(grid.width, grid.height);
    for (std::size_t k = 0; k < squares.size(); ++k) squares[k] = inside[k] ? has_inside : has_outside;
    build_pyramid(std::move(squares));
}

PixelShape::PixelShape(const TexelGrid& grid, Image<float> coverage) : grid_(grid), coverage_(std::move(coverage)) {
    assert(grid.pixel_aspect == 1);
    assert(coverage_.width() == grid.width && coverage_.height() == grid.height);
    Image<std::uint8_t> squares(grid.width, grid.height);
    for (int j = 0; j < grid.height; ++j)
        for (int i = 0; i < grid.width; ++i)
            squares(i, j) = !(coverage_(i, j) > 0) ? has_outside : cut_at(i, j, true).is_whole() ? has_inside : cut;
    build_pyramid(std::move(squares));
}

void PixelShape::build_pyramid(Image<std::uint8_t> squares) {
    levels_.push_back(std::move(squares));
    while (levels_.back().size() > 1) {
        const Image<std::uint8_t>& below = levels_.back();
        Image<std::uint8_t> above((below.width() + 1) / 2, (below.height() + 1) / 2, 0);
        for (int j = 0; j < below.height(); ++j)
            for (int i = 0; i < below.width(); ++i) above(i / 2, j / 2) = std::uint8_t(above(i / 2, j / 2) | below(i, j));
        levels_.push_back(std::move(above));
    }
}

/// The part of a square that is inside, or the rest of it; around the square's centre.
CutSquare PixelShape::cut_at(int i, int j, bool inside) const {
    const CutSquare part = cut_square(coverage_, grid_, i, j);
    return inside ? part : CutSquare{-part.nx, -part.ny, -part.reach};
}

bool PixelShape::contains(double u, double v) const {
    if (margin_ > 0) return false;
    const double x = u * grid_.width, y = v * grid_.height;
    const double i = std::floor(x - whole_tiles(x, grid_.width, grid_.wrap_x) * grid_.width);
    const double j = std::floor(y - whole_tiles(y, grid_.height, grid_.wrap_y) * grid_.height);
    if (!(i >= 0 && i < grid_.width && j >= 0 && j < grid_.height)) return false;
    const std::uint8_t holds = levels_.front()(int(i), int(j));
    return holds == cut ? cut_at(int(i), int(j), true).holds(x - std::floor(x) - 0.5, y - std::floor(y) - 0.5) : holds == has_inside;
}

// Branch and bound, the nearest block first. On a repeated axis the nearest square lies at most half a tile away, so this tile
// and its neighbours are enough.
NearestPoint PixelShape::nearest(double u, double v, bool inside) const {
    const std::uint8_t wanted = inside ? has_inside : has_outside;
    const double tiles_u = whole_tiles(u * grid_.width, grid_.width, grid_.wrap_x), tiles_v = whole_tiles(v * grid_.height, grid_.height, grid_.wrap_y);
    const double x = (u - tiles_u) * grid_.width, y = (v - tiles_v) * grid_.height, tall = grid_.pixel_aspect;

    struct Reach {
        double low_x, high_x, low_y, high_y;
    };
    const auto reach = [&](const Block& block) {
        const double left = double(block.tile_x) * grid_.width, top = double(block.tile_y) * grid_.height;
        return Reach{left + (block.i << block.level) + margin_, left + std::min((block.i + 1) << block.level, grid_.width) - margin_,
                     top + (block.j << block.level) + margin_, top + std::min((block.j + 1) << block.level, grid_.height) - margin_};
    };
    const auto block_at = [&](int level, int i, int j, int tile_x, int tile_y) {
        Block block{0, level, i, j, tile_x, tile_y};
        const Reach r = reach(block);
        const double dx = clamped_gap(x, r.low_x, r.high_x), dy = tall * clamped_gap(y, r.low_y, r.high_y);
        block.distance2 = dx * dx + dy * dy;
        return block;
    };

    // The roots, one a tile, then down; `stack` keeps the nearest on top of its siblings.
    std::array<Block, 9 + 3 * 32> stack;
    int depth = 0;
    const auto push_sorted = [&](int from) {
        std::sort(stack.begin() + from, stack.begin() + depth, [](const Block& a, const Block& b) { return a.distance2 > b.distance2; });
    };
    const int top = int(levels_.size()) - 1;
    const int around_x = grid_.wrap_x == Wrap::repeat ? 1 : 0, around_y = grid_.wrap_y == Wrap::repeat ? 1 : 0;
    for (int b = -around_y; b <= around_y; ++b)
        for (int a = -around_x; a <= around_x; ++a) stack[std::size_t(depth++)] = block_at(top, 0, 0, a, b);
    push_sorted(0);

    NearestPoint best;
    double best2 = std::numeric_limits<double>::infinity();
    while (depth > 0) {
        const Block block = stack[std::size_t(--depth)];
        const Image<std::uint8_t>& level = levels_[std::size_t(block.level)];
        const std::uint8_t holds = level(block.i, block.j);
        if (block.distance2 >= best2 || !(holds & wanted)) continue;
        if (holds == wanted && (margin_ == 0 || block.level == 0)) { // nothing else in it: a rectangle
            const Reach r = reach(block);
            best2 = block.distance2;
            best.u = std::clamp(x, r.low_x, r.high_x) / grid_.width + tiles_u;
            best.v = std::clamp(y, r.low_y, r.high_y) / grid_.height + tiles_v;
            continue;
        }
        if (block.level == 0) { // a part of a square
            const double centre_x = double(block.tile_x) * grid_.width + block.i + 0.5, centre_y = double(block.tile_y) * grid_.height + block.j + 0.5;
            const auto [dx, dy] = cut_at(block.i, block.j, inside).nearest(x - centre_x, y - centre_y);
            const double gap_x = x - centre_x - dx, gap_y = y - centre_y - dy, distance2 = gap_x * gap_x + gap_y * gap_y;
            if (distance2 >= best2) continue;
            best2 = distance2;
            best.u = (centre_x + dx) / grid_.width + tiles_u;
            best.v = (centre_y + dy) / grid_.height + tiles_v;
            continue;
        }
        const Image<std::uint8_t>& below = levels_[std::size_t(block.level - 1)];
        const int first = depth;
        for (int j = 2 * block.j; j < std::min(2 * block.j + 2, below.height()); ++j)
            for (int i = 2 * block.i; i < std::min(2 * block.i + 2, below.width()); ++i)
                stack[std::size_t(depth++)] = block_at(block.level - 1, i, j, block.tile_x, block.tile_y);
        push_sorted(first);
    }
    best.distance = std::sqrt(best2) / grid_.width;
    return best;
}

double PixelShape::signed_distance(double u, double v) const {
    return contains(u, v) ? -nearest(u, v, false).distance : nearest(u, v, true).distance;
}

} // namespace reliefbake
