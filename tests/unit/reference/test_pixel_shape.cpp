#include "shaders-reference/oracle/pixel_shape.h"
#include "tests/support/fields.h"
#include "tests/support/shapes.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace reliefbake;
using namespace reliefbake::test;

namespace {

/// Over all squares and, on repeated axes, three tiles either way.
double brute_distance(const TexelGrid& grid, const Image<std::uint8_t>& shape, double u, double v, bool inside, double margin) {
    double best = INFINITY;
    const int tiles_x = grid.wrap_x == Wrap::repeat ? 3 : 0, tiles_y = grid.wrap_y == Wrap::repeat ? 3 : 0;
    for (int j = -tiles_y * grid.height; j < (tiles_y + 1) * grid.height; ++j)
        for (int i = -tiles_x * grid.width; i < (tiles_x + 1) * grid.width; ++i) {
            if ((shape(grid.address_x(i), grid.address_y(j)) != 0) != inside) continue;
            const double x = u * grid.width, y = v * grid.height;
            const double dx = std::max({i + margin - x, x - (i + 1 - margin), 0.0}), dy = std::max({j + margin - y, y - (j + 1 - margin), 0.0});
            best = std::min(best, std::hypot(dx * grid.pitch_x(), dy * grid.pitch_y()));
        }
    return best;
}

void compare_with_brute_force(const TexelGrid& grid, const Image<std::uint8_t>& squares, ShapeModel model, std::mt19937& random) {
    const PixelShape shape(grid, squares, model);
    for (int k = 0; k < 20; ++k) {
        const double u = uniform(random, -1.5, 2.5), v = uniform(random, -1.5, 2.5);
        for (const bool inside : {false, true}) {
            const NearestPoint nearest = shape.nearest(u, v, inside);
            const double truth = brute_distance(grid, squares, u, v, inside, model == ShapeModel::centres ? 0.5 : 0);
            if (std::isinf(truth)) {
                CHECK(std::isinf(nearest.distance));
                continue;
            }
            CHECK(nearest.distance == Approx(truth).margin(1e-12));
            CHECK(std::hypot(u - nearest.u, grid.aspect() * (v - nearest.v)) == Approx(truth).margin(1e-12));
        }
        if (model == ShapeModel::squares) CHECK(shape.contains(u, v) == (shape.nearest(u, v, true).distance == 0));
    }
}

/// To the nearest of many points of the squares' parts inside, or of what is outside: never too small, and too large by less than their spacing.
double sampled_distance(const TexelGrid& grid, const Image<float>& coverage, double u, double v, bool inside) {
    constexpr int spacing = 40;
    double best2 = INFINITY;
    const int tile_x = grid.wrap_x == Wrap::repeat ? 1 : 0, tile_y = grid.wrap_y == Wrap::repeat ? 1 : 0;
    for (int j = -tile_y * grid.height; j < (tile_y + 1) * grid.height; ++j)
        for (int i = -tile_x * grid.width; i < (tile_x + 1) * grid.width; ++i) {
            const int at_x = grid.address_x(i), at_y = grid.address_y(j);
            const bool touched = coverage(at_x, at_y) > 0;
            const CutSquare square = touched ? cut_square(coverage, grid, at_x, at_y) : CutSquare();
            for (int b = 0; b <= spacing; ++b)
                for (int a = 0; a <= spacing; ++a) {
                    const double x = double(a) / spacing - 0.5, y = double(b) / spacing - 0.5;
                    const bool held = touched && (square.is_whole() || square.nx * x + square.ny * y <= square.reach);
                    if (held != inside) continue;
                    const double dx = u * grid.width - (i + 0.5 + x), dy = v * grid.height - (j + 0.5 + y);
                    best2 = std::min(best2, dx * dx + dy * dy);
                }
        }
    return std::sqrt(best2) / grid.width;
}

} // namespace

TEST_CASE("the distance to cut squares is that to their points, inside and outside, around borders too", "[oracle][shape]") {
    std::mt19937 random(7);
    int inside_points = 0;
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp})
        for (const unsigned share : {12u, 128u, 256u})
            for (int round = 0; round < 3; ++round) {
                const TexelGrid grid{4 + int(random() % 4), 3 + int(random() % 5), wrap, wrap, 1};
                const Image<float> coverage = random_coverage(grid, random(), share);
                const PixelShape shape(grid, coverage);
                for (int k = 0; k < 20; ++k) {
                    const double u = uniform(random, 0, 1), v = uniform(random, 0, 1);
                    for (const bool inside : {false, true}) {
                        const NearestPoint nearest = shape.nearest(u, v, inside);
                        const double sampled = sampled_distance(grid, coverage, u, v, inside) * grid.width;
                        INFO("share " << share << " wrap " << int(wrap) << " inside " << inside << " at " << u * grid.width << ", " << v * grid.height);
                        if (std::isinf(sampled)) continue; // no point of a sliver
                        CHECK(nearest.distance * grid.width <= sampled + 1e-9);
                        CHECK(nearest.distance * grid.width >= sampled - 1.5 / 40);
                        CHECK(std::hypot(u - nearest.u, grid.aspect() * (v - nearest.v)) == Approx(nearest.distance).margin(1e-12));
                    }
                    CHECK(shape.contains(u, v) == (shape.nearest(u, v, true).distance == 0));
                    inside_points += shape.contains(u, v);
                }
            }
    CHECK(inside_points > 50);
    const TexelGrid grid{5, 4, Wrap::clamp, Wrap::clamp, 1};
    CHECK(PixelShape(grid, Image<float>(5, 4, 0)).signed_distance(0.5, 0.5) == INFINITY);
    CHECK(PixelShape(grid, Image<float>(5, 4, 1)).signed_distance(0.5, 0.5) == -INFINITY);
}

TEST_CASE("the distance to pixel squares and centres is that of brute force, at every odd size", "[oracle][shape]") {
    std::mt19937 random(5);
    const int sizes[][2] = {{1, 1}, {2, 1}, {1, 3}, {3, 3}, {5, 8}, {17, 13}};
    for (const auto& size : sizes)
        for (const Wrap wrap_x : {Wrap::repeat, Wrap::clamp})
            for (const Wrap wrap_y : {Wrap::repeat, Wrap::clamp})
                for (const unsigned share : {0u, 8u, 128u, 250u, 256u})
                    for (const ShapeModel model : {ShapeModel::squares, ShapeModel::centres}) {
                        const TexelGrid grid{size[0], size[1], wrap_x, wrap_y, 1.3};
                        compare_with_brute_force(grid, random_shape(grid, random(), share), model, random);
                    }
}

TEST_CASE("the signed distance changes by no more than the way gone", "[oracle][shape]") {
    std::mt19937 random(6);
    const TexelGrid grid{9, 7, Wrap::repeat, Wrap::clamp, 0.8};
    const TexelGrid square_texels{9, 7, Wrap::repeat, Wrap::clamp, 1};
    const PixelShape squares(grid, random_shape(grid, 3, 100)), contour(square_texels, random_coverage(square_texels, 4, 100));
    for (const PixelShape* shape : {&squares, &contour})
        for (int k = 0; k < 2000; ++k) {
            const double u = uniform(random, 0, 1), v = uniform(random, 0, 1), to_u = uniform(random, -1, 2), to_v = uniform(random, 0, 1);
            const double change = shape->signed_distance(to_u, to_v) - shape->signed_distance(u, v);
            CHECK(std::abs(change) <= std::hypot(to_u - u, shape->grid().aspect() * (to_v - v)) + 1e-12);
        }
}
