#pragma once
// Mirrored copies, so that directed searches know one quadrant alone.

#include "bake/image.h"

#include <algorithm>

namespace reliefbake {

struct Flip {
    bool x = false, y = false; ///< left to right, top to bottom
    friend bool operator==(const Flip&, const Flip&) = default;
};

/// Its own inverse.
inline Image<float> flipped(const Image<float>& image, Flip flip) {
    if (image.empty() || (!flip.x && !flip.y)) return image;
    Image<float> out(image.width(), image.height());
    for (int y = 0; y < image.height(); ++y) {
        const float* from = image.row(flip.y ? image.height() - 1 - y : y);
        if (flip.x) std::reverse_copy(from, from + image.width(), out.row(y));
        else std::copy_n(from, image.width(), out.row(y));
    }
    return out;
}

} // namespace reliefbake
