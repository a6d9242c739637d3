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

std::vector<ConeMap> bake_all_cones(const std::vector<DepthMap>& depths, const ConeOptions& options, SharedPyramids* of_first,
                                    StageClock& clock) {
    ConeStatistics sum;
    std::vector<ConeMap> cones = clock.time("cone", [&] {
        std::vector<ConeMap> baked;
        for (const DepthMap& depth : depths) {
            ConeStatistics one;
            baked.push_back(bake_level_cones(depth, options, &one, baked.empty() ? of_first : nullptr));
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

/// A level on its way from heights to channels.
struct Level {
    DepthMap depth;
    std::vector<ConeMap> cones;        ///< one
    std::vector<EncodedConeMap> codes; ///< of it
    NormalMap normals;
};

/// Heights, cones, codes and normals of every level.
std::vector<Level> bake_levels(const ConePlan& plan, const MipBase& base, StageClock& clock) {
    std::vector<DepthMap> depths = clock.time("mips", [&] { return bake_depth_mips(base.depth); });
    std::vector<ConeMap> cones = bake_all_cones(depths, plan.cone, base.pyramids, clock);
    if (plan.given.trilinear)
        clock.time("trilinear", [&] {
            narrow_for_trilinear(cones);
            return true;
        });
    std::vector<Level> levels(depths.size());
    for (std::size_t n = 0; n < levels.size(); ++n) {
        levels[n].depth = std::move(depths[n]);
        levels[n].cones.push_back(std::move(cones[n]));
    }
    clock.time("encode", [&] {
        for (Level& level : levels)
            level.codes.push_back(encode_cones(level.cones[0], level.depth, {plan.given.encoding, plan.bits}));
        return true;
    });
    clock.time("normals", [&] {
        for (Level& level : levels) level.normals = bake_normals(level.depth, plan.depth_scale, plan.cone.threads);
        return true;
    });
    return levels;
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

Result<MipRun> bake_mips(const ConePlan& plan, const BakeSource& source, const MipBase& base, FileBatch& batch, StageClock& clock) {
    std::vector<Level> levels = bake_levels(plan, base, clock);

    // Say what they are.
    MipRun run;
    std::vector<ReliefMapInfo> infos;
    for (const Level& level : levels)
        infos.push_back(describe_cones(plan, source, level.depth, level.cones, level.codes));
    describe_chain(infos, plan);
    run.info = infos[0];
    run.warnings = cone_warnings(plan.given, source.image, levels[0].depth, levels[0].cones, levels[0].codes);
    for (std::size_t n = 0; n < levels.size(); ++n)
        run.levels.push_back({file_of(plan, int(n)), levels[n].depth.grid, infos[n].statistics});

    // Write one file, or many.
    std::vector<ReliefMap> maps;
    for (std::size_t n = 0; n < levels.size(); ++n) {
        Level level = std::move(levels[n]);
        maps.push_back(assemble_map(infos[n], std::move(level.depth), std::move(level.codes), std::move(level.normals)));
    }
    const Result<void> written =
        clock.time("write", [&] { return write_map_levels(plan.given.output, maps, batch, plan.cone.threads); });
    if (!written) return tl::unexpected(written.error());
    return run;
}

} // namespace reliefbake
