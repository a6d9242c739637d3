// Curved relief against the mesh really displaced, at its extremes, and under changes that must not show.

#include "shaders-reference/renderer/mesh_renderer.h"

#include "bake/cone.h"
#include "cli/bench/revolved.h"
#include "mesh/quadric_bake.h"
#include "shaders-reference/measure/shape_relief.h"
#include "shaders-reference/measure/verify_mesh.h"
#include "tests/support/fields.h"
#include "tests/support/shapes.h"
#include "tests/support/slow_cones.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>
#include <limits>
#include <tuple>

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

template <class Map>
MeshRendering rendered(const MeshObject& object, const Map& map, const MeshRenderOptions& options) {
    auto renderer = MeshRenderer::create(RendererBackend::osmesa);
    REQUIRE(renderer);
    REQUIRE(renderer->load(map));
    REQUIRE(renderer->set_objects({object}));
    auto rendering = renderer->render(options);
    INFO((rendering ? "" : rendering.error().message));
    REQUIRE(rendering);
    return std::move(*rendering);
}

/// `open`: the mesh ends at v = 0 and v = 1.
template <class Map>
MeshVerifyReport judged_map(const Mesh& mesh, const Map& map, const DepthMap& depth, const MeshRelief& how, MeshRenderOptions options, bool open) {
    MeshVerifyOptions views;
    views.width = options.width = 320, views.height = options.height = 240;
    views.views = {{90, 20, 30, 0}, {90, 140, 30, 0}}; // across open ends, of which no polygon lets a ray in
    const auto report = verify_mesh(mesh, BilinearSurface(depth), how, [&](const View&, const Camera& camera) -> Result<MeshFrame> {
        options.camera = camera;
        MeshRendering frame = rendered({&mesh, how, false, open}, map, options);
        return MeshFrame{std::move(frame.distance), std::move(frame.steps), std::move(frame.colour), frame.seconds};
    }, views);
    REQUIRE(report);
    return *report;
}

MeshVerifyReport judged(const Mesh& mesh, const DepthMap& depth, const MeshRelief& how, const MeshRenderOptions& options, bool open = false) {
    return judged_map(mesh, coned(depth), depth, how, options, open);
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
    struct Goal { const char* name; double depth_scale, ray, bent, band; }; // least intersections over unions, and share of the band
    for (const auto& [name, depth_scale, ray, bent, band] :
         {Goal{"sphere", 0.1, 0.98, 0.985, 0.85}, {"cylinder", 0.1, 0.98, 0.995, 0.85}, {"torus", 0.03, 0.985, 0.985, 0.85}}) {
        const Mesh mesh = surface(name, 64);
        for (const bool flat : {true, false}) {
            const DepthMap depth = flat ? level(0.8) : hills();
            const MeshRelief how{depth_scale, 6, 3};
            const bool open = std::string(name) == "cylinder";
            for (const Correction correction : {Correction::ray, Correction::cone, Correction::bent}) {
                CAPTURE(name, flat, int(correction));
                const MeshComparison total = judged(mesh, depth, how, plenty(correction), open).total;
                CHECK(total.not_finite == 0);
                CHECK(total.iou() >= (correction == Correction::bent ? bent : ray));
                CHECK(total.band_agreement() >= band);
            }
            CHECK(judged(mesh, depth, how, plenty(Correction::none)).total.band_agreement() < 0.05);
        }
    }
}

TEST_CASE("A sphere that a level map makes smaller is smaller by that much", "[renderer][mesh]") {
    const Mesh mesh = surface("sphere", 128);
    const MeshComparison total = judged(mesh, level(0.8), {0.1, 6, 3}, plenty(Correction::bent)).total;
    CHECK(total.iou() > 0.998);
    CHECK(total.depth_99 < 0.05);

    SECTION("the sign of the quadric matters") {
        Mesh hollow = mesh;
        for (Quadric& quadric : hollow.quadrics) quadric = {-quadric.a, -quadric.b, -quadric.c};
        CHECK(judged(hollow, level(0.8), {0.1, 6, 3}, plenty(Correction::bent)).total.band_agreement() < 0.05);
    }
    SECTION("its size matters") {
        Mesh bent_more = mesh;
        for (Quadric& quadric : bent_more.quadrics) quadric = {2 * quadric.a, 2 * quadric.b, 2 * quadric.c};
        CHECK(judged(bent_more, level(0.8), {0.1, 6, 3}, plenty(Correction::bent)).total.iou() < 0.97);
    }
}

