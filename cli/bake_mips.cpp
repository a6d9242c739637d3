#include "cli/bake_mips.h"

#include "bake/mips.h"
#include "bake/normal_map.h"
#include "bake/trilinear.h"
#include "cli/assemble_map.h"
#include "cli/cone_info.h"
#include "cli/cone_warnings.h"
#include "formats/map_file.h"

#include <algorithm>
#include <utility>

namespace reliefbake {

namespace {

std::vector<ConeMap> bake_all_cones(const std::vector<DepthMap>& depths, const ConeOptions& options, StageClock& clock) {
    ConeStatistics sum;
    std::vector<ConeMap> cones = clock.time("cone", [&] {
        std::vector<ConeMap> baked;
        for (const DepthMap& depth : depths) {
            ConeStatistics one;
            baked.push_back(bake_level_cones(depth, options, &one));
            sum.seconds_near += one.seconds_near;
            sum.seconds_pyramid += one.seconds_pyramid;
            sum.seconds_search += one.seconds_search;
        }
        return baked;
    });
    clock.add("cone_near", sum.seconds_near);
    clock.add("cone_pyramid", sum.seconds_pyramid);
    clock.add("cone_search", sum.seconds_search);
    return cones;
}

template <class From, class Verb>
auto each(const std::vector<From>& levels, Verb verb) {
    std::vector<decltype(verb(levels[0]))> results;
    for (const From& level : levels) results.push_back(verb(level));
    return results;
}

/// One file's metadata must hold for all of its levels; numbered files speak for themselves.
void describe_chain(std::vector<ReliefMapInfo>& infos, const ConePlan& plan) {
    for (ReliefMapInfo& info : infos) info.trilinear = plan.given.trilinear;
    if (!holds_mips(plan.given.output)) return;
    infos[0].levels = int(infos.size());
    for (const ReliefMapInfo& info : infos) infos[0].filter_delta = std::max(infos[0].filter_delta, info.filter_delta);
}

std::string file_of(const ConePlan& plan, int level) {
    return holds_mips(plan.given.output) ? plan.given.output : mip_path(plan.given.output, level).string();
}

} // namespace

Result<MipRun> bake_mips(const ConePlan& plan, const SourceImage& source, const DepthMap& depth, StageClock& clock) {
    const ConeCommandOptions& given = plan.given;

    // Every level's heights, cones, codes and normals.
    std::vector<DepthMap> depths = clock.time("mips", [&] { return bake_depth_mips(depth); });
    std::vector<ConeMap> cones = bake_all_cones(depths, plan.cone, clock);
    if (given.trilinear)
        clock.time("trilinear", [&] {
            narrow_for_trilinear(cones);
            return true;
        });
    std::vector<EncodedConeMap> encoded = clock.time("encode", [&] {
        std::vector<EncodedConeMap> codes;
        for (std::size_t n = 0; n < cones.size(); ++n)
            codes.push_back(encode_cones(cones[n], depths[n], {given.encoding, plan.bits}));
        return codes;
    });
    std::vector<NormalMap> normals = clock.time("normals", [&] {
        return each(depths, [&](const DepthMap& level) { return bake_normals(level, plan.depth_scale, plan.cone.threads); });
    });

    // What they are.
    MipRun run;
    std::vector<ReliefMapInfo> infos;
    for (std::size_t n = 0; n < cones.size(); ++n)
        infos.push_back(describe_cones(plan, source, depths[n], cones[n], encoded[n]));
    describe_chain(infos, plan);
    run.info = infos[0];
    run.warnings = cone_warnings(given, source, depths[0], cones[0], encoded[0]);
    for (std::size_t n = 0; n < cones.size(); ++n)
        run.levels.push_back({file_of(plan, int(n)), cones[n].grid, infos[n].statistics});
    cones.clear();

    // One file, or many.
    std::vector<ReliefMap> maps;
    for (std::size_t n = 0; n < depths.size(); ++n)
        maps.push_back(assemble_map(infos[n], std::move(depths[n]), std::move(encoded[n]), std::move(normals[n])));
    const Result<void> written =
        clock.time("write", [&] { return write_map_levels(given.output, maps, plan.cone.threads); });
    if (!written) return tl::unexpected(written.error());
    return run;
}

} // namespace reliefbake
