#include "mesh/corner_lists.h"
#include "mesh/weld.h"

#include <catch2/catch.hpp>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>

#include "cli/bench/surfaces.h"

using namespace reliefbake;
using Imath::V3d;

TEST_CASE("vertices weld where coordinates are equal, whatever the sign of zero") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Weld weld = weld_positions({{0, 1, 2}, {-0.0, 1, 2}, {nan, 1, 2}, {0, 1, 3}, {nan, 1, 2}, {0, 1, 2}, {0, std::nextafter(1.0, 2), 2}}, 1);
    REQUIRE(weld.position_of == std::vector<std::uint32_t>{0, 0, no_position, 1, no_position, 0, 2});
    REQUIRE(weld.first_vertex == std::vector<std::uint32_t>{0, 3, 6});
}

TEST_CASE("welding agrees with a map, for any number of threads") {
    std::mt19937 random(7);
    std::vector<V3d> points;
    for (int k = 0; k < 70'000; ++k) points.push_back({double(random() % 40), double(random() % 40) / 3, double(random() % 40) * 1e-9});
    std::map<std::array<double, 3>, std::uint32_t> numbers;
    std::vector<std::uint32_t> expected;
    for (const V3d& p : points)
        expected.push_back(numbers.try_emplace({p.x, p.y, p.z}, std::uint32_t(numbers.size())).first->second);
    for (const int threads : {1, 2, 5}) REQUIRE(weld_positions(points, threads).position_of == expected);
}

TEST_CASE("corner lists hold each corner once and leave out what belongs to no ring") {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {std::numeric_limits<double>::infinity(), 0, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 3, 1}, {0, 1, 4}, {3, 2, 1}};
    const CornerLists lists = list_corners(mesh, weld_positions(mesh.positions, 1), 1);
    REQUIRE(lists.degenerate_triangles == 1);
    REQUIRE(lists.non_finite_triangles == 1);
    REQUIRE(lists.corners == LargeArray<std::uint32_t>{0, 9, 1, 11, 2, 10});
}

TEST_CASE("neighbours are those of a half-edge mesh of another library") {
    const Mesh mesh = make_surface("saddle", 1, true).mesh;
    using Other = OpenMesh::TriMesh_ArrayKernelT<>;
    Other other;
    for (const V3d& p : mesh.positions) other.add_vertex({float(p.x), float(p.y), float(p.z)});
    for (const Triangle& t : mesh.triangles)
        other.add_face(other.vertex_handle(t[0]), other.vertex_handle(t[1]), other.vertex_handle(t[2]));
    const CornerLists lists = list_corners(mesh, weld_positions(mesh.positions, 1), 2);
    for (std::uint32_t p = 0; p < mesh.positions.size(); ++p) {
        std::set<std::uint32_t> ours, theirs;
        for (const std::uint32_t corner : lists.at(p))
            for (const std::uint32_t place : lists.places[corner / 3])
                if (place != p) ours.insert(place);
        for (const auto v : other.vv_range(other.vertex_handle(p))) theirs.insert(std::uint32_t(v.idx()));
        REQUIRE(ours == theirs);
    }
}
