#include "formats/bump_file.h"

#include "formats/bump_json.h"
#include "formats/decode_session.h"
#include "formats/map_facts.h"

#include <algorithm>

namespace reliefbake {

namespace {

namespace fs = std::filesystem;

Result<BumpFacts> facts_of(const ImageClaims& claims, const std::string& name) {
    BumpFacts facts = bump_facts_from(claims.relief);
    if (facts.kind.empty())
        return fail(ErrorCode::bad_data, name + ": does not say that it is a bump map; bake one with reliefbake bump");
    if (!bump_kind_of(facts.kind))
        return fail(ErrorCode::bad_data, name + ": expected a map of kind derivative, normal or horizon, found " + facts.kind);
    if (!facts.bad_keys.empty())
        return fail(ErrorCode::bad_data, name + ": its metadata makes no sense at " + join(facts.bad_keys));
    const Result<BitDepth> bits = bits_of_map(claims, name);
    if (!bits) return tl::unexpected(bits.error());
    facts.info.bits = *bits;
    return facts;
}

/// The image's channels into their planes.
Result<void> read_planes(DecodeSession& session, const BumpImage& image, BumpMap& map, const std::string& name) {
    const std::vector<std::string>& held = session.claims().channels;
    std::vector<int> indices;
    std::vector<Image<float>*> planes;
    for (const std::string& channel : image.channels) {
        const auto found = std::find(held.begin(), held.end(), channel);
        if (found == held.end()) return fail(ErrorCode::bad_data, name + ": has no channel " + channel + "; it has " + join(held));
        const std::size_t plane = std::size_t(image.first) + indices.size();
        indices.push_back(int(found - held.begin()));
        planes.push_back(plane < map.planes.size() ? &map.planes[plane] : &map.depth);
        *planes.back() = Image<float>(map.grid.width, map.grid.height);
    }
    return session.read(indices, [&](int y, int rows, const float* samples) {
        const std::size_t first = std::size_t(y) * std::size_t(map.grid.width), count = std::size_t(rows) * std::size_t(map.grid.width);
        for (std::size_t c = 0; c < planes.size(); ++c)
            for (std::size_t k = 0; k < count; ++k) (*planes[c])[first + k] = samples[k * planes.size() + c];
    });
}

/// Floating formats can hold what no map means.
Result<void> check_values(const BumpMap& map, const std::string& name) {
    const bool wide = map.info.kind == BumpKind::derivative;
    const float least = map.info.kind == BumpKind::horizon || is_unorm(map.info.bits) ? 0 : wide ? -1e9f : -1.0001f;
    const float most = wide && !is_unorm(map.info.bits) ? 1e9f : 1.0001f;
    const auto all_in = [](const Image<float>& plane, float low, float high) {
        return std::all_of(plane.begin(), plane.end(), [=](float v) { return v >= low && v <= high; });
    };
    for (const Image<float>& plane : map.planes)
        if (!all_in(plane, least, most)) return fail(ErrorCode::bad_data, name + ": holds values that a map of kind " + word_of(map.info.kind) + " has not");
    if (!all_in(map.depth, 0, 1)) return fail(ErrorCode::bad_data, name + ": its depth channel leaves 0..1");
    return {};
}

} // namespace

Result<BumpMap> read_bump_map(const fs::path& path, std::uint64_t max_bytes) {
    BumpMap map;
    std::vector<BumpImage> images{{}};
    for (std::size_t n = 0; n < images.size(); ++n) {
        const fs::path file = path.parent_path() / (path.stem().string() + images[n].suffix + path.extension().string());
        const std::string name = file.string();
        Result<DecodeSession> session = DecodeSession::open(file, max_bytes, n == 0 ? horizon_azimuths + 1 : 4);
        if (!session) return tl::unexpected(session.error());
        const ImageClaims& claims = session->claims();
        Result<BumpFacts> facts = facts_of(claims, name);
        if (!facts) return tl::unexpected(facts.error());
        const TexelGrid grid{int(claims.width), int(claims.height), facts->wrap_x, facts->wrap_y, facts->pixel_aspect};
        if (n == 0) {
            map.grid = grid;
            map.planes.resize(std::size_t(bump_planes(facts->info.kind)));
            images = bump_images(facts->info);
            map.info = std::move(facts->info);
        } else if (grid != map.grid || facts->info.kind != map.info.kind || facts->info.bits != map.info.bits ||
                   facts->info.argument_hash != map.info.argument_hash || facts->info.source_hash != map.info.source_hash) {
            return fail(ErrorCode::bad_data, name + ": is not the second half of its pair: it was baked otherwise");
        }
        if (Result<void> read = read_planes(*session, images[n], map, name); !read) return tl::unexpected(read.error());
    }
    if (Result<void> whole = check_values(map, path.string()); !whole) return tl::unexpected(whole.error());
    return map;
}

} // namespace reliefbake
