#include "cli/explain/explain_text.h"

#include "bake/wrap_words.h"
#include "cli/choices.h"
#include "cli/explain/explain_cones.h"
#include "cli/explain/explain_lines.h"
#include "cli/report/format_text.h"
#include "formats/map_layout.h"
#include "formats/shortest_decimal.h"

namespace reliefbake {

namespace {

std::string ratio_formula(const ReliefMapInfo& info, const std::string& cone, const std::string& depth) {
    const std::string max = digits(shortest_decimal(info.cone_max));
    switch (info.encoding) {
    case ConeEncoding::ratio:
        return cone + " * " + max;
    case ConeEncoding::sqrt:
        return cone + " * " + cone + " * " + max;
    case ConeEncoding::radius:
        return depth + " > 0.0 ? " + cone + " / " + depth + " : " + max;
    case ConeEncoding::normal:
        return cone + " / sqrt(1.0 - " + cone + " * " + cone + ")";
    }
    return "";
}

std::string length_formula(const ReliefMapInfo& info, const TexelGrid& grid) {
    const std::string aspect = digits(grid.aspect());
    if (info.metric == Metric::l1) return "abs(dir.x) + abs(" + aspect + " * dir.y)";
    return "length(vec2(dir.x, " + aspect + " * dir.y))";
}

std::string normal_lines(const ReliefMapInfo& info, const std::string& x, const std::string& y) {
    const bool unorm = is_unorm(info.bits);
    std::string text = "  normal  n.xy = " + std::string(unorm ? "2.0 * " : "") + "vec2(" + x + ", " + y +
                       ")" + (unorm ? " - 1.0" : "") + "; n.z = sqrt(1.0 - dot(n.xy, n.xy)); y points " +
                       (info.normal_y == NormalY::gl ? "up" : "down") + " the image (" +
                       word_of(normal_y_words, info.normal_y) + ").\n";
    return text + "          The slopes are those of a relief " + digits(info.depth_scale) +
           " texture widths deep.\n";
}

std::string cone_lines(const ReliefMapInfo& info, const TexelGrid& grid, const std::string& cone,
                       const std::string& depth) {
    const std::string ray = "A ray at height gap g above the surface that moves dir in uv per unit of depth may sink by\n          ";
    const std::string pieces = "A ray that moves dir in uv per unit of depth is l times what it sank away from the apex's axis";
    return "  cone    ratio = " + ratio_formula(info, cone, depth) + "; texture widths per unit of depth (" +
           word_of(encoding_words, info.encoding) + ").\n          " +
           (info.kind == "cone-pieces" ? pieces : ray + "ratio * g / (l + ratio)") + ", with l = " + length_formula(info, grid) + " (" +
           word_of(metric_words, info.metric) + " cones).\n";
}

std::string safety_lines(const ReliefMapInfo& info) {
    std::string text = guarantee_line(info);
    if (info.filter_delta > 0)
        text += "A GPU that filters with 8-bit weights reads a depth off by up to " +
                digits(info.filter_delta) + ": subtract that from g.\n";
    if (info.filter_delta > 0 && info.encoding == ConeEncoding::radius)
        text += "Add it to the depth that a code is divided by, and take 2/255 from codes of 8-bit textures (radius).\n";
    return text;
}

std::string mip_words(const ReliefMapInfo& info) {
    if (info.levels == 1) return info.trilinear ? "one level of a chain, safe to blend with its neighbours" : "no mips";
    return std::to_string(info.levels) + " mip levels, " +
           (info.trilinear ? "safe to blend" : "one at a time (nearest mip, no blend of two)");
}

/// How to decode the channels of a map whose kind this version knows.
std::string channel_lines(const ReliefMap& map) {
    const ReliefMapInfo& info = map.info;
    const bool several = has_cone_planes(info.kind);
    const auto channels = layout_images(info)[0].channels;
    const bool named = info.layout == ChannelLayout::named;
    std::string text;
    if (!holds_relief(info)) text += "Depth and normals lie in the cone map of the same heights (--relief FILE).\n";
    if (holds_relief(info) && !map.normal_x.empty() && !map.normal_y.empty())
        text += normal_lines(info, channels[0], channels[1]);
    text += plane_lines(info);
    const std::string depth = several ? (named ? "relief.depth" : "depth") : channels[depth_plane];
    if (several || !map.cone.empty()) text += cone_lines(info, map.grid, cone_word(info), depth);
    if (holds_relief(info) && !map.depth.empty()) text += "  depth   " + depth + "; 0 is the top (the polygon), 1 the floor.\n";
    if (info.holes)
        text += "Depth 1, the largest code, is a hole: where the four texels around a point have it there is no floor.\n"
                "Discard a ray that comes down to depth 1 there; all else of the filtered depth is solid.\n";
    return text + family_lines(info);
}

} // namespace

std::string explain_text(const ReliefMap& map) {
    const ReliefMapInfo& info = map.info;
    std::string text = title_line(info.kind, map.grid, info.bits, info.version);
    text += "Sample it with linear or nearest filtering, " + addressing_of(map.grid) + ", no sRGB decoding, " +
            mip_words(info) + ".\n";
    const bool readable = is_known_kind(info.kind) || !map.depth.empty() || !map.cone.empty();
    text += readable ? channel_lines(map) : "This version does not know the kind, nor how its channels are decoded.\n";
    return text + safety_lines(info) + statistics_lines(info.statistics) + source_line(info.source_hash, info.argument_hash);
}

} // namespace reliefbake
