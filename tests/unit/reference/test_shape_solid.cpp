#include "shaders-reference/oracle/shape_solid.h"
#include "tests/support/fields.h"
#include "tests/support/shapes.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace reliefbake;
using namespace reliefbake::test;

namespace {

const TexelGrid square16{16, 16, Wrap::clamp, Wrap::clamp, 1};

double hit(const PixelShape& shape, const ShapeSolid& solid, const SolidRay& ray) {
    const auto t = first_solid_hit(shape, solid, ray, 0, domain_exit(shape.grid(), solid, ray));
    return t ? *t : INFINITY;
}

Point3 at(const SolidRay& ray, double t) {
    return {ray.origin[0] + t * ray.direction[0], ray.origin[1] + t * ray.direction[1], ray.origin[2] + t * ray.direction[2]};
}

ShapeSolid extrusion(double e = 0, double b = 0, double c = INFINITY) { return {SolidKind::extrusion, e, b, c}; }
ShapeSolid revolution(double e = 0, double b = 0, double c = INFINITY) { return {SolidKind::revolution, e, b, c}; }

/// Smaller root t >= 0 of |o + t d| = radius + k (z + t dz): a cone around the axis.
double cone_hit(const SolidRay& ray, double radius, double k) {
    const auto& [o, d] = ray;
    const double r = radius + k * o[2], dr = k * d[2];
    const double a = d[0] * d[0] + d[1] * d[1] - dr * dr, b = o[0] * d[0] + o[1] * d[1] - r * dr, c = o[0] * o[0] + o[1] * o[1] - r * r;
    if (b * b < a * c) return INFINITY;
    return (-b - std::sqrt(b * b - a * c)) / a;
}

} // namespace

TEST_CASE("one square, extruded: its walls, and around its corners circles", "[oracle][solid]") {
    const PixelShape shape(square16, shape_of(square16, [](int i, int j) { return i == 8 && j == 8; }));
    const double low = 0.5, high = 9.0 / 16;
    CHECK(hit(shape, extrusion(), {{0, 0.53, 0}, {1, 0, 0.1}}) == Approx(low));
    CHECK(hit(shape, extrusion(), {{1, 0.53, 0}, {-1, 0, 0.1}}) == Approx(1 - high));
    CHECK(hit(shape, extrusion(), {{0, 0.57, 0}, {1, 0, 0.1}}) == INFINITY);
    CHECK(hit(shape, extrusion(), {{0, 0.53, 0}, {1, 0, 3}}) == INFINITY); // the floor comes first
    CHECK(hit(shape, extrusion(), {{0.53, 0.53, 0}, {0, 0, 1}}) == 0);
    // Grown by e: 0.03 above its upper edge the outline is the corner's circle.
    const double e = 0.05, y = 0.5 - 0.03;
    CHECK(hit(shape, extrusion(e), {{0, y, 0}, {1, 0, 0.1}}) == Approx(low - std::sqrt(e * e - 0.03 * 0.03)).epsilon(1e-9));
    CHECK(hit(shape, extrusion(e), {{0, 0.53, 0}, {1, 0, 0.1}}) == Approx(low - e));
}

TEST_CASE("a half plane, bevelled and chamfered: planes", "[oracle][solid]") {
    const PixelShape shape(square16, shape_of(square16, [](int i, int) { return i >= 8; }));
    for (const double b : {0.05, 0.3, 100.0})
        for (const double e : {0.0, 0.1})
            for (const double c : {0.0, 0.4, 1.0, double(INFINITY)}) {
                const double u = 0.1, du = 0.7, way = 0.5 - u - e;
                const double bevelled = way / (du + b);
                const double expected = bevelled <= c ? bevelled : (way - b * c) / du;
                INFO("b " << b << " e " << e << " c " << c);
                CHECK(hit(shape, extrusion(e, b, c), {{u, 0.5, 0}, {du, 0.1, 1}}) == Approx(expected).epsilon(1e-9));
            }
    // From below, on the way up, away from the wall: the bevel recedes.
    CHECK(hit(shape, extrusion(0, 0.3), {{0.1, 0.5, 1}, {0.5, 0, -1}}) == Approx((0.4 - 0.3) / (0.5 - 0.3)));
    CHECK(hit(shape, extrusion(0, 0.3), {{0.1, 0.5, 1}, {0.2, 0, -1}}) == INFINITY);
}

