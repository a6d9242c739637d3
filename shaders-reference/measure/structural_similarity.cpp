#include "shaders-reference/measure/structural_similarity.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace reliefbake {
namespace {

constexpr int radius = 5;
constexpr double sigma = 1.5, c1 = (0.01 * 255) * (0.01 * 255), c2 = (0.03 * 255) * (0.03 * 255);

/// Sums of weights, a, b, a^2, b^2, ab.
using Moments = std::array<double, 6>;

double luma(const RgbImage& picture, std::size_t pixel) {
    const std::uint8_t* rgb = &picture.rgb[3 * pixel];
    return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
}

/// Adds the moments of the neighbours along one axis, `stride` apart; `at` of `count`.
Moments blurred(const std::vector<Moments>& moments, std::size_t pixel, int at, int count, std::ptrdiff_t stride) {
    Moments sum{};
    for (int k = std::max(-radius, -at); k <= std::min(radius, count - 1 - at); ++k) {
        const double weight = std::exp(-0.5 * k * k / (sigma * sigma));
        const Moments& other = moments[std::size_t(std::ptrdiff_t(pixel) + k * stride)];
        for (std::size_t m = 0; m < sum.size(); ++m) sum[m] += weight * other[m];
    }
    return sum;
}

double similarity(Moments m) {
    for (std::size_t k = 1; k < m.size(); ++k) m[k] /= m[0];
    const double variance_a = m[3] - m[1] * m[1], variance_b = m[4] - m[2] * m[2], covariance = m[5] - m[1] * m[2];
    return (2 * m[1] * m[2] + c1) * (2 * covariance + c2) / ((m[1] * m[1] + m[2] * m[2] + c1) * (variance_a + variance_b + c2));
}

} // namespace

double structural_similarity(const RgbImage& a, const RgbImage& b) {
    assert(a.width == b.width && a.height == b.height && a.width > 0 && a.height > 0);
    const std::size_t pixels = std::size_t(a.width) * std::size_t(a.height);
    std::vector<Moments> moments(pixels), rows(pixels);
    for (std::size_t k = 0; k < pixels; ++k) {
        const double x = luma(a, k), y = luma(b, k);
        moments[k] = {1, x, y, x * x, y * y, x * y};
    }
    for (std::size_t k = 0; k < pixels; ++k) rows[k] = blurred(moments, k, int(k % std::size_t(a.width)), a.width, 1);
    double sum = 0;
    for (std::size_t k = 0; k < pixels; ++k) sum += similarity(blurred(rows, k, int(k / std::size_t(a.width)), a.height, a.width));
    return sum / double(pixels);
}

} // namespace reliefbake
