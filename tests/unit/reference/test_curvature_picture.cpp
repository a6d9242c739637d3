#include "shaders-reference/measure/curvature_picture.h"

#include "cli/bench/surfaces.h"
#include "mesh/quadric_bake.h"

#include <catch2/catch.hpp>

#include <limits>

using namespace reliefbake;

namespace {

constexpr int side = 60;

RgbImage picture_of(const char* name, double turn) {
    Mesh mesh = make_surface(name, 1, false).mesh;
    for (Imath::V3d& p : mesh.positions) p = Imath::V3d(p.x, p.z * turn, -p.y * turn); // z becomes up, or down
    QuadricOptions options;
    options.threads = 1;
    const Result<QuadricBake> made = bake_quadrics(mesh, options, name);
    REQUIRE(made);
    return curvature_picture(std::span(&made->mesh, 1), side);
}

/// Red less blue in the middle of a panel.
int redness(const RgbImage& picture, int panel) {
    const std::size_t pixel = (std::size_t(side / 2) * std::size_t(picture.width) + std::size_t(panel * side + side / 2)) * 3;
    return int(picture.rgb[pixel]) - int(picture.rgb[pixel + 2]);
}

} // namespace

TEST_CASE("bulges are red, saddles blue, and the ground white") {
    const RgbImage sphere = picture_of("sphere", 1);
    REQUIRE(sphere.width == 2 * side);
    REQUIRE(sphere.height == side);
    CHECK(redness(sphere, 0) > 50);
    CHECK(redness(sphere, 1) > 50);
    CHECK(redness(picture_of("saddle", 1), 1) < -50);
    CHECK((sphere.rgb[0] == 255 && sphere.rgb[1] == 255 && sphere.rgb[2] == 255));
}

TEST_CASE("a mesh without extent, or not finite, is an empty picture") {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {0, 0, 0}, {std::numeric_limits<double>::quiet_NaN(), 0, 0}};
    mesh.triangles = {{0, 1, 2}};
    mesh.normals.resize(3), mesh.quadrics.resize(3);
    const RgbImage picture = curvature_picture(std::span(&mesh, 1), side);
    for (const std::uint8_t value : picture.rgb) CHECK(value == 255);
}
