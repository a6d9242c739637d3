// Laws of the quadric: what must hold for every mesh, and known surfaces.

#include "mesh/quadric_bake.h"
#include "mesh/vertex_frames.h"

#include "cli/bench/surfaces.h"

#include <catch2/catch.hpp>

#include <Imath/ImathMatrix.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <random>

using namespace reliefbake;
using Imath::V3d;

namespace {

QuadricBake bake(const Mesh& mesh, FrameKind frame = FrameKind::automatic, int threads = 1, QuadricFit fit = QuadricFit::ring) {
    QuadricOptions options;
    options.frame = frame, options.threads = threads, options.fit = fit;
    const Result<QuadricBake> made = bake_quadrics(mesh, options, "mesh");
    REQUIRE(made);
    return *made;
}

bool same_bits(const std::vector<Quadric>& a, const std::vector<Quadric>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Quadric)) == 0;
}

/// Largest difference over the largest curvature.
double difference(const std::vector<Quadric>& a, const std::vector<Quadric>& b) {
    double largest = 0, size = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        for (const float d : {a[k].a - b[k].a, a[k].b - b[k].b, a[k].c - b[k].c}) largest = std::max(largest, std::fabs(double(d)));
        for (const float d : {a[k].a, a[k].b, a[k].c}) size = std::max(size, std::fabs(double(d)));
    }
    return largest / size;
}

/// Root mean square error of a, b, c over the root mean square of the curvature, in the frames that the bake gave.
double error(const SurfaceMesh& s, const QuadricBake& made) {
    double wrong = 0, all = 0;
    for (std::size_t v = 0; v < made.mesh.quadrics.size(); ++v) {
        const Imath::V4f& t4 = made.mesh.tangents[v];
        const V3d p = made.mesh.positions[v], n = s.surface.gradient(p).normalized();
        V3d x(t4.x, t4.y, t4.z);
        x = (x - n * n.dot(x)).normalized();
        const ExactQuadric e = exact_quadric(s.surface, p, x, n.cross(x) * double(t4.w));
        const Quadric& q = made.mesh.quadrics[v];
        wrong += std::pow(q.a - e.a, 2) + std::pow(q.b - e.b, 2) + std::pow(q.c - e.c, 2) / 2;
        all += e.a * e.a + e.b * e.b + e.c * e.c / 2;
    }
    return std::sqrt(wrong / all);
}

Mesh scaled(Mesh mesh, double factor) {
    for (V3d& p : mesh.positions) p *= factor;
    return mesh;
}

/// A bent sheet with texture coordinates along x and y; `flip` mirrors them.
Mesh sheet(bool flip) {
    SurfaceMesh s = make_surface("saddle", 0, true);
    for (V3d& p : s.mesh.positions) {
        p.z += 0.5 * p.x * p.y;
        s.mesh.uvs.push_back({float(flip ? -p.x : p.x), float(p.y)});
    }
    return s.mesh;
}

} // namespace

TEST_CASE("a plane has no curvature, in any position") {
    Mesh mesh = make_surface("saddle", 1, true).mesh;
    for (V3d& p : mesh.positions) p.z = 0;
    for (const Quadric& q : bake(mesh).mesh.quadrics) REQUIRE((q.a == 0 && q.b == 0 && q.c == 0));
    const Imath::M33d turn(0.36, 0.48, -0.8, -0.8, 0.6, 0, 0.48, 0.64, 0.6);
    for (V3d& p : mesh.positions) p = p * turn + V3d(3, 5, 7);
    for (const Quadric& q : bake(mesh).mesh.quadrics)
        for (const float term : {q.a, q.b, q.c}) REQUIRE(std::fabs(term) < 1e-9);
}

TEST_CASE("a sphere of radius R has a = b = -1/(2R), c = 0") {
    for (const double radius : {1.0, 3.0}) {
        const QuadricBake made = bake(scaled(make_surface("sphere", 2, false).mesh, radius));
        for (const Quadric& q : made.mesh.quadrics) {
            REQUIRE(q.a == Approx(-1 / (2 * radius)).epsilon(2e-3));
            REQUIRE(q.b == Approx(-1 / (2 * radius)).epsilon(2e-3));
            REQUIRE(std::fabs(q.c) < 2e-3 / radius);
        }
    }
}

