// check_texels MAP.exr N [SEED]: takes N texels at random out of a map of any size and compares each one's cone with every
// other texel of the map, clamped. For maps baked with --wrap clamp --channels cone,depth (or normal,cone,depth), encoding sqrt.
// Fails when a texel stands in a cone. Prints how near the cones come to the widest that their neighbourhood allows.

#include "bake/parallel.h"
#include "formats/decode_session.h"
#include "formats/map_json.h"
#include "formats/mapped_storage.h"
#include "formats/read_image.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

using namespace reliefbake;

namespace {

struct Sample {
    int x, y;
    double ratio;         ///< decoded
    double excess = 0;    ///< largest height of a texel above the cone, in the relief's depth
    double widest = 1e30; ///< least ratio of distance to rise, of the texel and its eight neighbours
};

struct Map {
    Image<float> depth;
    std::vector<Sample> samples;
    double cone_max;
};

/// Depths into `storage`, and the samples' cones.
Result<Map> read_map_rows(std::pmr::memory_resource& storage, const std::filesystem::path& path, int count, unsigned seed) {
    Result<DecodeSession> session = DecodeSession::open_rows(path, 1ull << 40);
    if (!session) return tl::unexpected(session.error());
    const ImageClaims& claims = session->claims();
    const MapMetadata meta = map_metadata_from(claims.relief);
    if (meta.encoding != ConeEncoding::sqrt || meta.wrap_x != Wrap::clamp || meta.wrap_y != Wrap::clamp || !meta.cone_max)
        return fail(ErrorCode::usage, path.string() + ": expected a clamped map with cones in sqrt");
    const int width = int(claims.width), height = int(claims.height);
    Map map{Image<float>::unfilled(width, height, &storage), {}, *meta.cone_max};
    std::mt19937 random(seed);
    for (int k = 0; k < count; ++k) map.samples.push_back({int(random() % unsigned(width)), int(random() % unsigned(height)), 0});
    const int channels = int(claims.channels.size());
    const int wanted[] = {channels - 2, channels - 1}; // cone, depth
    const Result<void> read = session->read(wanted, [&](int y, int rows, const float* samples) {
        for (Sample& s : map.samples)
            if (s.y >= y && s.y < y + rows) {
                const double code = samples[2 * (std::size_t(s.y - y) * std::size_t(width) + std::size_t(s.x))];
                s.ratio = code * code * map.cone_max;
            }
        float* out = map.depth.row(y);
        for (std::size_t k = 0; k < std::size_t(rows) * std::size_t(width); ++k) out[k] = samples[2 * k + 1];
    });
    if (!read) return tl::unexpected(read.error());
    return map;
}

/// Compares one row of the map with a sample: heights above the cone, and the slopes that its neighbourhood asks for.
void compare_row(const Map& map, int row, Sample& sample) {
    const int width = map.depth.width(), height = map.depth.height();
    const float* depth = map.depth.row(row);
    for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i) {
            const int ax = std::clamp(sample.x + i, 0, width - 1), ay = std::clamp(sample.y + j, 0, height - 1);
            const float apex = map.depth(ax, ay);
            const double dy = double(row - ay) / width;
            for (int x = 0; x < width; ++x) {
                const float rise = apex - depth[x];
                if (rise <= 0) continue;
                const double dx = double(x - ax) / width, squared = dx * dx + dy * dy;
                // Within the best so far, nearly always: a product tells.
                if (squared >= sample.widest * sample.widest * rise * rise && (i != 0 || j != 0)) continue;
                const double distance = std::sqrt(squared);
                sample.widest = std::min(sample.widest, distance / rise);
                if (i == 0 && j == 0) sample.excess = std::max(sample.excess, rise - distance / sample.ratio);
            }
        }
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 3) return std::fputs("usage: check_texels MAP.exr N [SEED]\n", stderr), 2;
    const std::filesystem::path path = argv[1];
    const auto refused = [](const Error& error) { return std::fprintf(stderr, "check_texels: %s\n", error.message.c_str()), int(error.code); };
    ReadOptions any;
    any.max_bytes = 1ull << 40;
    const Result<ImageSides> sides = look_at_sides(path, any);
    if (!sides) return refused(sides.error());
    const std::uint64_t bytes = std::uint64_t(sides->width) * std::uint64_t(sides->height) * sizeof(float) + MappedStorage::array_step;
    const Result<std::unique_ptr<MappedStorage>> storage = MappedStorage::create(path.parent_path(), bytes, 2ull << 30);
    if (!storage) return refused(storage.error());
    Result<Map> map = read_map_rows(**storage, path, std::atoi(argv[2]), argc > 3 ? unsigned(std::atoi(argv[3])) : 1);
    if (!map) return refused(map.error());

    // One sample a thread at a time: a row of all samples is in the cache.
    parallel_for(int(map->samples.size()), 0, [&](int k) {
        for (int row = 0; row < sides->height; ++row) compare_row(*map, row, map->samples[std::size_t(k)]);
    });
    double worst = 0, tightness = 0;
    for (const Sample& s : map->samples) {
        worst = std::max(worst, s.excess);
        tightness += s.ratio / std::min(s.widest, map->cone_max);
    }
    std::printf("%zu texels, each against all %.4g others: %.3g of the depth in a cone at most; cones %.4f of the least of their neighbourhood's nine on average\n",
                map->samples.size(), double(sides->width) * sides->height, worst, tightness / double(map->samples.size()));
    return worst > 0 ? 4 : 0;
}
