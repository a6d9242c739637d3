#include "shaders-reference/measure/verify_mesh.h"

#include "cli/bench/revolved.h"
#include "tests/support/fields.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace reliefbake;
using namespace reliefbake::test;

namespace {

MeshVerifyOptions small_views() {
    MeshVerifyOptions options;
    options.width = 160;
    options.height = 120;
    options.pictures = true;
    return options;
}

/// A shader that draws triangles: stands for one that is right, or wrong in a known way.
MeshShader shader_of(const TriangleSource& triangles, const MeshVerifyOptions& options) {
    return [&triangles, options](const View&, const Camera& camera) -> Result<MeshFrame> {
        Result<PlainMeshRenderer> renderer = PlainMeshRenderer::create(options.backend);
        PlainMeshOptions frame;
        frame.camera = camera;
        frame.width = options.width;
        frame.height = options.height;
        Result<PlainMeshRendering> drawn = renderer->render(frame, triangles);
        if (!drawn) return tl::unexpected<Error>(drawn.error());
        return MeshFrame{std::move(drawn->distance), Image<float>(options.width, options.height, 7), std::move(drawn->colour), 0.001};
    };
}

const TexelGrid repeated{32, 16, Wrap::repeat, Wrap::repeat, 1};
const RevolvedSurface& torus = revolved_surfaces()[1];

} // namespace

TEST_CASE("the displaced mesh itself is judged right, the bare mesh and an outward one wrong", "[measure][mesh]") {
    const Mesh mesh = make_revolved(torus, 64);
    const DepthMap map = noise(repeated, 3);
    const BilinearSurface relief(map);
    const MeshRelief how{0.1, 5, 2}, outward{-0.1, 5, 2};
    const MeshVerifyOptions options = small_views();
    const TriangleSource truth = displaced_triangles(mesh, relief, how), bare = plain_triangles(mesh), raised = displaced_triangles(mesh, relief, outward);

    const auto right = verify_mesh(mesh, relief, how, shader_of(truth, options), options);
    REQUIRE(right);
    CHECK(right->total.iou() == 1);
    CHECK(right->total.band_agreement() == 1);
    CHECK(right->total.cut_iou() == 1);
    CHECK(right->total.depth_max == 0);
    CHECK(right->total.steps_mean == 7);
    CHECK(right->views.size() == 3);
    CHECK(right->total.band > 500);

    const auto uncorrected = verify_mesh(mesh, relief, how, shader_of(bare, options), options);
    REQUIRE(uncorrected);
    CHECK(uncorrected->total.iou() < 0.97);
    CHECK(uncorrected->total.band_agreement() < 0.01);
    CHECK(uncorrected->total.cut_iou() < 0.01);
    CHECK(uncorrected->total.depth_mean > 0.3);

    const auto wrong = verify_mesh(mesh, relief, how, shader_of(raised, options), options);
    REQUIRE(wrong);
    CHECK(wrong->total.iou() < uncorrected->total.iou());
    CHECK(wrong->total.cut_iou() < 0.01);

    const nlohmann::json json = to_json(*uncorrected);
    CHECK(json["wrong_cover"].get<std::uint64_t>() == uncorrected->total.wrong_cover);
    CHECK(json["views"].size() == 3);
    CHECK(right->views[0].pictures->difference.rgb.size() == 160 * 120 * 3);
}

TEST_CASE("a mesh without texture coordinates is refused", "[measure][mesh]") {
    Mesh mesh = make_revolved(torus, 8);
    mesh.uvs.clear();
    const DepthMap map = noise(repeated, 3);
    const BilinearSurface relief(map);
    const auto refused = verify_mesh(mesh, relief, {}, [](const View&, const Camera&) -> Result<MeshFrame> { return MeshFrame{}; });
    REQUIRE_FALSE(refused);
    CHECK(refused.error().code == ErrorCode::usage);
}

TEST_CASE("the ball holds the mesh, whatever is not finite", "[measure][mesh]") {
    Mesh mesh = make_revolved(torus, 32);
    mesh.positions[3].x = NAN;
    const Ball ball = ball_around(mesh);
    CHECK(ball.radius == Approx(1.4).margin(0.03));
    CHECK(std::fabs(ball.middle[0]) < 0.03);
    CHECK(ball_around(Mesh{{{1, 2, 3}}, {}, {}, {}, {}, {}}).radius == 1);
}
