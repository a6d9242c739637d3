#include "shaders-reference/renderer/shape_renderer.h"
#include "tests/support/shapes.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>

using namespace reliefbake;
using namespace reliefbake::test;

namespace {

constexpr double turn = 6.283185307179586;
const TexelGrid square64{64, 64, Wrap::clamp, Wrap::clamp, 1};

/// H(u, v), wavy in both directions, and its slopes.
double height(double u, double v) { return 0.5 + 0.2 * std::sin(4 * turn * u) + 0.2 * std::cos(3 * turn * v); }

BumpTexture wavy_bumps() {
    const TexelGrid grid{512, 512, Wrap::repeat, Wrap::repeat, 1};
    BumpTexture bump{grid, Image<float>(512, 512), Image<float>(512, 512)};
    for (int j = 0; j < 512; ++j)
        for (int i = 0; i < 512; ++i) {
            bump.slope_u(i, j) = float(0.2 * 4 * turn * std::cos(4 * turn * TexelGrid::centre(i, 512)));
            bump.slope_v(i, j) = float(-0.2 * 3 * turn * std::sin(3 * turn * TexelGrid::centre(j, 512)));
        }
    return bump;
}

ShapeRendering draw(const ShapeMap& map, const ShapeRenderOptions& options) {
    ShapeRenderer renderer = *ShapeRenderer::create(RendererBackend::osmesa);
    const BumpTexture bump = wavy_bumps();
    REQUIRE(renderer.load(map));
    REQUIRE(renderer.set_textures(nullptr, &bump));
    return *renderer.render(options);
}

using Surface = std::function<Vec3(double, double)>; ///< P(p, q)

/// Unit normal p x q of a surface, by central differences.
Vec3 normal_of(const Surface& surface, double p, double q) {
    constexpr double h = 1e-5;
    const Vec3 a = surface(p + h, q), b = surface(p - h, q), c = surface(p, q + h), d = surface(p, q - h);
    const Vec3 s{a[0] - b[0], a[1] - b[1], a[2] - b[2]}, t{c[0] - d[0], c[1] - d[1], c[2] - d[2]};
    const Vec3 n{s[1] * t[2] - s[2] * t[1], s[2] * t[0] - s[0] * t[2], s[0] * t[1] - s[1] * t[0]};
    const double length = std::hypot(n[0], n[1], n[2]);
    return {n[0] / length, n[1] / length, n[2] / length};
}

double degrees_between(const Vec3& a, const Quad& b) {
    const double dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    return std::acos(std::min(1.0, dot / std::hypot(b[0], b[1], b[2]))) * 360 / turn;
}

double dot(const Quad& a, const Quad& b) { return double(a[0]) * b[0] + double(a[1]) * b[1] + double(a[2]) * b[2]; }

Vec3 hit_point(const ShapeRendering& rendering, std::size_t k) {
    Vec3 p;
    for (std::size_t axis = 0; axis < 3; ++axis) p[axis] = rendering.origin[k][axis] + double(rendering.counts[k][3]) * rendering.direction[k][axis];
    return p;
}

} // namespace

TEST_CASE("bumps on a cylinder tilt normals as the displaced surface does", "[renderer][bump]") {
    const double radius = 0.5, a = 0.01;
    const ShapeMap map = shape_map_of(square64, shape_of(square64, [](int i, int) { return i < 32; }), {DistanceMethod::exact, false, 1, BitDepth::float32, 0});
    ShapeRenderOptions options;
    options.solid.kind = SolidKind::revolution;
    options.projection = Projection::cylindrical;
    options.bump_scale = a;
    options.texture_tiles_u = turn * radius; // a texture width is a width on the surface
    options.steps = 500, options.binary_steps = 16;
    options.width = options.height = 96;
    options.view = {80, 30, 20, 0};
    const ShapeRendering rendering = draw(map, options);
    const Surface displaced = [&](double angle, double v) {
        const double r = radius + a * height((angle / turn + 0.5) * options.texture_tiles_u, v);
        return Vec3{r * std::cos(angle), r * std::sin(angle), -v};
    };
    int checked = 0;
    double most_tilt = 0;
    for (std::size_t k = 0; k < rendering.counts.size(); ++k) {
        if (rendering.status(k) != RayStatus::hit || rendering.normal[k][3] != 0) continue;
        const Vec3 p = hit_point(rendering, k);
        // p x q = around x up; v goes down
        const Vec3 expected = normal_of([&](double angle, double minus_v) { return displaced(angle, -minus_v); }, std::atan2(p[1], p[0]), -p[2]);
        CHECK(degrees_between(expected, rendering.bumped[k]) < 1);
        most_tilt = std::max(most_tilt, 1 - dot(rendering.normal[k], rendering.bumped[k]));
        ++checked;
    }
    CHECK(checked > 1000);
    CHECK(most_tilt > 0.001); // 2.5 degrees
}

