#include "shaders-reference/renderer/mesh_source.h"

#include <string_view>

namespace reliefbake {

std::string mesh_vertex_source(Prelude prelude) { return prelude_text(prelude).append(shader_text("mesh_camera.glsl")).append(shader_text("mesh_relief.vert")); }

std::string mesh_fragment_source(const MeshConfig& config, Prelude prelude) {
    std::string source = prelude_text(prelude);
    const auto define = [&source](std::string_view name, std::string_view value) {
        source.append("#define ").append(name).append(" ").append(value).append("\n");
    };
    const auto define_number = [&define](std::string_view name, int value) { define(name, std::to_string(value)); };
    if (config.solid) {
        define_number("SHAPE_UNORM", config.shape_unorm);
        define_number("SHAPE_SIGNED", config.shape_signed);
        define_number("SOLID_REVOLUTION", 0);
    } else {
        for (const ShaderConstant& constant : shader_constants(config.decoder)) define_number(constant.name, constant.value);
    }
    define_number("CURVED_PATH", config.path);
    define_number("CURVED_CONE", config.sunk_cone);
    define_number("CURVED_HALVES", config.halves);
    define_number("MESH_SOLID", config.solid);
    define_number("MESH_TWIST", config.twist);
    define_number("MESH_KEEP", config.keep);
    const std::string trace = config.solid ? "curved_extrusion" : config.search ? "curved_search" : "curved_march", as = config.path == published_path ? "_published" : "";
    define("MESH_TRACE", trace + as);
    if (config.solid) {
        for (const char* file : {"shape_map.glsl", "shape_solid.glsl"}) source += shader_text(file);
    } else {
        for (const char* file : {"relief_map.glsl", "relief_cones.glsl"}) source += shader_text(file);
    }
    source += shader_text("curved_path.glsl");
    source += shader_text(config.path == published_path ? "curved_path_published.glsl" : "curved_finish.glsl");
    source += shader_text((config.solid ? "curved_extrusion" : "curved_march") + as + ".glsl");
    source += shader_text("light.glsl");
    source += shader_text("mesh_relief.frag");
    return source;
}

} // namespace reliefbake
