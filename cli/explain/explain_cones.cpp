#include "cli/explain/explain_cones.h"

#include "cli/report/format_text.h"
#include "formats/map_layout.h"

namespace reliefbake {

namespace {

/// "R G B A", only those that hold planes of their own.
std::string cone_channels(const ReliefMapInfo& info) {
    const LayoutImage image = layout_images(info)[0];
    std::string text;
    int next = first_cone_plane;
    for (std::size_t c = 0; c < image.channels.size(); ++c) {
        if (image.parts[0][c] != next) continue;
        text += (text.empty() ? "" : " ") + image.channels[c];
        ++next;
    }
    return text;
}

std::string sector_lines(const ReliefMapInfo& info) {
    const std::string n = std::to_string(info.planes);
    std::string where = cone_channels(info) + " hold sectors 0 to " + std::to_string(info.planes - 1);
    if (info.layout == ChannelLayout::side)
        where = "R G B A hold sectors 0 to 3 in the left half of the image, 4 to 7 in the right half (filter each half alone)";
    if (info.layout == ChannelLayout::pair)
        where = "R G B A hold sectors 0 to 3 in this file, 4 to 7 in the one whose stem ends in _b";
    return "  cone    " + where + ".\n          Sector k is for rays that move by (du, R dv) at an angle from 2 pi k / " + n +
           " up to 2 pi (k + 1) / " + n + ",\n          u to the right and v down the image.\n";
}

std::string stack_lines(const ReliefMapInfo& info) {
    const std::string n = std::to_string(info.planes);
    return "  cone    " + cone_channels(info) + " hold levels 0 to " + std::to_string(info.planes - 1) +
           ". The apex of level k lies at height h + (1 - h) k / " + n + " above\n          a surface of height h; of the " +
           "steps that the apexes below a ray allow, take the longest (g is the gap above the apex).\n";
}

std::string piece_lines(const ReliefMapInfo& info) {
    const std::string n = std::to_string(info.planes);
    return "  cone    " + cone_channels(info) + " hold pieces 0 to " + std::to_string(info.planes - 1) +
           ". Piece k ends (1 - h) (k + 1) / " + n + " above a surface of height h, with a radius of\n          r times that; between "
           "ends the radius is linear. A ray may go on while it is within the radius at its height.\n";
}

std::string relaxed_rays(const ReliefMapInfo& info) {
    switch (info.rays) {
    case RelaxedRays::strict:
        return "";
    case RelaxedRays::top:
        return " That is so for rays that start at the top straight above the texel; others may jump a peak.";
    case RelaxedRays::slope:
        return " That is so for rays steeper than " + digits(info.relaxed_slope) + "; others may jump a peak.";
    }
    return "";
}

} // namespace

std::string cone_word(const ReliefMapInfo& info) {
    if (has_cone_planes(info.kind)) return "cone";
    return layout_images(info)[0].channels[cone_plane];
}

std::string plane_lines(const ReliefMapInfo& info) {
    if (info.kind == "acm") return sector_lines(info);
    if (info.kind == "cone-pieces") return piece_lines(info);
    return info.kind == "cone-stack" ? stack_lines(info) : "";
}

std::string family_lines(const ReliefMapInfo& info) {
    std::string text;
    if (info.family == ConeFamily::relaxed)
        text = "Relaxed cones: a step pierces the surface once at most. When the ray is below it, search between the last two "
               "points." + relaxed_rays(info) + "\n";
    if (info.family == ConeFamily::hybrid)
        text = "Hybrid cones: a step pierces the surface once at most, and ends at most " + digits(info.hybrid_delta) +
               " below where it went in." + relaxed_rays(info) + "\n";
    if (info.lookup == ConeLookup::cell)
        text += "Fetch cones unfiltered, with texelFetch at floor(uv * size - 0.5); depth is filtered as ever.\n";
    return text;
}

std::string guarantee_line(const ReliefMapInfo& info) {
    if (!info.held.cones) return "";
    const std::string surface =
        info.surface == SurfaceModel::bilinear ? "bilinearly filtered surface" : "surface of texel centres";
    if (info.guarantee == "C") return "No point of the " + surface + " lies inside a cone (guarantee C).\n";
    if (info.guarantee == "R")
        return "No step from outside passes more than one crossing of the " + surface + " (guarantee R).\n";
    return "Nothing is guaranteed about the cones.\n";
}

} // namespace reliefbake
