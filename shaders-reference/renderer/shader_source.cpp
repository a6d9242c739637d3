#include "shaders-reference/renderer/shader_source.h"

#include <cassert>

namespace reliefbake {
namespace {

std::string_view shader_text(std::string_view name) {
    for (const ShaderText& shader : shader_texts())
        if (shader.name == name) return shader.text;
    assert(!"no such shader file");
    return {};
}

std::string_view prelude_file(Prelude prelude) {
    switch (prelude) {
    case Prelude::core330: return "prelude_330.glsl";
    case Prelude::core450: return "prelude_450.glsl";
    case Prelude::es300: return "prelude_300es.glsl";
    }
    return {};
}

struct TechniqueFiles {
    std::vector<std::string_view> files;
    std::string_view function;
};

TechniqueFiles technique_files(Technique technique) {
    switch (technique) {
    case Technique::cone: return {{"patch_hit.glsl", "cone_march.glsl"}, "cone_march"};
    case Technique::cone_published: return {{"cone_march_published.glsl"}, "cone_march_published"};
    case Technique::linear: return {{"linear_search.glsl"}, "linear_search"};
    case Technique::binary: return {{"linear_search.glsl", "binary_search.glsl"}, "binary_search"};
    case Technique::given: return {{"given_hits.glsl"}, "given_hit"};
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

std::string define(std::string_view name, std::string_view value) {
    std::string line("#define ");
    return line.append(name).append(" ").append(value).append("\n");
}

} // namespace

ShaderConfig shader_config(const ReliefMapInfo& info, Technique technique, bool exact_finish) {
    return {info.encoding, info.metric, is_unorm(info.bits), info.normal_y, technique, exact_finish};
}

std::string vertex_source(Prelude prelude) {
    return std::string(shader_text(prelude_file(prelude))) + std::string(shader_text("fullscreen.vert"));
}

std::string fragment_source(const ShaderConfig& config, Prelude prelude) {
    const TechniqueFiles technique = technique_files(config.technique);
    std::string source(shader_text(prelude_file(prelude)));
    source += define("RELIEF_ENCODING", std::to_string(encoding_number(config.encoding)));
    source += define("RELIEF_METRIC_L1", config.metric == Metric::l1 ? "1" : "0");
    source += define("RELIEF_NORMAL_UNORM", config.normal_unorm ? "1" : "0");
    source += define("RELIEF_NORMAL_DX", config.normal_y == NormalY::dx ? "1" : "0");
    source += define("RELIEF_EXACT_FINISH", config.exact_finish ? "1" : "0");
    source += define("RELIEF_TRACE", technique.function);
    source += shader_text("relief_map.glsl");
    for (const std::string_view file : technique.files) source += shader_text(file);
    source += shader_text("shade.glsl");
    source += shader_text("relief_plane.frag");
    return source;
}

} // namespace reliefbake
