#include "bake/filter_delta.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <random>

using namespace reliefbake;

namespace {

/// Bilinear depth in cell (i, j) with weights a and b.
double filtered(const DepthMap& map, int i, int j, double a, double b) {
    const TexelGrid& g = map.grid;
    const int k = g.address_x(i + 1), l = g.address_y(j + 1);
    const double top = (1 - a) * map.depth(i, j) + a * map.depth(k, j);
    const double bottom = (1 - a) * map.depth(i, l) + a * map.depth(k, l);
    return (1 - b) * top + b * bottom;
}

} // namespace

TEST_CASE("Weights of 8 bits change no filtered depth by more than filter_delta, and come near it") {
    std::mt19937 random(4);
    TexelGrid grid;
    grid.width = 4;
    grid.height = 3;
    DepthMap map{grid, BitDepth::unorm16, Image<float>(4, 3)};
    for (float& level : map.level)
        level = float(random() % 65536);
    const double bound = filter_delta(map);
    double worst = 0;
    for (int n = 0; n < 200000; ++n) {
        const int i = int(random() % 4), j = int(random() % 3);
        const double a = random() / 4294967296.0, b = random() / 4294967296.0;
        const double sampled = filtered(map, i, j, std::round(a * 256) / 256, std::round(b * 256) / 256);
        worst = std::max(worst, std::abs(sampled - filtered(map, i, j, a, b)));
    }
    CHECK(worst <= bound);
    CHECK(worst > bound / 2);
}

TEST_CASE("A flat map loses nothing but the 8-bit result's truncation") {
    const DepthMap flat{TexelGrid{}, BitDepth::float32, Image<float>(1, 1, 0.5f)};
    CHECK(filter_delta(flat) == 0);
    const DepthMap flat8{TexelGrid{}, BitDepth::unorm8, Image<float>(1, 1, 100)};
    CHECK(filter_delta(flat8) == Approx(2 / 255.0));
}
