#include "shaders-reference/measure/heat_map.h"

#include <algorithm>
#include <cmath>

namespace reliefbake {
namespace {

constexpr double anchors[][3] = {{68, 1, 84},    {71, 44, 122},  {59, 81, 139},   {44, 113, 142}, {33, 144, 141},
                                 {39, 173, 129}, {92, 200, 99},  {170, 220, 50},  {253, 231, 37}};
constexpr int intervals = 8;
constexpr double smallest_error = 1e-5;

template <class Value>
RgbImage paint(const Rendering& rendering, const Value& value) {
    RgbImage picture{rendering.width(), rendering.height(), {}};
    picture.rgb.reserve(rendering.hit.size() * 3);
    for (std::size_t pixel = 0; pixel < rendering.hit.size(); ++pixel) {
        std::array<std::uint8_t, 3> colour{};
        if (rendering.status(pixel) != RayStatus::no_ray) colour = viridis(value(pixel));
        picture.rgb.insert(picture.rgb.end(), colour.begin(), colour.end());
    }
    return picture;
}

} // namespace

std::array<std::uint8_t, 3> viridis(double x) {
    const double place = std::clamp(x, 0.0, 1.0) * intervals;
    const int low = std::min(int(place), intervals - 1);
    std::array<std::uint8_t, 3> colour;
    for (int c = 0; c < 3; ++c) {
        const double value = anchors[low][c] + (place - low) * (anchors[low + 1][c] - anchors[low][c]);
        colour[std::size_t(c)] = std::uint8_t(std::lround(value));
    }
    return colour;
}

RgbImage error_picture(const Rendering& rendering, const Image<Quad>& oracle) {
    return paint(rendering, [&](std::size_t pixel) {
        const double error = std::abs(double(rendering.counts[pixel][3]) - double(oracle[pixel][0]));
        return 1 - std::log10(std::max(error, smallest_error)) / std::log10(smallest_error);
    });
}

RgbImage steps_picture(const Rendering& rendering, double brightest) {
    return paint(rendering, [&](std::size_t pixel) { return rendering.counts[pixel][0] / brightest; });
}

} // namespace reliefbake
