#include "cli/cone_info.h"

#include "bake/filter_delta.h"
#include "cli/version.h"
#include "formats/shortest_decimal.h"

#include <algorithm>
#include <numeric>

namespace reliefbake {

namespace {

std::map<std::string, double> statistics_of(const DepthMap& depth, const ConeMap& cones,
                                            const EncodedConeMap& encoded) {
    const auto [shallow, deep] = std::minmax_element(depth.level.begin(), depth.level.end());
    const double sum = std::accumulate(cones.ratio.begin(), cones.ratio.end(), 0.0);
    return {{"depth_min", double(*shallow) / max_code(depth.bits)},
            {"depth_max", double(*deep) / max_code(depth.bits)},
            {"ratio_min", shortest_decimal(*std::min_element(cones.ratio.begin(), cones.ratio.end()))},
            {"ratio_mean", sum / double(cones.ratio.size())},
            {"zero_codes", double(encoded.zero_codes)}};
}

} // namespace

ReliefMapInfo describe_cones(const ConePlan& plan, const SourceImage& source, const DepthMap& depth,
                             const ConeMap& cones, const EncodedConeMap& encoded) {
    ReliefMapInfo info;
    info.metric = cones.options.metric;
    info.encoding = encoded.encoding;
    info.bits = encoded.bits;
    info.surface = cones.options.surface;
    info.layout = plan.layout;
    info.normal_y = plan.given.normal_y;
    info.cone_max = encoded.ratio_max;
    info.depth_scale = plan.depth_scale;
    info.filter_delta = filter_delta(depth);
    info.tolerance = shortest_decimal(cones.options.tolerance);
    info.guarantee = "C";
    info.version = version();
    info.source_hash = source.pixel_hash;
    info.argument_hash = plan.argument_hash;
    info.statistics = statistics_of(depth, cones, encoded);
    return info;
}

} // namespace reliefbake
