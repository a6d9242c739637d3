// The tile loop's frame: stored depth -> search surface -> near slopes -> far slopes -> ratios.

#include "bake/cone.h"

#include "bake/cone_search.h"
#include "bake/cone_slopes.h"
#include "bake/exits.h"
#include "bake/sectors.h"
#include "bake/max_pyramid.h"
#include "bake/parallel.h"
#include "bake/search_surface.h"
#include "bake/shared_pyramids.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

namespace reliefbake {
namespace {

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

/// A bake in progress: slopes of one cone map, raised by one search after another.
class ConeBake {
  public:
    ConeBake(const DepthMap& depth, const ConeOptions& options, ConeStatistics& statistics, SharedPyramids* shared)
        : depth_(depth), options_(options), statistics_(statistics), shared_(shared) {
        surface_ = surface_without_heights(depth.grid, depth.bits, options);
        surface_.height = Image<float>(depth.grid.width, depth.grid.height);
        parallel_for(depth.grid.height, options.threads, [&](int y) {
            const float* level = depth.level.row(y);
            std::transform(level, level + depth.grid.width, surface_.height.row(y), std::negate<>());
        });
        statistics_.seconds_pyramid += watch_.lap();
    }

    const SearchSurface& surface() const { return surface_; }

    /// Raises `slopes` by all points of the surface, seen from cones that stand on it, or on `apex` when one is given.
    void search_all(Image<float> apex, Image<float>& slopes) {
        surface_.apex = std::move(apex);
        const MaxPyramid& pyramid = (shared_ ? *shared_ : own_).of({}, surface_.height, options_.threads);
        statistics_.seconds_pyramid += watch_.lap();
        raise(near_slopes(surface_, options_.threads), slopes);
        statistics_.seconds_near += watch_.lap();
        statistics_.node_tests +=
            search_far_slopes(surface_, {surface_.height, {}}, pyramid, options_.tolerance, options_.threads, slopes);
        statistics_.seconds_search += watch_.lap();
        surface_.apex = {};
    }

    /// Raises `slopes` by what lies in each of some sectors of directions, or by its exits alone. The near surface of all comes
    /// first: it spares the far searches most of their work.
    void search_sectors(const std::vector<Sector>& sectors, const std::optional<ExitRule>& exits, Image<float>& slopes) {
        std::vector<SearchSurface> turned;
        for (const Sector& sector : sectors) {
            turned.push_back(turned_surface(sector, exits));
            raise(flipped(near_slopes(turned.back(), options_.threads), sector.flip), slopes);
        }
        statistics_.seconds_near += watch_.lap();
        for (std::size_t k = 0; k < sectors.size(); ++k) {
            const Image<float>& height = turned[k].height;
            const ExitTexels seen = exits ? exit_texels(turned[k], options_.threads) : ExitTexels{};
            const SearchTarget target{exits ? seen.height : height, seen.from};
            SharedPyramids once; // alone, nobody asks twice
            const SharedPyramids::Subject subject{sectors[k].flip, exits, exits ? options_.metric : Metric::l2};
            const MaxPyramid& pyramid = (shared_ ? *shared_ : once).of(subject, target.height, options_.threads);
            statistics_.seconds_pyramid += watch_.lap();
            slopes = flipped(slopes, sectors[k].flip);
            statistics_.node_tests += search_far_slopes(turned[k], target, pyramid, options_.tolerance, options_.threads, slopes);
            slopes = flipped(slopes, sectors[k].flip);
            statistics_.seconds_search += watch_.lap();
        }
    }

    ConeMap finish(Image<float> slopes) {
        ConeMap cones{depth_.grid, options_, std::move(slopes)};
        const bool open = std::isinf(options_.ratio_max);
        const float top = open ? *std::max_element(surface_.height.begin(), surface_.height.end()) : 0.0f;
        parallel_for(depth_.grid.height, options_.threads, [&](int y) {
            slopes_to_ratios(depth_.grid, depth_.bits, options_, cones.ratio.row(y));
            if (open) open_topmost_cones(surface_, top, y, cones.ratio.row(y));
        });
        statistics_.seconds_search += watch_.lap();
        return cones;
    }

