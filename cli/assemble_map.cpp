#include "cli/assemble_map.h"

#include "bake/stored_code.h"

#include <cmath>

namespace reliefbake {

namespace {

float stored_normal(float n, BitDepth bits) {
    if (is_unorm(bits)) return stored_value(nearest_code(0.5 * n + 0.5, bits), bits);
    return std::copysign(stored_value(nearest_code(std::fabs(n), bits), bits), n);
}

Image<float> stored_normals(const Image<float>& plane, float sign, BitDepth bits) {
    Image<float> stored(plane.width(), plane.height());
    for (std::size_t i = 0; i < plane.size(); ++i)
        stored[i] = stored_normal(sign * plane[i], bits);
    return stored;
}

Image<float> sampled_depth(const DepthMap& depth) {
    Image<float> sampled = depth.level;
    for (float& level : sampled)
        level /= float(max_code(depth.bits));
    return sampled;
}

} // namespace

ReliefMap assemble_map(const ReliefMapInfo& info, const DepthMap& depth, const EncodedConeMap& cones,
                       const NormalMap& normals) {
    const float y_sign = info.normal_y == NormalY::gl ? 1.0f : -1.0f;
    return {info,
            depth.grid,
            stored_normals(normals.x, 1, info.bits),
            stored_normals(normals.y, y_sign, info.bits),
            cones.value,
            sampled_depth(depth)};
}

} // namespace reliefbake
