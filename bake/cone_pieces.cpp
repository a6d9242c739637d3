// Piecewise cones (001 sec. 3.4, method 2, which it leaves open; MATHS section 5; docs/FAMILIES.md has the proof). What is free
// above a texel is known from two sides: cones that stand at eight heights above it, and, for each of 32 heights, the distance to
// what is higher (Paglieroni and Petersen 1994). Under their envelope a line of n pieces is laid, from the bottom up.

#include "bake/cone.h"

#include "bake/distance_transform.h"
#include "bake/parallel.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>

namespace reliefbake {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double rounding_margin = 1 - 0x1p-20; ///< more than the float and double roundings of a radius, all together
constexpr float widest_ratio = 0x1p40f;         ///< "no cap"
constexpr int apexes = 8;                       ///< of the cones; apex j stands at share j / 8 of the height above the texel
constexpr int height_levels = 32;

/// The extreme of each texel's neighbours up to `reach` texels away on each axis.
template <class Better>
Image<float> extreme_around(const DepthMap& depth, int reach, int threads, Better better) {
    const TexelGrid& g = depth.grid;
    Image<float> rows(g.width, g.height), out(g.width, g.height);
    parallel_for(g.height, threads, [&](int y) {
        for (int x = 0; x < g.width; ++x) {
            rows(x, y) = depth.level(x, y);
            for (int i = -reach; i <= reach; ++i) rows(x, y) = better(rows(x, y), depth.level(g.address_x(x + i), y));
        }
    });
    parallel_for(g.height, threads, [&](int y) {
        for (int x = 0; x < g.width; ++x) {
            out(x, y) = rows(x, y);
            for (int j = -reach; j <= reach; ++j) out(x, y) = better(out(x, y), rows(x, g.address_y(y + j)));
        }
    });
    return out;
}

/// Heights are shares of the height above the footprint, 0 to 1; radii are in units of that height too. Piece k spans heights
/// k/n to (k+1)/n.
class Profiles {
  public:
    Profiles(int pieces, const std::vector<ConeMap>& cones, float ratio_max)
        : pieces_(pieces), cones_(cones), ratio_max_(ratio_max), size_(cones.front().grid.width), rows_(cones.front().grid.height),
          start_(size_, rows_, 0), slope_(size_, rows_, std::numeric_limits<float>::infinity()), piece_(size_, rows_, 0) {
        for (int k = 0; k < pieces; ++k) ratios_.emplace_back(size_, rows_);
    }

    /// Goes on at texel `at` over heights low..high, where nothing stands within `free`; intervals come in order, up to 1.
    void advance(std::size_t at, double low, double high, double free) {
        while (piece_[at] < pieces_) {
            const double from = double(piece_[at]) / pieces_, to = double(piece_[at] + 1) / pieces_, end = std::min(high, to);
            if (low < end) narrow(at, from, std::max(low, from), end, free);
            if (high < to) return;
            finish_piece(at, to, to - from);
            low = to;
        }
    }

    std::vector<Image<float>> take_ratios() { return std::move(ratios_); }

  private:
    /// The steepest the piece may be: under the one bound that allows most on all of the interval. Radii never need to fall
    /// with height, for what is free never does.
    void narrow(std::size_t at, double from, double low, double high, double free) {
        const double start = double(start_[at]), to_high = 1 / (high - from), to_low = low > from ? 1 / (low - from) : infinity;
        double slope = 0;
        const auto offer = [&](double at_low, double at_high) {
            const double rise = at_low - start;
            if (low > from) slope = std::max(slope, std::min((at_high - start) * to_high, rise * to_low));
            else if (rise >= 0) slope = std::max(slope, (at_high - start) * to_high);
        };
        offer(free, free);
        for (int j = 0; j < apexes; ++j) {
            const double apex = double(j) / apexes, ratio = double(cones_[std::size_t(j)].ratio[at]);
            if (apex <= low) offer(ratio * (low - apex), ratio * (high - apex));
        }
        slope_[at] = std::min(slope_[at], std::nextafter(float(slope), 0.0f));
    }

