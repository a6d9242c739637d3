#include "cli/bench/time_cones.h"

#include <algorithm>
#include <chrono>

namespace reliefbake {

namespace {

double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

} // namespace

nlohmann::json time_bake(const DepthMap& depth, const ConeOptions& options, const ConeCounts& counts, int repeat) {
    ConeStatistics best;
    for (int k = 0; k < repeat; ++k) {
        ConeStatistics run;
        if (counts.sectors > 1) bake_sector_cones(depth, counts.sectors, options, &run);
        else if (counts.pieces) bake_piecewise_cones(depth, counts.levels, options, &run);
        else if (counts.levels > 1) bake_stacked_cones(depth, counts.levels, options, &run);
        else bake_cones(depth, options, &run);
        if (k == 0) best = run;
        best.seconds_near = std::min(best.seconds_near, run.seconds_near);
        best.seconds_pyramid = std::min(best.seconds_pyramid, run.seconds_pyramid);
        best.seconds_search = std::min(best.seconds_search, run.seconds_search);
    }
    const double texels = double(depth.level.size()), ns = 1e9 / texels;
    return {{"search_ns_per_texel", (best.seconds_near + best.seconds_pyramid + best.seconds_search) * ns},
            {"near_ns_per_texel", best.seconds_near * ns},
            {"pyramid_ns_per_texel", best.seconds_pyramid * ns},
            {"far_ns_per_texel", best.seconds_search * ns},
            {"node_tests_per_texel", double(best.node_tests) / texels}};
}

nlohmann::json time_adaptive(const DepthMap& depth, AdaptiveOptions adaptive, const ConeOptions& options) {
    const int levels = adaptive.levels;
    const double ns = 1e9 / double(depth.level.size());
    adaptive.levels = 0;
    double start = now();
    const std::vector<ConeMap> original = bake_sector_cones_adaptive(depth, adaptive, options);
    const double original_seconds = now() - start;
    adaptive.levels = levels;
    start = now();
    const std::vector<ConeMap> fast = bake_sector_cones_adaptive(depth, adaptive, options);
    const double fast_seconds = now() - start;
    std::size_t wider = 0;
    for (std::size_t s = 0; s < fast.size(); ++s)
        for (std::size_t k = 0; k < fast[s].ratio.size(); ++k) wider += fast[s].ratio[k] > original[s].ratio[k] * 1.0001f;
    const double cones = double(depth.level.size()) * double(fast.size());
    return {{{"name", "ring search (002)"}, {"ns_per_texel", original_seconds * ns}, {"too_wide", 0.0}},
            {{"name", "adaptive (002)"}, {"ns_per_texel", fast_seconds * ns}, {"too_wide", double(wider) / cones}}};
}

nlohmann::json time_peer(const Peer& peer, const DepthMap& depth, float ratio_max, double seconds) {
    double start = now();
    const TexelBaker bake = peer.prepare(depth, ratio_max);
    const double shared = now() - start;
    // A stride that is odd and not near a divisor of the width spreads the texels over rows and columns.
    const std::size_t count = depth.level.size(), stride = (count / 2 + count / 5 + 1) | 1;
    std::size_t done = 0;
    volatile float sink = 0;
    start = now();
    for (std::size_t k = 0; done < count && (done < 16 || now() - start < seconds); ++done, k = (k + stride) % count)
        sink = bake(int(k % std::size_t(depth.grid.width)), int(k / std::size_t(depth.grid.width)));
    (void)sink;
    const double ns = (now() - start) / double(done) * 1e9 + shared / double(count) * 1e9;
    return {{"name", peer.name}, {"source", peer.source}, {"ns_per_texel", ns}, {"texels", done}};
}

} // namespace reliefbake
