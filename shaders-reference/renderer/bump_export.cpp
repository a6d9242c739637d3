#include "shaders-reference/renderer/bump_export.h"

#include "bake/wrap_words.h"
#include "shaders-reference/renderer/shader_edit.h"

namespace reliefbake {
namespace {

std::string file_comment(const BumpMap& map) {
    const BumpMapInfo& info = map.info;
    const char* const bound[] = {"bump_map = (dH/du, dH/dv, depth)", "bump_map = (normal x, y, z, depth)",
                                 "horizon_map_0 = azimuths 0 to 3, horizon_map_1 = azimuths 4 to 7"};
    std::string text = "// For a bump map of " + std::to_string(map.grid.width) + " x " + std::to_string(map.grid.height) +
                       " texels; written by reliefbake shader.\n// Bind ";
    text.append(bound[int(info.kind)]).append(".\n// Samplers: linear, no sRGB decoding, ");
    return text + addressing_of(map.grid) + ".\n\n";
}

int codes_number(const BumpMapInfo& info) {
    if (!is_unorm(info.bits)) return 0;
    return info.codes == SignedCodes::centred ? 1 : 2;
}

std::vector<std::string_view> files_of(BumpKind kind) {
    switch (kind) {
    case BumpKind::derivative: return {"signed_code.glsl", "bump_derivative.glsl"};
    case BumpKind::normal: return {"signed_code.glsl", "bump_normal.glsl"};
    case BumpKind::horizon: break;
    }
    return {"horizon.glsl"};
}

UniformValues values_of(const BumpMap& map) {
    const BumpMapInfo& info = map.info;
    const int largest = max_code(info.bits), zero = is_unorm(info.bits) ? centred_zero(info.bits) : 0;
    return {{"signed_largest", float_literal(largest)},
            {"signed_zero", float_literal(zero)},
            {"bump_scale", float_literal(info.derivative_scale)},
            {"bump_aspect", float_literal(map.grid.aspect())},
            {"horizon_diagonal", float_literal(horizon_angle(map.grid, 1))},
            {"horizon_deepen", float_literal(1)}};
}

/// What the shader shows: a normal and the depth, or the share of a sun that is seen.
std::string body_of(BumpKind kind, const std::string& result) {
    const std::string shown = result + "vec4(0.5 * normal.x + 0.5, 0.5 * normal.y + 0.5, 0.5 * normal.z + 0.5, bump_depth(bump_uv));\n";
    switch (kind) {
    case BumpKind::derivative:
        return "    // A flat polygon, b along v (down the image), under a relief a tenth of the texture's width deep.\n"
               "    vec3 normal = bump_normal(bump_uv, vec3(0.0, 0.0, 1.0), vec3(1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0), 0.1);\n    " + shown;
    case BumpKind::normal: return "    vec3 normal = bump_normal(bump_uv);\n    " + shown;
    case BumpKind::horizon: break;
    }
    return "    const float sun_size = 0.01;\n    float seen = horizon_visibility(bump_uv, normalize(bump_sun), sun_size);\n    " + result +
           "vec4(seen, seen, seen, 1.0);\n";
}

std::string entry_point(BumpKind kind, bool hlsl) {
    const bool sun = kind == BumpKind::horizon;
    std::string comment("\n// bump_uv: where the texture is looked up.");
    if (sun) comment += " bump_sun: towards the sun, x along u, y up the image, z out of the polygon.";
    if (hlsl)
        return comment + "\nfloat4 main(float2 bump_uv : TEXCOORD0" + (sun ? ", float3 bump_sun : TEXCOORD1" : "") + ") : SV_Target {\n" +
               body_of(kind, "return ") + "}\n";
    return comment + "\nin vec2 bump_uv;\n" + (sun ? "in vec3 bump_sun;\n" : "") + "out vec4 bump_colour;\n\nvoid main() {\n" + body_of(kind, "bump_colour = ") + "}\n";
}

} // namespace

std::string export_bump_shader(const BumpMap& map, ShaderLanguage language) {
    const std::vector<ShaderConstant> constants = {{"SIGNED_CODES", codes_number(map.info)}, {"BUMP_NORMAL_DX", map.info.normal_y == NormalY::dx}};
    std::string body;
    for (const std::string_view file : files_of(map.info.kind)) body.append(body.empty() ? "" : "\n").append(specialise(shader_text(file), constants));
    body += entry_point(map.info.kind, language == ShaderLanguage::hlsl);
    body = fix_uniforms(body, values_of(map));
    return in_language(language, file_comment(map), body, map.grid);
}

} // namespace reliefbake
