#include "cli/explain/explain_bump.h"

#include "bake/wrap_words.h"
#include "cli/bump/bump_options.h"
#include "cli/explain/explain_lines.h"
#include "cli/report/format_text.h"
#include "formats/bump_file.h"

#include <cstdio>

namespace reliefbake {

namespace {

/// "(x * 255.0 - 128.0) / 127.0": in this order zero comes out as 0.
std::string signed_formula(const std::string& sample, const BumpMapInfo& info) {
    if (!is_unorm(info.bits)) return sample;
    if (info.codes == SignedCodes::unorm) return "2.0 * " + sample + " - 1.0";
    const int zero = centred_zero(info.bits), largest = max_code(info.bits);
    return "(" + sample + " * " + std::to_string(largest) + ".0 - " + std::to_string(zero) + ".0) / " + std::to_string(largest - zero) + ".0";
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

std::string derivative_lines(const BumpMap& map) {
    const auto channels = bump_images(map.info)[0].channels;
    const std::string sample = "vec2(" + channels[0] + ", " + channels[1] + ")", decoded = signed_formula(sample, map.info);
    const bool scaled = is_unorm(map.info.bits);
    std::string text = "  d       vec2(dH/du, dH/dv) = " + (scaled ? digits(map.info.derivative_scale) + " * (" + decoded + ")" : decoded) + ",\n" +
                       "          height 0 to 1 per texture width and per texture height, v down the image; " + word_of(kernel_words, map.info.kernel) +
                       " differences.\n";
    return text + "  bump    N' = normalize(N + a * (d.x * cross(N, B) - d.y / " + digits(map.grid.aspect()) + " * cross(N, T))), T along u, B along v, both\n" +
           "          of length 1; a is the relief's depth in texture widths (003, formulas 4 and 5). In the tangent frame, B down the\n" +
           "          image: normalize(vec3(-a * d.x, -a * d.y / " + digits(map.grid.aspect()) + ", 1.0)).\n";
}

std::string normal_lines(const BumpMapInfo& info) {
    const auto channels = bump_images(info)[0].channels;
    const std::string sample = "vec3(" + channels[0] + ", " + channels[1] + ", " + channels[2] + ")";
    const std::string up = info.normal_y == NormalY::gl ? "" : "-";
    return "  normal  n = normalize(" + signed_formula(sample, info) + "); y points " + (info.normal_y == NormalY::gl ? "up (OpenGL)" : "down (DirectX)") +
           " the image.\n          n is (-S dH/du, " + up + "S dH/dv / R, 1) made one long, with v down the image, S = " + digits(info.depth_scale) +
           " texture widths, R = height / width; " + word_of(kernel_words, info.kernel) + " differences.\n";
}

std::string horizon_lines(const BumpMap& map) {
    const BumpMapInfo& info = map.info;
    std::string where = joined(bump_images(info)[0].channels) + " hold azimuths 0 to 7 and the depth";
    if (info.layout == ChannelLayout::pair) where = "R, G, B, A hold azimuths 0 to 3 in this file, 4 to 7 in the one whose stem ends in _b";
    constexpr double half_turn = 3.14159265358979323846;
    std::string angles;
    for (int k = 0; k < horizon_azimuths; ++k) {
        char degrees[16];
        std::snprintf(degrees, sizeof degrees, "%s%.4g", k == 0 ? "" : ", ", horizon_angle(map.grid, k) * 180 / half_turn);
        angles += degrees;
    }
    return "  horizon " + where + ".\n          Azimuth k looks towards (du, R dv) at " + angles + " degrees, u to the right and v down the image.\n" +
           "          A value is the sine of the horizon's elevation, of a relief S = " + digits(info.depth_scale) +
           " texture widths deep; of another depth S' the\n          tangent is S'/S times as large: t = s / sqrt(1 - s * s) * S'/S, s' = t / sqrt(1 + t * t).\n" +
           "          The sun is seen where the sine of its elevation is larger; between azimuths mix the two beside it by angle.\n";
}

std::string kind_lines(const BumpMap& map) {
    switch (map.info.kind) {
    case BumpKind::derivative: return derivative_lines(map);
    case BumpKind::normal: return normal_lines(map.info);
    case BumpKind::horizon: break;
    }
    return horizon_lines(map);
}

} // namespace

std::string explain_bump_text(const BumpMap& map) {
    const BumpMapInfo& info = map.info;
    std::string text = title_line(word_of(bump_kind_words, info.kind), map.grid, info.bits, info.version);
    text += "Sample it with linear or nearest filtering, " + addressing_of(map.grid) + ", no sRGB decoding.\n";
    text += kind_lines(map);
    if (holds_depth(info)) text += "  depth   " + bump_images(info)[0].channels.back() + "; 0 is the top (height 1), 1 the floor.\n";
    text += "At texel centres a decoded value is at most " + digits(info.error) + " from that of the exact surface of the stored depth.\n";
    return text + statistics_lines(info.statistics) + source_line(info.source_hash, info.argument_hash);
}

} // namespace reliefbake
