#include "cli/scene/map_need.h"

#include "formats/map_pixels.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace reliefbake {
namespace {

bool is_conservative(SceneCones cones) { return cones != SceneCones::none && cones != SceneCones::relaxed; }

std::optional<SceneCones> joined_cones(SceneCones a, SceneCones b) {
    if (a == b || b == SceneCones::none) return a;
    if (a == SceneCones::none) return b;
    if (a == SceneCones::open && is_conservative(b)) return b;
    if (b == SceneCones::open && is_conservative(a)) return a;
    return {};
}

/// Channels of the map itself, and of the relief beside sectors.
int channels_of(const MapNeed& need) {
    constexpr int relief = 3; // normal x, y, depth
    if (need.cones == SceneCones::sectors_4) return 4 + relief;
    if (need.cones == SceneCones::sectors_8) return 8 + relief;
    return (need.normals ? 2 : 0) + (need.cones != SceneCones::none ? 1 : 0) + 1;
}

/// Cost of a set of needs, and the part that holds its lowest one.
struct Best {
    std::uint64_t bytes = 0;
    int maps = 0;
    std::uint32_t part = 0;
};

std::optional<MapNeed> joined_part(const std::vector<MapNeed>& needs, std::uint32_t part) {
    std::optional<MapNeed> whole;
    for (std::size_t k = 0; k < needs.size(); ++k) {
        if ((part >> k & 1) == 0) continue;
        whole = whole ? joined(*whole, needs[k]) : needs[k];
        if (!whole) return {};
    }
    return whole;
}

} // namespace

std::optional<MapNeed> joined(const MapNeed& a, const MapNeed& b) {
    const std::optional<SceneCones> cones = joined_cones(a.cones, b.cones);
    if (!cones || (a.depth_scale && b.depth_scale && *a.depth_scale != *b.depth_scale)) return {};
    MapNeed both;
    both.cones = *cones;
    both.normals = a.normals || b.normals;
    both.bits = std::max(a.bits, b.bits);
    both.level = std::min(a.level, b.level);
    both.mips = a.mips || b.mips;
    both.trilinear = a.trilinear || b.trilinear;
    both.depth_scale = a.depth_scale ? a.depth_scale : b.depth_scale;
    return both;
}

int level_size(int size, int level) { return level > 30 ? 1 : std::max(1, size >> level); }

int chain_levels(int width, int height, int level, bool mips) {
    int levels = 1;
    if (mips)
        while (level_size(std::max(width, height), level + levels - 1) > 1) ++levels;
    return levels;
}

std::uint64_t bytes_of(const MapNeed& need, int width, int height) {
    std::uint64_t texels = 0;
    for (int k = 0; k < chain_levels(width, height, need.level, need.mips); ++k)
        texels += std::uint64_t(level_size(width, need.level + k)) * std::uint64_t(level_size(height, need.level + k));
    return texels * std::uint64_t(channels_of(need) * sample_bytes_of(need.bits));
}

std::vector<std::vector<std::size_t>> cheapest_maps(const std::vector<MapNeed>& needs, int width, int height) {
    assert(needs.size() <= most_needs);
    const std::uint32_t all = (1u << needs.size()) - 1;
    std::vector<std::uint64_t> cost(all + 1, 0); // of one map for a part; 0: there is none
    for (std::uint32_t part = 1; part <= all; ++part)
        if (const std::optional<MapNeed> need = joined_part(needs, part)) cost[part] = bytes_of(*need, width, height);

    std::vector<Best> best(all + 1);
    for (std::uint32_t set = 1; set <= all; ++set) {
        const std::uint32_t lowest = set & (~set + 1), rest = set ^ lowest;
        best[set].bytes = ~std::uint64_t(0);
        for (std::uint32_t others = rest;; others = (others - 1) & rest) { // every subset of the rest
            const std::uint32_t part = lowest | others;
            const Best& left = best[set ^ part];
            const std::uint64_t bytes = cost[part] + left.bytes;
            if (cost[part] > 0 && std::pair(bytes, left.maps + 1) < std::pair(best[set].bytes, best[set].maps)) best[set] = {bytes, left.maps + 1, part};
            if (others == 0) break;
        }
    }

    std::vector<std::vector<std::size_t>> parts;
    for (std::uint32_t set = all; set != 0; set ^= best[set].part) {
        parts.emplace_back();
        for (std::size_t k = 0; k < needs.size(); ++k)
            if (best[set].part >> k & 1) parts.back().push_back(k);
    }
    return parts;
}

} // namespace reliefbake
