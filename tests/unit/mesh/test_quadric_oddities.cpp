// Meshes that are no clean surfaces: every result is defined and counted.

#include "mesh/quadric_bake.h"

#include "cli/bench/surfaces.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <random>

using namespace reliefbake;
using Imath::V3d;

namespace {

QuadricBake bake(const Mesh& mesh, FrameKind frame = FrameKind::automatic) {
    QuadricOptions options;
    options.frame = frame, options.threads = 1;
    const Result<QuadricBake> made = bake_quadrics(mesh, options, "mesh");
    REQUIRE(made);
    for (std::size_t v = 0; v < made->mesh.positions.size(); ++v) {
        const Quadric& q = made->mesh.quadrics[v];
        const Imath::V3f& n = made->mesh.normals[v];
        const Imath::V4f& t = made->mesh.tangents[v];
        REQUIRE((std::isfinite(q.a) && std::isfinite(q.b) && std::isfinite(q.c)));
        REQUIRE(n.length() == Approx(1).epsilon(1e-3));
        REQUIRE(Imath::V3f(t.x, t.y, t.z).length() == Approx(1).epsilon(1e-3));
        REQUIRE(std::fabs(t.w) == 1);
    }
    return *made;
}

/// A fan around vertex 0, open by one triangle if asked.
Mesh fan(const std::vector<V3d>& around, bool open) {
    Mesh mesh;
    mesh.positions.push_back({0, 0, 0});
    for (const V3d& p : around) mesh.positions.push_back(p);
    const std::uint32_t n = std::uint32_t(around.size());
    for (std::uint32_t k = 0; k + open < n; ++k) mesh.triangles.push_back({0, 1 + k, 1 + (k + 1) % n});
    return mesh;
}

std::vector<V3d> circle(int n, double height, double turn = 0) {
    std::vector<V3d> points;
    for (int k = 0; k < n; ++k) points.push_back({std::cos(2 * M_PI * k / n + turn), std::sin(2 * M_PI * k / n + turn), height});
    return points;
}

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

} // namespace

TEST_CASE("few neighbours: the shortest solution, and it is counted") {
    // Three neighbours on a cap of height 1/8: the symmetric solution has no linear part and no c.
    QuadricBake made = bake(fan(circle(3, -0.125), false), FrameKind::principal);
    REQUIRE(made.counts.low_valence == 4);
    REQUIRE(made.counts.short_rank == 4);
    REQUIRE(made.mesh.quadrics[0].a == Approx(-0.125).epsilon(1e-5));
    REQUIRE(made.mesh.quadrics[0].b == Approx(-0.125).epsilon(1e-5));

    made = bake(fan({{1, 0, 0}, {0, 1, 0}}, true)); // one triangle
    REQUIRE(made.counts.boundary == 3);
    REQUIRE(made.counts.low_valence == 3);
    for (const Quadric& q : made.mesh.quadrics) REQUIRE((q.a == 0 && q.b == 0 && q.c == 0));
}

TEST_CASE("four neighbours on two lines: c cannot be seen and is 0, turned or not") {
    for (const double turn : {0.0, M_PI / 4, 44 * M_PI / 180, 0.3}) {
        Mesh mesh = fan(circle(4, -0.25, turn), false);
        mesh.tangents.assign(5, {1, 0, 0, 1});
        const QuadricBake made = bake(mesh);
        CAPTURE(turn);
        REQUIRE(made.mesh.quadrics[0].a == Approx(-0.25).epsilon(1e-5));
        REQUIRE(made.mesh.quadrics[0].b == Approx(-0.25).epsilon(1e-5));
        REQUIRE(std::fabs(made.mesh.quadrics[0].c) < 1e-6);
        REQUIRE(made.counts.short_rank >= 1);
    }
}

TEST_CASE("neighbours in one line bend along it alone") {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, -0.1}, {2, 0, -0.4}, {-1, 0, -0.1}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    const QuadricBake made = bake(mesh);
    REQUIRE(made.counts.short_rank > 0);
}

