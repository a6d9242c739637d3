#include "cli/render/shader.h"

#include "cli/choices.h"
#include "cli/options/map_hint_options.h"
#include "formats/bump_file.h"
#include "formats/map_kind.h"
#include "formats/shape_file.h"
#include "shaders-reference/renderer/bump_export.h"
#include "shaders-reference/renderer/shape_export.h"

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
    const Result<std::string> kind = kind_of_map(options_.file, options_.hints.max_bytes);
    if (!kind) return tl::unexpected(kind.error());
    if (bump_kind_of(*kind)) {
        if (Result<void> checked = refuse_hints(options_.hints, options_.file, *kind); !checked) return checked;
        const Result<BumpMap> bump = read_bump_map(options_.file, options_.hints.max_bytes);
        if (!bump) return tl::unexpected(bump.error());
        std::fputs(export_bump_shader(*bump, options_.language).c_str(), stdout);
        return {};
    }
    if (*kind == "shape") {
        if (Result<void> checked = refuse_hints(options_.hints, options_.file, *kind); !checked) return checked;
        const Result<ShapeMap> shape = read_shape_map(options_.file, options_.hints.max_bytes);
        if (!shape) return tl::unexpected(shape.error());
        std::fputs(export_shape_shader(*shape, options_.language).c_str(), stdout);
        return {};
    }
    const Result<ReliefMap> map = read_map(options_.file, options_.hints);
    if (!map) return tl::unexpected(map.error());
    const Result<std::string> text = export_shader(*map, options_.language);
    if (!text) return fail(text.error().code, options_.file + ": " + text.error().message);
    std::fputs(text->c_str(), stdout);
    return {};
}

} // namespace reliefbake
