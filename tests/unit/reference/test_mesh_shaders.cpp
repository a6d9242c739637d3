// The shaders of curved relief as texts, and against truths in closed form: a plane, a ball.

#include "shaders-reference/renderer/mesh_renderer.h"

#include "bake/cone.h"
#include "cli/bench/revolved.h"
#include "mesh/quadric_bake.h"
#include "shaders-reference/measure/verify_mesh.h"
#include "shaders-reference/renderer/mesh_source.h"
#include "tests/support/fields.h"
#include "tests/support/glslang_check.h"
#include "tests/support/slow_cones.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>

using namespace reliefbake;
using namespace reliefbake::test;

namespace {

MeshRendering drawn(const MeshObject& object, const ReliefMap& map, const MeshRenderOptions& options) {
    auto renderer = MeshRenderer::create(RendererBackend::osmesa);
    REQUIRE(renderer);
    REQUIRE(renderer->load(map));
    REQUIRE(renderer->set_objects({object}));
    auto rendering = renderer->render(options);
    if (!rendering) FAIL(rendering.error().message);
    return std::move(*rendering);
}

/// The line of sight through a sample, unit.
Vec3 sight_at(const Camera& camera, int x, int y, const MeshRenderOptions& picture) {
    const double across = 2 * (x + 0.5) / picture.width - 1, upwards = 1 - 2 * (y + 0.5) / picture.height;
    Vec3 view;
    double square = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        view[k] = camera.forward[k] + across * camera.right[k] + upwards * camera.up[k];
        square += view[k] * view[k];
    }
    for (double& part : view) part /= std::sqrt(square);
    return view;
}

/// The plane that ReliefRenderer draws, as a mesh of n x n squares.
Mesh plane_mesh(double aspect, int tiles, int n) {
    Mesh mesh;
    mesh.v_down = true;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            const double u = double(i) / n, v = double(j) / n;
            mesh.positions.push_back({tiles * u, -aspect * tiles * v, 0});
            mesh.uvs.push_back({float(u), float(v)});
            mesh.normals.push_back({0, 0, 1});
            mesh.tangents.push_back({1, 0, 0, 1});
            mesh.quadrics.push_back({});
        }
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const auto at = [&](int x, int y) { return std::uint32_t((j + y) * (n + 1) + i + x); };
            mesh.triangles.push_back({at(0, 0), at(0, 1), at(1, 1)});
            mesh.triangles.push_back({at(0, 0), at(1, 1), at(1, 0)});
        }
    return mesh;
}

} // namespace

TEST_CASE("every shader of curved meshes is valid under all three preludes", "[shaders][mesh]") {
    GlslangCheck check;
    for (const Prelude prelude : {Prelude::core330, Prelude::core450, Prelude::es300}) {
        check.add(mesh_vertex_source(prelude), ".vert");
        for (int path = 0; path < 4; ++path)
            for (int bits = 0; bits < 32; ++bits) {
                MeshConfig config;
                config.path = path;
                config.solid = bits & 1;
                config.sunk_cone = !config.solid && path % 2 == 1 && bits & 2;
                config.halves = path == published_path && bits & 8;
                config.search = !config.solid && path != published_path && !config.sunk_cone && bits & 2;
                config.twist = bits & 4, config.keep = bits & 8;
                config.shape_unorm = bits & 16, config.shape_signed = bits & 2;
                config.decoder.sectors = bits & 16 ? 8 : 0;
                check.add(mesh_fragment_source(config, prelude), ".frag");
            }
    }
    CHECK(check.faults() == "");
}

TEST_CASE("A flat mesh shows what the renderer of planes shows", "[renderer][mesh]") {
    const TexelGrid grid{24, 18, Wrap::repeat, Wrap::repeat, 1};
    const DepthMap depth = noise(grid, 5);
    ReliefMap map = make_relief_map(depth, bake_cones(depth, {}).ratio, 1, {});
    map.info.depth_scale = 0.15;
    RenderOptions flat;
    flat.width = 120, flat.height = 90, flat.tiles = 3, flat.max_steps = 2000;
    const Mesh mesh = plane_mesh(grid.aspect(), flat.tiles, 5);
    MeshRenderOptions options;
    options.width = flat.width, options.height = flat.height, options.max_steps = flat.max_steps;
    options.epsilon = flat.epsilon, options.binary_steps = 12;
    for (const double angle : {20.0, 60.0}) {
        flat.view = {angle, 25, 30, 0};
        const Result<Rendering> truth = render(map, flat);
        REQUIRE(truth);
        options.camera = make_camera(grid, flat.view, flat.tiles, 4.0 / 3);
        for (const Correction correction : {Correction::none, Correction::ray, Correction::cone, Correction::bent}) {
            options.correction = correction;
            const MeshRendering curved = drawn({&mesh, {map.info.depth_scale, double(flat.tiles), double(flat.tiles)}}, map, options);
            int hits = 0, covered = 0, far = 0;
            for (int y = 0; y < flat.height; ++y)
                for (int x = 0; x < flat.width; ++x) {
                    const std::size_t k = std::size_t(y) * std::size_t(flat.width) + std::size_t(x);
                    hits += truth->status(k) == RayStatus::hit, covered += std::isfinite(curved.distance[k]);
                    if (truth->status(k) != RayStatus::hit || !std::isfinite(curved.distance[k])) continue;
                    const double down = -sight_at(options.camera, x, y, options)[2];
                    const double way = (options.camera.eye[2] + double(truth->counts[k][3]) * map.info.depth_scale) / down;
                    far += std::fabs(double(curved.distance[k]) - way) * down > 2e-3 * map.info.depth_scale;
                }
            CAPTURE(angle, int(correction), hits, covered, far);
            CHECK(std::abs(hits - covered) <= 0.01 * hits); // the border of the plane, as each rasterises it
            CHECK(far <= 0.005 * hits); // tips of noise that steps of no less than a thirty-second of a texel pass by
        }
    }
}

