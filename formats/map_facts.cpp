#include "formats/map_facts.h"

#include "formats/map_json.h"

#include <limits>

namespace reliefbake {

namespace {

/// What the user says replaces what the file says, damaged or not.
template <class T>
void override_fact(std::optional<T>& fact, const std::optional<T>& hint, const char* key, MapMetadata& metadata) {
    if (!hint) return;
    fact = hint;
    std::erase(metadata.bad_keys, key);
}

void apply_hints(const MapHints& hints, MapMetadata& metadata) {
    override_fact(metadata.metric, hints.metric, "metric", metadata);
    override_fact(metadata.encoding, hints.encoding, "encoding", metadata);
    override_fact(metadata.surface, hints.surface, "surface", metadata);
    override_fact(metadata.normal_y, hints.normal_y, "normal_y", metadata);
    override_fact(metadata.cone_max, hints.cone_max, "cone_max", metadata);
    override_fact(metadata.depth_scale, hints.depth_scale, "depth_scale", metadata);
    if (hints.holes) override_fact(metadata.holes, std::optional(true), "holes", metadata);
    if (hints.wrap_x) metadata.wrap_x = hints.wrap_x;
    if (hints.wrap_y) metadata.wrap_y = hints.wrap_y;
    if (metadata.wrap_x && metadata.wrap_y) std::erase(metadata.bad_keys, "wrap");
}

/// The cap belongs to the codes of ratio and sqrt; radius and normal decode without one.
bool needs_cone_max(const MapMetadata& metadata) {
    return !metadata.encoding || *metadata.encoding == ConeEncoding::ratio || *metadata.encoding == ConeEncoding::sqrt;
}

Result<void> check_facts(const MapMetadata& metadata, bool has_order, bool is_targa, const std::string& name) {
    if (!metadata.bad_keys.empty())
        return fail(ErrorCode::bad_data, name + ": its metadata makes no sense at " + join(metadata.bad_keys));
    std::vector<std::string> missing;
    if (!has_order) missing.push_back("--channel-order");
    if (!metadata.metric) missing.push_back("--metric");
    if (!metadata.encoding) missing.push_back("--encoding");
    if (!metadata.surface) missing.push_back("--surface");
    if (!metadata.wrap_x || !metadata.wrap_y) missing.push_back("--wrap");
    if (!metadata.cone_max && needs_cone_max(metadata)) missing.push_back("--cone-max");
    if (missing.empty()) return {};
    return fail(ErrorCode::bad_data, name + (is_targa ? ": a TGA cannot say how to read it" : ": does not say how to read it") +
                                         "; add " + join(missing));
}

/// "RGBA" as the four names R, G, B, A.
Result<std::vector<std::string>> names_of(const std::string& order) {
    const bool letters = order.find_first_not_of("RGBAY-") == order.npos;
    if (order.size() != 4 || !letters)
        return fail(ErrorCode::usage, "channel order '" + order +
                                          "': four letters of R, G, B, A, Y or '-' are needed, for nx, ny, cone and depth");
    std::vector<std::string> names;
    for (const char letter : order) names.emplace_back(1, letter);
    return names;
}

/// The four channels in the order that the user gives.
Result<std::vector<LayoutImage>> given_images(const std::string& order) {
    Result<std::vector<std::string>> names = names_of(order);
    if (!names) return tl::unexpected(names.error());
    return std::vector<LayoutImage>{
        {"", std::move(*names), {{normal_x_plane, normal_y_plane, cone_plane, depth_plane}}}};
}

/// Where the planes lie, as the file or the user says.
Result<std::vector<LayoutImage>> images_of(const ReliefMapInfo& info, const MapMetadata& metadata, const MapHints& hints,
                                           const std::string& name) {
    if (has_cone_planes(info.kind)) {
        if (!hints.channel_order.empty())
            return fail(ErrorCode::usage, name + ": --channel-order is for maps of kind cone; this one is of kind " + info.kind);
        const Result<void> layout = check_layout(info);
        if (!layout) return fail(ErrorCode::bad_data, name + ": its metadata makes no sense: " + layout.error().message);
        return layout_images(info);
    }
    if (!hints.channel_order.empty()) return given_images(hints.channel_order);
    if (is_known_kind(info.kind))
        return std::vector<LayoutImage>{
            {"", *metadata.channels, {{normal_x_plane, normal_y_plane, cone_plane, depth_plane}}}};
    if (hints.cones_suffice) return std::vector<LayoutImage>();
    return fail(ErrorCode::bad_data, name + ": is of kind '" + info.kind +
                                         "', which this version does not know; it reads cone, acm, cone-stack and cone-pieces");
}

ReliefMapInfo info_of(const MapMetadata& metadata, BitDepth bits) {
    ReliefMapInfo info;
    info.kind = metadata.kind.value_or(info.kind);
    info.metric = *metadata.metric;
    info.encoding = *metadata.encoding;
    info.bits = bits;
    info.surface = *metadata.surface;
    info.layout = metadata.layout.value_or(info.layout);
    info.family = metadata.family.value_or(info.family);
    info.rays = metadata.rays.value_or(info.rays);
    info.relaxed_slope = metadata.relaxed_slope.value_or(info.relaxed_slope);
    info.hybrid_delta = metadata.hybrid_delta.value_or(info.hybrid_delta);
    info.lookup = metadata.lookup.value_or(info.lookup);
    info.planes = has_cone_planes(info.kind) ? metadata.planes.value_or(0) : 0;
    info.levels = metadata.levels.value_or(info.levels);
    info.trilinear = metadata.trilinear.value_or(info.trilinear);
    if (metadata.channels && !has_cone_planes(info.kind)) {
        const std::vector<std::string>& channels = *metadata.channels;
        info.held = {channels[normal_x_plane] != "-" && channels[normal_y_plane] != "-", channels[cone_plane] != "-"};
    }
    info.holes = metadata.holes.value_or(info.holes);
    info.normal_y = metadata.normal_y.value_or(info.normal_y);
    info.cone_max = metadata.cone_max.value_or(std::numeric_limits<float>::infinity());
    info.depth_scale = metadata.depth_scale.value_or(info.depth_scale);
    info.filter_delta = metadata.filter_delta.value_or(info.filter_delta);
    info.tolerance = metadata.tolerance.value_or(info.tolerance);
    info.guarantee = metadata.guarantee;
    info.version = metadata.version;
    info.source_hash = metadata.source_hash;
    info.alpha_hash = metadata.alpha_hash;
    info.argument_hash = metadata.argument_hash;
    info.statistics = metadata.statistics;
    return info;
}

} // namespace

Result<BitDepth> bits_of_map(const ImageClaims& claims, const std::string& name) {
    const bool whole = claims.bit_depth == 8 * sample_bytes(claims.sample);
    if (whole && claims.sample == SampleType::uint8) return BitDepth::unorm8;
    if (whole && claims.sample == SampleType::uint16) return BitDepth::unorm16;
    if (claims.sample == SampleType::half) return BitDepth::half;
    if (claims.sample == SampleType::float32) return BitDepth::float32;
    return fail(ErrorCode::bad_data, name + ": maps have unsigned 8 or 16 bit, half or float samples; these are others");
}

std::string join(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

Result<MapFacts> map_facts(const ImageClaims& claims, bool is_targa, const MapHints& hints, const std::string& name) {
    MapMetadata metadata = map_metadata_from(claims.relief);
    apply_hints(hints, metadata);
    if (!hints.channel_order.empty()) std::erase(metadata.bad_keys, "channels");
    // Only a cone map's order must be told: those of other kinds follow from their layout, or are refused.
    const bool has_order = !hints.channel_order.empty() || metadata.channels || metadata.kind.value_or("cone") != "cone";
    if (Result<void> facts = check_facts(metadata, has_order, is_targa, name); !facts) return tl::unexpected(facts.error());
    const Result<BitDepth> bits = bits_of_map(claims, name);
    if (!bits) return tl::unexpected(bits.error());

    MapFacts facts;
    facts.info = info_of(metadata, *bits);
    Result<std::vector<LayoutImage>> images = images_of(facts.info, metadata, hints, name);
    if (!images) return tl::unexpected(images.error());
    facts.images = std::move(*images);
    const int parts = facts.images.empty() ? 1 : int(facts.images[0].parts.size());
    if (claims.width % parts != 0)
        return fail(ErrorCode::bad_data, name + ": says that it holds two images side by side, but its width is odd");
    facts.grid = {int(claims.width) / parts, int(claims.height), *metadata.wrap_x, *metadata.wrap_y,
                  metadata.pixel_aspect.value_or(1)};
    if (hints.level > 0) {
        facts.grid.pixel_aspect *= double(claims.top_height) / double(claims.top_width) * facts.grid.width / facts.grid.height;
        facts.info.statistics.clear();
    }
    return facts;
}

} // namespace reliefbake
