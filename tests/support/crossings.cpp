#include "tests/support/crossings.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace reliefbake::test {
namespace {

constexpr double grazing = 1e-9;

/// Height of the patch of cell (i, j), continued beyond it; x, y in texels from the first texel's centre.
double patch_height(const DepthMap& depth, int i, int j, double x, double y) {
    const TexelGrid& g = depth.grid;
    const auto texel = [&](int a, int b) { return 1 - depth.depth(g.address_x(a), g.address_y(b)); };
    const double a = x - i, b = y - j;
    return (1 - b) * ((1 - a) * texel(i, j) + a * texel(i + 1, j)) + b * ((1 - a) * texel(i, j + 1) + a * texel(i + 1, j + 1));
}

/// Adds the parameters in (from, to) at which start + t step is a whole number.
void add_walls(double start, double step, double from, double to, std::vector<double>& walls) {
    if (step == 0) return;
    const double a = start + from * step, b = start + to * step;
    for (double wall = std::ceil(std::min(a, b)); wall <= std::max(a, b); ++wall) walls.push_back((wall - start) / step);
}

} // namespace

double surface_height(const DepthMap& depth, double u, double v) {
    const double x = u * depth.grid.width - 0.5, y = v * depth.grid.height - 0.5;
    return patch_height(depth, int(std::floor(x)), int(std::floor(y)), x, y);
}

Stretch follow(const DepthMap& depth, const DescendingRay& ray, double from, double to) {
    const double x = ray.u * depth.grid.width - 0.5, y = ray.v * depth.grid.height - 0.5;
    const double dx = ray.du * depth.grid.width, dy = ray.dv * depth.grid.height;
    std::vector<double> walls = {from, to};
    add_walls(x, dx, from, to, walls);
    add_walls(y, dy, from, to, walls);
    for (double& t : walls) t = std::clamp(t, from, to);
    std::sort(walls.begin(), walls.end());

    Stretch stretch;
    bool above = true;
    const auto look = [&](double gap) {
        if (above ? gap < -grazing : gap > grazing) above = !above, ++stretch.crossings;
        stretch.deepest = std::max(stretch.deepest, -gap);
    };
    for (std::size_t k = 1; k < walls.size(); ++k) {
        const double t0 = walls[k - 1], t1 = walls[k], middle = 0.5 * (t0 + t1);
        const int i = int(std::floor(x + middle * dx)), j = int(std::floor(y + middle * dy));
        const auto gap = [&](double t) { return ray.h - t - patch_height(depth, i, j, x + t * dx, y + t * dy); };
        // gap = start + b s + c s^2 for s in [0, 1].
        const double start = gap(t0), end = gap(t1), c = 2 * (start + end - 2 * gap(middle)), b = end - start - c;
        look(start);
        const double vertex = -0.5 * b / c;
        if (c != 0 && vertex > 0 && vertex < 1) look(start + (b + c * vertex) * vertex);
        look(end);
    }
    return stretch;
}

} // namespace reliefbake::test