TEST_CASE("A ball under a level map is a smaller ball, to its rim", "[renderer][mesh]") {
    const RevolvedSurface* sphere = nullptr;
    for (const RevolvedSurface& known : revolved_surfaces())
        if (known.name == "sphere") sphere = &known;
    REQUIRE(sphere);
    const Mesh mesh = bake_quadrics(make_revolved(*sphere, 192), {}, "sphere")->mesh;
    const double radius = mesh.positions[0].length();
    const TexelGrid grid{8, 8, Wrap::repeat, Wrap::repeat, 1};
    const DepthMap depth{grid, BitDepth::unorm16, Image<float>(8, 8, 52428)}; // 0.8
    const ReliefMap map = make_relief_map(depth, bake_cones(depth, {}).ratio, 1, {});
    MeshRenderOptions options;
    options.width = 200, options.height = 150, options.max_steps = 200, options.binary_steps = 12;
    options.camera = make_orbit_camera({0, 0, 0}, radius, {65, 40, 30, 0}, 4.0 / 3);

    for (const double depth_scale : {0.05, 0.2, 0.4}) {
        const double inner = radius * (1 - 0.8 * depth_scale);
        int both = 0, either = 0, far = 0;
        const auto compare = [&](const Mesh& bent) {
            both = either = far = 0;
            const MeshRendering picture = drawn({&bent, {depth_scale * radius, 2, 1}}, map, options);
            for (int y = 0; y < options.height; ++y)
                for (int x = 0; x < options.width; ++x) {
                    const Vec3 sight = sight_at(options.camera, x, y, options);
                    double along = 0, square = 0;
                    for (std::size_t k = 0; k < 3; ++k) along -= options.camera.eye[k] * sight[k], square += options.camera.eye[k] * options.camera.eye[k];
                    const double root = along * along - square + inner * inner;
                    const bool in = root >= 0, on = std::isfinite(picture.distance(x, y));
                    both += in && on, either += in || on;
                    far += in && on && std::fabs(double(picture.distance(x, y)) - (along - std::sqrt(root))) > 0.05 * depth_scale * radius;
                }
        };
        compare(mesh);
        CAPTURE(depth_scale, both, either, far);
        CHECK(both >= 0.99 * either);
        CHECK(far <= 0.01 * both);
        Mesh wrong = mesh; // a with the other sign
        for (Quadric& quadric : wrong.quadrics) quadric.a = -quadric.a;
        compare(wrong);
        CHECK((both < 0.99 * either || far > 0.01 * both));
    }
}

TEST_CASE("Bricks reach the goals with the steps of the papers, and stay in place where the texture narrows", "[renderer][mesh]") {
    const TexelGrid grid{64, 64, Wrap::repeat, Wrap::repeat, 1};
    DepthMap depth{grid, BitDepth::unorm16, Image<float>(grid.width, grid.height)};
    for (int y = 0; y < grid.height; ++y)
        for (int x = 0; x < grid.width; ++x) {
            const int along = (x + y / 16 % 2 * 16) % 32, edge = std::min({along, 31 - along, y % 16, 15 - y % 16});
            depth.level(x, y) = float(std::round(65535 * (1 - 0.95 * std::clamp((edge - 1) / 2.0, 0.0, 1.0))));
        }
    const ReliefMap map = make_relief_map(depth, bake_cones(depth, {}).ratio, 1, {});
    for (const RevolvedSurface& surface : revolved_surfaces()) {
        if (surface.name != "sphere" && surface.name != "torus") continue;
        const Mesh mesh = bake_quadrics(make_revolved(surface, 64), {}, surface.name)->mesh;
        const MeshRelief how{0.1 * surface.radius, 6, 3};
        MeshVerifyOptions views;
        views.width = 400, views.height = 300, views.views = {{90, 20, 30, 0}, {70, 140, 30, 0}};
        const auto judged = [&](Correction correction) {
            const auto report = verify_mesh(mesh, BilinearSurface(depth), how, [&](const View&, const Camera& camera) -> Result<MeshFrame> {
                MeshRenderOptions options;
                options.correction = correction, options.camera = camera;
                options.width = views.width, options.height = views.height;
                MeshRendering frame = drawn({&mesh, how}, map, options);
                return MeshFrame{std::move(frame.distance), std::move(frame.steps), std::move(frame.colour), frame.seconds};
            }, views);
            REQUIRE(report);
            return report->total;
        };
        const MeshComparison bent = judged(Correction::bent), ray = judged(Correction::ray);
        CAPTURE(surface.name, bent.iou(), bent.band_agreement(), bent.depth_mean, ray.iou(), ray.band_agreement(), ray.depth_mean);
        CHECK(bent.iou() >= 0.99);
        CHECK(bent.band_agreement() >= (surface.name == "sphere" ? 0.8 : 0.77)); // a torus changes its curvature on the way
        CHECK(ray.iou() >= 0.98);
        if (surface.name == "sphere") CHECK(bent.depth_mean < 0.75 * ray.depth_mean);
    }
}
