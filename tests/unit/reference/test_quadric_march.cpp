#include "shaders-reference/oracle/quadric_march.h"

#include "cli/bench/revolved.h"
#include "mesh/quadric_bake.h"
#include "shaders-reference/measure/verify_mesh.h"
#include "tests/support/fields.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace reliefbake;
using namespace reliefbake::test;

namespace {

const TexelGrid repeated{32, 32, Wrap::repeat, Wrap::repeat, 1};
constexpr int width = 240, height = 180;

Mesh baked(const char* name, int segments) {
    for (const RevolvedSurface& s : revolved_surfaces())
        if (s.name == name) {
            const Result<QuadricBake> bake = bake_quadrics(make_revolved(s, segments), {}, name);
            REQUIRE(bake);
            return bake->mesh;
        }
    std::abort();
}

MeshComparison judge(const Mesh& mesh, const BilinearSurface& relief, const MeshRelief& how, QuadricMarchOptions march, std::vector<View> views = {{90, 20, 30, 0}}) {
    march.width = width, march.height = height;
    MeshVerifyOptions options;
    options.width = width, options.height = height;
    options.views = std::move(views);
    const Result<MeshVerifyReport> report = verify_mesh(mesh, relief, how, marching_shader(mesh, relief, how, march), options);
    REQUIRE(report);
    return report->total;
}

QuadricMarchOptions with(BendModel model, bool ends_v = false) {
    QuadricMarchOptions options;
    options.model = model;
    options.ends_v = ends_v;
    return options;
}

double covered(const Image<float>& plane) { return double(std::count_if(plane.begin(), plane.end(), [](float d) { return std::isfinite(d); })); }

} // namespace

TEST_CASE("a sphere sunk by a constant depth: the circle is exact, the quadric as far off as its formula says", "[oracle][march]") {
    const DepthMap floor = depth_of(repeated, [](int, int) { return 0.0; });
    const BilinearSurface relief(floor);
    const Mesh mesh = baked("sphere", 128);
    const Camera camera = make_orbit_camera({0, 0, 0}, 1.1, {90, 20, 30, 0}, double(width) / height);
    double eye = 0;
    for (const double x : camera.eye) eye += x * x;
    // The silhouette of a ball of radius r covers this much more than one of radius 1.
    const auto area = [&](double r) { return r * r / (eye - r * r) * (eye - 1); };
    QuadricMarchOptions options;
    options.width = width, options.height = height;
    for (const double depth : {0.05, 0.1, 0.3}) {
        const MeshRelief how{depth, 4, 2};
        const auto share = [&](BendModel model) {
            options.model = model;
            return covered(march_quadrics(mesh, relief, how, camera, options).distance);
        };
        options.model = BendModel::ab;
        const double ball = covered(march_quadrics(mesh, BilinearSurface(depth_of(repeated, [](int, int) { return 1.0; })), how, camera, options).distance);
        CHECK(share(BendModel::circle) / ball == Approx(area(1 - depth)).epsilon(0.01));
        // A ray at incidence i is deepest at (cos i)^2 / (2 (sin i)^2) radii, and sin i is its distance from the middle.
        CHECK(share(BendModel::ab) / ball == Approx(area(std::sqrt(1 / (1 + 2 * depth)))).epsilon(0.01));
        CHECK(share(BendModel::abc) / ball == Approx(share(BendModel::ab) / ball).margin(0.002));
    }
}

