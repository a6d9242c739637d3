#include "cli/advise/apply_advice.h"

#include "cli/advise/bake_command_text.h"
#include "cli/cone/bake_command.h"
#include "cli/cone/bake_maps.h"
#include "cli/output_checks.h"
#include "formats/map_file.h"
#include "formats/map_layout.h"

#include <filesystem>

namespace reliefbake {
namespace {

/// The command's options as its own parser reads them, so that the file is the one that the printed command bakes.
Result<ConeCommandOptions> options_of(const ConeCommandOptions& source, const std::string& output, const Representation& map) {
    Result<ConeCommandOptions> options = parse_also(bake_command_text(map) + " -o OUT", source);
    if (options) options->output = output, options->json = false, options->quiet = true;
    return options;
}

/// All figures that do not depend on the clock.
bool same_figures(const Measurement& a, const Measurement& b) {
    return a.rays == b.rays && a.missed == b.missed && a.early == b.early && a.out_of_steps == b.out_of_steps && a.error_mean == b.error_mean && a.error_deviation == b.error_deviation && a.error_p99 == b.error_p99 &&
           a.error_max == b.error_max && a.mse == b.mse && a.dissimilarity == b.dissimilarity && a.steps_mean == b.steps_mean && a.steps_max == b.steps_max && a.fetches_mean == b.fetches_mean;
}

} // namespace

Result<void> check_apply(const std::string& input, const std::string& output) {
    const std::string extension = extension_of(output);
    if (extension != ".png" && extension != ".tif" && extension != ".exr")
        return fail(ErrorCode::usage, "--output: expected .png, .tif or .exr, which say what their map means and are judged again, found '" + output + "'");
    return validate_not_input(input, output).and_then([&] { return validate_output_folder(output); });
}

bool can_hold(const std::string& output, const Representation& map) {
    ReliefMapInfo info;
    info.bits = map.bits;
    if (map.has_cones() && map.kind != "cone") info.kind = map.kind, info.planes = map.planes, info.layout = ChannelLayout::named;
    info.held.cones = map.has_cones();
    return check_map_format(output, info) && holds_relief(info);
}

Result<void> apply_advice(const ConeCommandOptions& source, const std::string& output, const Trial& answer, const std::function<Result<Measurement>(const ReliefMap&)>& measure) {
    const Result<ConeCommandOptions> options = options_of(source, output, answer.candidate.map);
    if (!options) return tl::unexpected(options.error());
    const Result<ConePlan> plan = plan_cone(*options);
    if (!plan) return tl::unexpected(plan.error());
    const Result<BakedMaps> baked = bake_maps({*plan});
    if (!baked) return tl::unexpected(baked.error());
    const Result<Measurement> figures = read_map(output).and_then(measure);
    if (figures && same_figures(*figures, answer.figures)) return {};
    std::error_code ignored;
    std::filesystem::remove(output, ignored);
    if (!figures) return tl::unexpected(figures.error());
    return fail(ErrorCode::internal, output + ": the map that was baked has other figures than the one that was measured; it was removed");
}

} // namespace reliefbake
