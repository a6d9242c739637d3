#include "cli/bench/revolved.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace reliefbake {

namespace {

constexpr double pi = std::numbers::pi, tube = 0.4;

// The vase's profile: a belly and a neck; its least radius of curvature is that of its horizontal circles at the neck.
constexpr double vase_mean = 0.6, vase_swing = 0.25, vase_height = 2.2, vase_phase = 1.6 * pi, vase_start = -0.35 * pi;

double sphere_angle(double v) { return pi * (v - 0.5); }
double tube_angle(double v) { return 2 * pi * (v - 0.5); }
double vase_angle(double v) { return vase_start + vase_phase * v; }
double torus_r(double v) { return 1 + tube * std::cos(tube_angle(v)); }
double torus_z(double v) { return tube * std::sin(tube_angle(v)); }
double torus_dr(double v) { return -2 * pi * tube * std::sin(tube_angle(v)); }
double torus_dz(double v) { return 2 * pi * tube * std::cos(tube_angle(v)); }

/// Length of the profile over that of the widest circle.
double rows_per_segment(const RevolvedSurface& s) {
    constexpr int parts = 1000;
    double length = 0, widest = 0;
    for (int k = 0; k < parts; ++k) {
        const double v = (k + 0.5) / parts;
        length += std::hypot(s.dr(v), s.dz(v)) / parts;
        widest = std::max(widest, s.r(v));
    }
    return length / (2 * pi * widest * s.turn);
}

} // namespace

const std::vector<RevolvedSurface>& revolved_surfaces() {
    static const std::vector<RevolvedSurface> surfaces{
        {"sphere", [](double v) { return std::cos(sphere_angle(v)); }, [](double v) { return std::sin(sphere_angle(v)); },
         [](double v) { return -pi * std::sin(sphere_angle(v)); }, [](double v) { return pi * std::cos(sphere_angle(v)); }, 1},
        {"torus", torus_r, torus_z, torus_dr, torus_dz, tube, 1, true},
        {"cylinder", [](double) { return 1.0; }, [](double v) { return 2 * v - 1; }, [](double) { return 0.0; }, [](double) { return 2.0; }, 1},
        {"torus-open", torus_r, torus_z, torus_dr, torus_dz, tube, 0.75, true},
        {"vase", [](double v) { return vase_mean + vase_swing * std::sin(vase_angle(v)); }, [](double v) { return vase_height * (v - 0.5); },
         [](double v) { return vase_swing * vase_phase * std::cos(vase_angle(v)); }, [](double) { return vase_height; }, vase_mean - vase_swing},
    };
    return surfaces;
}

Mesh make_revolved(const RevolvedSurface& s, int segments, int shear) {
    const int rows = std::max(2, int(std::lround(segments * rows_per_segment(s))));
    Mesh mesh;
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= segments; ++i) {
            const double v = double(s.profile_closes ? j % rows : j) / rows;
            const double angle = 2 * pi * s.turn * (s.turn == 1 ? i % segments : i) / segments;
            const bool pole = s.r(v) < 1e-12;
            const Imath::V3d across = pole ? Imath::V3d(0) : Imath::V3d(std::cos(angle), std::sin(angle), 0);
            mesh.positions.push_back(across * s.r(v) + Imath::V3d(0, 0, s.z(v)));
            mesh.normals.push_back(Imath::V3f((across * s.dz(v) - Imath::V3d(0, 0, s.dr(v))).normalized()));
            mesh.uvs.push_back({float(i + (pole ? 0.5 : 0)) / float(segments), float(j) / float(rows) + float(shear * i) / float(segments)});
        }
    const auto vertex = [&](int i, int j) { return std::uint32_t(j * (segments + 1) + i); };
    const auto add = [&](const Triangle& t) {
        const Imath::V3d &p = mesh.positions[t[0]], &q = mesh.positions[t[1]], &r = mesh.positions[t[2]];
        if (p != q && q != r && r != p) mesh.triangles.push_back(t); // at a pole half of them have no area
    };
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < segments; ++i) {
            add({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
            add({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
        }
    return mesh;
}

} // namespace reliefbake
