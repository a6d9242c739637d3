#include "cli/cone/bake_mips.h"

#include "bake/mips.h"
#include "bake/normal_map.h"
#include "bake/trilinear.h"
#include "cli/cone/assemble_map.h"
#include "cli/cone/bake_planes.h"
#include "cli/cone/cone_info.h"
#include "cli/cone/cone_warnings.h"
#include "formats/map_file.h"

#include <algorithm>
#include <utility>

namespace reliefbake {

namespace {

/// A level on its way from heights to channels.
struct Level {
    DepthMap depth;
    std::vector<ConeMap> cones;        ///< one, or one per sector, level of a stack or piece
    std::vector<EncodedConeMap> codes; ///< of them
    NormalMap normals;
};

void bake_cones_of(std::vector<Level>& levels, const ConePlan& plan, SharedPyramids* of_first, StageClock& clock) {
    ConeStatistics sum;
    clock.time("cone", [&] {
        for (Level& level : levels) {
            ConeStatistics one;
            level.cones = bake_planes(plan, level.depth, &one, &level == &levels.front() ? of_first : nullptr);
            sum.seconds_near += one.seconds_near;
            sum.seconds_pyramid += one.seconds_pyramid;
            sum.seconds_search += one.seconds_search;
        }
        return true;
    });
    clock.add("cone_near", sum.seconds_near);
    clock.add("cone_pyramid", sum.seconds_pyramid);
    clock.add("cone_search", sum.seconds_search);
}

/// A blend of two levels mixes each sector with itself, and each level of a stack, whose apex is a mean of apexes as the surface is
/// one of surfaces: so each plane is a chain of its own.
void narrow_planes_for_trilinear(std::vector<Level>& levels) {
    for (std::size_t plane = 0; plane < levels.front().cones.size(); ++plane) {
        std::vector<ConeMap> chain;
        for (Level& level : levels) chain.push_back(std::move(level.cones[plane]));
        narrow_for_trilinear(chain);
        for (std::size_t n = 0; n < levels.size(); ++n) levels[n].cones[plane] = std::move(chain[n]);
    }
}

/// Heights, cones, codes and normals of every level.
std::vector<Level> bake_levels(const ConePlan& plan, const MipBase& base, StageClock& clock) {
    std::vector<Level> levels;
    for (DepthMap& depth : clock.time("mips", [&] { return bake_depth_mips(base.depth); })) levels.push_back({std::move(depth), {}, {}, {}});
    if (const auto most = std::size_t(plan.given.mip_levels.value_or(int(levels.size()))); most < levels.size())
        levels.erase(levels.begin() + std::ptrdiff_t(most), levels.end());
    if (plan.given.held.cones) bake_cones_of(levels, plan, base.pyramids, clock);
    if (plan.given.trilinear)
        clock.time("trilinear", [&] {
            narrow_planes_for_trilinear(levels);
            return true;
        });
    clock.time("encode", [&] {
        for (Level& level : levels)
            for (const ConeMap& cones : level.cones)
                level.codes.push_back(encode_cones(cones, level.depth, {plan.given.encoding, plan.bits}));
        return true;
    });
    clock.time("normals", [&] {
        if (plan.given.held.normals)
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

Result<void> write_chain(const ConePlan& plan, const std::vector<ReliefMap>& maps, FileBatch& batch) {
    const Result<void> written = write_map_levels(plan.given.output, maps, batch, plan.cone.threads);
    if (!written || plan.given.relief_output.empty()) return written;
    std::vector<ReliefMap> reliefs;
    for (const ReliefMap& map : maps) reliefs.push_back(relief_map_for(map));
    return write_map_levels(plan.given.relief_output, reliefs, batch, plan.cone.threads);
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
    return clock.time("write", [&] { return write_chain(plan, maps, batch); }).map([&] { return run; });
}

} // namespace reliefbake
