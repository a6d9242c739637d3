#include "shaders-reference/measure/structural_similarity.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <random>

using namespace reliefbake;

namespace {

RgbImage noise(int width, int height, int low, int high, unsigned seed) {
    std::mt19937 random(seed);
    RgbImage picture{width, height, {}};
    for (int k = 0; k < width * height; ++k) {
        const auto grey = std::uint8_t(low + int(random() % unsigned(high - low + 1)));
        picture.rgb.insert(picture.rgb.end(), {grey, grey, grey});
    }
    return picture;
}

/// The definition, window by window, without separating it.
double slow_similarity(const RgbImage& a, const RgbImage& b) {
    double total = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) {
            double w = 0, ma = 0, mb = 0, va = 0, vb = 0, ab = 0;
            for (int pass = 0; pass < 2; ++pass) {
                for (int j = std::max(0, y - 5); j <= std::min(a.height - 1, y + 5); ++j)
                    for (int i = std::max(0, x - 5); i <= std::min(a.width - 1, x + 5); ++i) {
                        const double weight = std::exp(-((i - x) * (i - x) + (j - y) * (j - y)) / (2 * 1.5 * 1.5));
                        const double p = a.rgb[std::size_t(3 * (j * a.width + i))], q = b.rgb[std::size_t(3 * (j * a.width + i))];
                        if (pass == 0) w += weight, ma += weight * p, mb += weight * q;
                        else va += weight * (p - ma) * (p - ma), vb += weight * (q - mb) * (q - mb), ab += weight * (p - ma) * (q - mb);
                    }
                if (pass == 0) ma /= w, mb /= w;
            }
            const double c1 = 2.55 * 2.55, c2 = 7.65 * 7.65;
            total += (2 * ma * mb + c1) * (2 * ab / w + c2) / ((ma * ma + mb * mb + c1) * (va / w + vb / w + c2));
        }
    return total / (a.width * a.height);
}

} // namespace

TEST_CASE("structural similarity follows its definition") {
    for (const auto& [width, height] : {std::pair{1, 1}, {3, 17}, {24, 13}}) {
        const RgbImage a = noise(width, height, 0, 255, 1), b = noise(width, height, 60, 200, 2);
        CHECK(structural_similarity(a, b) == Approx(slow_similarity(a, b)).epsilon(1e-9));
        CHECK(structural_similarity(a, b) == Approx(structural_similarity(b, a)).epsilon(1e-12));
        CHECK(structural_similarity(a, a) == Approx(1).epsilon(1e-12));
    }
}

TEST_CASE("a shift of light is less of a difference than other structure") {
    const RgbImage a = noise(60, 40, 90, 150, 3);
    RgbImage lighter = a;
    for (std::uint8_t& code : lighter.rgb) code = std::uint8_t(code + 10);
    CHECK(structural_similarity(a, lighter) > 0.98);
    CHECK(structural_similarity(a, noise(60, 40, 90, 150, 4)) < 0.3);
}
