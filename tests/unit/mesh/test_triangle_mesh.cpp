#include "mesh/triangle_mesh.h"

#include <catch2/catch.hpp>

#include <limits>

using namespace reliefbake;

namespace {

TriangleSoup tetrahedron() {
    return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

} // namespace

TEST_CASE("a closed mesh keeps its vertices in order and satisfies Euler's formula") {
    const Result<CheckedMesh> made = make_mesh(tetrahedron(), "t.obj");
    REQUIRE(made);
    REQUIRE(made->mesh.n_vertices() - made->mesh.n_edges() + made->mesh.n_faces() == 2);
    REQUIRE(made->mesh.point(made->mesh.vertex_handle(3))[2] == 1);
    REQUIRE(made->degenerate_triangles + made->non_manifold_triangles == 0);
}

TEST_CASE("triangles that are no faces are left out and counted") {
    TriangleSoup soup = tetrahedron();
    soup.triangles.push_back({1, 1, 2}); // two corners in one
    soup.triangles.push_back({0, 2, 1}); // a third face on an edge
    const Result<CheckedMesh> made = make_mesh(soup, "t.obj");
    REQUIRE(made);
    REQUIRE(made->mesh.n_faces() == 4);
    REQUIRE(made->degenerate_triangles == 1);
    REQUIRE(made->non_manifold_triangles == 1);
}

TEST_CASE("positions that are not finite and indices out of range are refused with the file's name") {
    TriangleSoup soup = tetrahedron();
    soup.positions[2][1] = std::numeric_limits<double>::quiet_NaN();
    Result<CheckedMesh> made = make_mesh(soup, "t.obj");
    REQUIRE(!made);
    REQUIRE(made.error().code == ErrorCode::bad_data);
    REQUIRE(made.error().message.find("t.obj: 1 positions are not finite, the first is number 2") == 0);
    soup = tetrahedron();
    soup.triangles[1][0] = 4;
    made = make_mesh(soup, "t.obj");
    REQUIRE(!made);
    REQUIRE(made.error().message.find("number 1") != std::string::npos);
}
