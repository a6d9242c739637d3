#include "formats/map_layout.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <utility>

namespace reliefbake {

namespace {

const std::vector<std::string> rgba_names{"R", "G", "B", "A"};

/// Four cone planes from `first` on; a stack with fewer repeats its last.
std::vector<int> four_planes(int first, int planes) {
    std::vector<int> four;
    for (int c = first; c < first + 4; ++c) four.push_back(first_cone_plane + std::min(c, planes - 1));
    return four;
}

/// The image of a map with one cone a texel: normal x, normal y, cone, depth. What the file has not is "-"; what it has is named by the
/// readers of images, who call one channel Y, two Y and A.
LayoutImage single_image(const ReliefMapInfo& info) {
    static const std::vector<std::string> all{"relief.nx", "relief.ny", "relief.cone", "relief.depth"}, one{"Y"}, two{"Y", "A"};
    const bool held[] = {info.held.normals, info.held.normals, info.held.cones, true};
    const auto count = std::count(std::begin(held), std::end(held), true);
    const std::vector<std::string>& letters = count == 1 ? one : count == 2 ? two : rgba_names;
    LayoutImage image{"", {}, {{normal_x_plane, normal_y_plane, cone_plane, depth_plane}}};
    std::size_t next = 0;
    for (std::size_t plane = 0; plane < all.size(); ++plane)
        image.channels.push_back(!held[plane] ? "-" : info.layout == ChannelLayout::named ? all[plane] : letters[next++]);
    return image;
}

LayoutImage named_image(const ReliefMapInfo& info) {
    LayoutImage image{"", {"relief.nx", "relief.ny", "relief.depth"}, {{normal_x_plane, normal_y_plane, depth_plane}}};
    const std::string layer = info.kind == "acm" ? "cone" + std::to_string(info.planes) + ".s" : info.kind == "cone-stack" ? "stack.k" : "pieces.k";
    for (int k = 0; k < info.planes; ++k) {
        image.channels.push_back(layer + std::to_string(k));
        image.parts[0].push_back(first_cone_plane + k);
    }
    return image;
}

} // namespace

bool has_cone_planes(const std::string& kind) { return kind == "acm" || kind == "cone-stack" || kind == "cone-pieces"; }

bool is_known_kind(const std::string& kind) { return kind == "cone" || has_cone_planes(kind); }

bool holds_relief(const ReliefMapInfo& info) {
    return !has_cone_planes(info.kind) || info.layout == ChannelLayout::named;
}

Result<void> check_layout(const ReliefMapInfo& info) {
    constexpr int most_planes = 64; // of a stack; far beyond any use, and it bounds what a file can make us allocate
    const auto refused = [](const char* words) { return fail(ErrorCode::usage, words); };
    const bool two_images = info.layout == ChannelLayout::side || info.layout == ChannelLayout::pair;
    if (!has_cone_planes(info.kind)) {
        if (two_images) return refused("layouts side and pair are for eight sectors; a cone map has rgba or named");
        return {};
    }
    if (info.held != HeldPlanes()) return refused("only maps of kind cone can leave out normals or cones");
    if (info.kind == "acm" && info.planes != 4 && info.planes != 8) return refused("an acm map has 4 or 8 sectors");
    if (info.planes < 1 || info.planes > most_planes) return refused("a cone stack has 1 to 64 levels or pieces");
    if (two_images && (info.kind != "acm" || info.planes != 8)) return refused("layouts side and pair are for eight sectors");
    if (info.layout == ChannelLayout::rgba && info.planes > 4)
        return refused("an RGBA image holds four planes of cones; choose the layout named, or for eight sectors side or pair");
    return {};
}

std::vector<LayoutImage> layout_images(const ReliefMapInfo& info) {
    assert(check_layout(info) || !is_known_kind(info.kind));
    if (!has_cone_planes(info.kind)) return {single_image(info)};
    if (info.layout == ChannelLayout::named) return {named_image(info)};
    const std::vector<int> first = four_planes(0, info.planes);
    if (info.layout == ChannelLayout::rgba) return {{"", rgba_names, {first}}};
    const std::vector<int> second = four_planes(4, info.planes);
    if (info.layout == ChannelLayout::side) return {{"", rgba_names, {first, second}}};
    return {{"", rgba_names, {first}}, {"_b", rgba_names, {second}}};
}

LayoutImage written_image(const LayoutImage& image) {
    LayoutImage written{image.suffix, {}, std::vector<std::vector<int>>(image.parts.size())};
    for (std::size_t c = 0; c < image.channels.size(); ++c) {
        if (image.channels[c] == "-") continue;
        written.channels.push_back(image.channels[c]);
        for (std::size_t part = 0; part < image.parts.size(); ++part) written.parts[part].push_back(image.parts[part][c]);
    }
    return written;
}

std::filesystem::path image_path(const std::filesystem::path& path, const LayoutImage& image) {
    if (image.suffix.empty()) return path;
    return path.parent_path() / (path.stem().string() + image.suffix + path.extension().string());
}

const Image<float>& plane_of(const ReliefMap& map, int plane) {
    switch (plane) {
    case normal_x_plane: return map.normal_x;
    case normal_y_plane: return map.normal_y;
    case cone_plane: return map.cone;
    case depth_plane: return map.depth;
    default: return map.cone_planes[std::size_t(plane - first_cone_plane)];
    }
}

Image<float>& plane_of(ReliefMap& map, int plane) {
    return const_cast<Image<float>&>(plane_of(std::as_const(map), plane));
}

} // namespace reliefbake
