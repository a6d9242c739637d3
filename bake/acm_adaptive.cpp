#include "bake/acm_adaptive.h"

#include "bake/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>

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

/// Narrows the cones of one quadrant: quarters of square rings, growing until no farther texel could limit them. A quadrant
/// holds the directions from its first axis (a > 0) up to, not including, its second one (b).
void search_quadrant(const Level& level, const TexelGrid& grid, int x, int y, int quadrant, int sectors, Fan& fan) {
    const int width = level.height.width(), height = level.height.height(), last = std::max(width, height);
    const int first = quadrant * sectors / 4, second = first + sectors / 4 - 1; // the same one of 4
    const double pitch_a = quadrant % 2 ? level.pitch_y : level.pitch_x, pitch_b = quadrant % 2 ? level.pitch_x : level.pitch_y;
    const float own = level.height(x, y), most_rise = level.highest - own;
    const auto test = [&](int a, int b) {
        const int dx = quadrant == 0 ? a : quadrant == 1 ? -b : quadrant == 2 ? -a : b;
        const int dy = quadrant == 0 ? b : quadrant == 1 ? a : quadrant == 2 ? -b : -a;
        const float rise = level.height(TexelGrid::address(x + dx, width, grid.wrap_x), TexelGrid::address(y + dy, height, grid.wrap_y)) - own;
        if (rise <= 0) return;
        const double along_a = a * pitch_a, along_b = b * pitch_b;
        float& ratio = fan[std::size_t(along_b < along_a ? first : second)];
        ratio = std::min(ratio, float(std::sqrt(along_a * along_a + along_b * along_b) / rise));
    };
    const double pitch = std::min(pitch_a, pitch_b);
    for (int r = 1; r < last && r * pitch < double(std::max(fan[std::size_t(first)], fan[std::size_t(second)])) * most_rise; ++r) {
        for (int b = 0; b <= r; ++b) test(r, b);
        for (int a = 1; a < r; ++a) test(a, r);
    }
}

/// The ring search of all sectors. `start` bounds the cones from the beginning: the parent's, or the cap.
Fan search_rings(const Level& level, const TexelGrid& grid, int x, int y, int sectors, const Fan& start) {
    Fan fan = start;
    for (int quadrant = 0; quadrant < 4; ++quadrant) search_quadrant(level, grid, x, y, quadrant, sectors, fan);
    return fan;
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

    Fan widest;
    widest.fill(options.ratio_max);
    for (std::size_t i = levels.size(); i-- > 0;) {
        Level& level = levels[i];
        const Level* parent = i + 1 < levels.size() ? &levels[i + 1] : nullptr;
        const int width = level.height.width();
        level.fans.resize(level.height.size());
        parallel_for(level.height.height(), options.threads, [&](int y) {
            for (int x = 0; x < width; ++x) {
                const std::size_t above = parent ? std::size_t(y / 2) * parent->height.width() + x / 2 : 0;
                const bool similar = parent && std::fabs(level.height(x, y) - parent->height[above]) <= adaptive.similarity;
                level.fans[std::size_t(y) * width + x] =
                    similar ? parent->fans[above] : search_rings(level, grid, x, y, adaptive.sectors, parent ? parent->fans[above] : widest);
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
