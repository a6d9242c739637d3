#include "shaders-reference/renderer/resolve.h"

#include <algorithm>
#include <cmath>

namespace reliefbake {
namespace {

std::uint8_t encode_srgb(double linear) {
    const double x = std::clamp(linear, 0.0, 1.0);
    const double encoded = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
    return std::uint8_t(std::lround(255 * encoded));
}

} // namespace

RgbImage resolve_picture(const Image<Quad>& linear, int factor) {
    RgbImage picture{linear.width() / factor, linear.height() / factor, {}};
    picture.rgb.reserve(std::size_t(picture.width) * std::size_t(picture.height) * 3);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            for (int channel = 0; channel < 3; ++channel) {
                double sum = 0;
                for (int b = 0; b < factor; ++b)
                    for (int a = 0; a < factor; ++a) sum += linear(x * factor + a, y * factor + b)[std::size_t(channel)];
                picture.rgb.push_back(encode_srgb(sum / (factor * factor)));
            }
    return picture;
}

} // namespace reliefbake
