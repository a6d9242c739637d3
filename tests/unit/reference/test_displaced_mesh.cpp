#include "shaders-reference/oracle/displaced_mesh.h"

#include "cli/bench/revolved.h"
#include "mesh/weld.h"
#include "tests/support/fields.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstring>
#include <map>

using namespace reliefbake;
using namespace reliefbake::test;
using Imath::V3d;

namespace {

const TexelGrid repeated{32, 16, Wrap::repeat, Wrap::repeat, 1};

double three_quarters(int, int) { return 0.75; }
double bumps(int i, int j) { return 1 - double(std::uint32_t(i * 7919 + j * 104729) % 97) / 97; }

const RevolvedSurface& surface(const char* name) {
    for (const RevolvedSurface& s : revolved_surfaces())
        if (s.name == name) return s;
    std::abort();
}

std::vector<DisplacedVertex> displaced(const Mesh& mesh, const DepthMap& map, const MeshRelief& how, DisplaceOptions options = {}) {
    std::vector<DisplacedVertex> all;
    const BilinearSurface relief(map);
    const auto made = displace(mesh, relief, how, options, [&](std::span<const DisplacedVertex> batch) {
        CHECK(batch.size() <= 3 * options.batch);
        all.insert(all.end(), batch.begin(), batch.end());
    });
    REQUIRE(made);
    CHECK(*made * 3 == all.size());
    return all;
}

double distance_to_axis(const Imath::V3f& p) { return std::hypot(double(p.x), double(p.y)); }

/// Undirected edges, by the places they join, and how many triangles use each; triangles without area have none.
std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges_of(const std::vector<DisplacedVertex>& triangles) {
    std::vector<V3d> positions;
    for (const DisplacedVertex& v : triangles) positions.push_back(V3d(v.position));
    const Weld weld = weld_positions(positions, 1);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (std::size_t t = 0; t < triangles.size(); t += 3)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = weld.position_of[t + k], b = weld.position_of[t + (k + 1) % 3];
            ++edges[std::minmax(a, b)];
        }
    return edges;
}

} // namespace

TEST_CASE("a constant depth makes a smaller sphere, cylinder and torus", "[oracle][displaced]") {
    const DepthMap map = depth_of(repeated, three_quarters);
    const double sink = 0.25 * 0.2, flat = 1 - std::cos(3.14159265 / 64); // inward; what 64 segments lie below the round
    const MeshRelief how{0.2, 4, 2};
    for (const DisplacedVertex& v : displaced(make_revolved(surface("sphere"), 64), map, how)) {
        CHECK(V3d(v.position).length() <= 1 - sink + 1e-6);
        CHECK(V3d(v.position).length() >= 1 - sink - 2.1 * flat);
        CHECK(V3d(v.normal).dot(V3d(v.position).normalized()) > 0.998);
    }
    for (const DisplacedVertex& v : displaced(make_revolved(surface("cylinder"), 64), map, how)) {
        CHECK(distance_to_axis(v.position) <= 1 - sink + 1e-6);
        CHECK(distance_to_axis(v.position) >= 1 - sink - 1.1 * flat);
        CHECK(std::fabs(v.position.z) <= 1.000001f);
    }
    for (const DisplacedVertex& v : displaced(make_revolved(surface("torus"), 64), map, how))
        CHECK(std::hypot(distance_to_axis(v.position) - 1, double(v.position.z)) == Approx(0.4 - sink).margin(0.01));
}

TEST_CASE("the displaced mesh is where the height says, and not on its outer side", "[oracle][displaced]") {
    const DepthMap map = depth_of(repeated, bumps);
    const BilinearSurface relief(map);
    const MeshRelief how{0.3, 3, 2};
    double deepest = 0;
    for (const DisplacedVertex& v : displaced(make_revolved(surface("sphere"), 96), map, how)) {
        const double depth = 1 - relief.height(v.uv.x, v.uv.y);
        CHECK(V3d(v.position).length() == Approx(1 - 0.3 * depth).margin(2e-3)); // 96 segments are 0.6e-3 from round, each way
        deepest = std::max(deepest, depth);
    }
    CHECK(deepest > 0.8);
}

TEST_CASE("texture coordinates run as the mesh's file says", "[oracle][displaced]") {
    const DepthMap map = depth_of({4, 4, Wrap::clamp, Wrap::clamp, 1}, [](int, int j) { return j == 0; }); // high at the image's top
    Mesh mesh = make_revolved(surface("cylinder"), 16);
    const auto radius_at = [&](bool top) {
        double sum = 0;
        int count = 0;
        for (const DisplacedVertex& v : displaced(mesh, map, {0.5, 1, 1}))
            if (v.position.z * (top ? 1 : -1) > 0.999f) sum += distance_to_axis(v.position), ++count;
        return sum / count;
    };
    CHECK(radius_at(true) > 0.95);
    CHECK(radius_at(false) < 0.52);
    mesh.v_down = true;
    CHECK(radius_at(true) < 0.52);
    CHECK(radius_at(false) > 0.95);
}