TEST_CASE("an anti-aliased half plane: the wall lies where the coverage says", "[oracle][solid]") {
    for (const float part : {0.1f, 0.5f, 0.9f}) {
        Image<float> coverage(16, 16);
        for (int j = 0; j < 16; ++j)
            for (int i = 0; i < 16; ++i) coverage(i, j) = i < 8 ? 0.0f : i == 8 ? part : 1.0f;
        const PixelShape shape(square16, coverage);
        const double wall = (9 - double(part)) / 16;
        CHECK(hit(shape, extrusion(), {{0.1, 0.4, 0}, {1, 0.2, 0.1}}) == Approx(wall - 0.1));
        CHECK(hit(shape, extrusion(0.05, 0.3), {{0.1, 0.4, 0}, {0.7, 0.2, 1}}) == Approx((wall - 0.05 - 0.1) / (0.7 + 0.3)));
        const Point3 normal = solid_normal(shape, extrusion(), {0.2, 0.4, 0.5});
        CHECK(normal[0] == Approx(-1));
        CHECK(shape.signed_distance(wall + 0.1, 0.4) == Approx(-0.1));
    }
}

TEST_CASE("an anti-aliased disc is the cylinder or sphere within a tenth of a texel", "[oracle][solid]") {
    const int n = 64;
    const TexelGrid grid{n, n, Wrap::clamp, Wrap::clamp, 1};
    const double cu = 0.51, cv = 0.49, radius = 0.3;
    const auto part = [&](double u0, int i, int j) { // of a texel, by points
        int covered = 0;
        for (int k = 0; k < 32 * 32; ++k) covered += std::hypot((i + (k % 32 + 0.5) / 32) / n - u0, (j + (k / 32 + 0.5) / 32) / n - cv) < radius;
        return float(covered) / (32 * 32);
    };
    Image<float> disc(n, n), half(n, n);
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) disc(i, j) = part(cu, i, j), half(i, j) = part(0, i, j);
    const PixelShape cylinder(grid, disc), ball(grid, half);
    std::mt19937 random(3);
    for (int k = 0; k < 300; ++k) {
        const double aside = uniform(random, -0.25, 0.25);
        CHECK(hit(cylinder, extrusion(), {{0, cv + aside, 0}, {1, 0, 0.1}}) == Approx(cu - std::sqrt(radius * radius - aside * aside)).margin(0.1 / n));
        CHECK(hit(ball, revolution(), {{-1, aside, cv}, {1, 0, 0}}) == Approx(1 - std::sqrt(radius * radius - aside * aside)).margin(0.1 / n));
        const double angle = uniform(random, 0, 6.2831853);
        const Point3 normal = solid_normal(cylinder, extrusion(), {cu + 0.4 * std::cos(angle), cv + 0.4 * std::sin(angle), 0.5});
        CHECK(normal[0] * std::cos(angle) - normal[1] * std::sin(angle) > 0.995);
    }
}

TEST_CASE("a strip beside the axis, revolved: cylinders and cones", "[oracle][solid]") {
    std::mt19937 random(2);
    const TexelGrid grid{16, 24, Wrap::clamp, Wrap::clamp, 1};
    const PixelShape shape(grid, shape_of(grid, [](int i, int) { return i < 4; }));
    int hits = 0;
    for (int k = 0; k < 500; ++k) {
        const double angle = uniform(random, 0, 6.2831853);
        const SolidRay ray{{std::cos(angle), std::sin(angle), uniform(random, 0, 0.9)},
                           {-std::cos(angle + uniform(random, -0.4, 0.4)), -std::sin(angle), uniform(random, -0.2, 0.2)}};
        for (const double e : {0.0, 0.2})
            for (const double b : {0.0, 0.3}) {
                double expected = cone_hit(ray, 0.25 + e, b);
                if (!(expected <= domain_exit(grid, revolution(), ray))) expected = INFINITY;
                const double found = hit(shape, revolution(e, b), ray);
                if (expected == INFINITY) CHECK(found == INFINITY);
                else CHECK(found == Approx(expected).margin(1e-7));
                hits += expected < INFINITY;
            }
    }
    CHECK(hits > 1000);
    // Along the axis, and just beside it; up through the chamfer.
    CHECK(hit(shape, revolution(), {{0, 0, 0}, {0, 0, 1}}) == 0);
    CHECK(hit(shape, revolution(0, 0.3, 0.5), {{0.39, 0, 0}, {0, 0, 1}}) == Approx((0.39 - 0.25) / 0.3));
    CHECK(hit(shape, revolution(0, 0.3, 0.25), {{0.39, 0, 0}, {0, 0, 1}}) == INFINITY);
}

