#include "shaders-reference/oracle/cone_constraint.h"
#include "tests/support/fields.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace reliefbake;
using namespace reliefbake::test;

namespace {

double dense_constraint(const BilinearSurface& surface, double u, double v, const Heading& heading, double reach, int samples) {
    const double apex = surface.height(u, v);
    double best = 0;
    for (int i = 1; i <= samples; ++i) {
        const double s = reach * i / samples;
        const double height = surface.height(u + s * heading.x, v + s * heading.y / surface.grid().aspect());
        best = std::max(best, (height - apex) / s);
    }
    return best;
}

} // namespace

TEST_CASE("a ramp constrains with its own slope", "[oracle]") {
    // Slope 1 per texture width along u; pixel_aspect must not matter along u.
    const BilinearSurface ramp(depth_of({8, 2, Wrap::clamp, Wrap::clamp, 3}, [](int i, int) { return i / 8.0; }));
    CHECK(cone_constraint(ramp, 0.3, 0.5, {1, 0}, 10).slope == Approx(1));
    CHECK(cone_constraint(ramp, 0.3, 0.5, {-1, 0}, 10).slope == 0);
    CHECK(cone_constraint(ramp, 0.3, 0.5, {std::sqrt(0.5), std::sqrt(0.5)}, 10).slope == Approx(std::sqrt(0.5)));
}

TEST_CASE("rounding at a wall does not pass for a slope", "[oracle]") {
    // Texel centres of this size lie a few 1e-13 texels before or behind their wall.
    const TexelGrid grid{1024, 666, Wrap::clamp, Wrap::clamp, 1};
    const BilinearSurface ramp(depth_of(grid, [](int, int j) { return j / 1024.0; }));
    for (int j = 0; j < 665; ++j) {
        const double v = TexelGrid::centre(j, 666);
        CHECK(cone_constraint(ramp, 0.461, v, {0, 1}, 1).slope == Approx(1).epsilon(1e-6));
        CHECK(cone_constraint(ramp, 0.461, v, {0, -1}, 1).slope < 1e-6);
    }
}

TEST_CASE("a spike constrains with height over distance, in the isotropic metric", "[oracle]") {
    const TexelGrid grid{16, 8, Wrap::clamp, Wrap::clamp, 2};
    const BilinearSurface spike(depth_of(grid, [](int i, int j) { return i == 12 && j == 6 ? 1.0 : 0.0; }));
    const double u = TexelGrid::centre(2, 16), v = TexelGrid::centre(3, 8);
    const double du = 10.0 / 16, dv = 3.0 / 8;
    const double distance = std::hypot(du, dv * grid.aspect());
    const Constraint found = cone_constraint(spike, u, v, Heading::along(grid, du, dv), 10);
    CHECK(found.slope == Approx(1 / distance));
    CHECK(found.distance == Approx(distance));
    CHECK(cone_constraint(spike, u, v, Heading::along(grid, du, dv), 0.5 * distance).slope == 0);
}

TEST_CASE("the saddle cell is steeper along its diagonal than its corners say", "[oracle]") {
    const BilinearSurface saddle(depth_of({2, 2, Wrap::clamp, Wrap::clamp, 1}, [](int i, int j) { return (i + j) % 2; }));
    // From a low corner texel the rise per texel is sqrt(2) along the diagonal, at the apex itself.
    const Constraint found = cone_constraint(saddle, 0.25, 0.25, Heading::from_angle(std::atan(1.0)), 10);
    CHECK(found.slope / 2 == Approx(std::sqrt(2.0)));
    CHECK(found.distance == Approx(0).margin(1e-12));
}

TEST_CASE("the constraint agrees with dense samples on every odd size", "[oracle]") {
    std::mt19937 random(5);
    const int sizes[][2] = {{1, 1}, {2, 1}, {1, 3}, {3, 3}, {7, 16}, {17, 13}};
    for (const auto& size : sizes)
        for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
            const TexelGrid grid{size[0], size[1], wrap, wrap == Wrap::clamp ? Wrap::repeat : Wrap::clamp, 0.6};
            const BilinearSurface surface(noise(grid, random()));
            for (int k = 0; k < 60; ++k) {
                const double u = uniform(random, 0, 1), v = uniform(random, 0, 1);
                const Heading heading = Heading::from_angle(uniform(random, 0, 6.2831853));
                const double truth = dense_constraint(surface, u, v, heading, 1.5, 30000);
                const Constraint found = cone_constraint(surface, u, v, heading, 1.5);
                CHECK(found.slope >= truth - 1e-9);
                CHECK(found.slope <= truth * 1.01 + 0.02);
            }
        }
}