  private:
    SearchSurface turned_surface(const Sector& sector, const std::optional<ExitRule>& exits) const {
        return {surface_.grid,        surface_.metric, surface_.model, flipped(surface_.height, sector.flip),
                surface_.slope_floor, {},              sector.wedge,   exits,
                flipped(surface_.footprint, sector.flip)};
    }

    /// near_slopes are never below those of the widest cone, so the first ones are where a map starts.
    void raise(Image<float> by, Image<float>& slopes) const {
        if (slopes.empty()) {
            slopes = std::move(by);
            return;
        }
        parallel_for(by.height(), options_.threads, [&](int y) {
            for (int x = 0; x < by.width(); ++x) slopes(x, y) = std::max(slopes(x, y), by(x, y));
        });
    }

    const DepthMap& depth_;
    const ConeOptions& options_;
    ConeStatistics& statistics_;
    Stopwatch watch_;
    SearchSurface surface_{};
    SharedPyramids* shared_; ///< may be null
    SharedPyramids own_;     ///< without `shared_`: the pyramid of all texels
};

ExitRule exit_rule(const DepthMap& depth, const ConeOptions& options) {
    ExitRule rule;
    if (options.rays == RelaxedRays::slope) rule.least_fall = float(double(options.relaxed_slope) / slope_unit(depth.grid, depth.bits) * (1 - 0x1p-20));
    rule.from_top = options.rays == RelaxedRays::top;
    return rule;
}

/// Apexes that stand `lift` of height above the surface; rounded down, so that cones only get narrower.
Image<float> lifted(const SearchSurface& surface, float lift) {
    Image<float> apex = surface.height;
    for (float& z : apex) z = std::max(std::nextafter(z + lift, -std::numeric_limits<float>::infinity()), z);
    return apex;
}

} // namespace

ConeMap bake_cones(const DepthMap& depth, const ConeOptions& options, ConeStatistics* statistics, SharedPyramids* shared) {
    assert(options.ratio_max > 0 && options.tolerance >= 0);
    assert(is_baked_pixel_aspect(depth.grid.pixel_aspect));
    ConeStatistics local;
    ConeBake bake(depth, options, statistics ? *statistics : local, shared);
    Image<float> slopes;
    if (options.family == ConeFamily::conservative) bake.search_all({}, slopes);
    else bake.search_sectors(sectors_of(4), exit_rule(depth, options), slopes);
    if (options.family == ConeFamily::hybrid)
        bake.search_all(lifted(bake.surface(), options.hybrid_delta * float(max_code(depth.bits))), slopes);
    return bake.finish(std::move(slopes));
}

std::vector<ConeMap> bake_sector_cones(const DepthMap& depth, int sectors, const ConeOptions& options, ConeStatistics* statistics,
                                       SharedPyramids* shared) {
    assert(sectors == 4 || (sectors == 8 && options.metric == Metric::l2));
    assert(options.family != ConeFamily::hybrid);
    ConeStatistics local;
    ConeBake bake(depth, options, statistics ? *statistics : local, shared);
    std::optional<ExitRule> exits;
    if (options.family == ConeFamily::relaxed) exits = exit_rule(depth, options);
    std::vector<ConeMap> maps;
    for (const Sector& sector : sectors_of(sectors)) {
        Image<float> slopes;
        bake.search_sectors({sector}, exits, slopes);
        maps.push_back(bake.finish(std::move(slopes)));
    }
    return maps;
}

std::vector<ConeMap> bake_stacked_cones(const DepthMap& depth, int levels, const ConeOptions& options, ConeStatistics* statistics,
                                        SharedPyramids* shared) {
    assert(levels >= 1 && options.family == ConeFamily::conservative);
    ConeStatistics local;
    ConeBake bake(depth, options, statistics ? *statistics : local, shared);
    std::vector<ConeMap> maps;
    for (int level = 0; level < levels; ++level) {
        // Heights are negated levels, the top is 0: an apex at h + (1 - h) k/n is h (1 - k/n) here.
        Image<float> apex;
        if (level > 0) {
            apex = bake.surface().height;
            const float share = std::nextafter(1 - float(level) / float(levels), 2.0f);
            for (float& z : apex) z = std::max(std::nextafter(z * share, -std::numeric_limits<float>::infinity()), z);
        }
        Image<float> slopes;
        bake.search_all(std::move(apex), slopes);
        maps.push_back(bake.finish(std::move(slopes)));
    }
    return maps;
}

} // namespace reliefbake
