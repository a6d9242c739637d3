#pragma once
// What one map of cones or depth must hold, and the fewest bytes that serve several such needs of one source.

#include "bake/bit_depth.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace reliefbake {

/// The cones of a map. `open`: any that hold nothing of the relief, as ao reads them.
enum class SceneCones { none, open, cone, cone_normal, sectors_4, sectors_8, relaxed };

struct MapNeed {
    SceneCones cones = SceneCones::none;
    bool normals = false;
    BitDepth bits = BitDepth::unorm16; ///< 8, 16 or float: those that scenes choose from
    int level = 0;                     ///< mip level of the source that is the map's largest
    bool mips = false;                 ///< the levels below it, too
    bool trilinear = false;            ///< cones that hold under a blend of levels
    std::optional<double> depth_scale; ///< of the normals; none without them

    friend bool operator==(const MapNeed&, const MapNeed&) = default;
};

/// The least that serves both: a map that serves `a` and `b` serves it. Nothing where their cones or depth scales differ.
std::optional<MapNeed> joined(const MapNeed& a, const MapNeed& b);

/// Size of mip level n of an axis.
int level_size(int size, int level);

/// Levels of a chain whose largest is `level` of a width x height source.
int chain_levels(int width, int height, int level, bool mips);

/// Bytes of all texels of all levels of its images, as a program holds them; with sectors, those of the relief beside them, too.
std::uint64_t bytes_of(const MapNeed& need, int width, int height);

/// The partition of needs into maps that takes the fewest bytes; of equals the one with the fewest maps. Each part lists indices, in
/// order, and so do the parts by their first. Since every partition that serves more also serves less, dropping or lowering a need never
/// adds bytes. `needs`: at most most_needs.
std::vector<std::vector<std::size_t>> cheapest_maps(const std::vector<MapNeed>& needs, int width, int height);
constexpr std::size_t most_needs = 12; ///< 3^12 parts are looked at

} // namespace reliefbake
