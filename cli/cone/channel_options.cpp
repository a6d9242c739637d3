#include "cli/cone/channel_options.h"

#include "cli/options/solid_options.h"

#include <sstream>

namespace reliefbake {

namespace {

constexpr const char* expected = "expected depth, with normal or cone or both before it, e.g. cone,depth";

HeldPlanes require_planes(const std::string& text) {
    HeldPlanes held{false, false};
    bool depth = false;
    std::istringstream words(text);
    for (std::string word; std::getline(words, word, ',');) {
        bool* plane = word == "normal" ? &held.normals : word == "cone" ? &held.cones : word == "depth" ? &depth : nullptr;
        if (!plane || *plane) throw CLI::ValidationError("--channels", std::string(expected) + "; found '" + text + "'");
        *plane = true;
    }
    if (!depth || text.back() == ',') throw CLI::ValidationError("--channels", std::string(expected) + "; found '" + text + "'");
    return held;
}

} // namespace

void add_channels_option(CLI::App& app, ConeCommandOptions& options) {
    app.option_defaults()->group("Result");
    app.add_option_function<std::string>(
           "--channels", [&options](const std::string& text) { options.held = require_planes(text); },
           "What the map holds, so many channels in this order; without cones none are baked (default normal,cone,depth)")
        ->type_name("LIST");
}

Result<void> check_channels(const CLI::App& app, const ConeCommandOptions& options) {
    if (!options.held.normals)
        if (Result<void> fits = refuse_given(app, "", {"--normal-y"}, "--channels leaves the normals out"); !fits) return fits;
    if (options.held.cones) return {};
    return refuse_given(app, "", {"--surface", "--metric", "--tolerance", "--cone-max", "--kind", "--relaxed", "--delta", "--lookup", "--encoding", "--trilinear"},
                        "--channels leaves the cones out");
}

} // namespace reliefbake
