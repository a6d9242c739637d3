#include "cli/bump/bump_report.h"

#include "cli/output_checks.h"
#include "cli/report/format_text.h"
#include "cli/report/height_report.h"
#include "formats/bump_file.h"

namespace reliefbake {

using nlohmann::json;

namespace {

std::string values_line(const BumpMapInfo& info) {
    switch (info.kind) {
    case BumpKind::derivative:
        return format("  derivatives by %s differences up to %.6g in %s", word_of(kernel_words, info.kernel).c_str(),
                      info.statistics.at("derivative_max"), storage_words(info.bits));
    case BumpKind::normal:
        return format("  normals by %s differences, y %s, of a relief %.6g texture widths deep, in %s", word_of(kernel_words, info.kernel).c_str(),
                      info.normal_y == NormalY::gl ? "up" : "down", info.depth_scale, storage_words(info.bits));
    case BumpKind::horizon: break;
    }
    return format("  horizons of a relief %.6g texture widths deep, sines up to %.4f, %.4f on average, in %s", info.depth_scale,
                  info.statistics.at("sine_max"), info.statistics.at("sine_mean"), storage_words(info.bits));
}

} // namespace

std::vector<std::string> bump_warnings(const BumpPlan& plan, const SourceImage& source) {
    const ConeCommandOptions& given = plan.given.height;
    std::vector<std::string> warnings;
    if (source.srgb_tagged) warnings.push_back(given.input + ": tagged sRGB, which heights are not; its codes are taken as they stand");
    if (extension_of(given.output) == ".tga")
        warnings.push_back(given.output + ": TGA keeps no metadata; whoever reads the map must know what it means");
    return warnings;
}

std::string bump_result_text(const BumpRun& run) {
    json seconds = json::object();
    for (const auto& [stage, duration] : run.seconds) seconds[stage] = duration;
    json result = height_result(run.plan.given.height, run.source, run.height, run.grid);
    result["map"] = to_json(run.info, run.grid);
    result["warnings"] = run.warnings;
    result["threads"] = run.plan.threads;
    result["seconds"] = seconds;
    // A file's name need not be UTF-8; JSON must be.
    return result.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

std::string bump_summary(const BumpRun& run) {
    const double texels = double(run.grid.width) * run.grid.height, seconds = run.seconds.back().second;
    return height_summary(run.plan.given.height, run.source, run.height, run.grid) + values_line(run.info) +
           format("; error at most %.3g\n", run.info.error) + format("  %.3g s, %.3g texels/s, %d threads\n", seconds, texels / seconds, run.plan.threads);
}

} // namespace reliefbake
