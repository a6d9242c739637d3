#include "formats/shape_file.h"

#include "formats/decode_session.h"
#include "formats/map_facts.h"
#include "formats/shape_json.h"

#include <algorithm>
#include <array>
#include <vector>

namespace reliefbake {

namespace {

Result<ShapeFacts> facts_of(const ImageClaims& claims, const std::string& name) {
    ShapeFacts facts = shape_facts_from(claims.relief);
    if (facts.kind.empty())
        return fail(ErrorCode::bad_data, name + ": does not say that it is a shape map; bake one with reliefbake shape");
    if (facts.kind != "shape") return fail(ErrorCode::bad_data, name + ": expected a map of kind shape, found " + facts.kind);
    if (!facts.bad_keys.empty())
        return fail(ErrorCode::bad_data, name + ": its metadata makes no sense at " + join(facts.bad_keys));
    const Result<BitDepth> bits = bits_of_map(claims, name);
    if (!bits) return tl::unexpected(bits.error());
    facts.info.bits = *bits;
    return facts;
}

Result<std::vector<int>> channel_indices(const ShapeMapInfo& info, const std::vector<std::string>& held, const std::string& name) {
    std::vector<int> indices;
    for (const std::string& channel : shape_channels(info)) {
        const auto found = std::find(held.begin(), held.end(), channel);
        if (found == held.end()) return fail(ErrorCode::bad_data, name + ": has no channel " + channel + "; it has " + join(held));
        indices.push_back(int(found - held.begin()));
    }
    return indices;
}

/// Floating formats can hold what no map means.
Result<void> check_values(const ShapeMap& map, const std::string& name) {
    const float least = map.info.signed_distance && !is_unorm(map.info.bits) ? -1 : 0;
    const bool contour = map.info.model == ShapeModel::contour;
    for (std::size_t k = 0; k < map.shape.size(); ++k) {
        if (!(map.distance[k] >= least && map.distance[k] <= 1)) return fail(ErrorCode::bad_data, name + ": its distance channel leaves its range");
        const float outside = map.shape[k];
        if (!(contour ? outside >= 0 && outside <= 1 : outside == 0 || outside == 1))
            return fail(ErrorCode::bad_data, name + ": its shape channel " + (contour ? "leaves 0..1" : "holds other values than 0 and 1"));
        if (!(map.gradient_x[k] >= -1 && map.gradient_x[k] <= 1 && map.gradient_y[k] >= -1 && map.gradient_y[k] <= 1))
            return fail(ErrorCode::bad_data, name + ": its gradient channels leave -1..1");
    }
    return {};
}

} // namespace

Result<ShapeMap> read_shape_map(const std::filesystem::path& path, std::uint64_t max_bytes) {
    const std::string name = path.string();
    Result<DecodeSession> session = DecodeSession::open(path, max_bytes, 4);
    if (!session) return tl::unexpected(session.error());
    const ImageClaims& claims = session->claims();
    Result<ShapeFacts> facts = facts_of(claims, name);
    if (!facts) return tl::unexpected(facts.error());
    const Result<std::vector<int>> channels = channel_indices(facts->info, claims.channels, name);
    if (!channels) return tl::unexpected(channels.error());

    ShapeMap map;
    map.info = std::move(facts->info);
    map.grid = {int(claims.width), int(claims.height), facts->wrap_x, facts->wrap_y, 1};
    const std::array<Image<float>*, 4> planes{&map.gradient_x, &map.gradient_y, &map.distance, &map.shape};
    for (Image<float>* plane : planes) *plane = Image<float>(map.grid.width, map.grid.height);
    const Result<void> read = session->read(*channels, [&](int y, int rows, const float* samples) {
        const std::size_t first = std::size_t(y) * std::size_t(map.grid.width), count = std::size_t(rows) * std::size_t(map.grid.width);
        for (std::size_t c = 0; c < planes.size(); ++c)
            for (std::size_t k = 0; k < count; ++k) (*planes[c])[first + k] = samples[k * planes.size() + c];
    });
    const Result<void> whole = read ? check_values(map, name) : read;
    if (!whole) return tl::unexpected(whole.error());
    return map;
}

} // namespace reliefbake
