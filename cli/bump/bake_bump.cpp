#include "cli/bump/bake_bump.h"

#include "cli/bump/bump_report.h"
#include "cli/command_output.h"
#include "cli/cone/stored_height.h"
#include "cli/stage_clock.h"
#include "formats/bump_file.h"

#include <cstdio>
#include <string>

namespace reliefbake {

namespace {

std::string number_text(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", number);
    return text;
}

/// The derivative of the largest code: as told, or the largest of the map; of a flat one any will do.
Result<double> derivative_scale(const BumpPlan& plan, const DerivativeMap& map) {
    constexpr double largest_half = 65504;
    const double most = largest_derivative(map);
    const auto refused = [&](const std::string& words) { return fail(ErrorCode::usage, plan.given.height.input + words); };
    if (plan.info.bits == BitDepth::half && most > largest_half)
        return refused(": its largest derivative is " + number_text(most) + ", beyond a half; use --bits float");
    if (!is_unorm(plan.info.bits)) return 1;
    if (plan.given.derivative_max && *plan.given.derivative_max < most)
        return refused(": its largest derivative is " + number_text(most) + ", above --derivative-max " + number_text(*plan.given.derivative_max));
    if (plan.given.derivative_max) return *plan.given.derivative_max;
    return most > 0 ? most : 1;
}

Result<BumpMap> bake(const BumpPlan& plan, const DepthMap& depth) {
    BumpMapInfo info = plan.info;
    switch (info.kind) {
    case BumpKind::normal: return encode_normals(info, depth, bake_normals(depth, info.depth_scale, plan.threads, info.kernel));
    case BumpKind::horizon: return encode_horizons(info, depth, bake_horizons(depth, info.depth_scale, plan.threads));
    case BumpKind::derivative: break;
    }
    const DerivativeMap derivatives = bake_derivatives(depth, info.kernel, plan.threads);
    const Result<double> scale = derivative_scale(plan, derivatives);
    if (!scale) return tl::unexpected(scale.error());
    info.derivative_scale = *scale;
    return encode_derivatives(info, depth, derivatives);
}

void tell(const BumpRun& run) {
    const ConeCommandOptions& given = run.plan.given.height;
    for (const std::string& warning : run.warnings) print_warning("bump", warning);
    if (given.quiet) return;
    print_result(given.json ? bump_result_text(run) : bump_summary(run));
}

} // namespace

void BumpCommand::add_to(CLI::App& app) { add_bump_options(app, options_); }

Result<CommandFiles> BumpCommand::files() const {
    const FoldersMadeLater later;
    const Result<BumpPlan> plan = plan_bump(options_);
    if (!plan) return tl::unexpected(plan.error());
    CommandFiles files;
    files.inputs.push_back(options_.height.input);
    files.outputs = bump_files(options_.height.output, plan->info);
    files.arguments = plan->info.argument_hash + "\n";
    files.sample_bytes = double(bytes_of_sample(plan->info.bits));
    files.planes = options_.kind == BumpKind::horizon ? 8 : 1;
    files.max_bytes = options_.height.read.max_bytes;
    return files;
}

Result<void> BumpCommand::run() {
    Result<BumpPlan> planned = plan_bump(options_);
    if (!planned) return tl::unexpected(planned.error());
    BumpPlan& plan = *planned;
    const ConeCommandOptions& given = plan.given.height;
    StageClock clock(!given.quiet);

    const Result<StoredHeight> stored = read_stored_height(given, plan.info.bits, clock);
    if (!stored) return tl::unexpected(stored.error());
    plan.info.source_hash = stored->source.pixel_hash;
    const Result<BumpMap> map = clock.time("bake", [&] { return bake(plan, stored->depth); });
    if (!map) return tl::unexpected(map.error());
    const Result<void> written = clock.time("write", [&] { return write_bump_map(given.output, *map, plan.threads); });
    if (!written) return written;
    clock.stop();
    tell({plan, stored->source, stored->report, map->info, map->grid, bump_warnings(plan, stored->source), clock.seconds()});
    return {};
}

} // namespace reliefbake
