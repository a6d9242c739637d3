#include "bake/height_field.h"

#include "bake/stored_code.h"

namespace reliefbake {

DepthMap quantise_depth(const HeightField& field, BitDepth bits) {
    const Image<float>& heights = field.heights();
    DepthMap map{field.grid(), bits, Image<float>(heights.width(), heights.height())};
    for (std::size_t i = 0; i < heights.size(); ++i) {
        const StoredCode code = nearest_code(1.0 - double(heights[i]), bits);
        map.level[i] = is_unorm(bits) ? float(code) : stored_value(code, bits);
    }
    return map;
}

} // namespace reliefbake
