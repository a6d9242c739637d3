#include "shaders-reference/renderer/shader_source.h"

#include <algorithm>
#include <cassert>

namespace reliefbake {
namespace {

std::string_view prelude_file(Prelude prelude) {
    switch (prelude) {
    case Prelude::core330: return "prelude_330.glsl";
    case Prelude::core450: return "prelude_450.glsl";
    case Prelude::es300: return "prelude_300es.glsl";
    }
    return {};
}

int encoding_number(ConeEncoding encoding) {
    switch (encoding) {
    case ConeEncoding::ratio: return 0;
    case ConeEncoding::sqrt: return 1;
    case ConeEncoding::radius: return 2;
    case ConeEncoding::normal: return 3;
    }
    return 0;
}

int lookup_number(const ShaderConfig& config) {
    if (config.technique == Technique::cone_raw) return 2;
    return config.lookup == ConeLookup::cell ? 1 : 0;
}

/// Reads that the cones cost at each look, beside the one of the height.
int cone_fetches(const ShaderConfig& config) {
    const int planes = std::max(config.sectors, config.levels);
    const int lookup = lookup_number(config);
    if (planes == 1) return lookup == 0 ? 0 : lookup == 1 ? 1 : 4;
    const int textures = config.levels > 4 ? 2 : 1; // a sector is in one
    const int beside = lookup > 0 && config.encoding == ConeEncoding::radius ? 1 : 0;
    return (textures + beside) * (lookup == 2 ? 4 : 1);
}

} // namespace

std::string_view shader_text(std::string_view name) {
    for (const ShaderText& shader : shader_texts())
        if (shader.name == name) return shader.text;
    assert(!"no such shader file");
    return {};
}

std::vector<ShaderConstant> shader_constants(const ShaderConfig& config) {
    return {{"RELIEF_ENCODING", encoding_number(config.encoding)},
            {"RELIEF_METRIC_L1", config.metric == Metric::l1},
            {"RELIEF_NORMAL_UNORM", config.normal_unorm},
            {"RELIEF_NORMAL_DX", config.normal_y == NormalY::dx},
            {"RELIEF_SECTORS", config.sectors},
            {"RELIEF_LEVELS", config.levels},
            {"RELIEF_PIECES", config.pieces},
            {"RELIEF_PLANES", std::max(config.sectors, config.levels)},
            {"RELIEF_LOOKUP", lookup_number(config)},
            {"RELIEF_CONE_FETCHES", cone_fetches(config)},
            {"RELIEF_HOLES", config.holes},
            {"RELIEF_EMPTY_CONES", config.empty_cones},
            {"RELIEF_EXACT_FINISH", config.exact_finish},
            {"SCENE_SHADOW", int(config.shadow)},
            {"SCENE_AMBIENT", int(config.ambient)}};
}

ShaderConfig shader_config(const ReliefMap& map, Technique technique, bool exact_finish) {
    const ReliefMapInfo& info = map.info;
    ShaderConfig config;
    config.encoding = info.encoding;
    config.metric = info.metric;
    config.normal_unorm = is_unorm(info.bits);
    config.normal_y = info.normal_y;
    config.sectors = info.kind == "acm" ? int(map.cone_planes.size()) : 0;
    config.pieces = info.kind == "cone-pieces";
    config.levels = config.pieces || info.kind == "cone-stack" ? int(map.cone_planes.size()) : 1;
    config.lookup = info.lookup;
    config.holes = info.holes;
    config.empty_cones = has_cones(map) && info.family == ConeFamily::conservative;
    config.technique = technique;
    config.exact_finish = exact_finish;
    if (!config.empty_cones) config.ambient = Ambient::none;
    return config;
}

std::string prelude_text(Prelude prelude) { return std::string(shader_text(prelude_file(prelude))); }

std::string vertex_source(Prelude prelude) { return prelude_text(prelude) + std::string(shader_text("fullscreen.vert")); }

std::string fragment_source(const ShaderConfig& config, Prelude prelude) {
    const TechniqueInfo& technique = technique_info(config.technique);
    std::string source = prelude_text(prelude);
    const auto define = [&source](std::string_view name, std::string_view value) {
        source.append("#define ").append(name).append(" ").append(value).append("\n");
    };
    for (const ShaderConstant& constant : shader_constants(config)) define(constant.name, std::to_string(constant.value));
    define("RELIEF_TRACE", technique.function);
    source += shader_text("relief_map.glsl");
    if (config.holes) source += shader_text("relief_holes.glsl");
    source += shader_text("relief_cones.glsl");
    for (const std::string_view file : technique.files) source += shader_text(file);
    if (config.shadow == Shadow::horizon) source += shader_text("horizon.glsl");
    source += shader_text("light.glsl");
    source += shader_text("shade.glsl");
    source += shader_text("relief_plane.frag");
    return source;
}

} // namespace reliefbake