TEST_CASE("bumps on the top of an extrusion tilt normals as the displaced plane does", "[renderer][bump]") {
    const double a = 0.02;
    const ShapeMap map = shape_map_of(square64, shape_of(square64, [](int i, int j) { return i > 8 && j > 8 && i < 55 && j < 55; }));
    ShapeRenderOptions options;
    options.solid.on_plane = true;
    options.bump_scale = a;
    options.width = options.height = 64;
    options.view = {30, 15, 20, 0};
    const ShapeRendering rendering = draw(map, options);
    int checked = 0;
    for (std::size_t k = 0; k < rendering.counts.size(); ++k) {
        if (rendering.status(k) != RayStatus::hit || rendering.normal[k][3] != 1) continue;
        const Vec3 p = hit_point(rendering, k);
        const Vec3 expected = normal_of([&](double x, double y) { return Vec3{x, y, a * height(x, -y)}; }, p[0], -p[1]);
        CHECK(degrees_between(expected, rendering.bumped[k]) < 0.5);
        ++checked;
    }
    CHECK(checked > 500);
}

TEST_CASE("a bump leans the normal within the surface: tangents are tangent, on cones and spheres too", "[renderer][bump]") {
    // N' = (N - a (Hu T + Hv B)) / |...|. With N.T = N.B = 0, N.(N' |...|) = 1: so N'/(N.N') - N lies in the surface, across T where Hv = 0.
    const int n = 128;
    const TexelGrid grid{n, n, Wrap::clamp, Wrap::clamp, 1};
    const ShapeMap ball = shape_map_of(grid, shape_of(grid, [](int i, int j) { return std::hypot(i + 0.5, j - 63.5) < 40; }), {DistanceMethod::exact, false, 1, BitDepth::float32, 0});
    for (const Projection projection : {Projection::cylindrical, Projection::spherical})
        for (const double bevel : {0.0, 0.4}) {
            ShapeRenderOptions options;
            options.solid.kind = SolidKind::revolution;
            options.solid.outward = 0.1, options.solid.bevel = bevel;
            options.projection = projection;
            options.bump_scale = 0.05;
            options.steps = 500, options.binary_steps = 16;
            options.width = options.height = 64;
            options.view = {70, 200, 20, 0};
            const ShapeRendering rendering = draw(ball, options);
            int checked = 0;
            for (std::size_t k = 0; k < rendering.counts.size(); ++k) {
                if (rendering.status(k) != RayStatus::hit || rendering.normal[k][3] != 0) continue;
                const Quad &normal = rendering.normal[k], &bumped = rendering.bumped[k];
                const double lean = dot(normal, bumped);
                REQUIRE(lean > 0);
                const Vec3 p = hit_point(rendering, k);
                const double radius = std::hypot(p[0], p[1]);
                if (radius < 0.02) continue;
                // The part around the axis is -a Hu alone, which the place of the hit tells; a T that leans out of the surface would
                // change N.N' and so all of it.
                const Quad around{float(-p[1] / radius), float(p[0] / radius), 0, 0};
                const double u = (0.5 + std::atan2(p[1], p[0]) / turn);
                const double expected = -0.05 * 0.2 * 4 * turn * std::cos(4 * turn * u);
                CHECK(dot(around, normal) == Approx(0).margin(1e-5));
                CHECK(dot(around, bumped) / lean == Approx(expected).margin(4e-3));
                CHECK(dot(bumped, bumped) == Approx(1).margin(1e-5));
                ++checked;
            }
            CHECK(checked > 300);
        }
}
