#include "cli/shape/shape_report.h"

#include "bake/wrap_words.h"
#include "cli/report/format_text.h"
#include "cli/shape/shape_choices.h"
#include "formats/shape_file.h"

namespace reliefbake {

using nlohmann::json;

namespace {

/// Texels that one code of an integer format stands for.
double texels_a_code(const ShapeMapInfo& info) {
    return info.scale_f * info.max_distance * (info.signed_distance ? 2 : 1) / max_code(info.bits);
}

} // namespace

std::vector<std::string> shape_warnings(const ShapeCommandOptions& options, const BinaryShape& shape, const ShapeMapInfo& info) {
    std::vector<std::string> warnings;
    if (shape.empty())
        warnings.push_back(options.input + ": no texel is inside the shape; its distance is taken to be the map's diagonal (--threshold, --invert, --channel)");
    if (shape.full()) warnings.push_back(options.input + ": every texel is inside the shape (--threshold, --invert, --channel)");
    if (is_unorm(info.bits) && texels_a_code(info) > 1)
        warnings.push_back(options.output + format(": one code stands for %.3g texels, and shorter distances are 0; "
                                                   "--bits 16 or a smaller --scale-f keeps them", texels_a_code(info)));
    const double farthest = info.scale_f * info.max_distance;
    constexpr double filter_cost = 0.70710678118654757; // of guarantee S, texels
    if (farthest > 0 && farthest <= filter_cost)
        warnings.push_back(options.output + format(": its distances end at %.3g texels, and filtering them costs %.3g: no ray gets on, all of a solid looks filled; ", farthest, filter_cost) +
                           (info.max_distance > filter_cost ? "use a larger --scale-f" : "use a larger picture of the shape"));
    return warnings;
}

std::string shape_result_text(const ShapeRun& run) {
    json seconds = json::object();
    for (const auto& [stage, duration] : run.seconds) seconds[stage] = duration;
    const json result = {
        {"input", run.plan.given.input},
        {"output", run.plan.given.output},
        {"source",
         {{"format", run.source.format},
          {"channel", run.source.channel},
          {"bit_depth", run.source.bit_depth},
          {"is_integer", run.source.is_integer}}},
        {"inside", run.plan.shape.bright_is_inside != run.plan.shape.invert ? "bright" : "dark"},
        {"map", to_json(run.info, run.grid)},
        {"warnings", run.warnings},
        {"threads", run.plan.bake.threads},
        {"seconds", seconds},
    };
    // A file's name need not be UTF-8; JSON must be.
    return result.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

std::string shape_summary(const ShapeRun& run) {
    const ShapeMapInfo& info = run.info;
    const double texels = double(run.grid.width) * run.grid.height, inside = info.statistics.at("inside_texels");
    const bool bright = run.plan.shape.bright_is_inside != run.plan.shape.invert;
    std::string text = run.plan.given.output + format(": %d x %d from %s of ", run.grid.width, run.grid.height, run.source.channel.c_str()) +
                       run.plan.given.input + "\n";
    text += format("  %s texels are inside: %.4g %% of all; wrap %s, %s\n", bright ? "bright" : "dark", 100 * inside / texels,
                   word_of_wrap(run.grid.wrap_x), word_of_wrap(run.grid.wrap_y));
    text += format("  %s%s distances to %s in %s, at most %.6g texels; tau %.6g\n", info.signed_distance ? "signed " : "",
                   word_of(method_words, info.method).c_str(), word_of(model_words, info.model).c_str(), storage_words(info.bits),
                   info.max_distance, info.tau);
    return text + format("  %.3g s, %d threads\n", run.seconds.back().second, run.plan.bake.threads);
}

} // namespace reliefbake
