#include "bake/height_field.h"

#include "bake/stored_code.h"

#include <algorithm>

namespace reliefbake {

DepthMap quantise_depth(const HeightField& field, BitDepth bits) {
    const Image<float>& heights = field.heights();
    const HoleMask& holes = field.holes();
    DepthMap map{field.grid(), bits, Image<float>(heights.width(), heights.height()), !holes.empty()};
    const StoredCode floor = nearest_code(1, bits);
    for (std::size_t i = 0; i < heights.size(); ++i) {
        StoredCode code = nearest_code(1.0 - double(heights[i]), bits);
        if (map.holes) code = holes[i] ? floor : std::min(code, floor - 1);
        map.level[i] = is_unorm(bits) ? float(code) : stored_value(code, bits);
    }
    return map;
}

} // namespace reliefbake
