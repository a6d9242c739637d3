#include "cli/bake_cone.h"

#include "bake/normal_map.h"
#include "cli/assemble_map.h"
#include "cli/bake_mips.h"
#include "cli/cone_info.h"
#include "cli/cone_report.h"
#include "cli/cone_warnings.h"
#include "cli/stage_clock.h"
#include "cli/stored_height.h"
#include "formats/map_file.h"

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace reliefbake {

namespace {

std::vector<ConeMap> bake_kind(const DepthMap& depth, const ConePlan& plan, ConeStatistics& statistics) {
    if (plan.given.adaptive) return bake_sector_cones_adaptive(depth, *plan.given.adaptive, plan.cone);
    if (plan.given.kind == "acm") return bake_sector_cones(depth, plan.given.planes, plan.cone, &statistics);
    if (plan.given.kind == "cone-stack") return bake_stacked_cones(depth, plan.given.planes, plan.cone, &statistics);
    if (plan.given.kind == "cone-pieces") return bake_piecewise_cones(depth, plan.given.planes, plan.cone, &statistics);
    std::vector<ConeMap> one;
    one.push_back(bake_cones(depth, plan.cone, &statistics));
    return one;
}

std::vector<ConeMap> bake_timed_cones(const DepthMap& depth, const ConePlan& plan, StageClock& clock) {
    ConeStatistics statistics;
    std::vector<ConeMap> cones = clock.time("cone", [&] { return bake_kind(depth, plan, statistics); });
    clock.add("cone_near", statistics.seconds_near);
    clock.add("cone_pyramid", statistics.seconds_pyramid);
    clock.add("cone_search", statistics.seconds_search);
    return cones;
}

/// The ordinary cone map that goes with cones alone: its cone at a texel is the narrowest of theirs that stand on the surface.
ReliefMap relief_map_for(const ReliefMap& map, const EncodedConeMap& first) {
    ReliefMap relief{map.info, map.grid, map.normal_x, map.normal_y, first.value, map.depth, {}};
    relief.info.kind = "cone", relief.info.planes = 0, relief.info.layout = ChannelLayout::rgba;
    if (map.info.kind != "cone-stack") // codes grow with cones; the levels of a stack above the first stand above the surface
        for (const Image<float>& plane : map.cone_planes)
            for (std::size_t k = 0; k < plane.size(); ++k) relief.cone[k] = std::min(relief.cone[k], plane[k]);
    return relief;
}

void print(const ConeRun& run) {
    const ConeCommandOptions& given = run.plan.given;
    for (const std::string& warning : run.warnings)
        std::fprintf(stderr, "reliefbake cone: warning: %s\n", warning.c_str());
    if (given.quiet) return;
    std::fputs((given.json ? cone_result_text(run) : cone_summary(run)).c_str(), stdout);
}

} // namespace

void ConeCommand::add_to(CLI::App& app) { add_cone_options(app, options_); }

Result<void> ConeCommand::run() { return bake_planned(options_); }

Result<void> bake_planned(const ConeCommandOptions& options) {
    const Result<ConePlan> planned = plan_cone(options);
    if (!planned) return tl::unexpected(planned.error());
    const ConePlan& plan = *planned;
    const ConeCommandOptions& given = plan.given;
    StageClock clock(!given.quiet);

    Result<StoredHeight> stored = read_stored_height(given, plan.bits, clock);
    if (!stored) return tl::unexpected(stored.error());
    if (given.mips) {
        const Result<MipRun> mips = bake_mips(plan, stored->source, stored->depth, clock);
        if (!mips) return tl::unexpected(mips.error());
        clock.stop();
        print({plan, stored->source, stored->report, mips->info, mips->levels[0].grid, mips->warnings, clock.seconds(),
               mips->levels});
        return {};
    }
    DepthMap& depth = stored->depth;
    std::vector<ConeMap> cones = bake_timed_cones(depth, plan, clock);
    std::vector<EncodedConeMap> encoded = clock.time("encode", [&] {
        std::vector<EncodedConeMap> maps;
        for (const ConeMap& map : cones) maps.push_back(encode_cones(map, depth, {given.encoding, plan.bits}));
        return maps;
    });
    NormalMap normals = clock.time("normals", [&] {
        return bake_normals(depth, plan.depth_scale, plan.cone.threads);
    });

    const ReliefMapInfo info = describe_cones(plan, stored->source, depth, cones, encoded);
    const std::vector<std::string> warnings = cone_warnings(given, stored->source, depth, cones, encoded);
    cones = {};

    const EncodedConeMap first = given.relief_output.empty() ? EncodedConeMap{} : encoded.front();
    const ReliefMap map = assemble_map(info, std::move(depth), std::move(encoded), std::move(normals));
    const Result<void> written = clock.time("write", [&] { return write_map(given.output, map, plan.cone.threads); });
    if (!written) return written;
    if (!given.relief_output.empty()) {
        const Result<void> beside = clock.time("write_relief", [&] {
            return write_map(given.relief_output, relief_map_for(map, first), plan.cone.threads);
        });
        if (!beside) return beside;
    }
    clock.stop();
    print({plan, stored->source, stored->report, info, map.grid, warnings, clock.seconds(), {}});
    return {};
}

} // namespace reliefbake
