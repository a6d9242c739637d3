// The tile loop's frame: stored depth -> search surface -> near slopes -> far slopes -> ratios.

#include "bake/cone.h"

#include "bake/cone_search.h"
#include "bake/max_pyramid.h"
#include "bake/parallel.h"
#include "bake/search_surface.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>

namespace reliefbake {
namespace {

/// Float rounding of a slope, all stages together, is below 2^-20 of it.
constexpr double rounding_margin = 1 + 0x1p-20;

/// "No cap": wider than any march can use, and still far from overflow when squared.
constexpr double widest_ratio = 0x1p40;

class Stopwatch {
  public:
    /// Seconds since the last call, or since the start.
    double lap() {
        const auto now = std::chrono::steady_clock::now();
        const double seconds = std::chrono::duration<double>(now - last_).count();
        last_ = now;
        return seconds;
    }

  private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// Levels per texel to height per texture width.
double slope_unit(const DepthMap& depth) { return double(depth.grid.width) / max_code(depth.bits); }

SearchSurface make_search_surface(const DepthMap& depth, const ConeOptions& options) {
    SearchSurface surface{depth.grid, options.metric, options.surface, Image<float>(depth.grid.width, depth.grid.height), 0.0f};
    parallel_for(depth.grid.height, options.threads, [&](int y) {
        const float* level = depth.level.row(y);
        std::transform(level, level + depth.grid.width, surface.height.row(y), std::negate<>());
    });
    const double cap = std::min(double(options.ratio_max), widest_ratio);
    surface.slope_floor = float(1 / (cap * slope_unit(depth) * (1 + double(options.tolerance)) * rounding_margin));
    return surface;
}

float ratio_of(float slope, double unit, double ratio_max) {
    return float(std::min(ratio_max, 1 / (double(slope) * unit * rounding_margin)));
}

/// Without a cap, a texel that has nothing above its whole footprint gets an unbounded cone.
void open_topmost_cones(const SearchSurface& surface, Image<float>& ratio) {
    const TexelGrid& g = surface.grid;
    const float top = *std::max_element(surface.height.begin(), surface.height.end());
    const int reach = surface.has_footprint() ? 1 : 0;
    for (int y = 0; y < g.height; ++y)
        for (int x = 0; x < g.width; ++x) {
            bool topmost = true;
            for (int j = -reach; j <= reach; ++j)
                for (int i = -reach; i <= reach; ++i)
                    topmost &= surface.height(g.address_x(x + i), g.address_y(y + j)) == top;
            if (topmost) ratio(x, y) = std::numeric_limits<float>::infinity();
        }
}

} // namespace

ConeMap bake_cones(const DepthMap& depth, const ConeOptions& options, ConeStatistics* statistics) {
    assert(options.ratio_max > 0 && options.tolerance >= 0);
    assert(is_baked_pixel_aspect(depth.grid.pixel_aspect));
    ConeStatistics local;
    ConeStatistics& stats = statistics ? *statistics : local;
    Stopwatch watch;

    const SearchSurface surface = make_search_surface(depth, options);
    const MaxPyramid pyramid = build_max_pyramid(surface.height, options.threads);
    stats.seconds_pyramid = watch.lap();

    Image<float> slopes = near_slopes(surface, options.threads);
    stats.seconds_near = watch.lap();

    stats.node_tests = search_far_slopes(surface, pyramid, options.tolerance, options.threads, slopes);

    ConeMap cones{depth.grid, options, std::move(slopes)};
    parallel_for(depth.grid.height, options.threads, [&](int y) {
        for (float* value = cones.ratio.row(y); value != cones.ratio.row(y) + depth.grid.width; ++value)
            *value = ratio_of(*value, slope_unit(depth), options.ratio_max);
    });
    stats.seconds_search = watch.lap();
    if (std::isinf(options.ratio_max)) open_topmost_cones(surface, cones.ratio);
    return cones;
}

} // namespace reliefbake
