#include "shaders-reference/oracle/comes_out.h"
#include "tests/support/crossings.h"
#include "tests/support/fields.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <random>

using namespace reliefbake;
using namespace reliefbake::test;

TEST_CASE("a ray through a wall comes out behind it, one into a plateau does not", "[oracle]") {
    const DepthMap wall = depth_of({16, 1, Wrap::repeat, Wrap::repeat, 1}, [](int i, int) { return i == 8 ? 0.9 : 0.0; });
    const BilinearSurface surface(wall);
    const ReliefRay ray{0, 0.5, 0.5, 1, 0, -0.1}; // in the wall about u = 8.5 / 16
    CHECK_FALSE(comes_out(surface, ray, 0.53, 0.532, 0));
    CHECK(comes_out(surface, ray, 0.53, 0.7, 0));
    CHECK(comes_out(surface, ray, 0.53, 0.7, 0.4)); // 0.43 high at 0.7
    CHECK_FALSE(comes_out(surface, ray, 0.53, 0.7, 0.5));
    CHECK_FALSE(comes_out(surface, ray, 0.7, 0.6, 0));

    const BilinearSurface plateau(depth_of({4, 4, Wrap::repeat, Wrap::repeat, 1}, [](int, int) { return 0.5; }));
    CHECK_FALSE(comes_out(plateau, {0.1, 0.2, 1, 3, -2, -1}, 0.5, 1, 0));
    CHECK(comes_out(plateau, {0.1, 0.2, 1, 3, -2, -1}, 0.4, 1, 0.05));
}

TEST_CASE("a ray inside the relief comes out where its crossings say so", "[oracle]") {
    std::mt19937 random(7);
    const auto uniform = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
    int inside = 0, out = 0;
    for (int k = 0; k < 4000; ++k) {
        const TexelGrid grid{1 + int(random() % 9), 1 + int(random() % 9), k % 2 ? Wrap::repeat : Wrap::clamp, k % 3 ? Wrap::repeat : Wrap::clamp, 1};
        const DepthMap depth = depth_of(grid, [&](int, int) { return uniform(0, 1); });
        const BilinearSurface surface(depth);
        const DescendingRay ray{uniform(-1, 2), uniform(-1, 2), 1, uniform(-6, 6), uniform(-6, 6)};
        const double from = uniform(0, 1), to = uniform(from, 1);
        const double height = surface_height(depth, ray.u + from * ray.du, ray.v + from * ray.dv);
        if (height - (1 - from) < 1e-6) continue; // above it, or on it
        ++inside;
        // `follow` takes a start under the surface for one crossing.
        const Stretch stretch = follow(depth, ray, from, to);
        const bool expected = stretch.crossings > 1;
        CHECK(comes_out(surface, {ray.u, ray.v, ray.h, ray.du, ray.dv, -1}, from, to, 1e-9) == expected);
        out += expected;
    }
    CHECK(inside > 1000);
    CHECK(out > 200);
    CHECK(out < inside - 200);
}
