#pragma once
// Which planes of a map lie in which channels of which image file (docs/FORMATS.md).

#include "bake/error.h"
#include "bake/relief_map.h"

#include <filesystem>
#include <string>
#include <vector>

namespace reliefbake {

/// Numbers of a map's planes; cone_planes[k] is first_cone_plane + k.
enum MapPlane { normal_x_plane, normal_y_plane, cone_plane, depth_plane, first_cone_plane };

/// One image file of a map.
struct LayoutImage {
    std::string suffix;                  ///< behind the stem of the map's name: "", or "_b" for the second of a pair
    std::vector<std::string> channels;   ///< names in the file, in the order of the samples; "-" is a plane that the file has not
    std::vector<std::vector<int>> parts; ///< side by side from the left: the plane that each channel holds
};

/// Kinds whose cones are cone_planes: "acm", "cone-stack", "cone-pieces".
bool has_cone_planes(const std::string& kind);

/// Kinds that this version reads and writes: those above and "cone".
bool is_known_kind(const std::string& kind);

/// Whether depth and normals lie beside the cones; else they come from a relief file (MapHints::relief).
bool holds_relief(const ReliefMapInfo& info);

/// Refuses (usage, in words that make sense after "file: ") what no layout holds: acm has 4 or 8 planes, a cone-stack 1 or
/// more; rgba up to 4 of them, side and pair 8; only cone maps leave out normals or cones.
Result<void> check_layout(const ReliefMapInfo& info);

/// The files of a map that check_layout passes, the one with the map's own name first.
std::vector<LayoutImage> layout_images(const ReliefMapInfo& info);

/// The image without the planes that its file has not: what is written.
LayoutImage written_image(const LayoutImage& image);

/// `path` with the image's suffix: map.png, map_b.png.
std::filesystem::path image_path(const std::filesystem::path& path, const LayoutImage& image);

Image<float>& plane_of(ReliefMap& map, int plane);
const Image<float>& plane_of(const ReliefMap& map, int plane);

} // namespace reliefbake
