#include "cli/cone/cone_report.h"

#include "cli/choices.h"
#include "cli/report/format_text.h"
#include "cli/report/height_report.h"
#include "formats/map_json.h"

#include <cmath>

namespace reliefbake {

using nlohmann::json;

namespace {

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

/// What differs between the maps of a run.
void add_map_result(const ConeRun& run, json& whole) {
    json map = to_json(run.info, run.grid);
    json seconds = json::object();
    for (const auto& [stage, duration] : run.seconds)
        seconds[stage] = duration;
    whole["output"] = run.plan.given.output;
    whole["statistics"] = map["statistics"];
    whole["map"] = std::move(map);
    whole["warnings"] = run.warnings;
    whole["seconds"] = seconds;
    if (!run.levels.empty()) whole["levels"] = level_list(run.levels);
    if (const auto& large = run.large)
        whole["out_of_core"] = {{"rows", {large->first, large->end}}, {"band_rows", large->band_rows}, {"memory", large->memory},
                                {"working_space", large->working_space}, {"pyramid_in_memory", large->pyramid_in_memory}};
}

} // namespace

std::string cone_result_text(const std::vector<ConeRun>& runs) {
    const ConeRun& first = runs.front();
    json result = height_result(first.plan.given, first.source, first.height, first.grid);
    result["threads"] = first.plan.cone.threads;
    add_map_result(first, result);
    for (std::size_t k = 1; k < runs.size(); ++k) add_map_result(runs[k], result["also"].emplace_back());
    // A file's name need not be UTF-8; JSON must be.
    return result.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

std::string cone_summary(const ConeRun& run) {
    const auto& statistics = run.info.statistics;
    const double rows = run.large ? run.large->end - run.large->first : run.grid.height, texels = double(run.grid.width) * rows;
    const double seconds = run.seconds.back().second;
    std::string text = height_summary(run.plan.given, run.source, run.height, run.grid);
    const bool whole = run.info.statistics.contains("ratio_min") || !run.info.held.cones;
    if (!whole) text += format("  rows %d to %d alone, %s, for `merge`\n", run.large->first, run.large->end, storage_words(run.info.bits));
    else if (run.info.held.cones) text += format("  cones %s in %s, ratio %.4g at least, %.4g on average; %.0f texels with code 0\n",
                   word_of(encoding_words, run.info.encoding).c_str(), storage_words(run.info.bits),
                   statistics.at("ratio_min"), statistics.at("ratio_mean"), statistics.at("zero_codes"));
    else text += format("  no cones; %s\n", storage_words(run.info.bits));
    if (run.info.holes)
        text += format("  %.0f texels are holes, %.0f cells open\n", statistics.at("hole_texels"), statistics.at("open_cells"));
    if (run.large)
        text += format("  out of core: %d rows at a time, %.0f MiB on the disk meanwhile, within %.0f MiB of memory\n", run.large->band_rows,
                       double(run.large->working_space >> 20), double(run.large->memory >> 20));
    if (!run.levels.empty())
        text += format("  %zu mip levels, %s\n", run.levels.size(),
                       run.info.trilinear ? "safe to blend" : "one at a time (nearest mip)");
    return text +
           format("  %.3g s, %.3g texels/s, %d threads\n", seconds, texels / seconds, run.plan.cone.threads);
}

} // namespace reliefbake
