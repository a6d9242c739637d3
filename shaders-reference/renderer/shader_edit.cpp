#include "shaders-reference/renderer/shader_edit.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cstdint>
#include <sstream>

namespace reliefbake {
namespace {

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

/// Where the parenthesis that is open before `at` closes.
std::size_t closing(const std::string& text, std::size_t at) {
    for (int depth = 1;; ++at) {
        depth += text[at] == '(' ? 1 : text[at] == ')' ? -1 : 0;
        if (depth == 0) return at;
    }
}

} // namespace

std::string float_literal(double number) {
    char digits[64];
    std::string text(digits, std::to_chars(digits, digits + sizeof digits, float(number)).ptr);
    return text.find_first_of(".e") == text.npos ? text + ".0" : text;
}

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

std::string fix_uniforms(const std::string& text, const UniformValues& values) {
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

std::string to_hlsl(std::string text, const TexelGrid& grid) {
    // Samplers and reads.
    for (const std::string name : {"relief_map", "relief_cones_0", "relief_cones_1", "bump_map", "horizon_map_0", "horizon_map_1", "shape_map"}) {
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
                                     std::pair("ivec2", "int2"), std::pair("mix", "lerp"), std::pair("atan", "atan2")})
        replace_word(text, glsl, hlsl);
    // A global without `static` would be a parameter that nobody sets.
    for (std::size_t at = text.find("\nconst "); at != text.npos; at = text.find("\nconst ", at + 1)) text.insert(at + 1, "static ");
    return text;
}

} // namespace reliefbake
