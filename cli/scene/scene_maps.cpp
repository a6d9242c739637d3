#include "cli/scene/scene_maps.h"

#include "bake/relief_map.h"
#include "cli/choices.h"
#include "formats/bump_file.h"
#include "formats/map_file.h"
#include "formats/map_layout.h"
#include "formats/map_pixels.h"

namespace reliefbake {
namespace {

namespace fs = std::filesystem;

/// The files of one image of a map, one a level or one for all.
void add_files(SceneMap& map, const fs::path& output, const MapNeed& need, const MapPlace& place, int channels, int times_wider) {
    const int levels = chain_levels(place.width, place.height, need.level, need.mips);
    for (int k = 0; k < levels; ++k) {
        const int width = level_size(place.width, need.level + k) * times_wider, height = level_size(place.height, need.level + k);
        const std::uint64_t bytes = std::uint64_t(width) * std::uint64_t(height) * std::uint64_t(channels * sample_bytes_of(need.bits));
        if (k > 0 && holds_mips(output)) {
            map.files.back().bytes += bytes;
            continue;
        }
        map.files.push_back({mip_path(output, k).string(), width, height, channels, 8 * sample_bytes_of(need.bits), bytes});
    }
}

/// As the writer lays it out.
void add_layout(SceneMap& map, const ReliefMapInfo& info, const MapNeed& need, const MapPlace& place) {
    for (const LayoutImage& image : layout_images(info)) {
        const LayoutImage written = written_image(image);
        add_files(map, image_path(map.output, image), need, place, int(written.channels.size()), int(written.parts.size()));
    }
    for (int k = 0; k < chain_levels(place.width, place.height, need.level, need.mips); ++k)
        map.units += std::uint64_t(level_size(place.width, need.level + k)) * std::uint64_t(level_size(place.height, need.level + k));
}

std::vector<std::string> common_options(const MapNeed& need, bool with_cones) {
    std::vector<std::string> options = {"--bits", word_of(bits_words, need.bits)};
    if (need.level > 0) options.insert(options.end(), {"--level", std::to_string(need.level)});
    if (need.mips) options.push_back("--mips");
    if (need.mips && need.trilinear && with_cones) options.push_back("--trilinear");
    return options;
}

ReliefMapInfo info_of(const MapNeed& need) {
    ReliefMapInfo info;
    info.bits = need.bits;
    info.held = {need.normals, need.cones != SceneCones::none};
    return info;
}

SceneMap single_map(const MapNeed& need, const MapPlace& place) {
    SceneMap map;
    map.command = need.cones == SceneCones::cone_normal ? "cone-normal" : "cone";
    map.what = need.cones == SceneCones::none ? "depth and normals" : need.cones == SceneCones::relaxed ? "relaxed cones" : need.cones == SceneCones::cone_normal ? "cone normals" : need.normals ? "cones" : "open cones";
    map.options = common_options(need, need.cones != SceneCones::none);
    if (need.cones == SceneCones::relaxed) map.options.insert(map.options.end(), {"--kind", "relaxed"});
    if (need.cones == SceneCones::none) map.options.insert(map.options.end(), {"--channels", "normal,depth"});
    else if (!need.normals) map.options.insert(map.options.end(), {"--channels", "cone,depth"});
    map.output = place.name + place.extension;
    add_layout(map, info_of(need), need, place);
    return map;
}

SceneMap bump_map(BumpKind kind, BitDepth bits, const MapPlace& place) {
    SceneMap map;
    map.command = "bump";
    map.what = kind == BumpKind::normal ? "normals" : "horizons";
    map.options = {"--kind", word_of(kind), "--bits", word_of(bits_words, bits)};
    map.output = place.name + place.extension;
    BumpMapInfo info;
    info.kind = kind, info.bits = bits, info.layout = kind == BumpKind::horizon ? ChannelLayout::pair : ChannelLayout::rgba;
    MapNeed whole;
    whole.bits = bits;
    for (const BumpImage& image : bump_images(info)) add_files(map, image_path(map.output, {image.suffix, {}, {}}), whole, place, int(image.channels.size()), 1);
    map.units = std::uint64_t(place.width) * std::uint64_t(place.height);
    return map;
}

} // namespace

std::vector<SceneMap> relief_maps(const MapNeed& need, const MapPlace& place) {
    if (need.cones != SceneCones::sectors_4 && need.cones != SceneCones::sectors_8) return {single_map(need, place)};
    const int sectors = need.cones == SceneCones::sectors_4 ? 4 : 8;
    SceneMap map;
    map.command = "acm";
    map.what = std::to_string(sectors) + " sectors";
    map.options = common_options(need, true);
    map.options.insert(map.options.end(), {"--sectors", std::to_string(sectors)});
    map.output = place.name + place.extension;
    ReliefMapInfo info;
    info.kind = "acm", info.planes = sectors, info.bits = need.bits;
    info.layout = sectors == 4 ? ChannelLayout::rgba : need.mips ? ChannelLayout::pair : ChannelLayout::side;
    add_layout(map, info, need, place);

    // Depth and normals, which a map of cones alone leaves out.
    MapNeed beside = need;
    beside.cones = SceneCones::none;
    MapPlace relief = place;
    relief.name += "_relief";
    return {map, single_map(beside, relief)};
}

SceneMap normal_map(BitDepth bits, const MapPlace& place) { return bump_map(BumpKind::normal, bits, place); }

SceneMap horizon_map(BitDepth bits, const MapPlace& place) { return bump_map(BumpKind::horizon, bits, place); }

SceneMap shape_map(const MapPlace& place) {
    SceneMap map;
    map.command = "shape", map.what = "distances";
    map.output = place.name + place.extension;
    constexpr int channels = 4; // gradient x, y, distance, shape
    add_files(map, map.output, MapNeed(), place, channels, 1);
    map.options = {"--bits", word_of(bits_words, BitDepth::unorm16)};
    map.units = std::uint64_t(place.width) * std::uint64_t(place.height);
    return map;
}

SceneMap quadric_mesh(const std::string& name, std::uint64_t bytes, std::uint64_t vertices) {
    SceneMap map;
    map.command = "quadric", map.what = "quadrics";
    map.output = name + ".glb";
    map.files = {{map.output, 0, 0, 0, 0, bytes}};
    map.units = vertices;
    return map;
}

std::vector<std::string> source_options(const SceneAsset& asset) {
    std::vector<std::string> options;
    const auto add = [&](const char* flag, const std::string& value) {
        if (!value.empty()) options.push_back(flag + ("=" + value));
    };
    add("--channel", asset.channel);
    add("--input", asset.input);
    add("--range", asset.range);
    add("--wrap", asset.wrap);
    add("--alpha", asset.alpha);
    if (asset.invert) options.push_back("--invert");
    if (asset.antialiased) options.push_back("--antialiased");
    return options;
}

} // namespace reliefbake
