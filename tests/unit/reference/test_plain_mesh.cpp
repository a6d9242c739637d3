#include "shaders-reference/renderer/plain_mesh.h"

#include "cli/bench/revolved.h"
#include "shaders-reference/measure/compare_mesh.h"
#include "tests/support/fields.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace reliefbake;
using namespace reliefbake::test;

namespace {

const TexelGrid repeated{32, 16, Wrap::repeat, Wrap::repeat, 1};
constexpr int width = 320, height = 240;

const RevolvedSurface& surface(const char* name) {
    for (const RevolvedSurface& s : revolved_surfaces())
        if (s.name == name) return s;
    std::abort();
}

PlainMeshOptions level_view() {
    PlainMeshOptions options;
    options.camera = make_orbit_camera({0, 0, 0}, 1.5, {90, 20, 30, 0}, double(width) / height);
    options.width = width;
    options.height = height;
    return options;
}

Image<float> distances(const PlainMeshOptions& options, const TriangleSource& triangles) {
    static Result<PlainMeshRenderer> renderer = PlainMeshRenderer::create(RendererBackend::osmesa);
    REQUIRE(renderer);
    Result<PlainMeshRendering> rendering = renderer->render(options, triangles);
    REQUIRE(rendering);
    return std::move(rendering->distance);
}

/// The exact distance of a sphere about the origin through each pixel's centre.
Image<float> sphere_distances(const PlainMeshOptions& options, double radius) {
    Image<float> exact(width, height, INFINITY);
    const Camera& c = options.camera;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double sx = 2 * (x + 0.5) / width - 1, sy = 1 - 2 * (y + 0.5) / height;
            double dd = 0, de = 0, ee = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                const double d = c.forward[k] + sx * c.right[k] + sy * c.up[k];
                dd += d * d, de += d * c.eye[k], ee += c.eye[k] * c.eye[k];
            }
            const double root = de * de - dd * (ee - radius * radius);
            if (root > 0) exact(x, y) = float((-de - std::sqrt(root)) / std::sqrt(dd));
        }
    return exact;
}

MeshComparison compare(const Image<float>& base, const Image<float>& truth, const Image<float>& rendering) {
    const MeshPlanes planes{base, truth, rendering, Image<float>(width, height, 0)};
    return compare_mesh({&planes, 1}, 1);
}

} // namespace

TEST_CASE("a sphere sunk by a constant depth covers the smaller disc, at its distance", "[reference][mesh]") {
    const PlainMeshOptions options = level_view();
    const DepthMap map = depth_of(repeated, [](int, int) { return 0.5; });
    const BilinearSurface relief(map);
    const Mesh mesh = make_revolved(surface("sphere"), 128);
    const Image<float> base = distances(options, plain_triangles(mesh));
    const Image<float> sunk = distances(options, displaced_triangles(mesh, relief, {0.2, 4, 2}));
    const MeshComparison round = compare(base, sphere_distances(options, 0.9), sunk);
    CHECK(round.iou() > 0.99);
    CHECK(round.depth_99 < 0.02); // 128 segments, and pixels at the limb
    CHECK(round.cut_iou() > 0.95);
    // A mutant that sinks outward is caught: it cuts nothing.
    const Image<float> raised = distances(options, displaced_triangles(mesh, relief, {-0.2, 4, 2}));
    CHECK(compare(base, sphere_distances(options, 0.9), raised).iou() < 0.75);
    CHECK(compare(base, sphere_distances(options, 0.9), raised).cut_iou() == 0);
    CHECK(compare(base, sphere_distances(options, 0.9), base).cut_iou() == 0);
}

TEST_CASE("a cylinder sunk by a constant depth is narrower by as much", "[reference][mesh]") {
    const PlainMeshOptions options = level_view();
    const DepthMap map = depth_of(repeated, [](int, int) { return 0.25; });
    const BilinearSurface relief(map);
    const Mesh mesh = make_revolved(surface("cylinder"), 128);
    const Image<float> sunk = distances(options, displaced_triangles(mesh, relief, {0.4, 6, 2}));
    int covered = 0;
    for (int x = 0; x < width; ++x) covered += std::isfinite(sunk(x, height / 2));
    double eye = 0, half = 0;
    for (std::size_t k = 0; k < 3; ++k) eye += options.camera.eye[k] * options.camera.eye[k], half += options.camera.right[k] * options.camera.right[k];
    const double radius = 0.7, tangent = radius / std::sqrt(eye - radius * radius);
    CHECK(covered == Approx(width * tangent / std::sqrt(half)).margin(1.5));
}

TEST_CASE("a rough displaced torus has no cracks, and is drawn the same twice", "[reference][mesh]") {
    PlainMeshOptions options = level_view();
    options.camera = make_orbit_camera({0, 0, 0}, 1.5, {0, 0, 30, 0}, double(width) / height);
    const DepthMap map = noise(repeated, 5);
    const BilinearSurface relief(map);
    const Mesh mesh = make_revolved(surface("torus"), 64);
    DisplaceOptions small;
    small.batch = 999;
    const Image<float> once = distances(options, displaced_triangles(mesh, relief, {0.2, 5, 2}, small));
    CHECK(once == distances(options, displaced_triangles(mesh, relief, {0.2, 5, 2}, small)));
    // From above all within the ring must be covered, though half of the tube's radius may be gone.
    int within = 0;
    double half = 0, eye = 0;
    for (std::size_t k = 0; k < 3; ++k) half += options.camera.right[k] * options.camera.right[k], eye += options.camera.eye[k] * options.camera.eye[k];
    const double scale = std::sqrt(half) * std::sqrt(eye) * 2 / width; // of a pixel, at the middle
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double r = std::hypot(x + 0.5 - width / 2, y + 0.5 - height / 2) * scale;
            if (r < 0.9 || r > 1.1) continue;
            ++within;
            CHECK(std::isfinite(once(x, y)));
        }
    CHECK(within > 2000);
}

TEST_CASE("what cannot be made is said, not drawn", "[reference][mesh]") {
    Result<PlainMeshRenderer> renderer = PlainMeshRenderer::create(RendererBackend::osmesa);
    REQUIRE(renderer);
    const DepthMap map = noise(repeated, 5);
    const BilinearSurface relief(map);
    const Mesh mesh = make_revolved(surface("torus"), 64);
    DisplaceOptions few;
    few.most_triangles = 10;
    const auto refused = renderer->render(level_view(), displaced_triangles(mesh, relief, {0.2, 5, 2}, few));
    REQUIRE_FALSE(refused);
    CHECK(refused.error().code == ErrorCode::budget);
    PlainMeshOptions wide = level_view();
    wide.width = 1 << 20;
    const auto large = renderer->render(wide, plain_triangles(mesh));
    REQUIRE_FALSE(large);
    CHECK(large.error().code == ErrorCode::usage);
}
