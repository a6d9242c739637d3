#include "cli/bench/bench_peer.h"

#include "bake/normal_map.h"
#include "bake/stored_code.h"
#include "cli/choices.h"
#include "cli/cone/assemble_map.h"
#include "cli/options/map_hint_options.h"
#include "cli/options/thread_option.h"
#include "cli/version.h"
#include "shaders-reference/measure/stored_depth.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>

namespace reliefbake {

namespace {

const Words<Peer>& peer_words() {
    static const Words<Peer> words = [] {
        Words<Peer> all;
        for (const Peer& peer : all_peers()) all.emplace_back(peer.word, peer);
        return all;
    }();
    return words;
}

/// What its authors say of the peer's cones: texel centres, filtered by the sampler like any map. Nothing is guaranteed.
ReliefMapInfo peer_info(const ReliefMapInfo& of, const Peer& peer) {
    ReliefMapInfo info;
    info.family = peer.family;
    info.rays = peer.family == ConeFamily::relaxed ? RelaxedRays::top : RelaxedRays::strict;
    info.encoding = of.encoding;
    info.bits = of.bits;
    info.normal_y = of.normal_y;
    info.cone_max = of.cone_max;
    info.depth_scale = of.depth_scale;
    info.filter_delta = of.filter_delta;
    info.version = version();
    info.source_hash = of.source_hash;
    return info;
}

} // namespace

void BenchPeerCommand::add_to(CLI::App& app) {
    add_choice(app, "METHOD", peer_, peer_words(), "Whose cones")->required();
    app.add_option("MAP", file_, "A baked map; its stored depth is the surface")->required();
    app.add_option("-o,--output", output_, "Map to write, with the encoding and bits of MAP")->required()->type_name("OUT");
    add_thread_option(app, threads_);
    app.add_flag("--json", json_, "Print one object");
    add_map_hints(app, hints_);
}

Result<void> BenchPeerCommand::check_output(const ReliefMapInfo& info) const {
    std::error_code ignored;
    for (const std::filesystem::path& input : {std::filesystem::path(file_), hints_.relief})
        if (std::filesystem::equivalent(input, output_, ignored))
            return fail(ErrorCode::usage, output_ + ": the output is an input file; choose another name");
    return check_map_format(output_, info);
}

Result<void> BenchPeerCommand::run() {
    const Result<int> threads = resolve_threads(threads_);
    if (!threads) return tl::unexpected(threads.error());
    const Result<ReliefMap> map = read_map(file_, hints_);
    if (!map) return tl::unexpected(map.error());
    if (map->depth.empty()) return fail(ErrorCode::usage, file_ + ": the map has no depth channel: there is no surface to bake for");
    const ReliefMapInfo info = peer_info(map->info, peer_);
    if (Result<void> checked = check_output(info); !checked) return checked;
    const DepthMap depth = stored_depth(*map);

    const auto start = std::chrono::steady_clock::now();
    ConeMap cones{depth.grid, {}, bake_peer(peer_, depth, info.cone_max, *threads)};
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    cones.options.ratio_max = info.cone_max;

    const EncodedConeMap encoded = encode_cones(cones, depth, {info.encoding, info.bits});
    const ReliefMap written = assemble_map(info, depth, {encoded}, bake_normals(depth, info.depth_scale, *threads));
    if (Result<void> done = write_map(output_, written, *threads); !done) return done;
    const nlohmann::json report{{"method", peer_.word}, {"name", peer_.name}, {"source", peer_.source}, {"width", depth.grid.width},
                                {"height", depth.grid.height}, {"threads", *threads}, {"seconds", seconds}};
    if (json_) std::printf("%s\n", report.dump(2).c_str());
    else std::printf("%s: %s (%s), %dx%d, %.3g s on %d thread(s)\n", output_.c_str(), peer_.name.c_str(), peer_.source.c_str(), depth.grid.width,
                     depth.grid.height, seconds, *threads);
    return {};
}

} // namespace reliefbake