TEST_CASE("triangles without area, isolated vertices, non-finite ones, and folded pairs") {
    Mesh mesh = make_surface("sphere", 0, false).mesh;
    const std::size_t good = mesh.positions.size();
    mesh.positions.push_back({5, 5, 5});                                       // isolated
    mesh.positions.push_back({not_a_number, 0, 0});                                     // in a triangle
    mesh.positions.push_back({0, std::numeric_limits<double>::infinity(), 0}); // and alone
    const std::uint32_t bad = std::uint32_t(good) + 1;
    mesh.triangles.push_back({0, 1, bad});
    mesh.triangles.push_back({2, 2, 3});
    mesh.positions.push_back({9, 0, 0}), mesh.positions.push_back({10, 0, 0}), mesh.positions.push_back({11, 0, 0});
    const std::uint32_t line = std::uint32_t(good) + 3;
    mesh.triangles.push_back({line, line + 1, line + 2}); // no area
    const QuadricBake made = bake(mesh), clean = bake(make_surface("sphere", 0, false).mesh);
    REQUIRE(made.counts.isolated == 1);
    REQUIRE(made.counts.non_finite_vertices == 2);
    REQUIRE(made.counts.non_finite_triangles == 1);
    REQUIRE(made.counts.degenerate_triangles == 1);
    REQUIRE(made.counts.zero_area_triangles == 1);
    REQUIRE(made.counts.no_normal == 3);
    for (std::size_t v = 0; v < good; ++v) REQUIRE(made.mesh.quadrics[v].a == Approx(clean.mesh.quadrics[v].a).epsilon(1e-6));
    for (std::size_t v = good; v < made.mesh.quadrics.size(); ++v) REQUIRE(made.mesh.quadrics[v].a == 0);

    // Two coincident sheets that face away from each other have no normal in common.
    Mesh folded;
    folded.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    folded.triangles = {{0, 1, 2}, {3, 5, 4}};
    REQUIRE(bake(folded).counts.no_normal == 3);
}

TEST_CASE("edges with three triangles, and sheets that turn around, are counted") {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
    REQUIRE(bake(mesh).counts.non_manifold == 2);
    mesh.triangles = {{0, 1, 2}, {0, 1, 4}}; // the same way along one edge
    REQUIRE(bake(mesh).counts.non_manifold == 2);
}

TEST_CASE("boundaries are as right as the middle") {
    SurfaceMesh s = make_surface("saddle", 2, false);
    set_turned_tangents(s, 0);
    const QuadricBake made = bake(s.mesh);
    REQUIRE(made.counts.boundary == 4 * 64);
    double worst = 0;
    for (std::size_t v = 0; v < made.mesh.quadrics.size(); ++v) {
        const V3d n = s.surface.gradient(s.mesh.positions[v]).normalized();
        const Imath::V4f& t = s.mesh.tangents[v];
        const V3d x(t.x, t.y, t.z);
        const ExactQuadric e = exact_quadric(s.surface, s.mesh.positions[v], x, n.cross(x));
        worst = std::max({worst, std::fabs(made.mesh.quadrics[v].a - e.a), std::fabs(made.mesh.quadrics[v].b - e.b)});
    }
    REQUIRE(worst < 0.04);
}

TEST_CASE("a fan of 200 000 triangles takes no time of its square") {
    Mesh mesh = fan(circle(200'000, -0.1), false);
    mesh.uvs.resize(mesh.positions.size());
    std::mt19937 random(5);
    for (Imath::V2f& t : mesh.uvs) t = {float(random() % 1000), float(random() % 1000)};
    REQUIRE(bake(mesh).counts.triangles == 200'000);
    REQUIRE(bake(mesh, FrameKind::principal).mesh.quadrics[0].a == Approx(-0.1).epsilon(1e-3));
}

TEST_CASE("units from 1e-30 to 1e30, and a mesh of points all alike") {
    for (const double unit : {1e-30, 1e-6, 1e6, 1e30}) {
        Mesh mesh = make_surface("sphere", 0, false).mesh;
        for (V3d& p : mesh.positions) p *= unit;
        REQUIRE(bake(mesh).mesh.quadrics[0].a * unit == Approx(-0.5).epsilon(0.02));
    }
    Mesh tiny = make_surface("sphere", 0, false).mesh;
    for (V3d& p : tiny.positions) p *= 1e-45; // 1/(2R) is beyond a float
    REQUIRE(bake(tiny).counts.out_of_range == tiny.positions.size());
    for (V3d& p : tiny.positions) p = V3d(1, 2, 3);
    REQUIRE(bake(tiny).counts.degenerate_triangles == tiny.triangles.size());
}

TEST_CASE("what a frame needs and the mesh lacks is refused") {
    const Mesh mesh = make_surface("sphere", 0, false).mesh;
    QuadricOptions options;
    options.frame = FrameKind::uv;
    REQUIRE(bake_quadrics(mesh, options, "m.obj").error().code == ErrorCode::usage);
    options.frame = FrameKind::mesh;
    REQUIRE(bake_quadrics(mesh, options, "m.obj").error().message.starts_with("m.obj: --frame mesh: "));
}

TEST_CASE("texture coordinates that give no direction leave the principal one, counted") {
    Mesh mesh = make_surface("torus", 0, false).mesh;
    mesh.uvs.assign(mesh.positions.size(), {0.5f, 0.5f});
    const QuadricBake made = bake(mesh);
    REQUIRE(made.frame == FrameKind::uv);
    REQUIRE(made.counts.made_tangents == mesh.positions.size());
    mesh.uvs.assign(mesh.positions.size(), {float(not_a_number), 0.5f});
    REQUIRE(bake(mesh).counts.made_tangents == mesh.positions.size());
}
