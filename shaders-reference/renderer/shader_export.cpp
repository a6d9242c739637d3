#include "shaders-reference/renderer/shader_export.h"

#include "bake/wrap_words.h"
#include "shaders-reference/renderer/relief_renderer.h"
#include "shaders-reference/renderer/shader_edit.h"

#include <algorithm>
#include <utility>

namespace reliefbake {
namespace {

/// Where the file's channels belong in relief_map.
std::string swizzle_of(const HeldPlanes& held) {
    const bool holds[] = {held.normals, held.normals, held.cones, true};
    std::string text;
    for (int plane = 0, next = 0; plane < 4; ++plane) text.append(plane > 0 ? ", " : "").append(1, holds[plane] ? "RGBA"[next++] : '0');
    return text;
}

std::string file_comment(const ReliefMap& map) {
    const ReliefMapInfo& info = map.info;
    const std::size_t planes = map.cone_planes.size();
    std::string text = "// For a map of kind " + info.kind + ", " + std::to_string(map.grid.width) + " x " + std::to_string(map.grid.height) +
                       " texels; written by reliefbake shader.\n// Bind relief_map = (normal x, normal y, " + (planes == 0 ? "cone" : "unused") +
                       ", depth)";
    if (planes > 0) {
        const std::string what = info.kind == "acm" ? "sectors" : info.kind == "cone-stack" ? "levels" : "pieces";
        text += ", relief_cones_0 = " + what + " 0 to " + std::to_string(std::min<std::size_t>(planes, 4) - 1);
        if (planes > 4) text += ", relief_cones_1 = " + what + " 4 to " + std::to_string(planes - 1);
    }
    text += ".\n// Samplers: linear, no mips, no sRGB decoding, " + addressing_of(map.grid) + ".\n";
    if (info.layout == ChannelLayout::named && planes == 0) text += "// In the file: relief.nx, relief.ny, relief.cone, relief.depth.\n";
    if (planes == 0 && info.held != HeldPlanes()) text += "// The file has not all of them: give the texture the swizzle (" + swizzle_of(info.held) + ").\n";
    text += info.guarantee == "C"   ? "// No step passes a point of the relief (guarantee C).\n"
            : info.guarantee == "R" ? "// The last step holds the first hit alone (guarantee R).\n"
                                    : "// Nothing is guaranteed about these cones.\n";
    if (info.holes) text += "// Depth 1 is a hole: a ray that comes down to it between four such texels is discarded.\n";
    if (info.filter_delta > 0)
        text += "// relief_delta is for samplers with 8-bit weights, as most hardware has; 0 for exact ones.\n";
    return text + "\n";
}

UniformValues constants_of(const ReliefMap& map, int march_steps) {
    const ReliefMapInfo& info = map.info;
    const RenderOptions defaults;
    std::string repeat("ivec2("); // appended piece by piece: GCC 12 warns about operator+ here (bug 105651)
    repeat += std::to_string(map.grid.wrap_x == Wrap::repeat);
    repeat.append(", ").append(std::to_string(map.grid.wrap_y == Wrap::repeat)).append(")");
    return {{"relief_cone_max", float_literal(std::min<double>(info.cone_max, widest_ratio))},
            {"relief_aspect", float_literal(map.grid.aspect())},
            {"relief_delta", float_literal(info.filter_delta)},
            {"relief_code_delta", float_literal(info.bits == BitDepth::unorm8 ? filtered_code_error : 0)},
            {"relief_repeat", repeat},
            {"relief_depth_scale", float_literal(info.depth_scale)},
            {"relief_max_steps", std::to_string(march_steps)},
            {"relief_binary_steps", std::to_string(defaults.binary_steps)},
            {"relief_epsilon", float_literal(defaults.epsilon)}};
}

/// The use of it all: `march` from where the view enters the polygon.
std::string entry_point(const ReliefMap& map, std::string_view march, bool hlsl) {
    const bool normals = !map.normal_x.empty() && !map.normal_y.empty();
    const std::string inputs = "// relief_uv: where the view enters the polygon. relief_view: from the eye, in tangent space: x along u, y up the\n"
                               "// image, z out of the polygon.\n";
    const std::string result = hlsl ? "return " : "relief_colour = ";
    std::string body = "    ReliefRay ray;\n    ray.origin = relief_uv;\n"
                       "    ray.direction = vec2(relief_view.x, -relief_view.y / relief_aspect) * (relief_depth_scale / -relief_view.z);\n"
                       "    ReliefHit hit = " + std::string(march) + "(ray);\n" +
                       (map.info.holes ? "    if (relief_falls_through(ray, hit)) discard;\n" : "") +
                       "    vec2 uv = ray.origin + hit.t * ray.direction;\n";
    if (normals) {
        body += "    vec3 normal = relief_normal(textureLod(relief_map, uv, 0.0));\n"
                "    " + result + "vec4(0.5 * normal.x + 0.5, 0.5 * normal.y + 0.5, 0.5 * normal.z + 0.5, 1.0 - hit.t);\n";
    } else {
        body += "    " + result + "vec4(uv, 0.0, 1.0 - hit.t); // the map has no normals\n";
    }
    if (hlsl) return "\n" + inputs + "float4 main(float2 relief_uv : TEXCOORD0, float3 relief_view : TEXCOORD1) : SV_Target {\n" + body + "}\n";
    return "\n" + inputs + "in vec2 relief_uv;\nin vec3 relief_view;\nout vec4 relief_colour;\n\nvoid main() {\n" + body + "}\n";
}

} // namespace

std::string in_language(ShaderLanguage language, const std::string& comment, const std::string& body, const TexelGrid& grid) {
    switch (language) {
    case ShaderLanguage::glsl: return std::string(shader_text("prelude_330.glsl")) + comment + body;
    case ShaderLanguage::glsl_es: return std::string(shader_text("prelude_300es.glsl")) + comment + body;
    case ShaderLanguage::hlsl: return comment + to_hlsl(body, grid);
    }
    return {};
}

Result<std::string> export_shader(const ReliefMap& map, ShaderLanguage language) {
    if (!has_cones(map)) return fail(ErrorCode::usage, std::string("the map has no cones: there is no march for it"));
    if (map.depth.empty()) return fail(ErrorCode::usage, std::string("the map has no depth channel"));
    if (map.cone_planes.size() > 8)
        return fail(ErrorCode::usage, "shaders are written for up to 8 sectors or levels; this map has " + std::to_string(map.cone_planes.size()));
    const TechniqueInfo& technique = technique_info(suitable_technique(map));
    const std::vector<ShaderConstant> constants = shader_constants(shader_config(map, technique.technique, false));

    std::string body = specialise(shader_text("relief_map.glsl"), constants);
    if (map.info.holes) body.append("\n").append(specialise(shader_text("relief_holes.glsl"), constants));
    body.append("\n").append(specialise(shader_text("relief_cones.glsl"), constants));
    for (const std::string_view file : technique.files) body.append("\n").append(specialise(shader_text(file), constants));
    body += entry_point(map, technique.function, language == ShaderLanguage::hlsl);
    body = fix_uniforms(body, constants_of(map, technique.default_steps));
    return in_language(language, file_comment(map), body, map.grid);
}

} // namespace reliefbake
