#include "cli/shader.h"

#include "cli/choices.h"
#include "cli/map_hint_options.h"

#include <cstdio>

namespace reliefbake {

namespace {

const Words<ShaderLanguage> language_words = {
    {"glsl", ShaderLanguage::glsl}, {"glsl-es", ShaderLanguage::glsl_es}, {"hlsl", ShaderLanguage::hlsl}};

} // namespace

void ShaderCommand::add_to(CLI::App& app) {
    app.add_option("--for", options_.file, "A baked map")->required()->type_name("FILE");
    add_choice(app, "--language", options_.language, language_words, "GLSL 3.30 or ES 3.00, or HLSL (default glsl)");
    add_map_hints(app, options_.hints);
}

Result<void> ShaderCommand::run() {
    const Result<ReliefMap> map = read_map(options_.file, options_.hints);
    if (!map) return tl::unexpected(map.error());
    const Result<std::string> text = export_shader(*map, options_.language);
    if (!text) return fail(text.error().code, options_.file + ": " + text.error().message);
    std::fputs(text->c_str(), stdout);
    return {};
}

} // namespace reliefbake
