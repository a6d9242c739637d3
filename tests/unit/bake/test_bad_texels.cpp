#include "bake/bad_texels.h"
#include "tests/unit/bake/planes.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdlib>
#include <random>

using namespace reliefbake;
using reliefbake::test::plane;

TEST_CASE("NaN, both infinities and the no-data value are bad; the first is found in row order") {
    const Image<float> source = plane(3, 2, {0, 1, -9999, NAN, INFINITY, -INFINITY});
    CHECK(find_bad_texels(source, {}).count == 3);
    const BadTexels bad = find_bad_texels(source, -9999.0f);
    CHECK(bad.count == 4);
    CHECK(bad.first_x == 2);
    CHECK(bad.first_y == 0);
}

TEST_CASE("A hole takes the nearest value, the first in row order among equals") {
    Image<float> source = plane(5, 1, {1, NAN, NAN, NAN, 2});
    fill_bad_texels(source, find_bad_texels(source, {}));
    CHECK(source == plane(5, 1, {1, 1, 1, 2, 2}));
}

TEST_CASE("Every filled texel holds the value of a texel at the smallest distance") {
    std::mt19937 random(7);
    for (int round = 0; round < 50; ++round) {
        const int width = 1 + int(random() % 9), height = 1 + int(random() % 9);
        Image<float> source(width, height);
        for (std::size_t i = 0; i < source.size(); ++i)
            source[i] = random() % 3 ? NAN : float(i);
        source[random() % source.size()] = 1000;
        Image<float> filled = source;
        fill_bad_texels(filled, find_bad_texels(source, {}));
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                int nearest = width + height, taken = -1;
                for (int j = 0; j < height; ++j)
                    for (int i = 0; i < width; ++i) {
                        if (std::isnan(source(i, j))) continue;
                        const int distance = std::abs(i - x) + std::abs(j - y);
                        nearest = std::min(nearest, distance);
                        if (source(i, j) == filled(x, y)) taken = distance;
                    }
                CHECK(taken == nearest);
            }
    }
}