TEST_CASE("every known surface is met within 2 % on irregular meshes, better with each step of detail") {
    for (const std::string& name : surface_names())
        for (const double degrees : {0.0, 22.5, 45.0}) {
            double before = 1;
            for (const int detail : {1, 2, 3}) {
                SurfaceMesh s = make_surface(name, detail, true);
                set_turned_tangents(s, degrees);
                const double now = error(s, bake(s.mesh));
                CAPTURE(name, degrees, detail, before);
                if (detail > 1) REQUIRE(now < 0.8 * before);
                if (detail == 3) REQUIRE(now < 0.02);
                before = now;
            }
        }
}

TEST_CASE("scaling by a power of two scales the quadrics exactly") {
    const Mesh mesh = make_surface("torus", 0, true).mesh;
    const QuadricBake one = bake(mesh);
    for (const int power : {-40, -1, 3, 60}) {
        std::vector<Quadric> expected = one.mesh.quadrics;
        for (Quadric& q : expected)
            for (float* term : {&q.a, &q.b, &q.c}) *term = std::ldexp(*term, -power);
        CAPTURE(power);
        REQUIRE(same_bits(bake(scaled(mesh, std::ldexp(1.0, power))).mesh.quadrics, expected));
    }
}

TEST_CASE("turning or moving the mesh leaves the quadrics as they are") {
    SurfaceMesh s = make_surface("ellipsoid", 0, true);
    set_turned_tangents(s, 30);
    const QuadricBake still = bake(s.mesh);
    const Imath::M33d turn(0.36, 0.48, -0.8, -0.8, 0.6, 0, 0.48, 0.64, 0.6);
    for (std::size_t v = 0; v < s.mesh.positions.size(); ++v) {
        const Imath::V4f t = s.mesh.tangents[v];
        const V3d turned = V3d(t.x, t.y, t.z) * turn;
        s.mesh.tangents[v] = {float(turned.x), float(turned.y), float(turned.z), t.w};
        s.mesh.positions[v] = s.mesh.positions[v] * turn + V3d(1, -2, 4);
    }
    REQUIRE(difference(still.mesh.quadrics, bake(s.mesh).mesh.quadrics) < 1e-6);
}

TEST_CASE("a mirrored texture flips c and nothing else") {
    const QuadricBake right = bake(sheet(false)), left = bake(sheet(true));
    REQUIRE(right.counts.mirrored == 0);
    REQUIRE(left.counts.mirrored == left.mesh.positions.size());
    double twist = 0;
    for (std::size_t v = 0; v < right.mesh.quadrics.size(); ++v) {
        const Quadric &r = right.mesh.quadrics[v], &l = left.mesh.quadrics[v];
        REQUIRE(l.a == Approx(r.a).margin(1e-5));
        REQUIRE(l.b == Approx(r.b).margin(1e-5));
        REQUIRE(l.c == Approx(-r.c).margin(1e-5));
        twist = std::max(twist, std::fabs(double(r.c)));
    }
    REQUIRE(twist > 0.3); // else the signs say nothing
}

TEST_CASE("the copies at a seam share one ring and keep their own frames") {
    // A torus whose first ring of vertices is doubled, as a texture's seam does.
    const int rings = 24, sides = 12;
    SurfaceMesh s = make_surface("torus", 0, false);
    s.mesh = make_torus(rings, sides);
    Mesh split = s.mesh;
    for (int j = 0; j < sides; ++j) split.positions.push_back(split.positions[std::size_t(j * rings)]);
    for (Triangle& t : split.triangles) {
        const bool across = std::any_of(t.begin(), t.end(), [&](std::uint32_t v) { return int(v) % rings == rings - 1; });
        for (std::uint32_t& v : t)
            if (across && int(v) % rings == 0) v = std::uint32_t(rings * sides) + v / rings;
    }
    const QuadricBake whole = bake(s.mesh), cut = bake(split);
    REQUIRE(cut.counts.positions == whole.counts.positions);
    REQUIRE(cut.counts.boundary == 0);
    for (std::size_t v = 0; v < whole.mesh.quadrics.size(); ++v) REQUIRE(cut.mesh.quadrics[v].a == Approx(whole.mesh.quadrics[v].a).epsilon(1e-6));
    for (int j = 0; j < sides; ++j) {
        const Quadric &one = cut.mesh.quadrics[std::size_t(j * rings)], &copy = cut.mesh.quadrics[std::size_t(rings * sides + j)];
        REQUIRE((one.a == copy.a && one.b == copy.b && one.c == copy.c));
    }

    // The copies' frames turned by 90 degrees: a and b change places, c changes sign.
    set_turned_tangents(s, 20);
    split.tangents = s.mesh.tangents;
    for (int j = 0; j < sides; ++j) {
        const V3d p = split.positions[std::size_t(j * rings)], n = s.surface.gradient(p).normalized();
        const Imath::V4f& t = split.tangents[std::size_t(j * rings)];
        const V3d turned = n.cross(V3d(t.x, t.y, t.z));
        split.tangents.push_back({float(turned.x), float(turned.y), float(turned.z), 1});
    }
    const QuadricBake turned = bake(split);
    for (int j = 0; j < sides; ++j) {
        const Quadric &one = turned.mesh.quadrics[std::size_t(j * rings)], &copy = turned.mesh.quadrics[std::size_t(rings * sides + j)];
        REQUIRE(copy.a == Approx(one.b).margin(1e-5));
        REQUIRE(copy.b == Approx(one.a).margin(1e-5));
        REQUIRE(copy.c == Approx(-one.c).margin(1e-5));
    }
}

