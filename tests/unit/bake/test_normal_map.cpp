#include "bake/normal_map.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <random>

using namespace reliefbake;

namespace {

/// A depth plane depth(i, j) stored in floats.
template <class Depth>
DepthMap stored(const TexelGrid& grid, Depth depth) {
    DepthMap map{grid, BitDepth::float32, Image<float>(grid.width, grid.height)};
    for (int j = 0; j < grid.height; ++j)
        for (int i = 0; i < grid.width; ++i)
            map.level(i, j) = float(depth(i, j));
    return map;
}

TexelGrid clamped(int width, int height, double pixel_aspect = 1) {
    return {width, height, Wrap::clamp, Wrap::clamp, pixel_aspect};
}

} // namespace

TEST_CASE("A flat map's normals point up") {
    const NormalMap map = bake_normals(stored(clamped(3, 2), [](int, int) { return 0.5; }), 0.1);
    for (std::size_t i = 0; i < map.x.size(); ++i)
        CHECK((map.x[i] == 0 && map.y[i] == 0));
}

TEST_CASE("A ramp's normal is the plane's, at the border too, whatever the pixels' shape") {
    // Height rises by `rise` over the width to the right: slope = depth_scale * rise; the normal leans left.
    const double rise = 0.8, scale = 0.5, aspect = GENERATE(1.0, 0.5);
    const TexelGrid grid = clamped(16, 8, aspect);
    const NormalMap right =
        bake_normals(stored(grid, [&](int i, int) { return 0.9 - rise * i / 16; }), scale);
    const double slope = rise * scale;
    for (const float nx : right.x)
        CHECK(nx == Approx(-slope / std::sqrt(1 + slope * slope)).margin(1e-5));
    for (const float ny : right.y)
        CHECK(ny == Approx(0).margin(1e-6));
    // Rising to the image's top: 8 rows are 8 / 16 * aspect widths; the normal leans down.
    const NormalMap up = bake_normals(stored(grid, [&](int, int j) { return 0.1 + rise * j / 8; }), scale);
    const double steep = rise * scale / (8 / 16.0 * aspect);
    for (const float ny : up.y)
        CHECK(ny == Approx(-steep / std::sqrt(1 + steep * steep)).margin(1e-5));
}

TEST_CASE("Shifting a repeating map by a texel shifts its normals") {
    std::mt19937 random(2);
    Image<float> noise(7, 5);
    for (float& d : noise)
        d = float(random() / 4294967296.0);
    TexelGrid grid;
    grid.width = 7;
    grid.height = 5;
    const NormalMap map = bake_normals(stored(grid, [&](int i, int j) { return noise(i, j); }), 0.3);
    const NormalMap moved =
        bake_normals(stored(grid, [&](int i, int j) { return noise((i + 3) % 7, (j + 4) % 5); }), 0.3);
    for (int j = 0; j < 5; ++j)
        for (int i = 0; i < 7; ++i) {
            CHECK(moved.x(i, j) == map.x((i + 3) % 7, (j + 4) % 5));
            CHECK(moved.y(i, j) == map.y((i + 3) % 7, (j + 4) % 5));
        }
}

TEST_CASE("The steepest cliff keeps a positive z in float arithmetic") {
    TexelGrid grid = clamped(16384, 2);
    const NormalMap map = bake_normals(stored(grid, [](int i, int j) { return (i / 2 + j) % 2; }), 100);
    for (std::size_t i = 0; i < map.x.size(); ++i)
        REQUIRE(1 - map.x[i] * map.x[i] - map.y[i] * map.y[i] > 0);
}

TEST_CASE("Same normals for every number of threads") {
    std::mt19937 random(3);
    const DepthMap depth = stored(clamped(33, 41), [&](int, int) { return random() / 4294967296.0; });
    const NormalMap alone = bake_normals(depth, 0.3, 1);
    for (const int threads : {0, 2, 7}) {
        const NormalMap map = bake_normals(depth, 0.3, threads);
        CHECK(map.x == alone.x);
        CHECK(map.y == alone.y);
    }
}

TEST_CASE("Axes of one texel are flat") {
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
        const NormalMap map = bake_normals(stored({1, 1, wrap, wrap, 1}, [](int, int) { return 0.3; }), 1);
        CHECK(map.x(0, 0) == 0);
        CHECK(map.y(0, 0) == 0);
    }
}
