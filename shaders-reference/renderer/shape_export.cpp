#include "shaders-reference/renderer/shape_export.h"

#include "bake/wrap_words.h"
#include "shaders-reference/renderer/shader_edit.h"
#include "shaders-reference/renderer/shape_renderer.h"

namespace reliefbake {
namespace {

std::string file_comment(const ShapeMap& map) {
    const ShapeMapInfo& info = map.info;
    std::string text = "// For a shape map of " + std::to_string(map.grid.width) + " x " + std::to_string(map.grid.height) +
                       " texels; written by reliefbake shader.\n// Bind shape_map = (gradient u, gradient v, distance, 0 inside | 1 outside).\n";
    if (info.named) text += "// In the file: shape.gx, shape.gy, shape.distance, shape.mask.\n";
    text += "// Samplers: linear, no mips, no sRGB decoding, " + addressing_of(map.grid) + ".\n";
    text += info.guarantee == "S" ? "// No step of shape_safe enters the shape (guarantee S).\n" : "// Nothing is guaranteed about these distances.\n";
    if (info.filter_delta > 0) text += "// shape_delta is for samplers with 8-bit weights, as most hardware has; 0 for exact ones.\n";
    return text + "// solid_outward, solid_bevel, solid_chamfer and solid_depth are yours to choose.\n\n";
}

/// Those of the map; of the solid a basic extrusion with the published counts.
UniformValues values_of(const ShapeMap& map) {
    const ShapeSolid solid;
    const ShapeRenderOptions defaults;
    const CircleCounts counts = published_counts(solid.kind);
    constexpr double no_chamfer = 1e30;
    return {{"shape_tau", float_literal(map.info.tau)},
            {"shape_aspect", float_literal(map.grid.aspect())},
            {"shape_delta", float_literal(map.info.filter_delta)},
            {"solid_outward", float_literal(solid.outward)},
            {"solid_bevel", float_literal(solid.bevel)},
            {"solid_chamfer", float_literal(no_chamfer)},
            {"solid_axis", float_literal(solid.axis)},
            {"solid_depth", float_literal(solid.depth_scale)},
            {"solid_tiles", float_literal(solid.tiles)},
            {"solid_steps", std::to_string(counts.steps)},
            {"solid_binary_steps", std::to_string(counts.binary_steps)},
            {"solid_epsilon", float_literal(defaults.epsilon / map.grid.width)}};
}

std::string entry_point(bool hlsl) {
    const std::string inputs = "// shape_uv: where the view enters the polygon. shape_view: from the eye, in tangent space, of length 1: x along u, y up the\n"
                               "// image, z out of the polygon.\n";
    const std::string body = "    SolidRay ray;\n    ray.origin = vec3(shape_uv, 0.0);\n"
                             "    ray.direction = vec3(shape_view.x, -shape_view.y / shape_aspect, -shape_view.z / solid_depth);\n"
                             "    SolidHit hit = circle_trace(ray, solid_depth / -shape_view.z); // to the floor\n"
                             "    vec3 place = ray.origin + hit.t * ray.direction;\n"
                             "    vec3 normal = vec3(0.0, 0.0, 1.0);\n"
                             "    if (hit.status == SOLID_HIT && hit.t > 0.0) normal = solid_normal(place, shape_view);\n    " +
                             std::string(hlsl ? "return " : "shape_colour = ") +
                             "vec4(0.5 * normal.x + 0.5, 0.5 * normal.y + 0.5, 0.5 * normal.z + 0.5, 1.0 - place.z);\n";
    if (hlsl) return "\n" + inputs + "float4 main(float2 shape_uv : TEXCOORD0, float3 shape_view : TEXCOORD1) : SV_Target {\n" + body + "}\n";
    return "\n" + inputs + "in vec2 shape_uv;\nin vec3 shape_view;\nout vec4 shape_colour;\n\nvoid main() {\n" + body + "}\n";
}

} // namespace

std::string export_shape_shader(const ShapeMap& map, ShaderLanguage language) {
    const std::vector<ShaderConstant> constants = {
        {"SHAPE_UNORM", is_unorm(map.info.bits)}, {"SHAPE_SIGNED", map.info.signed_distance}, {"SOLID_REVOLUTION", 0}};
    std::string body;
    for (const std::string_view file : {"shape_map.glsl", "shape_solid.glsl", "circle_trace.glsl"})
        body.append(body.empty() ? "" : "\n").append(specialise(shader_text(file), constants));
    body += entry_point(language == ShaderLanguage::hlsl);
    return in_language(language, file_comment(map), fix_uniforms(body, values_of(map)), map.grid);
}

} // namespace reliefbake
