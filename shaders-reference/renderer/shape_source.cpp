#include "shaders-reference/renderer/shape_source.h"

#include <string_view>
#include <utility>

namespace reliefbake {
namespace {

std::string_view trace_function(CircleScheme scheme) {
    switch (scheme) {
    case CircleScheme::corrected: return "circle_trace";
    case CircleScheme::published: return "circle_trace_published";
    case CircleScheme::given: return "given_solid_hit";
    }
    return {};
}

} // namespace

std::string solid_fragment_source(const SolidConfig& config, Prelude prelude) {
    std::string source = prelude_text(prelude);
    const std::pair<const char*, int> constants[] = {{"SHAPE_UNORM", config.unorm},
                                                     {"SHAPE_SIGNED", config.signed_distance},
                                                     {"SOLID_REVOLUTION", config.kind == SolidKind::revolution},
                                                     {"SOLID_PLANE", config.on_plane},
                                                     {"SOLID_PROJECTION", int(config.projection)},
                                                     {"SOLID_COLOUR", config.colour},
                                                     {"SOLID_BUMP", config.bump},
                                                     {"SOLID_SHADOW", config.shadow}};
    for (const auto& [name, value] : constants)
        source.append("#define ").append(name).append(" ").append(std::to_string(value)).append("\n");
    source.append("#define SOLID_TRACE ").append(trace_function(config.scheme)).append("\n");
    // Shadows are always cast by the corrected scheme.
    for (const std::string_view file : {"shape_map.glsl", "shape_solid.glsl", "circle_trace.glsl"}) source += shader_text(file);
    if (config.scheme == CircleScheme::published) source += shader_text("circle_trace_published.glsl");
    if (config.scheme == CircleScheme::given) source += shader_text("given_solid_hit.glsl");
    source += shader_text("solid_texture.glsl");
    source += shader_text("light.glsl");
    source += shader_text("solid_scene.frag");
    return source;
}

} // namespace reliefbake
