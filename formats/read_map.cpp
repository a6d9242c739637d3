#include "formats/map_file.h"

#include "formats/decode_session.h"
#include "formats/map_facts.h"
#include "formats/relief_file.h"

#include <algorithm>
#include <cmath>

namespace reliefbake {

namespace {

/// Index in the file of each of the image's channels; -1 for "-".
Result<std::vector<int>> indices_of(const LayoutImage& image, const std::vector<std::string>& held, const std::string& name) {
    std::vector<int> indices;
    for (const std::string& channel : image.channels) {
        const auto found = std::find(held.begin(), held.end(), channel);
        if (found == held.end() && channel != "-")
            return fail(ErrorCode::bad_data, name + ": has no channel " + channel + "; it has " + join(held));
        indices.push_back(found == held.end() ? -1 : int(found - held.begin()));
    }
    return indices;
}

/// A channel of the file on its way into a plane.
struct Way {
    int sample;         ///< position among the samples of a pixel
    std::size_t column; ///< of the file where the plane's first one lies
    Image<float>* plane;
};

/// One way a plane: a stack that repeats its last level fills it once.
std::vector<Way> ways_into(ReliefMap& map, const LayoutImage& image, const std::vector<int>& indices,
                           std::vector<int>& channels) {
    std::vector<Way> ways;
    for (std::size_t c = 0; c < indices.size(); ++c) {
        if (indices[c] < 0) continue;
        for (std::size_t part = 0; part < image.parts.size(); ++part) {
            Image<float>& plane = plane_of(map, image.parts[part][c]);
            if (!plane.empty()) continue;
            plane = Image<float>(map.grid.width, map.grid.height);
            ways.push_back({int(channels.size()), part * std::size_t(map.grid.width), &plane});
        }
        channels.push_back(indices[c]);
    }
    return ways;
}

Result<void> read_planes(DecodeSession& session, const LayoutImage& image, ReliefMap& map, const std::string& name) {
    const Result<std::vector<int>> indices = indices_of(image, session.claims().channels, name);
    if (!indices) return tl::unexpected(indices.error());
    std::vector<int> channels;
    const std::vector<Way> ways = ways_into(map, image, *indices, channels);
    if (channels.empty()) return fail(ErrorCode::usage, "channel order '----' leaves nothing to read");
    const std::size_t file_width = std::size_t(session.claims().width);
    return session.read(channels, [&](int y, int rows, const float* samples) {
        for (const Way& way : ways)
            for (int row = 0; row < rows; ++row) {
                const float* from = samples + (std::size_t(row) * file_width + way.column) * channels.size() + way.sample;
                float* out = way.plane->row(y + row);
                for (int x = 0; x < map.grid.width; ++x) out[x] = from[std::size_t(x) * channels.size()];
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
    const auto good_cone = [](float v) { return v >= 0; };
    if (!std::all_of(map.depth.begin(), map.depth.end(), good_depth))
        return fail(ErrorCode::bad_data, name + ": its depth channel leaves 0..1");
    const auto good_cones = [&](const Image<float>& plane) { return std::all_of(plane.begin(), plane.end(), good_cone); };
    if (!good_cones(map.cone) || !std::all_of(map.cone_planes.begin(), map.cone_planes.end(), good_cones))
        return fail(ErrorCode::bad_data, name + ": its cone channel holds negative values or NaN");
    return {};
}

/// The file that bears the map's name: all of its facts, and the planes in it.
Result<MapFacts> read_first(const std::filesystem::path& path, const MapHints& hints, ReliefMap& map) {
    constexpr int usual_planes = 4;
    const std::string name = path.string();
    Result<DecodeSession> session = DecodeSession::open(path, hints.max_bytes, usual_planes, hints.level);
    if (!session) return tl::unexpected(session.error());
    Result<MapFacts> facts = map_facts(session->claims(), session->format() == ImageFormat::targa, hints, name);
    if (!facts) return facts;
    map.info = facts->info;
    map.grid = facts->grid;
    map.cone_planes.resize(std::size_t(map.info.planes));
    if (facts->images.empty()) return facts;
    const Result<void> read = session->check_planes(usual_planes + map.info.planes).and_then([&] {
        return read_planes(*session, facts->images[0], map, name);
    });
    if (!read) return tl::unexpected(read.error());
    return facts;
}

/// The other file of a pair.
Result<void> read_second(const std::filesystem::path& path, const LayoutImage& image, const MapHints& hints, ReliefMap& map) {
    const std::string name = path.string();
    Result<DecodeSession> session = DecodeSession::open(path, hints.max_bytes, 4, hints.level);
    if (!session) return tl::unexpected(session.error());
    const Result<MapFacts> facts = map_facts(session->claims(), false, hints, name);
    if (!facts) return tl::unexpected(facts.error());
    if (facts->grid != map.grid || facts->info.bits != map.info.bits || facts->info.argument_hash != map.info.argument_hash)
        return fail(ErrorCode::bad_data, name + ": is not the second half of its pair: it was baked otherwise");
    return read_planes(*session, image, map, name);
}

} // namespace

Result<ReliefMap> read_map(const std::filesystem::path& path, const MapHints& hints) {
    // Read the planes that the map's own files hold.
    ReliefMap map;
    const Result<MapFacts> facts = read_first(path, hints, map);
    if (!facts) return tl::unexpected(facts.error());
    for (std::size_t i = 1; i < facts->images.size(); ++i) {
        const LayoutImage& image = facts->images[i];
        if (Result<void> read = read_second(image_path(path, image), image, hints, map); !read)
            return tl::unexpected(read.error());
    }
    if (hints.alpha_is_height && map.depth.empty())
        return fail(ErrorCode::usage, path.string() + ": --alpha-is-height: this file holds no depth channel");
    if (hints.alpha_is_height) turn_heights_to_depths(map.depth, map.info.bits);

    // Take the rest from a relief file.
    const Result<void> whole = take_relief(map, path, hints).and_then([&] { return check_values(map, path.string()); });
    if (!whole) return tl::unexpected(whole.error());
    return map;
}

} // namespace reliefbake
