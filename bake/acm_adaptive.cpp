#include "bake/acm_adaptive.h"

#include "bake/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace reliefbake {
namespace {

using Fan = std::array<float, 8>; ///< one ratio a sector

struct Level {
    Image<float> height; ///< 0..1
    double pitch_x, pitch_y;
    std::vector<Fan> fans;
    float highest;
};

/// Height of a parent: the greatest of its children.
Level level_above(const Level& below) {
    Level level{Image<float>((below.height.width() + 1) / 2, (below.height.height() + 1) / 2, 0), 2 * below.pitch_x, 2 * below.pitch_y, {},
                below.highest};
    for (int y = 0; y < below.height.height(); ++y)
        for (int x = 0; x < below.height.width(); ++x)
            level.height(x / 2, y / 2) = std::max(level.height(x / 2, y / 2), below.height(x, y));
    return level;
}

int sector_of(double x, double y, int sectors) {
    const double turn = 6.283185307179586, angle = std::atan2(y, x);
    return std::min(int((angle < 0 ? angle + turn : angle) / turn * sectors), sectors - 1);
}

/// Square rings, growing until no sector could be limited by a farther texel.
Fan search_rings(const Level& level, const TexelGrid& grid, int x, int y, int sectors, float ratio_max) {
    Fan best;
    best.fill(ratio_max);
    const float own = level.height(x, y), most_rise = level.highest - own;
    const int width = level.height.width(), height = level.height.height(), last = std::max(width, height);
    const double pitch = std::min(level.pitch_x, level.pitch_y);
    const auto test = [&](int dx, int dy) {
        const float rise = level.height(TexelGrid::address(x + dx, width, grid.wrap_x), TexelGrid::address(y + dy, height, grid.wrap_y)) - own;
        if (rise <= 0) return;
        const double px = dx * level.pitch_x, py = dy * level.pitch_y;
        float& ratio = best[std::size_t(sector_of(px, py, sectors))];
        ratio = std::min(ratio, float(std::hypot(px, py) / rise));
    };
    for (int r = 1; r < last; ++r) {
        const float widest = *std::max_element(best.begin(), best.begin() + sectors);
        if (r * pitch >= double(widest) * most_rise) break;
        for (int d = -r; d <= r; ++d) test(d, -r), test(d, r);
        for (int d = -r + 1; d < r; ++d) test(-r, d), test(r, d);
    }
    return best;
}

} // namespace

std::vector<ConeMap> bake_sector_cones_adaptive(const DepthMap& depth, const AdaptiveOptions& adaptive, const ConeOptions& options) {
    const TexelGrid& grid = depth.grid;
    std::vector<Level> levels;
    levels.push_back({Image<float>(grid.width, grid.height), grid.pitch_x(), grid.pitch_y(), {}, 0});
    for (int y = 0; y < grid.height; ++y)
        for (int x = 0; x < grid.width; ++x) levels[0].height(x, y) = float(1 - depth.depth(x, y));
    levels[0].highest = *std::max_element(levels[0].height.begin(), levels[0].height.end());
    while (int(levels.size()) <= adaptive.levels && levels.back().height.size() > 1) levels.push_back(level_above(levels.back()));

    for (std::size_t i = levels.size(); i-- > 0;) {
        Level& level = levels[i];
        const Level* parent = i + 1 < levels.size() ? &levels[i + 1] : nullptr;
        const int width = level.height.width();
        level.fans.resize(level.height.size());
        parallel_for(level.height.height(), options.threads, [&](int y) {
            for (int x = 0; x < width; ++x) {
                Fan& fan = level.fans[std::size_t(y) * width + x];
                const bool similar = parent && std::fabs(level.height(x, y) - parent->height(x / 2, y / 2)) <= adaptive.similarity;
                fan = similar ? parent->fans[std::size_t(y / 2) * parent->height.width() + x / 2]
                              : search_rings(level, grid, x, y, adaptive.sectors, options.ratio_max);
            }
        });
    }

    std::vector<ConeMap> maps;
    for (int s = 0; s < adaptive.sectors; ++s) {
        ConeMap map{grid, options, Image<float>(grid.width, grid.height)};
        for (std::size_t k = 0; k < map.ratio.size(); ++k) map.ratio[k] = levels[0].fans[k][std::size_t(s)];
        maps.push_back(std::move(map));
    }
    return maps;
}

} // namespace reliefbake
