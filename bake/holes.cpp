#include "bake/holes.h"

#include "bake/bad_texels.h"
#include "bake/height_field.h"

namespace reliefbake {

Result<HoleMask> find_holes(const Image<float>& alpha, float threshold, const std::string& name) {
    const BadTexels bad = find_bad_texels(alpha, std::nullopt);
    if (bad.count > 0)
        return fail(ErrorCode::bad_data, name + ": expected an alpha everywhere, found " + std::to_string(bad.count) +
                                             " NaN or Inf values, the first at (" + std::to_string(bad.first_x) + ", " +
                                             std::to_string(bad.first_y) + ")");
    HoleMask holes(alpha.width(), alpha.height());
    for (std::size_t k = 0; k < alpha.size(); ++k) holes[k] = alpha[k] < threshold;
    return holes;
}

HoleMask stored_holes(const DepthMap& depth) {
    if (!depth.holes) return {};
    HoleMask holes(depth.grid.width, depth.grid.height);
    for (int y = 0; y < depth.grid.height; ++y)
        for (int x = 0; x < depth.grid.width; ++x) holes(x, y) = depth.is_hole(x, y);
    return holes;
}

HoleCount count_holes(const DepthMap& depth) {
    HoleCount count;
    const TexelGrid& g = depth.grid;
    for (int y = 0; y < g.height; ++y)
        for (int x = 0; x < g.width; ++x) {
            count.texels += depth.is_hole(x, y);
            const int right = g.address_x(x + 1), below = g.address_y(y + 1);
            count.cells += depth.is_hole(x, y) && depth.is_hole(right, y) && depth.is_hole(x, below) && depth.is_hole(right, below);
        }
    return count;
}

} // namespace reliefbake