TEST_CASE("c matters where frames are turned", "[renderer][mesh]") {
    Mesh mesh = surface("cylinder", 64);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) { // tangents by 45 degrees: a = b, and all of the difference in c
        const Imath::V3f n = mesh.normals[v], t(mesh.tangents[v].x, mesh.tangents[v].y, mesh.tangents[v].z);
        const Imath::V3f b = n.cross(t) * mesh.tangents[v].w, turned = (t + b).normalized();
        mesh.tangents[v] = {turned.x, turned.y, turned.z, mesh.tangents[v].w};
        const Quadric q = mesh.quadrics[v];
        mesh.quadrics[v] = {0.5f * (q.a + q.b), 0.5f * (q.a + q.b), q.b - q.a};
    }
    const MeshRelief how{0.1, 6, 3};
    MeshRenderOptions options = plenty(Correction::bent);
    const double with = judged(mesh, level(0.8), how, options, true).total.iou();
    CHECK(with > 0.995);
    options.twist = false;
    CHECK(judged(mesh, level(0.8), how, options, true).total.iou() < with - 0.01);
}

TEST_CASE("Extrusions of a shape end where the same relief does", "[renderer][mesh]") {
    const TexelGrid fine{128, 128, Wrap::repeat, Wrap::repeat, 1};
    struct Case { const char* name; std::function<bool(int, int)> inside; double iou, band; };
    const Case cases[] = {{"full", [](int, int) { return true; }, 0.999, 0},
                          {"empty", [](int, int) { return false; }, 0.99, 0.95},
                          {"dots", [](int x, int y) { return std::hypot(x % 64 - 31.5, y % 64 - 31.5) < 20; }, 0.985, 0.85},
                          {"bars", [](int x, int) { return x % 32 < 12; }, 0.985, 0.85}};
    const Mesh mesh = surface("cylinder", 64);
    for (const auto& [name, inside, iou, band] : cases) {
        const auto& in = inside;
        DepthMap depth{fine, BitDepth::unorm16, Image<float>(fine.width, fine.height)};
        for (int y = 0; y < fine.height; ++y)
            for (int x = 0; x < fine.width; ++x) depth.level(x, y) = in(x, y) ? 0.0f : 65535.0f;
        ShapeMapOptions bake;
        bake.bits = BitDepth::unorm16;
        const ShapeMap shape = shape_map_of(fine, shape_of(fine, in), bake);
        for (const Correction correction : {Correction::ray, Correction::bent}) {
            CAPTURE(name, int(correction));
            const MeshComparison total = judged_map(mesh, shape, depth, {0.1, 6, 2}, plenty(correction), true).total;
            CHECK(total.not_finite == 0);
            CHECK(total.iou() >= iou - (correction == Correction::ray ? 0.012 : 0));
            CHECK(total.band_agreement() >= band - (correction == Correction::ray ? 0.1 : 0));
        }
    }
}

TEST_CASE("Bevels and chamfers widen an extrusion towards its floor, over a curved mesh too", "[renderer][mesh]") {
    const TexelGrid fine{64, 64, Wrap::repeat, Wrap::repeat, 1};
    const ShapeMap shape = shape_map_of(fine, shape_of(fine, [](int x, int y) { return std::hypot(x - 31.5, y - 31.5) < 14; }));
    const Mesh mesh = surface("sphere", 48);
    const Ball ball = ball_around(mesh);
    MeshRenderOptions options = plenty(Correction::bent);
    options.width = 160, options.height = 120;
    options.camera = make_orbit_camera(ball.middle, ball.radius, {70, 30, 30, 0}, 4.0 / 3);
    const auto mean_distance = [&](double e, double b, double c) {
        options.solid.outward = e, options.solid.bevel = b, options.solid.chamfer = c;
        const MeshRendering rendering = rendered({&mesh, {0.1, 6, 3}}, shape, options);
        double sum = 0, count = 0;
        for (const float d : rendering.distance)
            if (std::isfinite(d)) sum += double(d), ++count;
        return sum / count;
    };
    const double none = std::numeric_limits<double>::infinity();
    const double basic = mean_distance(0, 0, none), outward = mean_distance(0.1, 0, none), bevelled = mean_distance(0, 0.15, none),
                 chamfered = mean_distance(0, 0.15, 0.5);
    CHECK(outward < basic - 1e-3);
    CHECK(bevelled < chamfered - 1e-4);
    CHECK(chamfered < basic - 1e-4);
}