    void finish_piece(std::size_t at, double to, double span) {
        const double radius = std::min(double(start_[at]) + double(slope_[at]) * span, double(ratio_max_) * to);
        start_[at] = std::nextafter(float(radius), 0.0f);
        ratios_[std::size_t(piece_[at])][at] = float(double(start_[at]) / to * rounding_margin);
        slope_[at] = std::numeric_limits<float>::infinity();
        ++piece_[at];
    }

    int pieces_;
    const std::vector<ConeMap>& cones_;
    float ratio_max_;
    int size_, rows_;
    Image<float> start_, slope_; ///< of the piece under way: its radius at its lower end, and the least slope that its bounds allow
    Image<std::uint8_t> piece_;
    std::vector<Image<float>> ratios_;
};

/// Lays all profiles over the intervals between levels of depth, from the floor up.
void pass_levels(const DepthMap& depth, const ConeOptions& options, Profiles& profiles) {
    const TexelGrid& g = depth.grid;
    const auto deeper = [](float a, float b) { return std::max(a, b); };
    const auto shallower = [](float a, float b) { return std::min(a, b); };
    // A point's own height is at least that of the lowest texel around; what is higher than a level lies in a cell with a texel
    // that is. From a point of one cell to one of another it is two texels less on each axis than between their farthest corners.
    const Image<float> floor = extreme_around(depth, 1, options.threads, deeper), nearest = extreme_around(depth, 2, options.threads, shallower);
    const auto [top, bottom] = std::minmax_element(depth.level.begin(), depth.level.end());
    const double pitch = std::min(g.pitch_x(), g.pitch_y()) * max_code(depth.bits) * rounding_margin; // a bound in both metrics
    Image<std::uint8_t> higher(g.width, g.height);
    for (int k = 0; k <= height_levels; ++k) {
        const float level = *bottom + (*top - *bottom) * (float(k) / height_levels);
        const float next = k == height_levels ? 0 : *bottom + (*top - *bottom) * (float(k + 1) / height_levels);
        std::transform(nearest.begin(), nearest.end(), higher.begin(), [&](float around) { return around < level; });
        const Image<float> distance = distance_transform(higher, {DistanceTo::centres, 1, g.wrap_x == Wrap::repeat, g.wrap_y == Wrap::repeat, options.threads});
        parallel_for(g.height, options.threads, [&](int y) {
            for (std::size_t at = std::size_t(y) * std::size_t(g.width); at < std::size_t(y + 1) * std::size_t(g.width); ++at) {
                const double room = double(floor[at]); // depth of the footprint's lowest texel
                if (room == 0) profiles.advance(at, 0, 1, infinity);
                else if (double(next) < room) profiles.advance(at, std::max(1 - double(level) / room, 0.0), 1 - double(next) / room, double(distance[at]) * pitch / room);
            }
        });
    }
}

} // namespace

std::vector<ConeMap> bake_piecewise_cones(const DepthMap& depth, int pieces, const ConeOptions& options, ConeStatistics* statistics) {
    assert(pieces >= 1 && pieces <= 64 && options.family == ConeFamily::conservative && options.lookup == ConeLookup::filtered);
    assert(options.surface == SurfaceModel::bilinear);
    ConeOptions finite = options;
    finite.ratio_max = std::min(options.ratio_max, widest_ratio);
    const std::vector<ConeMap> cones = bake_stacked_cones(depth, apexes, finite, statistics);
    const auto start = std::chrono::steady_clock::now();
    Profiles profiles(pieces, cones, finite.ratio_max);
    pass_levels(depth, options, profiles);
    std::vector<ConeMap> maps;
    for (Image<float>& ratio : profiles.take_ratios()) maps.push_back({depth.grid, options, std::move(ratio)});
    if (statistics) statistics->seconds_search += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return maps;
}

} // namespace reliefbake
