#pragma once
// Sources for measurements, without a file.

#include "bake/height_field.h"
#include "cli/cone/stored_height.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace reliefbake {

inline BakeSource source_of(Image<float> heights, WrapChoice wrap) {
    HeightOptions options;
    options.wrap_x = options.wrap_y = wrap;
    Result<CheckedHeight> checked = make_height_field(heights, false, options, "field");
    REQUIRE(checked);
    SourceImage image;
    image.pixel_hash = "0123456789abcdef0123456789abcdef";
    return BakeSource{std::move(image), "", checked->report, std::move(checked->field)};
}

/// Hills on a repeating tile, with posts one texel wide: thin enough for a linear search to miss.
inline BakeSource hills_with_posts(int size, WrapChoice wrap = WrapChoice::repeat) {
    Image<float> heights(size, size);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const double turn = 6.283185307179586 / size;
            heights(x, y) = float(0.3 + 0.2 * std::sin(2 * turn * x) * std::cos(3 * turn * y));
            if (x % 13 == 5 && y % 11 == 7) heights(x, y) = 1;
        }
    return source_of(std::move(heights), wrap);
}

} // namespace reliefbake