TEST_CASE("on a cylinder seen level the quadric cuts the silhouette, and no correction none of it", "[oracle][march]") {
    const DepthMap waves = depth_of(repeated, [](int i, int j) { return 0.5 + 0.25 * (std::sin(i * 0.3926991) + std::sin(j * 0.3926991)); });
    const BilinearSurface relief(waves);
    const Mesh mesh = baked("cylinder", 128);
    const MeshRelief how{0.1, 6, 2};
    const MeshComparison flat = judge(mesh, relief, how, with(BendModel::flat)), bent = judge(mesh, relief, how, with(BendModel::abc, true)),
                         circle = judge(mesh, relief, how, with(BendModel::circle, true)), endless = judge(mesh, relief, how, with(BendModel::abc));
    CHECK(flat.band_agreement() < 0.02);
    CHECK(flat.iou() < 0.97);
    CHECK(bent.band_agreement() > 0.9);
    CHECK(bent.iou() > 0.99);
    CHECK(circle.iou() > 0.995);
    CHECK(circle.depth_mean < bent.depth_mean);
    CHECK(endless.wrong_cover > 2 * bent.wrong_cover); // rays that should fall off the ends
    // Outward curvature taken for inward: caught.
    Mesh hollow = mesh;
    for (Quadric& q : hollow.quadrics) q.a = -q.a, q.b = -q.b, q.c = -q.c;
    CHECK(judge(hollow, relief, how, with(BendModel::abc, true)).band_agreement() < 0.3);
}

TEST_CASE("frames turned against the curvature need c", "[oracle][march]") {
    const DepthMap waves = depth_of(repeated, [](int i, int j) { return 0.5 + 0.25 * (std::sin(i * 0.3926991) + std::sin(j * 0.3926991)); });
    const BilinearSurface relief(waves);
    Mesh mesh = baked("cylinder", 128);
    const MeshComparison straight = judge(mesh, relief, {0.1, 6, 2}, with(BendModel::abc, true));
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) { // by 45 degrees, and the quadric with it
        const Imath::V3f n = mesh.normals[v], x(mesh.tangents[v].x, mesh.tangents[v].y, mesh.tangents[v].z);
        const Imath::V3f t = (x + n.cross(x) * mesh.tangents[v].w).normalized();
        mesh.tangents[v] = {t.x, t.y, t.z, mesh.tangents[v].w};
        const Quadric q = mesh.quadrics[v];
        mesh.quadrics[v] = {(q.a + q.b + q.c) / 2, (q.a + q.b - q.c) / 2, q.b - q.a};
    }
    const MeshComparison turned = judge(mesh, relief, {0.1, 6, 2}, with(BendModel::abc, true)), without = judge(mesh, relief, {0.1, 6, 2}, with(BendModel::ab, true));
    CHECK(turned.iou() == Approx(straight.iou()).margin(1e-3));
    CHECK(turned.band_agreement() == Approx(straight.band_agreement()).margin(0.01));
    CHECK(without.band_agreement() < straight.band_agreement() - 0.1);
}

TEST_CASE("the march is the same for any number of threads, and at odd curvatures finite", "[oracle][march]") {
    const DepthMap rough = noise(repeated, 4);
    const BilinearSurface relief(rough);
    Mesh mesh = baked("torus", 32);
    const Camera camera = make_orbit_camera({0, 0, 0}, 1.4, {60, 20, 30, 0}, double(width) / height);
    QuadricMarchOptions one, two;
    one.width = two.width = width, one.height = two.height = height;
    one.threads = 1, two.threads = 2;
    for (const float scale : {1.0f, 0.0f, -1e6f, 1e6f}) {
        for (Quadric& q : mesh.quadrics) q.a *= scale, q.b *= scale, q.c *= scale;
        for (const BendModel model : {BendModel::flat, BendModel::ab, BendModel::abc, BendModel::circle}) {
            one.model = two.model = model;
            const QuadricMarch a = march_quadrics(mesh, relief, {0.1, 3, 1}, camera, one), b = march_quadrics(mesh, relief, {0.1, 3, 1}, camera, two);
            CHECK(a.distance == b.distance);
            CHECK(std::none_of(a.distance.begin(), a.distance.end(), [](float d) { return std::isnan(d); }));
            CHECK(std::none_of(a.normal.begin(), a.normal.end(), [](const Imath::V3f& n) { return std::isnan(n.x + n.y + n.z); }));
        }
    }
}
