#include "bake/height_field.h"

#include "bake/stored_code.h"

#include <algorithm>

namespace reliefbake {

namespace {

/// `level` and `heights` may be one.
void quantise(const Image<float>& heights, const HoleMask& holes, BitDepth bits, Image<float>& level) {
    const StoredCode floor = nearest_code(1, bits);
    for (std::size_t i = 0; i < heights.size(); ++i) {
        StoredCode code = nearest_code(1.0 - double(heights[i]), bits);
        if (!holes.empty()) code = holes[i] ? floor : std::min(code, floor - 1);
        level[i] = is_unorm(bits) ? float(code) : stored_value(code, bits);
    }
}

} // namespace

DepthMap quantise_depth(const HeightField& field, BitDepth bits) {
    const Image<float>& heights = field.heights();
    DepthMap map{field.grid(), bits, Image<float>(heights.width(), heights.height()), !field.holes().empty()};
    quantise(heights, field.holes(), bits, map.level);
    return map;
}

DepthMap quantise_depth(HeightField&& field, BitDepth bits) {
    DepthMap map{field.grid(), bits, {}, !field.holes().empty()};
    const HoleMask holes = field.holes();
    map.level = std::move(field).take_heights();
    quantise(map.level, holes, bits, map.level);
    return map;
}

} // namespace reliefbake
