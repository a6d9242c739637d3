// Every node's maximum and plane lie on or above each of its texels.

#include "bake/max_pyramid.h"
#include "tests/support/cone_fields.h"

#include <catch2/catch.hpp>

using namespace reliefbake;
using namespace reliefbake::test;

namespace {

void require_bounds(const Image<float>& heights) {
    const MaxPyramid pyramid = build_max_pyramid(heights, 2);
    REQUIRE(pyramid.nodes_x(pyramid.level_count() - 1) * pyramid.nodes_y(pyramid.level_count() - 1) == 1);
    for (int k = 0; k < pyramid.level_count(); ++k) {
        const int side = MaxPyramid::side(k);
        for (int y = 0; y < heights.height(); ++y)
            for (int x = 0; x < heights.width(); ++x) {
                const PyramidNode n = pyramid.node(k, x / side, y / side);
                const double plane = double(n.plane) + double(n.gx) * (x - double(n.cx)) + double(n.gy) * (y - double(n.cy));
                REQUIRE(heights(x, y) <= n.max);
                REQUIRE(double(heights(x, y)) <= plane);
                REQUIRE(std::fabs(x - n.cx) <= n.half_x);
                REQUIRE(std::fabs(y - n.cy) <= n.half_y);
            }
    }
}

} // namespace

TEST_CASE("pyramid nodes bound their texels from above") {
    for (const std::string& name : adversarial_names()) require_bounds(adversarial(grid_of(67, 45, Wrap::clamp), name).level);
    for (std::uint32_t seed = 1; seed < 6; ++seed)
        require_bounds(noise(grid_of(int(3 + 13 * seed), int(50 - 7 * seed), Wrap::clamp), seed).level);
}

TEST_CASE("the root's plane of a ramp is tight") {
    const MaxPyramid pyramid = build_max_pyramid(adversarial(grid_of(256, 256, Wrap::clamp), "ramp", BitDepth::float32).level, 1);
    const PyramidNode root = pyramid.node(pyramid.level_count() - 1, 0, 0);
    REQUIRE(root.gx == Approx(-1.0 / 256).epsilon(1e-4));
    REQUIRE(std::fabs(root.gy) < 1e-7f);
    REQUIRE(root.plane == Approx(0.5).margin(1e-4));
}
