#include "cli/cone/assemble_map.h"

#include "bake/stored_code.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace reliefbake {

namespace {

float stored_normal(float n, BitDepth bits) {
    if (is_unorm(bits)) return stored_value(nearest_code(0.5 * n + 0.5, bits), bits);
    return std::copysign(stored_value(nearest_code(std::fabs(n), bits), bits), n);
}

Image<float> stored_normals(Image<float> plane, float sign, BitDepth bits) {
    for (float& n : plane)
        n = stored_normal(sign * n, bits);
    return plane;
}

Image<float> sampled_depth(DepthMap depth) {
    for (float& level : depth.level)
        level /= float(max_code(depth.bits));
    return std::move(depth.level);
}

} // namespace

ReliefMap assemble_map(const ReliefMapInfo& info, DepthMap depth, std::vector<EncodedConeMap> cones, NormalMap normals) {
    const float y_sign = info.normal_y == NormalY::gl ? 1.0f : -1.0f;
    std::vector<Image<float>> planes;
    for (EncodedConeMap& map : cones) planes.push_back(std::move(map.value));
    const bool single = info.kind == "cone";
    return {info,
            depth.grid,
            stored_normals(std::move(normals.x), 1, info.bits),
            stored_normals(std::move(normals.y), y_sign, info.bits),
            single && !planes.empty() ? std::move(planes.front()) : Image<float>(),
            sampled_depth(std::move(depth)),
            single ? std::vector<Image<float>>() : std::move(planes)};
}

ReliefMap relief_map_for(const ReliefMap& map) {
    ReliefMap relief{map.info, map.grid, map.normal_x, map.normal_y, map.cone_planes.front(), map.depth, {}};
    relief.info.kind = "cone", relief.info.planes = 0, relief.info.layout = ChannelLayout::rgba;
    if (map.info.kind != "cone-stack") // codes grow with cones; the levels of a stack above the first stand above the surface
        for (const Image<float>& plane : map.cone_planes)
            for (std::size_t k = 0; k < plane.size(); ++k) relief.cone[k] = std::min(relief.cone[k], plane[k]);
    return relief;
}

} // namespace reliefbake
