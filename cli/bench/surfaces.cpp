#include "cli/bench/surfaces.h"

#include <Imath/ImathMatrix.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>
#include <random>
#include <utility>

namespace reliefbake {

namespace {

using Imath::M33d;
using Imath::V3d;

constexpr double pi = std::numbers::pi;
constexpr double torus_radius = 1, tube_radius = 0.4, cylinder_radius = 0.7, saddle_bend = 0.8;
const V3d ellipsoid_axes(1, 0.7, 0.5);

double distance_to_axis(const V3d& p) { return std::sqrt(p.x * p.x + p.y * p.y); }

const ImplicitSurface surfaces[] = {
    {"sphere", [](const V3d& p) { return p * 2.0; }, [](const V3d&) { return M33d(2, 0, 0, 0, 2, 0, 0, 0, 2); }},
    {"ellipsoid", [](const V3d& p) { return p * 2.0 / (ellipsoid_axes * ellipsoid_axes); },
     [](const V3d&) {
         const V3d d = V3d(2) / (ellipsoid_axes * ellipsoid_axes);
         return M33d(d.x, 0, 0, 0, d.y, 0, 0, 0, d.z);
     }},
    {"torus", // F = (s - R)^2 + z^2, s the distance to the axis
     [](const V3d& p) {
         const double s = distance_to_axis(p), f = 2 * (s - torus_radius) / s;
         return V3d(f * p.x, f * p.y, 2 * p.z);
     },
     [](const V3d& p) {
         const double s = distance_to_axis(p), k = 2 * torus_radius / (s * s * s), f = 2 * (s - torus_radius) / s;
         return M33d(f + k * p.x * p.x, k * p.x * p.y, 0, k * p.x * p.y, f + k * p.y * p.y, 0, 0, 0, 2);
     }},
    {"cylinder", [](const V3d& p) { return V3d(2 * p.x, 2 * p.y, 0); }, [](const V3d&) { return M33d(2, 0, 0, 0, 2, 0, 0, 0, 0); }},
    {"saddle", // F = z - k (x^2 - y^2) / 2
     [](const V3d& p) { return V3d(-saddle_bend * p.x, saddle_bend * p.y, 1); },
     [](const V3d&) { return M33d(-saddle_bend, 0, 0, 0, saddle_bend, 0, 0, 0, 0); }},
};

/// A grid of columns x rows vertices, closed along the columns, and along the rows if asked.
void add_grid_triangles(Mesh& mesh, int columns, int rows, bool wrap_columns, bool wrap_rows) {
    const auto vertex = [&](int i, int j) { return std::uint32_t(j % rows * columns + i % columns); };
    for (int j = 0; j + !wrap_rows < rows; ++j)
        for (int i = 0; i + !wrap_columns < columns; ++i) {
            mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
            mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
        }
}

/// Small random steps that are the same in every run and library.
class Jitter {
  public:
    explicit Jitter(bool on) : on_(on) {}
    double operator()() { return on_ ? (double(random_()) / double(random_.max()) - 0.5) / 2 : 0; }

  private:
    bool on_;
    std::mt19937 random_{1};
};

V3d torus_point(double u, double v) {
    const double s = torus_radius + tube_radius * std::cos(v);
    return {s * std::cos(u), s * std::sin(u), tube_radius * std::sin(v)};
}

Mesh torus_mesh(int rings, int sides, Jitter jitter) {
    Mesh mesh;
    for (int j = 0; j < sides; ++j)
        for (int i = 0; i < rings; ++i) {
            const double u = i + jitter(), v = j + jitter();
            mesh.positions.push_back(torus_point(2 * pi * u / rings, 2 * pi * v / sides));
        }
    add_grid_triangles(mesh, rings, sides, true, true);
    return mesh;
}

Mesh cylinder_mesh(int columns, int rows, Jitter jitter) {
    Mesh mesh;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const bool edge = j == 0 || j == rows - 1;
            const double u = 2 * pi * (i + jitter()) / columns, along = (j + (edge ? 0 : jitter())) / (rows - 1);
            mesh.positions.push_back({cylinder_radius * std::cos(u), cylinder_radius * std::sin(u), 2 * along - 1});
        }
    add_grid_triangles(mesh, columns, rows, true, false);
    return mesh;
}

Mesh saddle_mesh(int side, Jitter jitter) {
    Mesh mesh;
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            const double x = 2 * (i + (i % (side - 1) ? jitter() : 0)) / (side - 1) - 1, y = 2 * (j + (j % (side - 1) ? jitter() : 0)) / (side - 1) - 1;
            mesh.positions.push_back({x, y, saddle_bend * (x * x - y * y) / 2});
        }
    add_grid_triangles(mesh, side, side, false, false);
    return mesh;
}

