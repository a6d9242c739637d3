#include "cli/cone_report.h"

#include "cli/choices.h"
#include "formats/map_json.h"
#include "formats/shortest_decimal.h"

#include <cmath>
#include <cstdio>

namespace reliefbake {

using nlohmann::json;

namespace {

template <class... Args>
std::string format(const char* pattern, Args... args) {
    char text[512];
    std::snprintf(text, sizeof text, pattern, args...);
    return text;
}

const char* word_of_wrap(Wrap wrap) { return wrap == Wrap::repeat ? "repeat" : "clamp"; }

bool was_chosen(const HeightOptions& options) {
    return options.wrap_x == WrapChoice::automatic || options.wrap_y == WrapChoice::automatic;
}

std::string range_line(const HeightReport& height) {
    const char* origin = height.range_from_data ? "the source's extremes" : "as declared or by the format";
    std::string line = format("  height 0..1 is source %g..%g, %s; the source spans %g..%g", height.range_low,
                              height.range_high, origin, height.source_low, height.source_high);
    if (height.bad_texels > 0) line += format("; %zu texels filled", height.bad_texels);
    return line + "\n";
}

json level_list(const std::vector<MipReport>& levels) {
    json list = json::array();
    for (const MipReport& level : levels) {
        json statistics = json::object();
        for (const auto& [name, value] : level.statistics)
            statistics[name] = std::isinf(value) ? json("inf") : json(value);
        list.push_back({{"output", level.output},
                        {"width", level.grid.width},
                        {"height", level.grid.height},
                        {"statistics", std::move(statistics)}});
    }
    return list;
}

json cone_result(const ConeRun& run) {
    const HeightReport& h = run.height;
    json seconds = json::object();
    for (const auto& [stage, duration] : run.seconds)
        seconds[stage] = duration;
    const auto number = [](double sample) { return shortest_decimal(float(sample)); };
    const json map = to_json(run.info, run.grid);
    json result = {
        {"input", run.plan.given.input},
        {"output", run.plan.given.output},
        {"source",
         {{"format", run.source.format},
          {"channel", run.source.channel},
          {"bit_depth", run.source.bit_depth},
          {"is_integer", run.source.is_integer},
          {"low", number(h.source_low)},
          {"high", number(h.source_high)},
          {"filled_texels", h.bad_texels}}},
        {"range", {{"low", number(h.range_low)}, {"high", number(h.range_high)}, {"from_data", h.range_from_data}}},
        {"wrap", {word_of_wrap(run.grid.wrap_x), word_of_wrap(run.grid.wrap_y)}},
        {"seam", {h.seam_x.border, h.seam_y.border}},
        {"map", map},
        {"statistics", map["statistics"]},
        {"warnings", run.warnings},
        {"threads", run.plan.cone.threads},
        {"seconds", seconds},
    };
    if (!run.levels.empty()) result["levels"] = level_list(run.levels);
    return result;
}

} // namespace

std::string cone_result_text(const ConeRun& run) {
    // A file's name need not be UTF-8; JSON must be.
    return cone_result(run).dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

std::string cone_summary(const ConeRun& run) {
    const auto& statistics = run.info.statistics;
    const double texels = double(run.grid.width) * run.grid.height;
    const double seconds = run.seconds.back().second;
    std::string text = run.plan.given.output + ": " +
                       format("%d x %d from %s of %s", run.grid.width, run.grid.height,
                              run.source.channel.c_str(), run.plan.given.input.c_str()) +
                       "\n" + range_line(run.height);
    text += format("  wrap %s, %s (%s; seam %.2f, %.2f)\n", word_of_wrap(run.grid.wrap_x),
                   word_of_wrap(run.grid.wrap_y), was_chosen(run.plan.given.height) ? "measured" : "as told",
                   run.height.seam_x.border, run.height.seam_y.border);
    text += format("  cones %s in %s, ratio %.4g at least, %.4g on average; %.0f texels with code 0\n",
                   word_of(encoding_words, run.info.encoding).c_str(), storage_words(run.info.bits),
                   statistics.at("ratio_min"), statistics.at("ratio_mean"), statistics.at("zero_codes"));
    if (!run.levels.empty())
        text += format("  %zu mip levels, %s\n", run.levels.size(),
                       run.info.trilinear ? "safe to blend" : "one at a time (nearest mip)");
    return text +
           format("  %.3g s, %.3g texels/s, %d threads\n", seconds, texels / seconds, run.plan.cone.threads);
}

} // namespace reliefbake
