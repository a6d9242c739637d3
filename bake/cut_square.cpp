#include "bake/cut_square.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace reliefbake {

namespace {

struct Corner {
    double x, y;
};

Corner nearest_on_edge(const Corner& a, const Corner& b, double x, double y) {
    const double ex = b.x - a.x, ey = b.y - a.y, square = ex * ex + ey * ey;
    const double t = square > 0 ? std::clamp(((x - a.x) * ex + (y - a.y) * ey) / square, 0.0, 1.0) : 0;
    return {a.x + t * ex, a.y + t * ey};
}

/// How far along the normal the edge lies from the centre, so that the area behind it is `area`; a >= b >= 0 the normal's parts by
/// size: a triangle cut off a corner, a trapezium, or all but a triangle.
double reach_of(double a, double b, double area) {
    const double triangle = 0.5 * b / a;
    if (area < triangle) return std::sqrt(2 * a * b * area) - 0.5 * (a + b);
    if (area < 1 - triangle) return (area - 0.5) * a;
    return 0.5 * (a + b) - std::sqrt(2 * a * b * (1 - area));
}

/// There a sampler repeats the texel's value outwards for half a texel, and only a whole square looks the same from all of that strip.
bool is_at_clamped_border(const TexelGrid& grid, int x, int y) {
    const auto at_end = [](int i, int count, Wrap wrap) { return wrap == Wrap::clamp && (i == 0 || i == count - 1); };
    return at_end(x, grid.width, grid.wrap_x) || at_end(y, grid.height, grid.wrap_y);
}

} // namespace

std::array<double, 2> CutSquare::nearest(double x, double y) const {
    const double in_x = std::clamp(x, -0.5, 0.5), in_y = std::clamp(y, -0.5, 0.5);
    if (is_whole() || (in_x == x && in_y == y && holds(x, y))) return {in_x, in_y};
    // The corners of what is left, in order: those of the square behind the edge, and where the edge cuts its sides.
    constexpr Corner square[] = {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};
    std::array<Corner, 8> left;
    std::size_t count = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        const Corner &a = square[k], &b = square[(k + 1) % 4];
        const double at_a = nx * a.x + ny * a.y - reach, at_b = nx * b.x + ny * b.y - reach;
        if (at_a <= 0) left[count++] = a;
        if ((at_a < 0 && at_b > 0) || (at_a > 0 && at_b < 0)) {
            const double t = at_a / (at_a - at_b);
            left[count++] = {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
        }
    }
    const auto squared = [&](const Corner& c) { return (x - c.x) * (x - c.x) + (y - c.y) * (y - c.y); };
    Corner best{nx > 0 ? -0.5 : 0.5, ny > 0 ? -0.5 : 0.5}; // the last corner to go, where rounding leaves none
    for (std::size_t k = 0; k < count; ++k) {
        const Corner c = nearest_on_edge(left[k], left[(k + 1) % count], x, y);
        if (squared(c) < squared(best)) best = c;
    }
    return {best.x, best.y};
}

double CutSquare::distance(double x, double y) const {
    const auto [px, py] = nearest(x, y);
    return std::sqrt((x - px) * (x - px) + (y - py) * (y - py));
}

CutSquare cut_square(const Image<float>& coverage, const TexelGrid& grid, int x, int y) {
    const double area = coverage(x, y);
    if (area >= 1 || is_at_clamped_border(grid, x, y)) return {};
    const int left = grid.address_x(x - 1), right = grid.address_x(x + 1), above = grid.address_y(y - 1), below = grid.address_y(y + 1);
    const double root = std::sqrt(2.0); // the paper's weights
    const double fall_x = double(coverage(left, above)) + root * coverage(left, y) + coverage(left, below) - coverage(right, above) -
                          root * coverage(right, y) - coverage(right, below);
    const double fall_y = double(coverage(left, above)) + root * coverage(x, above) + coverage(right, above) - coverage(left, below) -
                          root * coverage(x, below) - coverage(right, below);
    const double length = std::sqrt(fall_x * fall_x + fall_y * fall_y);
    constexpr double rounding = 1e-9; // what opposite differences that cancel may leave
    if (!(length > rounding)) return {};
    const double nx = fall_x / length, ny = fall_y / length;
    const auto [small, large] = std::minmax({std::fabs(nx), std::fabs(ny)});
    return {nx, ny, reach_of(large, small, area)};
}

} // namespace reliefbake
