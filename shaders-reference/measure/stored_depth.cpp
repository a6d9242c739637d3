#include "shaders-reference/measure/stored_depth.h"

#include <cmath>

namespace reliefbake {

DepthMap stored_depth(const ReliefMap& map) {
    DepthMap depth{map.grid, map.info.bits, map.depth, map.info.holes};
    if (is_unorm(map.info.bits))
        for (float& level : depth.level) level = std::round(level * float(max_code(map.info.bits)));
    return depth;
}

} // namespace reliefbake
