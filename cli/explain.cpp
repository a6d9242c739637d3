#include "cli/explain.h"

#include "cli/map_hint_options.h"

#include <cstdio>

namespace reliefbake {

void ExplainCommand::add_to(CLI::App& app) {
    app.add_option("FILE", options_.file, "A baked map")->required();
    app.add_flag("--json", options_.json, "Print one object");
    add_map_hints(app, options_.hints);
}

Result<void> ExplainCommand::run() {
    const Result<ReliefMap> map = read_map(options_.file, options_.hints);
    if (!map) return tl::unexpected(map.error());
    return {};
}

} // namespace reliefbake