TEST_CASE("discs of many squares approach cylinders, spheres and tori", "[oracle][solid]") {
    const int n = 512;
    const TexelGrid grid{n, n, Wrap::clamp, Wrap::clamp, 1};
    const auto disc = [&](double cu, double cv, double radius) {
        return PixelShape(grid, shape_of(grid, [=](int i, int j) {
                              return std::hypot((i + 0.5) / n - cu, (j + 0.5) / n - cv) < radius;
                          }));
    };
    const double texel = 1.0 / n;
    CHECK(hit(disc(0.5, 0.5, 0.3), extrusion(), {{0, 0.6, 0}, {1, 0, 0}}) == Approx(0.5 - std::sqrt(0.09 - 0.01)).margin(2 * texel));
    // A sphere around the axis: z = v.
    CHECK(hit(disc(0, 0.5, 0.3), revolution(), {{-1, 0.1, 0.6}, {1, 0, 0}}) == Approx(1 - std::sqrt(0.09 - 0.02)).margin(3 * texel));
    CHECK(hit(disc(0, 0.5, 0.3), revolution(0.1), {{-1, 0.1, 0.6}, {1, 0, 0}}) == Approx(1 - std::sqrt(0.16 - 0.02)).margin(3 * texel));
    // A torus, from above onto its ring, and through its hole.
    CHECK(hit(disc(0.6, 0.5, 0.2), revolution(), {{0, 0.6, 0}, {0, 0, 1}}) == Approx(0.3).margin(2 * texel));
    CHECK(hit(disc(0.6, 0.5, 0.2), revolution(), {{0, 0.3, 0}, {0, 0, 1}}) == INFINITY);
}

TEST_CASE("hits agree with a dense march over random shapes", "[oracle][solid]") {
    std::mt19937 random(11);
    int hits = 0;
    for (int k = 0; k < 400; ++k) {
        const TexelGrid grid{3 + int(random() % 7), 3 + int(random() % 7), random() % 2 ? Wrap::repeat : Wrap::clamp,
                             random() % 2 ? Wrap::repeat : Wrap::clamp, k % 3 ? 1.2 : 1};
        const PixelShape shape = k % 3 ? PixelShape(grid, random_shape(grid, random(), 30)) : PixelShape(grid, random_coverage(grid, random(), 30));
        ShapeSolid solid = random() % 2 ? extrusion() : revolution();
        solid.outward = random() % 2 * 0.03, solid.bevel = random() % 2 * 0.1, solid.chamfer = random() % 2 ? 0.5 : double(INFINITY);
        const bool turned = solid.kind == SolidKind::revolution;
        const SolidRay ray = {turned ? Point3{-0.7, uniform(random, -0.7, 0.7), uniform(random, 0, 1)} : Point3{uniform(random, 0, 1), uniform(random, 0, 1), 0},
                              turned ? Point3{1, uniform(random, -0.2, 0.2), uniform(random, -0.3, 0.3)}
                                     : Point3{uniform(random, -1, 1), uniform(random, -1, 1), 1}};
        const double t_max = domain_exit(grid, solid, ray);
        const int samples = 4000;
        double truth = INFINITY;
        for (int i = 0; i <= samples && truth == INFINITY; ++i)
            if (solid_gap(shape, solid, at(ray, t_max * i / samples)) <= 0) truth = t_max * i / samples;
        const double found = hit(shape, solid, ray);
        CHECK(found <= truth + 1e-9);
        if (found == INFINITY) continue;
        ++hits;
        CHECK(solid_gap(shape, solid, at(ray, found)) <= 1e-12);
        if (found > 0) CHECK(solid_gap(shape, solid, at(ray, found)) == Approx(0).margin(1e-6));
        // Between samples the march may overlook a sliver; a longer stretch inside it finds.
        if (truth == INFINITY || truth - found > 2 * t_max / samples)
            CHECK(solid_gap(shape, solid, at(ray, found + t_max / samples)) > -2 * t_max / samples);
    }
    CHECK(hits > 100);
}

