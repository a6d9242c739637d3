#include "cli/explain/explain.h"

#include "cli/explain/explain_bump.h"
#include "cli/explain/explain_shape.h"
#include "cli/explain/explain_text.h"
#include "cli/explain/ratio_histogram.h"
#include "cli/options/map_hint_options.h"
#include "formats/bump_file.h"
#include "formats/map_json.h"
#include "formats/map_kind.h"
#include "formats/shape_file.h"

#include <cstdio>

namespace reliefbake {

namespace {

Result<void> explain_bump(const std::string& file, const std::string& kind, const MapHints& hints, bool as_json) {
    if (Result<void> checked = refuse_hints(hints, file, kind); !checked) return checked;
    const Result<BumpMap> map = read_bump_map(file, hints.max_bytes);
    if (!map) return tl::unexpected(map.error());
    std::fputs((as_json ? to_json(map->info, map->grid).dump(2) + "\n" : explain_bump_text(*map)).c_str(), stdout);
    return {};
}

Result<void> explain_shape(const std::string& file, const MapHints& hints, bool as_json) {
    if (Result<void> checked = refuse_hints(hints, file, "shape"); !checked) return checked;
    const Result<ShapeMap> map = read_shape_map(file, hints.max_bytes);
    if (!map) return tl::unexpected(map.error());
    std::fputs((as_json ? to_json(map->info, map->grid).dump(2) + "\n" : explain_shape_text(*map)).c_str(), stdout);
    return {};
}

} // namespace

void ExplainCommand::add_to(CLI::App& app) {
    app.add_option("FILE", options_.file, "A baked map")->required();
    CLI::Option* const json = app.add_flag("--json", options_.json, "Print one object (docs/FORMATS.md)");
    app.add_option("--histogram", options_.bins, "Count cone ratios from 0 to 1 in so many bins, as ratio_histogram")
        ->check(CLI::Range(1, 4096))
        ->needs(json);
    add_map_hints(app, options_.hints);
}

Result<void> ExplainCommand::run() {
    const Result<std::string> kind = kind_of_map(options_.file, options_.hints.max_bytes);
    if (!kind) return tl::unexpected(kind.error());
    if (options_.bins && (bump_kind_of(*kind) || *kind == "shape"))
        return fail(ErrorCode::usage, options_.file + ": a map of kind " + *kind + " holds no cones to count; leave out --histogram");
    if (bump_kind_of(*kind)) return explain_bump(options_.file, *kind, options_.hints, options_.json);
    if (*kind == "shape") return explain_shape(options_.file, options_.hints, options_.json);
    MapHints hints = options_.hints;
    hints.cones_suffice = true;
    const Result<ReliefMap> map = read_map(options_.file, hints);
    if (!map) return tl::unexpected(map.error());
    if (!options_.json) {
        std::fputs(explain_text(*map).c_str(), stdout);
        return {};
    }
    nlohmann::ordered_json json = to_json(map->info, map->grid);
    if (options_.bins) {
        Result<nlohmann::ordered_json> counted = ratio_histogram(options_.file, *map, options_.bins);
        if (!counted) return tl::unexpected(counted.error());
        json["ratio_histogram"] = std::move(*counted);
    }
    std::fputs((json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n").c_str(), stdout);
    return {};
}

} // namespace reliefbake
