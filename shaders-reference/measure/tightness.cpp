#include "shaders-reference/measure/tightness.h"

#include "bake/parallel.h"
#include "shaders-reference/measure/map_sample.h"
#include "shaders-reference/oracle/cone_constraint.h"
#include "shaders-reference/oracle/steepest_texel.h"

#include <algorithm>
#include <cmath>

namespace reliefbake {
namespace {

constexpr double full_turn = 6.283185307179586;
constexpr double widest = 64;            ///< cap where the map has none, texture widths per unit of height
constexpr double square_reach = 0.7935; ///< mean over directions of 1 / (|cos| + |sin|)

/// Steepest slope of the bilinear surface seen from a point: the limiting texel exactly, then the patches between texels
/// along evenly spaced headings, each only where it could be steeper.
double steepest_slope(const BilinearSurface& surface, double u, double v, double at_least, int headings) {
    double slope = std::max(at_least, steepest_texel(surface, u, v, Metric::l2, at_least).slope);
    const double rise = surface.highest() - surface.height(u, v);
    for (int k = 0; k < headings; ++k) {
        const Heading heading = Heading::from_angle(full_turn * k / headings);
        slope = std::max(slope, cone_constraint(surface, u, v, heading, rise / slope, slope).slope);
    }
    return slope;
}

/// Steepest gradient in a cell: its square is convex there, so a corner has it.
double steepest_gradient(const BilinearSurface& surface, int i, int j) {
    const Patch patch = surface.patch(i, j);
    double steepest = 0;
    for (const double y : {0.0, 1.0})
        for (const double x : {0.0, 1.0})
            steepest = std::max(steepest, std::hypot(patch.slope(x, y, 1, 0) / surface.grid().pitch_x(),
                                                     patch.slope(x, y, 0, 1) / surface.grid().pitch_y()));
    return steepest;
}

/// Steepest slope seen from any point of cell (i, j). Points keep 1e-6 texels inside: on the rim, rounding would choose
/// between this cell and a neighbour whose points are another footprint's.
double cell_slope(const BilinearSurface& surface, int i, int j, double at_least, const TightnessOptions& options) {
    constexpr double rim = 1e-6;
    const TexelGrid& grid = surface.grid();
    double slope = std::max(at_least, steepest_gradient(surface, i, j));
    for (int b = 0; b <= options.steps; ++b)
        for (int a = 0; a <= options.steps; ++a) {
            const double x = i + rim + (1 - 2 * rim) * a / options.steps;
            const double y = j + rim + (1 - 2 * rim) * b / options.steps;
            slope = steepest_slope(surface, (x + 0.5) / grid.width, (y + 0.5) / grid.height, slope, options.headings);
        }
    return slope;
}

} // namespace

Image<double> footprint_cones(const BilinearSurface& surface, int x, int y, int width, int height, double ratio_max,
                              const TightnessOptions& options) {
    Image<double> cells(width + 1, height + 1);
    parallel_for(cells.height(), options.threads, [&](int b) {
        for (int a = 0; a < cells.width(); ++a)
            cells(a, b) = cell_slope(surface, x + a - 1, y + b - 1, 1 / ratio_max, options);
    });
    Image<double> cones(width, height);
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i)
            cones(i, j) = 1 / std::max(std::max(cells(i, j), cells(i + 1, j)), std::max(cells(i, j + 1), cells(i + 1, j + 1)));
    return cones;
}

double tightness(const ReliefMap& map, const BilinearSurface& surface, const TightnessOptions& options) {
    const TexelGrid& grid = map.grid;
    const int width = std::min(options.crop, grid.width);
    const int height = std::min(options.crop, grid.height);
    const int x = (grid.width - width) / 2;
    const int y = (grid.height - height) / 2;
    const double ratio_max = std::min<double>(map.info.cone_max, widest);
    const Image<double> best = footprint_cones(surface, x, y, width, height, ratio_max, options);
    const double reach = map.info.metric == Metric::l1 ? square_reach : 1;
    const bool undefined_on_top = map.info.encoding == ConeEncoding::radius; // the code is 0 there, whatever the cone
    double sum = 0;
    int counted = 0;
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i) {
            if (undefined_on_top && map.depth(x + i, y + j) == 0) continue;
            const double u = TexelGrid::centre(x + i, grid.width);
            const double v = TexelGrid::centre(y + j, grid.height);
            sum += reach * std::min(sampled_ratio(map, u, v, Fetch::nearest), ratio_max) / best(i, j);
            ++counted;
        }
    return counted > 0 ? sum / counted : 1;
}

} // namespace reliefbake
