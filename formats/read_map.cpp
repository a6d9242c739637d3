#include "formats/map_file.h"

#include "formats/decode_session.h"
#include "formats/map_json.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace reliefbake {

namespace {

constexpr int absent = -1;

std::string join(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

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

using ChannelIndices = std::array<int, 4>; ///< of nx, ny, cone, depth in the file; `absent` where there is none

Result<ChannelIndices> indices_of(const std::vector<std::string>& wanted, const std::vector<std::string>& held,
                                  const std::string& name) {
    ChannelIndices indices;
    for (std::size_t c = 0; c < indices.size(); ++c) {
        const auto found = std::find(held.begin(), held.end(), wanted[c]);
        if (found == held.end() && wanted[c] != "-")
            return fail(ErrorCode::bad_data, name + ": has no channel " + wanted[c] + "; it has " + join(held));
        indices[c] = found == held.end() ? absent : int(found - held.begin());
    }
    return indices;
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

Result<BitDepth> bits_of(const ImageClaims& claims, const std::string& name) {
    const bool whole = claims.bit_depth == 8 * sample_bytes(claims.sample);
    if (whole && claims.sample == SampleType::uint8) return BitDepth::unorm8;
    if (whole && claims.sample == SampleType::uint16) return BitDepth::unorm16;
    if (claims.sample == SampleType::half) return BitDepth::half;
    if (claims.sample == SampleType::float32) return BitDepth::float32;
    return fail(ErrorCode::bad_data, name + ": maps have unsigned 8 or 16 bit, half or float samples; these are others");
}

ReliefMapInfo info_of(const MapMetadata& metadata, BitDepth bits) {
    ReliefMapInfo info;
    info.kind = metadata.kind.value_or(info.kind);
    info.metric = *metadata.metric;
    info.encoding = *metadata.encoding;
    info.bits = bits;
    info.surface = *metadata.surface;
    info.layout = metadata.channels && (*metadata.channels)[0] == channel_names(ChannelLayout::named)[0] ? ChannelLayout::named
                                                                                                       : ChannelLayout::rgba;
    info.normal_y = metadata.normal_y.value_or(info.normal_y);
    info.cone_max = metadata.cone_max.value_or(std::numeric_limits<float>::infinity());
    info.depth_scale = metadata.depth_scale.value_or(info.depth_scale);
    info.filter_delta = metadata.filter_delta.value_or(info.filter_delta);
    info.tolerance = metadata.tolerance.value_or(info.tolerance);
    info.guarantee = metadata.guarantee;
    info.version = metadata.version;
    info.source_hash = metadata.source_hash;
    info.argument_hash = metadata.argument_hash;
    info.statistics = metadata.statistics;
    return info;
}

Result<void> read_planes(DecodeSession& session, const ChannelIndices& indices, ReliefMap& map) {
    Image<float>* const planes[] = {&map.normal_x, &map.normal_y, &map.cone, &map.depth};
    std::vector<int> channels;
    std::vector<Image<float>*> filled;
    for (std::size_t c = 0; c < indices.size(); ++c)
        if (indices[c] != absent) {
            *planes[c] = Image<float>(map.grid.width, map.grid.height);
            channels.push_back(indices[c]);
            filled.push_back(planes[c]);
        }
    if (channels.empty()) return fail(ErrorCode::usage, "channel order '----' leaves nothing to read");
    return session.read(channels, [&](int y, int rows, const float* samples) {
        const std::size_t count = std::size_t(rows) * std::size_t(map.grid.width);
        for (std::size_t c = 0; c < filled.size(); ++c) {
            float* out = filled[c]->row(y);
            for (std::size_t i = 0; i < count; ++i) out[i] = samples[i * filled.size() + c];
        }
    });
}

void turn_heights_to_depths(Image<float>& depth, BitDepth bits) {
    const float largest = float(max_code(bits));
    for (float& value : depth)
        value = is_unorm(bits) ? (largest - std::round(value * largest)) / largest : 1 - value;
}

/// Floating formats can hold what no map means; unorm ones cannot.
Result<void> check_values(const ReliefMap& map, const std::string& name) {
    const auto good_depth = [](float v) { return v >= 0 && v <= 1; };
    if (!std::all_of(map.depth.begin(), map.depth.end(), good_depth))
        return fail(ErrorCode::bad_data, name + ": its depth channel leaves 0..1");
    if (!std::all_of(map.cone.begin(), map.cone.end(), [](float v) { return v >= 0; }))
        return fail(ErrorCode::bad_data, name + ": its cone channel holds negative values or NaN");
    return {};
}

} // namespace

Result<ReliefMap> read_map(const std::filesystem::path& path, const MapHints& hints) {
    const std::string name = path.string();
    Result<DecodeSession> session = DecodeSession::open(path, hints.max_bytes, 4);
    if (!session) return tl::unexpected(session.error());
    const ImageClaims& claims = session->claims();

    // Learn how to read it.
    MapMetadata metadata = map_metadata_from(claims.relief);
    apply_hints(hints, metadata);
    if (!hints.channel_order.empty()) {
        Result<std::vector<std::string>> names = names_of(hints.channel_order);
        if (!names) return tl::unexpected(names.error());
        metadata.channels = std::move(*names);
        std::erase(metadata.bad_keys, "channels");
    }
    const bool is_targa = session->format() == ImageFormat::targa;
    if (Result<void> facts = check_facts(metadata, metadata.channels.has_value(), is_targa, name); !facts)
        return tl::unexpected(facts.error());
    const Result<BitDepth> bits = bits_of(claims, name);
    if (!bits) return tl::unexpected(bits.error());
    const Result<ChannelIndices> indices = indices_of(*metadata.channels, claims.channels, name);
    if (!indices) return tl::unexpected(indices.error());

    // Read it.
    ReliefMap map;
    map.info = info_of(metadata, *bits);
    map.grid = {int(claims.width), int(claims.height), *metadata.wrap_x, *metadata.wrap_y, metadata.pixel_aspect.value_or(1)};
    if (Result<void> read = read_planes(*session, *indices, map); !read) return tl::unexpected(read.error());
    if (hints.alpha_is_height) turn_heights_to_depths(map.depth, *bits);
    if (Result<void> values = check_values(map, name); !values) return tl::unexpected(values.error());
    return map;
}

} // namespace reliefbake
