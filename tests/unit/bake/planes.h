#pragma once
// Source planes written out in a test.

#include "bake/image.h"

#include <algorithm>
#include <initializer_list>

namespace reliefbake::test {

inline Image<float> plane(int width, int height, std::initializer_list<float> values) {
    Image<float> image(width, height);
    std::copy(values.begin(), values.end(), image.begin());
    return image;
}

} // namespace reliefbake::test
