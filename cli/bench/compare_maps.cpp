#include "cli/bench/compare_maps.h"

#include "bake/normal_map.h"
#include "cli/bench/peers.h"
#include "cli/bench/time_cones.h"
#include "cli/cone/assemble_map.h"
#include "shaders-reference/measure/verify.h"

#include <algorithm>
#include <cmath>

namespace reliefbake {

namespace {

constexpr int largest_side_for_peers = 256; // the expanding ring takes seconds for more
constexpr double depth_scale = 0.1;

struct Candidate {
    std::string method;
    Metric metric = Metric::l2;
    Image<float> ratio;
    double ns_per_texel = 0;
};

Image<float> minimum_3x3(const Image<float>& values, const TexelGrid& grid) {
    Image<float> out(values.width(), values.height());
    for (int y = 0; y < values.height(); ++y)
        for (int x = 0; x < values.width(); ++x) {
            float least = values(x, y);
            for (int j = -1; j <= 1; ++j)
                for (int i = -1; i <= 1; ++i) least = std::min(least, values(grid.address_x(x + i), grid.address_y(y + j)));
            out(x, y) = least;
        }
    return out;
}

Candidate ours(const std::string& method, const DepthMap& depth, ConeOptions options, SurfaceModel surface, Metric metric) {
    options.surface = surface, options.metric = metric;
    const double ns = time_bake(depth, options, {}, 3)["search_ns_per_texel"];
    return {method, metric, bake_cones(depth, options).ratio, ns};
}

Candidate theirs(const Peer& peer, const DepthMap& depth, const ConeOptions& options) {
    const double ns = time_peer(peer, depth, options.ratio_max, 0.2)["ns_per_texel"];
    return {peer.name + " (" + peer.source + ")", Metric::l2, bake_peer(peer, depth, options.ratio_max, options.threads), ns};
}

std::vector<Candidate> candidates(const DepthMap& depth, const ConeOptions& options) {
    std::vector<Candidate> out;
    out.push_back(ours("reliefbake, L2", depth, options, SurfaceModel::bilinear, Metric::l2));
    out.push_back(ours("reliefbake, L1", depth, options, SurfaceModel::bilinear, Metric::l1));
    out.push_back(ours("texel cones", depth, options, SurfaceModel::texel, Metric::l2));
    const Candidate& texels = out.back();
    out.push_back({"3x3 minimum of texel cones", Metric::l2, minimum_3x3(texels.ratio, depth.grid), texels.ns_per_texel});
    if (std::max(depth.grid.width, depth.grid.height) > largest_side_for_peers) return out;
    out.push_back(theirs(expanding_ring_peer(), depth, options));
    out.push_back(theirs(quick_cone_map_peer(), depth, options));
    return out;
}

/// Every candidate claims the bilinear surface: that is what a renderer will sample.
ReliefMap as_map(const Candidate& candidate, const DepthMap& depth, float ratio_max) {
    ReliefMapInfo info;
    info.metric = candidate.metric;
    info.encoding = ConeEncoding::ratio;
    info.bits = BitDepth::float32;
    info.cone_max = ratio_max;
    info.depth_scale = depth_scale;
    info.guarantee = "C";
    DepthMap floats{depth.grid, BitDepth::float32, Image<float>(depth.grid.width, depth.grid.height)};
    for (std::size_t k = 0; k < floats.level.size(); ++k) floats.level[k] = depth.level[k] / float(max_code(depth.bits));
    const ConeMap cones{depth.grid, {}, candidate.ratio};
    ConeMap capped = cones;
    capped.options.ratio_max = ratio_max;
    const EncodedConeMap encoded = encode_cones(capped, floats, {info.encoding, info.bits});
    return assemble_map(info, floats, {encoded}, bake_normals(floats, depth_scale));
}

} // namespace

Result<nlohmann::json> compare_maps(const DepthMap& depth, const ConeOptions& options) {
    nlohmann::json rows = nlohmann::json::array();
    VerifyOptions judge;
    judge.threads = options.threads;
    for (const Candidate& candidate : candidates(depth, options)) {
        const Result<VerifyReport> report = verify(as_map(candidate, depth, options.ratio_max), judge);
        if (!report) return tl::unexpected(report.error());
        const nlohmann::json measured = to_json(*report);
        nlohmann::json row{{"method", candidate.method}, {"bake_ns_per_texel", candidate.ns_per_texel}};
        for (const char* key : {"violations", "points", "missed", "early", "rays", "steps_mean", "steps_max", "tightness"})
            row[key] = measured.at(key);
        rows.push_back(std::move(row));
    }
    return rows;
}

} // namespace reliefbake
