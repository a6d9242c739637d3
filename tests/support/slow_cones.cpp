#include "tests/support/slow_cones.h"

#include "shaders-reference/oracle/cone_constraint.h"

#include <algorithm>
#include <cmath>

namespace reliefbake::test {
namespace {

double length(Metric metric, double dx, double dy) {
    return metric == Metric::l1 ? std::abs(dx) + std::abs(dy) : std::hypot(dx, dy);
}

/// Exact cone of one surface point against texel centres near and far, which headings may miss.
double cone_to_texels(const BilinearSurface& surface, double u, double v, double ratio_max) {
    const TexelGrid& grid = surface.grid();
    const double height = surface.height(u, v), x = surface.to_x(u), y = surface.to_y(v);
    const int tiles_x = grid.wrap_x == Wrap::repeat ? 1 : 0, tiles_y = grid.wrap_y == Wrap::repeat ? 1 : 0;
    double ratio = ratio_max;
    for (int b = -tiles_y * grid.height; b < (1 + tiles_y) * grid.height; ++b)
        for (int a = -tiles_x * grid.width; a < (1 + tiles_x) * grid.width; ++a) {
            const double rise = surface.texel(a, b) - height;
            if (rise > 1e-9) ratio = std::min(ratio, std::hypot((a - x) * grid.pitch_x(), (b - y) * grid.pitch_y()) / rise);
        }
    return ratio;
}

double dense_cone(const BilinearSurface& surface, double u, double v, double ratio_max, int headings) {
    double ratio = cone_to_texels(surface, u, v, ratio_max);
    const double rise = surface.highest() - surface.height(u, v);
    for (int k = 0; k < headings; ++k) {
        const Heading heading = Heading::from_angle(2 * 3.14159265358979323846 * k / headings);
        const double slope = cone_constraint(surface, u, v, heading, ratio * rise).slope;
        if (slope > 0) ratio = std::min(ratio, 1 / slope);
    }
    return ratio;
}

/// Steepest gradient anywhere in a cell, height per texture width. Its square is convex in the cell, so a corner has it;
/// points near that corner have it too, towards every side, which no sample *at* the corner shows.
double steepest_gradient(const BilinearSurface& surface, int i, int j) {
    const Patch patch = surface.patch(i, j);
    double steepest = 0;
    for (const double y : {0.0, 1.0})
        for (const double x : {0.0, 1.0}) {
            const double along_x = patch.slope(x, y, 1, 0) / surface.grid().pitch_x();
            const double along_y = patch.slope(x, y, 0, 1) / surface.grid().pitch_y();
            steepest = std::max(steepest, std::hypot(along_x, along_y));
        }
    return steepest;
}

double code_of(double ratio, double depth, double ratio_max, ConeEncoding encoding) {
    switch (encoding) {
    case ConeEncoding::ratio: return ratio / ratio_max;
    case ConeEncoding::sqrt: return std::sqrt(ratio / ratio_max);
    case ConeEncoding::radius: return std::min(1.0, ratio * depth);
    case ConeEncoding::normal: return ratio / std::hypot(1.0, ratio);
    }
    return 0;
}

float stored(double value, const MapChoices& choices) {
    if (!is_unorm(choices.bits)) {
        const float rounded = float(value);
        if (choices.rounding == Rounding::up) return rounded < value ? std::nextafter(rounded, 2.0f) : rounded;
        return rounded > value ? std::nextafter(rounded, 0.0f) : rounded;
    }
    const double full = max_code(choices.bits);
    const double code = choices.rounding == Rounding::up ? std::ceil(value * full) : std::floor(value * full);
    return float(std::clamp(code, 0.0, full) / full);
}

} // namespace

Image<float> texel_cones(const DepthMap& depth, Metric metric, double ratio_max) {
    const TexelGrid& grid = depth.grid;
    Image<float> cones(grid.width, grid.height);
    const int tiles_x = grid.wrap_x == Wrap::repeat ? 1 : 0;
    const int tiles_y = grid.wrap_y == Wrap::repeat ? 1 : 0;
    for (int j = 0; j < grid.height; ++j)
        for (int i = 0; i < grid.width; ++i) {
            double ratio = ratio_max;
            for (int b = -tiles_y * grid.height; b < (1 + tiles_y) * grid.height; ++b)
                for (int a = -tiles_x * grid.width; a < (1 + tiles_x) * grid.width; ++a) {
                    const double rise = depth.depth(i, j) - depth.depth(grid.address_x(a), grid.address_y(b));
                    if (rise <= 0) continue;
                    ratio = std::min(ratio, length(metric, (a - i) * grid.pitch_x(), (b - j) * grid.pitch_y()) / rise);
                }
            cones(i, j) = std::nextafter(float(ratio), 0.0f);
        }
    return cones;
}

Image<float> minimum_3x3(const Image<float>& values, const TexelGrid& grid) {
    Image<float> result(values.width(), values.height());
    for (int j = 0; j < values.height(); ++j)
        for (int i = 0; i < values.width(); ++i) {
            float least = values(i, j);
            for (int b = -1; b <= 1; ++b)
                for (int a = -1; a <= 1; ++a) least = std::min(least, values(grid.address_x(i + a), grid.address_y(j + b)));
            result(i, j) = least;
        }
    return result;
}

Image<float> footprint_cones(const DepthMap& depth, double ratio_max, int steps, int headings) {
    const TexelGrid& grid = depth.grid;
    const BilinearSurface surface(depth);
    // Each cell has its own points, just inside its walls: a point *on* a wall may round into the next cell and take a
    // slope from there. Cell 0 lies left of texel 0.
    const int side = steps + 1;
    const auto texel_at = [&](int a) {
        const double within = double(a % side) / steps;
        return a / side - 1 + std::clamp(within, 1e-7, 1 - 1e-7);
    };
    Image<double> points((grid.width + 1) * side, (grid.height + 1) * side);
    for (int b = 0; b < points.height(); ++b)
        for (int a = 0; a < points.width(); ++a) {
            const double u = (texel_at(a) + 0.5) / grid.width, v = (texel_at(b) + 0.5) / grid.height;
            points(a, b) = dense_cone(surface, u, v, ratio_max, headings);
        }
    Image<float> cones(grid.width, grid.height);
    for (int j = 0; j < grid.height; ++j)
        for (int i = 0; i < grid.width; ++i) {
            double least = ratio_max;
            for (int b = j * side; b < (j + 2) * side; ++b)
                for (int a = i * side; a < (i + 2) * side; ++a) least = std::min(least, points(a, b));
            for (int b = j - 1; b <= j; ++b)
                for (int a = i - 1; a <= i; ++a) least = std::min(least, 1 / steepest_gradient(surface, a, b));
            cones(i, j) = float(least);
        }
    return cones;
}

Image<float> proven_l2_cones(const DepthMap& depth, double ratio_max) {
    Image<float> cones = minimum_3x3(texel_cones(depth, Metric::l1, std::sqrt(2.0) * ratio_max), depth.grid);
    for (float& cone : cones) cone = float(cone / std::sqrt(2.0) * (1 - 1e-6));
    return cones;
}

ReliefMap make_relief_map(const DepthMap& depth, const Image<float>& ratio, double ratio_max, const MapChoices& choices,
                          double depth_scale) {
    const TexelGrid& grid = depth.grid;
    ReliefMap map;
    map.grid = grid;
    map.info.metric = choices.metric;
    map.info.encoding = choices.encoding;
    map.info.bits = choices.bits;
    map.info.holes = depth.holes;
    map.info.cone_max = float(ratio_max);
    map.info.depth_scale = depth_scale;
    map.info.guarantee = std::string("C"); // GCC 12 warns about the plain literal (-Wrestrict, bug 105651)
    map.normal_x = map.normal_y = map.cone = map.depth = Image<float>(grid.width, grid.height);
    const auto height = [&](int i, int j) { return 1 - depth.depth(grid.address_x(i), grid.address_y(j)); };
    const auto packed = [&](double n) { return float(is_unorm(choices.bits) ? 0.5 * n + 0.5 : n); };
    for (int j = 0; j < grid.height; ++j)
        for (int i = 0; i < grid.width; ++i) {
            const double x = -depth_scale * (height(i + 1, j) - height(i - 1, j)) / (2 * grid.pitch_x());
            const double y = depth_scale * (height(i, j + 1) - height(i, j - 1)) / (2 * grid.pitch_y());
            const double norm = std::sqrt(1 + x * x + y * y);
            map.normal_x(i, j) = packed(x / norm);
            map.normal_y(i, j) = packed(y / norm);
            map.depth(i, j) = float(depth.depth(i, j));
            map.cone(i, j) = stored(code_of(ratio(i, j), depth.depth(i, j), ratio_max, choices.encoding), choices);
        }
    return map;
}

} // namespace reliefbake::test