TEST_CASE("Two objects hide each other by their relief", "[renderer][mesh]") {
    const Mesh sphere = surface("sphere", 48);
    Mesh other = sphere;
    for (Imath::V3d& p : other.positions) p.x += 0.9;
    const ReliefMap map = coned(hills());
    MeshRenderOptions options = plenty(Correction::bent);
    options.width = 160, options.height = 120;
    options.camera = make_orbit_camera({0.45, 0, 0}, 1.5, {80, 20, 30, 0}, 4.0 / 3);
    const MeshObject a{&sphere, {0.1, 6, 3}}, b{&other, {0.1, 4, 2}};
    const auto draw = [&](const std::vector<MeshObject>& objects) {
        auto renderer = MeshRenderer::create(RendererBackend::osmesa);
        REQUIRE(renderer);
        REQUIRE(renderer->load(map));
        REQUIRE(renderer->set_objects(objects));
        return *renderer->render(options);
    };
    const MeshRendering first = draw({a}), second = draw({b}), both = draw({a, b}), turned = draw({b, a});
    int of_first = 0, of_second = 0;
    for (std::size_t k = 0; k < both.distance.size(); ++k) {
        REQUIRE(both.distance[k] == Approx(std::min(first.distance[k], second.distance[k])).epsilon(1e-4));
        of_first += first.distance[k] < second.distance[k], of_second += second.distance[k] < first.distance[k];
    }
    CHECK(of_first > 500);
    CHECK(of_second > 500);
    int differ = 0; // where both are as near, to the depth buffer
    for (std::size_t k = 0; k < both.distance.size(); ++k) differ += both.distance[k] != turned.distance[k];
    CHECK(differ < 10);
}

TEST_CASE("The picture does not depend on the unit of length", "[renderer][mesh]") {
    const Mesh mesh = surface("torus", 48);
    const ReliefMap map = coned(hills());
    MeshRenderOptions options = plenty(Correction::bent);
    options.width = 160, options.height = 120;
    for (const Correction correction : {Correction::ray, Correction::cone, Correction::bent})
        for (const double scale : {0x1p-20, 0x1p20}) {
            options.correction = correction;
            const Ball ball = ball_around(mesh);
            options.camera = make_orbit_camera(ball.middle, ball.radius, {70, 30, 30, 0}, 4.0 / 3);
            const MeshRendering plain = rendered({&mesh, {0.05, 6, 3}}, map, options);
            Mesh scaled = mesh;
            for (Imath::V3d& p : scaled.positions) p *= scale;
            scaled.quadrics.clear();
            scaled = baked(scaled);
            options.camera = make_orbit_camera({ball.middle[0] * scale, ball.middle[1] * scale, ball.middle[2] * scale}, ball.radius * scale, {70, 30, 30, 0}, 4.0 / 3);
            const MeshRendering other = rendered({&scaled, {0.05 * scale, 6, 3}}, map, options);
            CAPTURE(int(correction), scale);
            CHECK(other.colour.rgb == plain.colour.rgb);
        }
}

TEST_CASE("What the papers print draws another picture in another unit", "[renderer][mesh]") {
    const Mesh mesh = surface("sphere", 48);
    const MeshVerifyReport bent = judged(mesh, hills(), {0.1, 6, 3}, plenty(Correction::bent));
    for (const Correction correction : {Correction::ray_published, Correction::cone_published}) {
        double least = 1, most = 0;
        for (const double scale : {0.1, 1.0, 10.0}) {
            Mesh scaled = mesh;
            for (Imath::V3d& p : scaled.positions) p *= scale;
            scaled.quadrics.clear();
            const MeshComparison total = judged(baked(scaled), hills(), {0.1 * scale, 6, 3}, plenty(correction)).total;
            CHECK(total.not_finite == 0);
            least = std::min(least, total.cut_iou()), most = std::max(most, total.cut_iou());
        }
        CAPTURE(int(correction), least, most);
        CHECK(least < 0.5 * bent.total.cut_iou());
        CHECK(most > least + 0.05);
        CHECK(most < bent.total.cut_iou());
    }
}

TEST_CASE("Every kind of extrusion over a sphere is the relief that it is", "[renderer][mesh]") {
    const TexelGrid fine{64, 64, Wrap::repeat, Wrap::repeat, 1};
    ShapeMapOptions bake;
    bake.bits = BitDepth::float32;
    const ShapeMap shape = shape_map_of(fine, shape_of(fine, [](int x, int y) { return std::hypot(x - 31.5, y - 31.5) < 14; }), bake);
    const Mesh mesh = surface("sphere", 64);
    const double none = std::numeric_limits<double>::infinity();
    for (const auto& [e, b, c] : {std::tuple(0.0, 0.0, none), {0.1, 0.0, none}, {0.0, 0.15, none}, {0.03, 0.15, 0.5}})
        for (const Correction correction : {Correction::ray, Correction::bent, Correction::ray_published}) {
            MeshRenderOptions options = plenty(correction);
            options.solid.outward = e, options.solid.bevel = b, options.solid.chamfer = c;
            const MeshComparison total = judged_map(mesh, shape, shape_relief(shape, options.solid), {0.1, 6, 3}, options, false).total;
            CAPTURE(e, b, c, int(correction), total.iou(), total.band_agreement(), total.depth_mean);
            CHECK(total.not_finite == 0);
            if (correction == Correction::ray_published) continue;
            CHECK(total.iou() >= (correction == Correction::bent ? 0.98 : 0.965));
            CHECK(total.band_agreement() >= (correction == Correction::bent ? 0.75 : 0.7));
            ShapeSolid other = options.solid;
            other.outward += 0.15;
            CHECK(judged_map(mesh, shape, shape_relief(shape, other), {0.1, 6, 3}, options, false).total.depth_mean > total.depth_mean);
        }
}

