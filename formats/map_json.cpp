#include "formats/map_json.h"

#include "formats/fact_reader.h"
#include "formats/map_layout.h"
#include "formats/shortest_decimal.h"

#include <array>
#include <cmath>
#include <limits>

namespace reliefbake {

using nlohmann::json;
using Reader = FactReader;

namespace {

// The words of the file format, in the order of the enumerators.
constexpr std::array metric_words{"l2", "l1"};
constexpr std::array encoding_words{"ratio", "sqrt", "radius", "normal"};
constexpr std::array surface_words{"bilinear", "texel"};
constexpr std::array family_words{"conservative", "relaxed", "hybrid"};
constexpr std::array relaxed_words{"strict", "top", "slope"};
constexpr std::array lookup_words{"filtered", "cell"};

constexpr double largest_number = 1e30;

void read_wrap(const Reader& reader, MapMetadata& metadata) {
    const auto pair = reader.wrap("wrap");
    if (!pair) return;
    metadata.wrap_x = pair->first;
    metadata.wrap_y = pair->second;
}

void read_channels(const Reader& reader, MapMetadata& metadata) {
    const json* names = reader.find("channels");
    if (!names) return;
    std::vector<std::string> channels;
    if (names->is_array())
        for (const json& name : *names)
            if (name.is_string()) channels.push_back(name.get<std::string>());
    // Kinds with several cones have as many channels as their layout says.
    const bool cone = metadata.kind.value_or("cone") == "cone";
    if (names->is_array() && channels.size() == names->size() && (!cone || channels.size() == 4))
        metadata.channels = std::move(channels);
    else reader.bad("channels");
}

/// A whole number in [low, high].
std::optional<int> read_count(const Reader& reader, const char* key, int low, int high) {
    const auto number = reader.number(key, low, high);
    if (!number) return std::nullopt;
    if (*number != std::floor(*number)) return reader.bad(key);
    return int(*number);
}

/// What kinds of cones they are; files older than these keys mean the defaults.
void read_family(const Reader& reader, MapMetadata& metadata) {
    metadata.family = reader.word<ConeFamily>("family", family_words);
    metadata.rays = reader.word<RelaxedRays>("relaxed", relaxed_words);
    metadata.relaxed_slope = reader.number("relaxed_slope", 0, largest_number);
    metadata.hybrid_delta = reader.number("hybrid_delta", 0, 1);
    metadata.lookup = reader.word<ConeLookup>("lookup", lookup_words);
    metadata.planes = read_count(reader, "planes", 0, 64);
    metadata.levels = read_count(reader, "levels", 1, 64);
    metadata.trilinear = reader.flag("trilinear");
    metadata.holes = reader.flag("holes");
}

/// Only what can differ from the meaning of a file without the key.
void write_family(const ReliefMapInfo& info, json& facts) {
    facts["family"] = family_words[std::size_t(info.family)];
    facts["lookup"] = lookup_words[std::size_t(info.lookup)];
    if (info.family != ConeFamily::conservative) {
        facts["relaxed"] = relaxed_words[std::size_t(info.rays)];
        if (info.rays == RelaxedRays::slope) facts["relaxed_slope"] = info.relaxed_slope;
    }
    if (info.family == ConeFamily::hybrid) facts["hybrid_delta"] = info.hybrid_delta;
    if (has_cone_planes(info.kind)) facts["planes"] = info.planes;
    if (info.levels > 1) facts["levels"] = info.levels;
    if (info.trilinear) facts["trilinear"] = true;
    if (info.holes) facts["holes"] = true;
    if (!info.alpha_hash.empty()) facts["alpha_hash"] = info.alpha_hash;
}

std::optional<float> read_cone_max(const Reader& reader) {
    const json* value = reader.find("cone_max");
    if (value && *value == infinity_word) return std::numeric_limits<float>::infinity();
    const auto finite = reader.number("cone_max", std::numeric_limits<float>::min(), std::numeric_limits<float>::max());
    return finite ? std::optional(float(*finite)) : std::nullopt;
}

} // namespace

json to_json(const ReliefMapInfo& info, const TexelGrid& grid) {
    json facts = {
        {"kind", info.kind},
        {"version", info.version},
        {"width", grid.width},
        {"height", grid.height},
        {"aspect", grid.aspect()},
        {"pixel_aspect", grid.pixel_aspect},
        {"wrap", wrap_to_json(grid)},
        {"metric", metric_words[std::size_t(info.metric)]},
        {"surface", surface_words[std::size_t(info.surface)]},
        {"encoding", encoding_words[std::size_t(info.encoding)]},
        {"bits", bits_to_json(info.bits)},
        {"cone_max", number_or_word(shortest_decimal(info.cone_max))},
        {"layout", layout_words[std::size_t(info.layout)]},
        {"normal_y", normal_y_words[std::size_t(info.normal_y)]},
        {"depth_scale", info.depth_scale},
        {"filter_delta", info.filter_delta},
        {"tolerance", info.tolerance},
        {"guarantee", info.guarantee},
        {"source_hash", info.source_hash},
        {"argument_hash", info.argument_hash},
        {"statistics", numbers_to_json(info.statistics)},
    };
    if (is_known_kind(info.kind)) facts["channels"] = layout_images(info)[0].channels;
    write_family(info, facts);
    return facts;
}

MapMetadata map_metadata_from(const std::string& text) {
    MapMetadata metadata;
    const json object = json::parse(text, nullptr, false);
    if (!object.is_object()) return metadata;
    const Reader reader(object, metadata.bad_keys);

    metadata.kind = reader.text("kind");
    metadata.metric = reader.word<Metric>("metric", metric_words);
    metadata.encoding = reader.word<ConeEncoding>("encoding", encoding_words);
    metadata.surface = reader.word<SurfaceModel>("surface", surface_words);
    metadata.layout = reader.word<ChannelLayout>("layout", layout_words);
    metadata.normal_y = reader.word<NormalY>("normal_y", normal_y_words);
    metadata.cone_max = read_cone_max(reader);
    metadata.depth_scale = reader.number("depth_scale", 0, largest_number);
    metadata.pixel_aspect = reader.number("pixel_aspect", 1e-9, 1e9);
    metadata.filter_delta = reader.number("filter_delta", 0, 1);
    metadata.tolerance = reader.number("tolerance", 0, 1);
    metadata.guarantee = reader.text("guarantee").value_or("");
    metadata.alpha_hash = reader.text("alpha_hash").value_or("");
    read_wrap(reader, metadata);
    read_channels(reader, metadata);
    read_family(reader, metadata);
    reader.origin(metadata);
    return metadata;
}

} // namespace reliefbake
