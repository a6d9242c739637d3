#include "cli/bake_cone.h"

#include "bake/normal_map.h"
#include "cli/assemble_map.h"
#include "cli/bake_mips.h"
#include "cli/cone_info.h"
#include "cli/cone_report.h"
#include "cli/cone_warnings.h"
#include "cli/stage_clock.h"
#include "formats/map_file.h"

#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace reliefbake {

namespace {

/// A no-data value is given in the file's own numbers; the plane of an integer file is scaled to 0..1.
HeightOptions with_no_data(HeightOptions options, const SourceImage& source) {
    if (!options.no_data) options.no_data = source.no_data;
    if (options.no_data && source.is_integer)
        options.no_data = float(*options.no_data / (std::ldexp(1.0, source.bit_depth) - 1));
    return options;
}

/// The stored surface, and where it comes from.
struct StoredHeight {
    SourceImage source; ///< its plane is gone
    HeightReport report;
    DepthMap depth;
};

Result<StoredHeight> read_depth(const ConePlan& plan, StageClock& clock) {
    const ConeCommandOptions& given = plan.given;
    Result<SourceImage> source = clock.time("read", [&] { return read_image(given.input, given.read); });
    if (!source) return tl::unexpected(source.error());
    const Result<CheckedHeight> height = clock.time("height", [&] {
        return make_height_field(source->plane, source->is_integer, with_no_data(given.height, *source),
                                 given.input);
    });
    if (!height) return tl::unexpected(height.error());
    source->plane = {};
    DepthMap depth = clock.time("quantise", [&] { return quantise_depth(height->field, plan.bits); });
    return StoredHeight{std::move(*source), height->report, std::move(depth)};
}

ConeMap bake_timed_cones(const DepthMap& depth, const ConeOptions& options, StageClock& clock) {
    ConeStatistics statistics;
    ConeMap cones = clock.time("cone", [&] { return bake_cones(depth, options, &statistics); });
    clock.add("cone_near", statistics.seconds_near);
    clock.add("cone_pyramid", statistics.seconds_pyramid);
    clock.add("cone_search", statistics.seconds_search);
    return cones;
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

Result<void> ConeCommand::run() {
    const Result<ConePlan> plan = plan_cone(options_);
    if (!plan) return tl::unexpected(plan.error());
    return bake(*plan);
}

Result<void> ConeCommand::bake(const ConePlan& plan) {
    const ConeCommandOptions& given = plan.given;
    StageClock clock(!given.quiet);

    Result<StoredHeight> stored = read_depth(plan, clock);
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
    ConeMap cones = bake_timed_cones(depth, plan.cone, clock);
    EncodedConeMap encoded = clock.time("encode", [&] {
        return encode_cones(cones, depth, {given.encoding, plan.bits});
    });
    NormalMap normals = clock.time("normals", [&] {
        return bake_normals(depth, plan.depth_scale, plan.cone.threads);
    });

    const ReliefMapInfo info = describe_cones(plan, stored->source, depth, cones, encoded);
    const std::vector<std::string> warnings = cone_warnings(given, stored->source, depth, cones, encoded);
    cones = {};

    const ReliefMap map = assemble_map(info, std::move(depth), std::move(encoded), std::move(normals));
    const Result<void> written =
        clock.time("write", [&] { return write_map(given.output, map, plan.cone.threads); });
    if (!written) return written;
    clock.stop();
    print({plan, stored->source, stored->report, info, map.grid, warnings, clock.seconds(), {}});
    return {};
}

} // namespace reliefbake
