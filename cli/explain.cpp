#include "cli/explain.h"

#include "cli/explain_text.h"
#include "cli/map_hint_options.h"
#include "formats/map_json.h"

#include <cstdio>

namespace reliefbake {

void ExplainCommand::add_to(CLI::App& app) {
    app.add_option("FILE", options_.file, "A baked map")->required();
    app.add_flag("--json", options_.json, "Print one object (docs/FORMATS.md)");
    add_map_hints(app, options_.hints);
}

Result<void> ExplainCommand::run() {
    MapHints hints = options_.hints;
    hints.cones_suffice = true;
    const Result<ReliefMap> map = read_map(options_.file, hints);
    if (!map) return tl::unexpected(map.error());
    const auto replace = nlohmann::json::error_handler_t::replace;
    const std::string text = options_.json ? to_json(map->info, map->grid).dump(2, ' ', false, replace) + "\n"
                                           : explain_text(*map);
    std::fputs(text.c_str(), stdout);
    return {};
}

} // namespace reliefbake