TEST_CASE("the order of vertices and triangles changes nothing but rounding") {
    SurfaceMesh s = make_surface("ellipsoid", 1, true);
    set_turned_tangents(s, 40);
    const QuadricBake before = bake(s.mesh);
    std::mt19937 random(11);
    std::vector<std::uint32_t> order(s.mesh.positions.size()), place(order.size());
    std::iota(order.begin(), order.end(), 0u);
    std::shuffle(order.begin(), order.end(), random);
    Mesh mixed = s.mesh;
    for (std::uint32_t k = 0; k < order.size(); ++k) {
        place[order[k]] = k;
        mixed.positions[k] = s.mesh.positions[order[k]], mixed.tangents[k] = s.mesh.tangents[order[k]];
    }
    for (Triangle& t : mixed.triangles) {
        for (std::uint32_t& v : t) v = place[v];
        std::rotate(t.begin(), t.begin() + random() % 3, t.end());
    }
    std::shuffle(mixed.triangles.begin(), mixed.triangles.end(), random);
    const QuadricBake after = bake(mixed);
    std::vector<Quadric> back(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) back[order[k]] = after.mesh.quadrics[k];
    REQUIRE(difference(before.mesh.quadrics, back) < 1e-6);
}

TEST_CASE("any number of threads gives the same bits") {
    SurfaceMesh s = make_surface("torus", 4, true); // more than one block of every loop
    REQUIRE(s.mesh.positions.size() > 100'000);
    for (const QuadricFit fit : {QuadricFit::ring, QuadricFit::paper}) {
        const QuadricBake one = bake(s.mesh, FrameKind::principal, 1, fit);
        for (const int threads : {2, 3, 7}) {
            const QuadricBake many = bake(s.mesh, FrameKind::principal, threads, fit);
            REQUIRE(same_bits(one.mesh.quadrics, many.mesh.quadrics));
            REQUIRE(one.residual_rms == many.residual_rms);
        }
    }
}

TEST_CASE("in the principal frame c is 0 and a is the larger in size") {
    const SurfaceMesh s = make_surface("ellipsoid", 1, true);
    for (const Quadric& q : bake(s.mesh, FrameKind::principal).mesh.quadrics) {
        REQUIRE(std::fabs(q.c) < 1e-5);
        REQUIRE(std::fabs(q.a) >= std::fabs(q.b) - 1e-5);
    }
}

TEST_CASE("the two-term fit as printed is right in aligned frames and wrong in turned ones at every resolution") {
    for (const int detail : {1, 2, 3}) {
        SurfaceMesh s = make_surface("torus", detail, false);
        const auto two_terms = [&](double degrees) {
            set_turned_tangents(s, degrees);
            return error(s, bake(s.mesh, FrameKind::mesh, 1, QuadricFit::paper));
        };
        CAPTURE(detail);
        REQUIRE(two_terms(0) < 0.03);
        REQUIRE(two_terms(45) > 0.3);
    }
}

TEST_CASE("normals against the winding turn the quadric around") {
    SurfaceMesh s = make_surface("sphere", 1, false);
    for (const V3d& p : s.mesh.positions) s.mesh.normals.push_back(Imath::V3f(-p));
    const QuadricBake made = bake(s.mesh);
    REQUIRE(made.counts.against_winding == s.mesh.positions.size());
    for (const Quadric& q : made.mesh.quadrics) REQUIRE(q.a == Approx(0.5).epsilon(0.01));
}