TEST_CASE("No pixel is NaN at the extremes", "[renderer][mesh]") {
    const ReliefMap map = coned(hills());
    const std::pair<const char*, std::function<void(Mesh&)>> extremes[] = {
        {"flat vertices", [](Mesh& m) { for (Quadric& q : m.quadrics) q = {}; }},
        {"saddles", [](Mesh& m) { for (Quadric& q : m.quadrics) q = {3, -3, 0}; }},
        {"saddles by c", [](Mesh& m) { for (Quadric& q : m.quadrics) q = {0, 0, 5}; }},
        {"enormous curvature", [](Mesh& m) { for (Quadric& q : m.quadrics) q = {-1e30f, 1e30f, 1e30f}; }},
        {"denormal curvature", [](Mesh& m) { for (Quadric& q : m.quadrics) q = {1e-40f, -1e-42f, 1e-44f}; }},
        {"curvature that is not finite", [](Mesh& m) { for (Quadric& q : m.quadrics) q.a = std::numeric_limits<float>::quiet_NaN(); }},
        {"mirrored texture", [](Mesh& m) { for (Imath::V2f& uv : m.uvs) uv.x = -uv.x; }},
        {"texture of one point", [](Mesh& m) { for (Imath::V2f& uv : m.uvs) uv = Imath::V2f(0.3f); }},
        {"texture of one line", [](Mesh& m) { for (Imath::V2f& uv : m.uvs) uv.y = 0.3f; }},
        {"texture that is not finite", [](Mesh& m) { for (Imath::V2f& uv : m.uvs) uv.x = std::numeric_limits<float>::infinity(); }},
        {"normals of length 0", [](Mesh& m) { for (Imath::V3f& n : m.normals) n = Imath::V3f(0); }},
        {"normals across the view", [](Mesh& m) { for (Imath::V3f& n : m.normals) n = Imath::V3f(n.y, -n.x, 0); }},
        {"normals inside out", [](Mesh& m) { for (Imath::V3f& n : m.normals) n = -n; }},
        {"tangents of length 0", [](Mesh& m) { for (Imath::V4f& t : m.tangents) t = Imath::V4f(0); }},
        {"tangents along normals", [](Mesh& m) { for (std::size_t v = 0; v < m.normals.size(); ++v) m.tangents[v] = Imath::V4f(m.normals[v].x, m.normals[v].y, m.normals[v].z, 1); }},
    };
    const Mesh sphere = surface("sphere", 24);
    const Ball ball = ball_around(sphere);
    for (const auto& [name, spoil] : extremes)
        for (const double depth_scale : {1e-6, 0.1, 10.0, 1e6})
            for (const Correction correction : {Correction::none, Correction::ray, Correction::cone, Correction::bent})
                for (const Technique technique : {Technique::relaxed, Technique::binary}) {
                    if (correction == Correction::cone && technique == Technique::binary) continue;
                    CAPTURE(name, depth_scale, int(correction), int(technique));
                    Mesh mesh = sphere;
                    spoil(mesh);
                    MeshRenderOptions options;
                    options.width = 64, options.height = 48;
                    options.correction = correction;
                    options.technique = technique;
                    options.camera = make_orbit_camera(ball.middle, ball.radius, {80, 10, 30, 0}, 4.0 / 3);
                    const MeshRendering rendering = rendered({&mesh, {depth_scale, 3, 2}}, map, options);
                    int wrong = 0;
                    for (const float d : rendering.distance) wrong += std::isnan(d) || d < 0;
                    CHECK(wrong == 0);
                }
}

TEST_CASE("What meshes and maps do not serve is refused", "[renderer][mesh]") {
    auto renderer = MeshRenderer::create(RendererBackend::osmesa);
    REQUIRE(renderer);
    Mesh mesh = surface("sphere", 12);
    mesh.quadrics.clear();
    REQUIRE(renderer->load(coned(hills())));
    REQUIRE(renderer->set_objects({{&mesh, {0.1, 1, 1}}}));
    MeshRenderOptions options;
    options.width = options.height = 16;
    options.camera = make_orbit_camera({0, 0, 0}, 1, {}, 1);
    CHECK(renderer->render(options).error().message.find("quadrics") != std::string::npos);
    options.correction = Correction::none;
    CHECK(renderer->render(options));
    options.technique = Technique::pom;
    CHECK_FALSE(renderer->render(options));
    mesh.uvs.clear();
    CHECK_FALSE(renderer->set_objects({{&mesh, {0.1, 1, 1}}}));
}
