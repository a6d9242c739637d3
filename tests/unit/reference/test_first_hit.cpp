#include "shaders-reference/oracle/first_hit.h"
#include "tests/support/fields.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace reliefbake;
using namespace reliefbake::test;

namespace {

/// First of many samples that lies under the surface; the truth up to one sample.
double dense_march(const BilinearSurface& surface, const ReliefRay& ray, double t_max, int samples) {
    for (int i = 0; i <= samples; ++i) {
        const double t = t_max * i / samples;
        if (ray.h + t * ray.dh <= surface.height(ray.u + t * ray.du, ray.v + t * ray.dv)) return t;
    }
    return t_max;
}

} // namespace

TEST_CASE("a flat surface is met at its height", "[oracle]") {
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
        const BilinearSurface flat(depth_of({5, 3, wrap, wrap, 1}, [](int, int) { return 0.25; }));
        const auto hit = first_hit(flat, {0.3, 0.4, 1, 7, -3, -1});
        REQUIRE(hit);
        CHECK(hit->t == Approx(0.75));
        CHECK(hit->u == Approx(0.3 + 0.75 * 7));
        CHECK(first_hit(flat, {0.3, 0.4, 1, 0, 0, -1})->t == Approx(0.75));
        CHECK(first_hit(flat, {0.3, 0.4, 1, 0, 0, -1}, 0.125)->t == Approx(0.875));
        CHECK(first_hit(flat, {0.3, 0.4, 0.25, 1, 0, -1})->t == 0);
        CHECK(first_hit(flat, {0.3, 0.4, 0.2, 1, 0, 1})->t == 0);
        CHECK_FALSE(first_hit(flat, {0.3, 0.4, 0.3, 1, 0, 0}, 0, 100));
        CHECK_FALSE(first_hit(flat, {0.3, 0.4, 0.3, 1, 0, 1}));
    }
}

TEST_CASE("a ramp is met where the two lines cross", "[oracle]") {
    // Clamped ramp: height = x / 8 at texel x; in between H = (8 u - 0.5) / 8.
    const BilinearSurface ramp(depth_of({8, 1, Wrap::clamp, Wrap::clamp, 1}, [](int i, int) { return i / 8.0; }));
    const auto hit = first_hit(ramp, {0.2, 0.5, 1, 1, 0, -1});
    REQUIRE(hit);
    // 1 - t = 0.2 + t - 1/16
    CHECK(hit->t == Approx((1 - 0.2 + 1.0 / 16) / 2).epsilon(1e-12));
    // Beyond the last centre the surface stays at 7/8; level rays stop there too.
    CHECK(first_hit(ramp, {3, 0.5, 1, 1, 0, -1})->t == Approx(0.125));
    CHECK(first_hit(ramp, {0.2, 0.5, 0.5, 1, 0, 0}, 0, 10)->u == Approx(0.5625));
}

TEST_CASE("a pyramid's edges and apex are not lost between cells", "[oracle]") {
    const TexelGrid grid{9, 9, Wrap::repeat, Wrap::repeat, 1};
    const BilinearSurface pyramid(
        depth_of(grid, [](int i, int j) { return 1 - std::max(std::abs(i - 4), std::abs(j - 4)) / 4.0; }));
    const double centre = 0.5;
    for (int k = 0; k < 360; ++k) {
        const double angle = k * 3.14159265358979 / 180;
        // Aimed at the apex from 0.4 widths away, over lines that run along walls and through corners.
        const ReliefRay ray{centre - 0.4 * std::cos(angle), centre - 0.4 * std::sin(angle), 1, std::cos(angle),
                            std::sin(angle), -2.5e-9};
        const auto hit = first_hit(pyramid, ray, 0, 10);
        REQUIRE(hit);
        CHECK(hit->t == Approx(0.4).margin(1e-6));
    }
}

