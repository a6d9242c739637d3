#include "formats/relief_file.h"

#include "formats/map_layout.h"

#include <string>
#include <utility>

namespace reliefbake {

namespace {

std::string size_of(const TexelGrid& grid) { return std::to_string(grid.width) + " x " + std::to_string(grid.height); }

/// Empty, or how the relief differs from the one that the cones were baked for.
std::string difference(const ReliefMap& map, const ReliefMap& relief) {
    const TexelGrid &a = map.grid, &b = relief.grid;
    if (a.width != b.width || a.height != b.height) return "is " + size_of(b) + " texels, the cones " + size_of(a);
    if (a.wrap_x != b.wrap_x || a.wrap_y != b.wrap_y) return "was baked for another wrap than the cones";
    if (a.pixel_aspect != b.pixel_aspect) return "was baked for another pixel aspect than the cones";
    if (map.info.bits != relief.info.bits) return "has other bits than the cones, so its stored heights are others";
    const bool known = !map.info.source_hash.empty() && !relief.info.source_hash.empty();
    if (known && map.info.source_hash != relief.info.source_hash) return "was baked from other heights than the cones";
    if (map.info.holes != relief.info.holes || map.info.alpha_hash != relief.info.alpha_hash) return "has other holes than the cones";
    return "";
}

} // namespace

Result<void> take_relief(ReliefMap& map, const std::filesystem::path& path, const MapHints& hints) {
    if (!is_known_kind(map.info.kind) || holds_relief(map.info)) {
        if (hints.relief.empty()) return {};
        return fail(ErrorCode::usage, path.string() + ": --relief is for maps without depth and normals; this one needs none");
    }
    if (hints.relief.empty() && hints.cones_suffice) return {};
    if (hints.relief.empty())
        return fail(ErrorCode::usage, path.string() + ": holds cones alone; add --relief FILE, the cone map of the same heights");

    MapHints relief_hints;
    relief_hints.max_bytes = hints.max_bytes;
    relief_hints.level = hints.level;
    relief_hints.holes = hints.holes;
    relief_hints.cones_suffice = true; // the kind is judged below, in clearer words
    Result<ReliefMap> relief = read_map(hints.relief, relief_hints);
    if (!relief) return tl::unexpected(relief.error());
    if (relief->info.kind != "cone")
        return fail(ErrorCode::bad_data, hints.relief.string() + ": --relief needs a map of kind cone, found " + relief->info.kind);
    if (const std::string words = difference(map, *relief); !words.empty())
        return fail(ErrorCode::bad_data, hints.relief.string() + ": " + words);
    map.normal_x = std::move(relief->normal_x);
    map.normal_y = std::move(relief->normal_y);
    map.depth = std::move(relief->depth);
    map.info.normal_y = hints.normal_y.value_or(relief->info.normal_y);
    return {};
}

} // namespace reliefbake
