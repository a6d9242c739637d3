// Curved relief against the mesh really displaced, at its extremes, and under changes that must not show.

#include "shaders-reference/renderer/mesh_renderer.h"

#include "bake/cone.h"
#include "cli/bench/revolved.h"
#include "mesh/quadric_bake.h"
#include "shaders-reference/measure/verify_mesh.h"
#include "tests/support/fields.h"
#include "tests/support/slow_cones.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>
#include <limits>

using namespace reliefbake;
using namespace reliefbake::test;

namespace {

const TexelGrid square{32, 32, Wrap::repeat, Wrap::repeat, 1};

/// Hills of 8 texels' width, between depths 0.2 and 0.9.
DepthMap hills() {
    DepthMap map{square, BitDepth::unorm16, Image<float>(square.width, square.height)};
    for (int y = 0; y < square.height; ++y)
        for (int x = 0; x < square.width; ++x)
            map.level(x, y) = float(std::round(65535 * (0.55 + 0.35 * std::sin(x * 0.7853981634) * std::cos(y * 0.7853981634))));
    return map;
}

DepthMap level(double depth) {
    DepthMap map{square, BitDepth::unorm16, Image<float>(square.width, square.height, float(std::round(65535 * depth)))};
    return map;
}

ReliefMap coned(const DepthMap& depth) {
    return make_relief_map(depth, bake_cones(depth, {}).ratio, 1, {});
}

Mesh baked(const Mesh& mesh) {
    const auto bake = bake_quadrics(mesh, {}, "test");
    REQUIRE(bake);
    return bake->mesh;
}

Mesh surface(const std::string& name, int segments) {
    for (const RevolvedSurface& known : revolved_surfaces())
        if (known.name == name) return baked(make_revolved(known, segments));
    FAIL("no such surface");
    return {};
}

MeshRendering rendered(const Mesh& mesh, const ReliefMap& map, const MeshRelief& how, const MeshRenderOptions& options) {
    auto renderer = MeshRenderer::create(RendererBackend::osmesa);
    REQUIRE(renderer);
    REQUIRE(renderer->load(map));
    REQUIRE(renderer->set_objects({{&mesh, how}}));
    auto rendering = renderer->render(options);
    INFO((rendering ? "" : rendering.error().message));
    REQUIRE(rendering);
    return std::move(*rendering);
}

MeshVerifyReport judged(const Mesh& mesh, const DepthMap& depth, const MeshRelief& how, MeshRenderOptions options) {
    const ReliefMap map = coned(depth);
    MeshVerifyOptions views;
    views.width = options.width = 320, views.height = options.height = 240;
    const auto report = verify_mesh(mesh, BilinearSurface(depth), how, [&](const View&, const Camera& camera) -> Result<MeshFrame> {
        options.camera = camera;
        MeshRendering frame = rendered(mesh, map, how, options);
        return MeshFrame{std::move(frame.distance), std::move(frame.steps), std::move(frame.colour), frame.seconds};
    }, views);
    REQUIRE(report);
    return *report;
}

MeshRenderOptions plenty(Correction correction) {
    MeshRenderOptions options;
    options.correction = correction;
    options.max_steps = 200;
    options.binary_steps = 8;
    return options;
}

} // namespace

TEST_CASE("Corrected silhouettes are those of the displaced mesh; without correction nothing is cut away", "[renderer][mesh]") {
    for (const char* name : {"sphere", "cylinder", "torus"}) {
        const Mesh mesh = surface(name, 64);
        for (const bool flat : {true, false}) {
            const DepthMap depth = flat ? level(0.8) : hills();
            const MeshRelief how{0.1, 6, 3};
            for (const Correction correction : {Correction::ray, Correction::cone, Correction::bent, Correction::none}) {
                const MeshVerifyReport report = judged(mesh, depth, how, plenty(correction));
                CAPTURE(name, flat, int(correction), to_json(report).dump());
                WARN(name << " flat " << flat << " correction " << int(correction) << " iou " << report.total.iou() << " band " << report.total.band_agreement() << " holes "
                     << report.total.holes << " wrong " << report.total.wrong_cover << " depth mean " << report.total.depth_mean << " 99 " << report.total.depth_99 << " steps " << report.total.steps_mean << " band " << report.total.band);
                CHECK(report.total.not_finite == 0);
            }
        }
    }
}
