#include "shaders-reference/measure/shape_relief.h"

#include <algorithm>

namespace reliefbake {

DepthMap shape_relief(const ShapeMap& map, const ShapeSolid& solid) {
    DepthMap relief{map.grid, BitDepth::float32, map.distance};
    for (float& texel : relief.level) {
        const double beyond = decoded_distance(double(texel), map.info) - solid.outward;
        const double z = beyond <= 0 ? 0 : solid.bevel > 0 ? beyond / solid.bevel : 1;
        texel = float(z < std::min(solid.chamfer, 1.0) ? z : 1);
    }
    return relief;
}

} // namespace reliefbake