TEST_CASE("a finely sampled sphere is met where the sphere is", "[oracle]") {
    const int n = 257;
    const double radius = 0.4;
    const BilinearSurface sphere(depth_of({n, n, Wrap::clamp, Wrap::clamp, 1}, [&](int i, int j) {
        const double x = (i + 0.5) / n - 0.5, y = (j + 0.5) / n - 0.5;
        return std::sqrt(std::max(0.0, radius * radius - x * x - y * y));
    }));
    const auto hit = first_hit(sphere, {0, 0.5, 0.9, 1, 0, -1});
    REQUIRE(hit);
    // |(t - 0.5, 0.9 - t)| = radius
    const double expected = (1.4 - std::sqrt(1.4 * 1.4 - 2 * (0.25 + 0.81 - radius * radius))) / 2;
    CHECK(hit->t == Approx(expected).margin(1e-4));
}

TEST_CASE("a saddle cell is solved, not sampled", "[oracle]") {
    // One cell {0,1;1,0}: along its diagonal H = 1 - 2 f (1 - f) between the high corners ... and 2 f (1 - f) otherwise.
    const BilinearSurface saddle(depth_of({2, 2, Wrap::clamp, Wrap::clamp, 1}, [](int i, int j) { return (i + j) % 2; }));
    const auto hit = first_hit(saddle, {0.25, 0.25, 0.5, 0.5, 0.5, 0}, 0, 10);
    REQUIRE(hit);
    CHECK(hit->t == Approx(0.5).margin(1e-7));
    CHECK_FALSE(first_hit(saddle, {0.25, 0.25, 0.5 + 1e-12, 0.5, 0.5, 0}, 0, 10));
}

TEST_CASE("the oracle agrees with a dense march on every odd size", "[oracle]") {
    std::mt19937 random(7);
    const int sizes[][2] = {{1, 1}, {2, 1}, {1, 3}, {2, 2}, {5, 3}, {7, 16}, {17, 13}};
    for (const auto& size : sizes)
        for (const Wrap wrap_x : {Wrap::repeat, Wrap::clamp})
            for (const Wrap wrap_y : {Wrap::repeat, Wrap::clamp}) {
                const TexelGrid grid{size[0], size[1], wrap_x, wrap_y, 1.7};
                const BilinearSurface surface(noise(grid, random()));
                for (int k = 0; k < 40; ++k) {
                    const double reach = uniform(random, 0, 4);
                    const double angle = uniform(random, 0, 6.2831853);
                    const ReliefRay ray{uniform(random, -1, 2),   uniform(random, -1, 2), 1, reach * std::cos(angle),
                                        reach * std::sin(angle), -1};
                    const auto hit = first_hit(surface, ray);
                    REQUIRE(hit);
                    const int samples = 20000;
                    const double truth = dense_march(surface, ray, 1, samples);
                    // The march overlooks what is thinner than a sample: it may only be late.
                    CHECK(hit->t <= truth + 1e-12);
                    CHECK(hit->h - surface.height(hit->u, hit->v) == Approx(0).margin(1e-9));
                    const double after = hit->t + 1.0 / samples;
                    const bool grazes = ray.h - after > surface.height(ray.u + after * ray.du, ray.v + after * ray.dv);
                    if (!grazes) CHECK(hit->t >= truth - 1.5 / samples);
                }
            }
}

TEST_CASE("rising rays stop at the top or at an overhang of the march", "[oracle]") {
    std::mt19937 random(3);
    const BilinearSurface surface(noise({9, 6, Wrap::repeat, Wrap::clamp, 1}, 11));
    for (int k = 0; k < 200; ++k) {
        const double u = uniform(random, 0, 1), v = uniform(random, 0, 1);
        const double start = surface.height(u, v) + 0.01;
        const ReliefRay ray{u, v, start, uniform(random, -0.3, 0.3), uniform(random, -0.3, 0.3), 1};
        const double t_end = std::max(0.0, surface.highest() - start);
        const double truth = dense_march(surface, ray, t_end, 20000);
        const auto hit = first_hit(surface, ray);
        if (hit) CHECK(hit->t <= truth + 1e-12);
        else CHECK(truth == Approx(t_end).margin(1e-4));
    }
}