TEST_CASE("a larger solid is met earlier, a smaller one later", "[oracle][solid]") {
    const PixelShape shape(square16, shape_of(square16, [](int i, int) { return i >= 8; }));
    const SolidRay ray{{0.1, 0.5, 0}, {1, 0, 0.5}};
    CHECK(*first_solid_hit(shape, extrusion(), ray, -0.01, 2) == Approx(0.39));
    CHECK(*first_solid_hit(shape, extrusion(), ray, 0.01, 2) == Approx(0.41));
    CHECK_FALSE(first_solid_hit(shape, extrusion(), ray, 0.01, 0.4));
}

TEST_CASE("normals are the gradient of the gap in the world", "[oracle][solid]") {
    std::mt19937 random(4);
    const TexelGrid grid{8, 6, Wrap::repeat, Wrap::clamp, 1.2};
    const PixelShape squares(grid, random_shape(grid, 9, 60));
    const TexelGrid square_texels{8, 6, Wrap::repeat, Wrap::clamp, 1};
    const PixelShape contour(square_texels, random_coverage(square_texels, 9, 60));
    int checked = 0;
    for (int k = 0; k < 4000; ++k) {
        const PixelShape& shape = k % 4 < 2 ? squares : contour;
        ShapeSolid solid = k % 2 ? extrusion(0.01, 0.2, 0.6) : revolution(0.01, 0.2, 0.6);
        solid.depth_scale = 0.3;
        const Point3 p = k % 2 ? Point3{uniform(random, 0, 1), uniform(random, 0, 1), uniform(random, 0, 1)}
                               : Point3{uniform(random, -0.6, 0.6), uniform(random, -0.6, 0.6), uniform(random, 0, 1)};
        const Point3 scale = k % 2 ? Point3{1, -shape.grid().aspect(), -solid.depth_scale} : Point3{1, 1, -shape.grid().aspect()};
        // Central differences of two widths; where they disagree the gradient jumps nearby (a medial axis, the chamfer's edge).
        Point3 gradient[2];
        for (int w = 0; w < 2; ++w) {
            const double h = w ? 1e-5 : 1e-4;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                Point3 high = p, low = p;
                high[axis] += h, low[axis] -= h;
                gradient[w][axis] = (solid_gap(shape, solid, high) - solid_gap(shape, solid, low)) / (2 * h * scale[axis]);
            }
        }
        const double length = std::hypot(gradient[1][0], gradient[1][1], gradient[1][2]);
        double change = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) change = std::max(change, std::abs(gradient[0][axis] - gradient[1][axis]));
        if (change > 1e-3 || length < 1e-3) continue;
        ++checked;
        const Point3 normal = solid_normal(shape, solid, p);
        for (std::size_t axis = 0; axis < 3; ++axis) CHECK(normal[axis] == Approx(gradient[1][axis] / length).margin(2e-3));
    }
    CHECK(checked > 3000);
}

TEST_CASE("empty and full shapes, and growth beyond the map, are defined", "[oracle][solid]") {
    const PixelShape empty(square16, shape_of(square16, [](int, int) { return false; }));
    const PixelShape full(square16, shape_of(square16, [](int, int) { return true; }));
    const PixelShape dot(square16, shape_of(square16, [](int i, int j) { return i == 3 && j == 4; }));
    const SolidRay rays[] = {{{0.1, 0.2, 0}, {0.3, 0.1, 1}}, {{0, 0, 0}, {0, 0, 1}}, {{0.1, 0.2, 0}, {1, 0, 0}}};
    for (const SolidRay& ray : rays)
        for (const ShapeSolid& solid : {extrusion(), extrusion(0.2, 0.1), extrusion(0, 1e9, 0), revolution(), revolution(1, 1, 1)}) {
            CHECK(hit(empty, solid, ray) == INFINITY);
            CHECK(hit(full, solid, ray) == 0);
            const Point3 normal = solid_normal(full, solid, ray.origin);
            CHECK(std::hypot(normal[0], normal[1], normal[2]) == Approx(1));
        }
    for (const SolidRay& ray : rays) {
        CHECK(hit(dot, extrusion(2), ray) == 0);
        CHECK(hit(dot, revolution(2), ray) == 0);
    }
    CHECK(hit(dot, revolution(), {{0, 0, 0}, {0, 0, 1}}) == INFINITY);
}