/// Halves every edge; new vertices are shared.
void subdivide(Mesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
        const auto [found, is_new] = middles.try_emplace(std::minmax(a, b), std::uint32_t(mesh.positions.size()));
        if (is_new) mesh.positions.push_back((mesh.positions[a] + mesh.positions[b]).normalized());
        return found->second;
    };
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : mesh.triangles) {
        const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        for (const Triangle& t : {Triangle{a, ab, ca}, Triangle{ab, b, bc}, Triangle{ca, bc, c}, Triangle{ab, bc, ca}}) finer.push_back(t);
    }
    mesh.triangles = std::move(finer);
}

Mesh icosphere(int levels, Jitter jitter, const V3d& axes) {
    const double g = std::numbers::phi;
    Mesh mesh;
    for (const double s : {-1.0, 1.0})
        for (const double t : {-g, g})
            for (const V3d& p : {V3d(0, s, t), V3d(s, t, 0), V3d(t, 0, s)}) mesh.positions.push_back(p.normalized());
    // Its faces are the triples of vertices at the least distance, counter-clockwise from outside.
    const auto near = [&](std::uint32_t a, std::uint32_t b) { return mesh.positions[a].dot(mesh.positions[b]) > 0.4; };
    for (std::uint32_t a = 0; a < 12; ++a)
        for (std::uint32_t b = a + 1; b < 12; ++b)
            for (std::uint32_t c = b + 1; c < 12; ++c)
                if (near(a, b) && near(b, c) && near(c, a)) {
                    const V3d &p = mesh.positions[a], &q = mesh.positions[b], &r = mesh.positions[c];
                    mesh.triangles.push_back(p.dot(q.cross(r)) > 0 ? Triangle{a, b, c} : Triangle{a, c, b});
                }
    for (int k = 0; k < levels; ++k) subdivide(mesh);
    const double edge = 1.1 / double(1 << levels);
    for (V3d& p : mesh.positions) p = (p + V3d(jitter(), jitter(), jitter()) * edge).normalized() * axes;
    return mesh;
}

} // namespace

double second_form(const ImplicitSurface& surface, const V3d& point, const V3d& u, const V3d& v) {
    const M33d h = surface.hessian(point);
    double sum = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) sum += u[i] * h[i][j] * v[j];
    return -sum / surface.gradient(point).length();
}

ExactQuadric exact_quadric(const ImplicitSurface& surface, const V3d& p, const V3d& x, const V3d& y) {
    return {second_form(surface, p, x, x) / 2, second_form(surface, p, y, y) / 2, second_form(surface, p, x, y)};
}

V3d strongest_direction(const ImplicitSurface& surface, const V3d& point) {
    const V3d n = surface.gradient(point).normalized();
    const V3d x = n.cross(std::fabs(n.x) < 0.6 ? V3d(1, 0, 0) : V3d(0, 1, 0)).normalized(), y = n.cross(x);
    const double xx = second_form(surface, point, x, x), yy = second_form(surface, point, y, y), xy = second_form(surface, point, x, y);
    double angle = std::atan2(2 * xy, xx - yy) / 2;
    const double c = std::cos(angle), s = std::sin(angle);
    const double along = xx * c * c + 2 * xy * c * s + yy * s * s;
    if (std::fabs(along) < std::fabs(xx + yy - along)) angle += pi / 2;
    return x * std::cos(angle) + y * std::sin(angle);
}

const std::vector<std::string>& surface_names() {
    static const std::vector<std::string> names{"sphere", "cylinder", "torus", "ellipsoid", "saddle"};
    return names;
}

SurfaceMesh make_surface(const std::string& name, int detail, bool irregular) {
    const Jitter jitter(irregular);
    const int side = 16 << detail;
    for (const ImplicitSurface& surface : surfaces) {
        if (surface.name != name) continue;
        if (name == "sphere") return {surface, icosphere(detail + 2, jitter, V3d(1))};
        if (name == "ellipsoid") return {surface, icosphere(detail + 2, jitter, ellipsoid_axes)};
        if (name == "torus") return {surface, torus_mesh(2 * side, side, jitter)};
        if (name == "cylinder") return {surface, cylinder_mesh(2 * side, side + 1, jitter)};
        return {surface, saddle_mesh(side + 1, jitter)};
    }
    std::abort(); // the caller asks for one of surface_names()
}

Mesh make_torus(int rings, int sides) { return torus_mesh(rings, sides, Jitter(false)); }

void set_turned_tangents(SurfaceMesh& s, double degrees) {
    const double c = std::cos(degrees * pi / 180), d = std::sin(degrees * pi / 180);
    s.mesh.tangents.clear();
    for (const V3d& p : s.mesh.positions) {
        const V3d n = s.surface.gradient(p).normalized(), x = strongest_direction(s.surface, p), t = x * c + n.cross(x) * d;
        s.mesh.tangents.push_back({float(t.x), float(t.y), float(t.z), 1});
    }
}

} // namespace reliefbake