TEST_CASE("no edge covers more than a texel, and none is left alone", "[oracle][displaced]") {
    const DepthMap map = depth_of(repeated, bumps);
    for (const char* name : {"sphere", "torus", "cylinder", "vase"})
        for (const double longest : {1.0, 0.6}) {
            DisplaceOptions options;
            options.longest_edge = longest;
            options.batch = 1000;
            const Mesh mesh = make_revolved(surface(name), 12);
            const std::vector<DisplacedVertex> triangles = displaced(mesh, map, {0.2, 3, 2}, options);
            double worst = 0;
            for (std::size_t t = 0; t < triangles.size(); t += 3)
                for (std::size_t k = 0; k < 3; ++k) {
                    const Imath::V2f d = triangles[t + k].uv - triangles[t + (k + 1) % 3].uv;
                    worst = std::max(worst, std::hypot(double(d.x) * repeated.width, double(d.y) * repeated.height));
                }
            INFO(name << " " << longest << ": " << triangles.size() / 3 << " triangles");
            CHECK(worst <= longest * 1.00001);
            CHECK(worst > 0.6 * longest);
            // Every edge has its two sides, at the seams too. At a sphere's poles, where triangles do not agree on u, and at open ends there are others.
            const auto edges = edges_of(triangles);
            const auto single = std::count_if(edges.begin(), edges.end(), [&](const auto& e) { return e.second != 2; });
            const double ends = std::string(name) == "torus" ? 0 : 2 * 3 * repeated.width / longest;
            CHECK(double(single) <= 4 * ends);
        }
}

TEST_CASE("slivers, unlike neighbours and odd numbers leave no crack and no endless work", "[oracle][displaced]") {
    const DepthMap map = depth_of(repeated, bumps);
    std::mt19937 random(3);
    Mesh mesh = make_revolved(surface("torus"), 9);
    for (Imath::V2f& uv : mesh.uvs) uv += Imath::V2f(float(uniform(random, -2, 2)), float(uniform(random, -0.02, 0.02)));
    // Copies at seams have other texture coordinates now: heights part there, edges do not once the relief is flat.
    const std::vector<DisplacedVertex> level = displaced(mesh, map, {0, 3, 2});
    for (const auto& edge : edges_of(level)) CHECK(edge.second % 2 == 0);
    mesh.positions[5].x = NAN;
    mesh.uvs[9].y = INFINITY;
    for (const DisplacedVertex& v : displaced(mesh, map, {0.2, 3, 2})) CHECK(std::isfinite(v.position.x + v.normal.x + v.uv.y));
    // Everything at one point of the texture: nothing to cut.
    for (Imath::V2f& uv : mesh.uvs) uv = Imath::V2f(0.3f, 0.4f);
    CHECK(displaced(mesh, map, {0.2, 3, 2}).size() < 3 * mesh.triangles.size());
}

TEST_CASE("normals of the displaced mesh are those of its triangles, about", "[oracle][displaced]") {
    const DepthMap map = depth_of({64, 32, Wrap::repeat, Wrap::repeat, 1}, [](int i, int j) { return 0.5 + 0.2 * std::sin(i * 0.196349) * std::cos(j * 0.19635); });
    double worst = 1;
    const std::vector<DisplacedVertex> triangles = displaced(make_revolved(surface("torus"), 96), map, {0.1, 2, 1});
    for (std::size_t t = 0; t < triangles.size(); t += 3) {
        const V3d a(triangles[t].position), b(triangles[t + 1].position), c(triangles[t + 2].position);
        const V3d n = (b - a).cross(c - a);
        worst = std::min(worst, n.normalized().dot(V3d(triangles[t].normal + triangles[t + 1].normal + triangles[t + 2].normal).normalized()));
    }
    CHECK(worst > 0.95);
}

TEST_CASE("the displaced mesh is the same in every run, whatever the batch, and too large a one is refused", "[oracle][displaced]") {
    const DepthMap map = depth_of(repeated, bumps);
    const Mesh mesh = make_revolved(surface("vase"), 20);
    DisplaceOptions small;
    small.batch = 7;
    const auto a = displaced(mesh, map, {0.2, 3, 2}), b = displaced(mesh, map, {0.2, 3, 2}, small);
    REQUIRE(a.size() == b.size());
    CHECK(std::memcmp(a.data(), b.data(), a.size() * sizeof(DisplacedVertex)) == 0);
    small.most_triangles = 1000;
    const auto refused = displace(mesh, BilinearSurface(map), {0.2, 3, 2}, small, [](auto) { FAIL("nothing is made"); });
    REQUIRE_FALSE(refused);
    CHECK(refused.error().code == ErrorCode::budget);
}
