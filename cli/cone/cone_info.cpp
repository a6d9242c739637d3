#include "cli/cone/cone_info.h"

#include "bake/filter_delta.h"
#include "cli/version.h"
#include "formats/shortest_decimal.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace reliefbake {

namespace {

/// Of the surface.
std::map<std::string, double> statistics_of(const DepthMap& depth) {
    const auto [shallow, deep] = std::minmax_element(depth.level.begin(), depth.level.end());
    std::map<std::string, double> statistics = {{"depth_min", double(*shallow) / max_code(depth.bits)}, {"depth_max", double(*deep) / max_code(depth.bits)}};
    if (!depth.holes) return statistics;
    const HoleCount holes = count_holes(depth);
    statistics["hole_texels"] = double(holes.texels), statistics["open_cells"] = double(holes.cells);
    return statistics;
}

/// Over all planes of cones.
void add_statistics(const std::vector<ConeMap>& cones, const std::vector<EncodedConeMap>& encoded, std::map<std::string, double>& statistics) {
    double sum = 0, texels = 0, zero_codes = 0;
    float least = std::numeric_limits<float>::infinity();
    for (std::size_t k = 0; k < cones.size(); ++k) {
        const Image<float>& ratio = cones[k].ratio;
        for (int y = 0; y < ratio.height(); ++y) sum += sum_of_row(ratio, y);
        texels += double(ratio.size());
        least = std::min(least, *std::min_element(ratio.begin(), ratio.end()));
        zero_codes += double(encoded[k].zero_codes);
    }
    statistics["ratio_min"] = shortest_decimal(least), statistics["ratio_mean"] = sum / texels, statistics["zero_codes"] = zero_codes;
}

} // namespace

std::string guarantee_of(const ConeOptions& options) {
    if (options.family == ConeFamily::conservative) return std::string(1, 'C'); // GCC 12 warns about plain literals (bug 105651)
    return options.rays == RelaxedRays::strict ? std::string(1, 'R') : std::string();
}

double sum_of_row(const Image<float>& plane, int y) { return std::accumulate(plane.row(y), plane.row(y) + plane.width(), 0.0); }

ReliefMapInfo describe_surface(const ConePlan& plan, const std::string& source_hash, const DepthMap& depth, const ConeOptions& options) {
    ReliefMapInfo info;
    info.kind = plan.given.kind;
    info.planes = plan.given.kind == "cone" ? 0 : plan.given.planes;
    info.family = options.family;
    info.rays = options.rays;
    info.relaxed_slope = shortest_decimal(options.relaxed_slope);
    info.hybrid_delta = shortest_decimal(options.hybrid_delta);
    info.lookup = options.lookup;
    info.metric = options.metric;
    info.encoding = plan.given.encoding;
    info.bits = depth.bits;
    info.surface = options.surface;
    info.layout = plan.layout;
    info.held = plan.given.held;
    info.normal_y = plan.given.normal_y;
    info.cone_max = options.ratio_max;
    info.depth_scale = plan.depth_scale;
    info.holes = depth.holes;
    info.filter_delta = filter_delta(depth);
    info.tolerance = shortest_decimal(options.tolerance);
    info.guarantee = plan.given.adaptive || !plan.given.held.cones ? std::string() : guarantee_of(options);
    info.version = version();
    info.source_hash = source_hash;
    info.argument_hash = plan.argument_hash;
    info.statistics = statistics_of(depth);
    return info;
}

ReliefMapInfo describe_cones(const ConePlan& plan, const BakeSource& source, const DepthMap& depth,
                             const std::vector<ConeMap>& cones, const std::vector<EncodedConeMap>& encoded) {
    ReliefMapInfo info = describe_surface(plan, source.image.pixel_hash, depth, cones.empty() ? plan.cone : cones.front().options);
    info.alpha_hash = source.alpha_hash;
    if (cones.empty()) info.guarantee.clear();
    else add_statistics(cones, encoded, info.statistics);
    if (!encoded.empty()) info.cone_max = encoded.front().ratio_max;
    return info;
}

} // namespace reliefbake
