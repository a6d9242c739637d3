#include "shaders-reference/renderer/shader_export.h"

#include "shaders-reference/renderer/relief_renderer.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>
#include <utility>

namespace reliefbake {
namespace {

using Constants = std::vector<std::pair<std::string, std::string>>; ///< name and value, as written

bool is_word(char c) { return c == '_' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// Replaces `from` where it stands as a word of its own.
void replace_word(std::string& text, const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != text.npos; at = text.find(from, at)) {
        const std::size_t end = at + from.size();
        const bool whole = (at == 0 || !is_word(text[at - 1])) && (end == text.size() || !is_word(text[end]));
        if (whole) text.replace(at, from.size(), to);
        at += whole ? to.size() : from.size();
    }
}

/// Nine digits bring a float back; always with a point or an exponent, so that it is a float in every language.
std::string float_literal(double number) {
    char digits[64];
    std::string text(digits, std::to_chars(digits, digits + sizeof digits, float(number)).ptr);
    return text.find_first_of(".e") == text.npos ? text + ".0" : text;
}

int constant_value(const std::vector<ShaderConstant>& constants, const std::string& name) {
    for (const ShaderConstant& constant : constants)
        if (constant.name == name) return constant.value;
    assert(!"a shader asks for a constant that nobody sets");
    return 0;
}

/// NAME, NAME == N or NAME > N: all that glsl/ uses.
bool condition_holds(const std::string& condition, const std::vector<ShaderConstant>& constants) {
    std::istringstream words(condition);
    std::string name, comparison;
    int number = 0;
    words >> name;
    const int value = constant_value(constants, name);
    if (!(words >> comparison >> number)) return value != 0;
    assert(comparison == "==" || comparison == ">");
    return comparison == "==" ? value == number : value > number;
}

/// Takes the branches of #if that hold, puts numbers for the names of constants, and leaves out the comments that explain
/// these names.
std::string specialise(std::string_view text, const std::vector<ShaderConstant>& constants) {
    struct Branch {
        bool outside, taken, active; ///< the text around it is kept; some branch was; this one is
    };
    std::vector<Branch> branches;
    std::istringstream lines{std::string(text)};
    std::string result, line;
    bool explains = false;
    while (std::getline(lines, line)) {
        const auto rest = [&line](std::string_view directive) -> std::optional<std::string> {
            if (!line.starts_with(directive)) return std::nullopt;
            return line.substr(directive.size());
        };
        const bool kept = branches.empty() || branches.back().active;
        if (const auto condition = rest("#if ")) {
            const bool holds = kept && condition_holds(*condition, constants);
            branches.push_back({kept, holds, holds});
        } else if (const auto otherwise = rest("#elif ")) {
            Branch& branch = branches.back();
            branch.active = branch.outside && !branch.taken && condition_holds(*otherwise, constants);
            branch.taken = branch.taken || branch.active;
        } else if (rest("#else")) {
            Branch& branch = branches.back();
            branch.active = branch.outside && !branch.taken;
        } else if (rest("#endif")) {
            branches.pop_back();
        } else if (kept) {
            if (!line.starts_with("//")) explains = false;
            if (line.find("Set before this text") != line.npos || line.starts_with("// RELIEF_")) explains = true;
            if (explains) {
                if (result.ends_with("\n//\n")) result.resize(result.size() - 3);
                continue;
            }
            if (line.empty() && result.ends_with("\n\n")) continue;
            std::string code = line.substr(0, line.find("//"));
            const std::string comment = line.substr(code.size());
            for (const ShaderConstant& constant : constants) replace_word(code, std::string(constant.name), std::to_string(constant.value));
            result += code + comment + "\n";
        }
    }
    return result;
}

/// "uniform TYPE NAME;" becomes "const TYPE NAME = VALUE;". Samplers stay.
std::string fix_uniforms(const std::string& text, const Constants& values) {
    std::istringstream lines(text);
    std::string result, line;
    while (std::getline(lines, line)) {
        std::istringstream words(line);
        std::string keyword, type, name;
        words >> keyword >> type >> name;
        if (keyword == "uniform" && type != "sampler2D") {
            name.resize(name.find(';'));
            const auto found = std::find_if(values.begin(), values.end(), [&](const auto& value) { return value.first == name; });
            assert(found != values.end());
            line = "const " + type + " " + name + " = " + found->second + line.substr(line.find(';'));
        }
        result += line + "\n";
    }
    return result;
}

/// Where the parenthesis that is open before `at` closes.
std::size_t closing(const std::string& text, std::size_t at) {
    for (int depth = 1;; ++at) {
        depth += text[at] == '(' ? 1 : text[at] == ')' ? -1 : 0;
        if (depth == 0) return at;
    }
}

/// The same shader in HLSL. glsl/ keeps to what translates word by word: no struct constructors, no splats.
std::string to_hlsl(std::string text, const TexelGrid& grid) {
    // Samplers and reads.
    for (const std::string name : {"relief_map", "relief_cones_0", "relief_cones_1"}) {
        const auto replace = [&text](const std::string& from, const std::string& to) {
            for (std::size_t at = text.find(from); at != text.npos; at = text.find(from, at + to.size())) text.replace(at, from.size(), to);
        };
        replace("uniform sampler2D " + name + ";", "Texture2D<float4> " + name + ";\nSamplerState " + name + "_sampler;");
        replace("textureLod(" + name + ", ", name + ".SampleLevel(" + name + "_sampler, ");
        replace("textureSize(" + name + ", 0)", "int2(" + std::to_string(grid.width) + ", " + std::to_string(grid.height) + ")");
        const std::string fetch = "texelFetch(" + name + ", ", load = name + ".Load(int3(";
        for (std::size_t at = text.find(fetch); at != text.npos; at = text.find(fetch, at)) {
            text.replace(at, fetch.size(), load);
            text.insert(closing(text, at + load.size()), 1, ')');
        }
    }
    for (const auto& [glsl, hlsl] : {std::pair("vec2", "float2"), std::pair("vec3", "float3"), std::pair("vec4", "float4"),
                                     std::pair("ivec2", "int2"), std::pair("mix", "lerp")})
        replace_word(text, glsl, hlsl);
    // A global without `static` would be a parameter that nobody sets.
    for (std::size_t at = text.find("\nconst "); at != text.npos; at = text.find("\nconst ", at + 1)) text.insert(at + 1, "static ");
    return text;
}

std::string file_comment(const ReliefMap& map) {
    const ReliefMapInfo& info = map.info;
    const auto wrap = [](Wrap axis) { return std::string(axis == Wrap::repeat ? "repeat" : "clamp"); };
    const std::size_t planes = map.cone_planes.size();
    std::string text = "// For a map of kind " + info.kind + ", " + std::to_string(map.grid.width) + " x " + std::to_string(map.grid.height) +
                       " texels; written by reliefbake shader.\n// Bind relief_map = (normal x, normal y, " + (planes == 0 ? "cone" : "unused") +
                       ", depth)";
    if (planes > 0) {
        const std::string what = info.kind == "acm" ? "sectors" : "levels";
        text += ", relief_cones_0 = " + what + " 0 to " + std::to_string(std::min<std::size_t>(planes, 4) - 1);
        if (planes > 4) text += ", relief_cones_1 = " + what + " 4 to " + std::to_string(planes - 1);
    }
    text += ".\n// Samplers: linear, no mips, no sRGB decoding, " + wrap(map.grid.wrap_x) + " in u, " + wrap(map.grid.wrap_y) + " in v.\n";
    if (info.layout == ChannelLayout::named && planes == 0) text += "// In the file: relief.nx, relief.ny, relief.cone, relief.depth.\n";
    text += info.guarantee == "C"   ? "// No step passes a point of the relief (guarantee C).\n"
            : info.guarantee == "R" ? "// The last step holds the first hit alone (guarantee R).\n"
                                    : "// Nothing is guaranteed about these cones.\n";
    if (info.filter_delta > 0)
        text += "// relief_delta is for samplers with 8-bit weights, as most hardware has; 0 for exact ones.\n";
    return text + "\n";
}

Constants constants_of(const ReliefMap& map, int march_steps) {
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
                       "    ReliefHit hit = " + std::string(march) + "(ray);\n"
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

Result<std::string> export_shader(const ReliefMap& map, ShaderLanguage language) {
    if (!has_cones(map)) return fail(ErrorCode::usage, std::string("the map has no cones: there is no march for it"));
    if (map.depth.empty()) return fail(ErrorCode::usage, std::string("the map has no depth channel"));
    if (map.cone_planes.size() > 8)
        return fail(ErrorCode::usage, "shaders are written for up to 8 sectors or levels; this map has " + std::to_string(map.cone_planes.size()));
    const TechniqueInfo& technique = technique_info(suitable_technique(map));
    const std::vector<ShaderConstant> constants = shader_constants(shader_config(map, technique.technique, false));

    std::string body = specialise(shader_text("relief_map.glsl"), constants);
    body.append("\n").append(specialise(shader_text("relief_cones.glsl"), constants));
    for (const std::string_view file : technique.files) body.append("\n").append(specialise(shader_text(file), constants));
    body += entry_point(map, technique.function, language == ShaderLanguage::hlsl);
    body = fix_uniforms(body, constants_of(map, technique.default_steps));
    switch (language) {
    case ShaderLanguage::glsl: return std::string(shader_text("prelude_330.glsl")) + file_comment(map) + body;
    case ShaderLanguage::glsl_es: return std::string(shader_text("prelude_300es.glsl")) + file_comment(map) + body;
    case ShaderLanguage::hlsl: return file_comment(map) + to_hlsl(body, map.grid);
    }
    return {};
}

} // namespace reliefbake
