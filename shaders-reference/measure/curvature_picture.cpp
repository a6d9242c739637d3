#include "shaders-reference/measure/curvature_picture.h"

#include "bake/image.h"
#include "shaders-reference/renderer/resolve.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace reliefbake {

namespace {

using Imath::V3d;

// Orthonormal: to the right, up, and to the viewer.
const V3d right(0.8, 0, -0.6), up(-0.36, 0.8, -0.48), viewer(0.48, 0.6, 0.64);
constexpr int samples = 2; ///< a pixel's side

struct Curvatures {
    double mean, gaussian; ///< the second as a signed root
};

Curvatures curvatures_of(const Quadric& q) {
    const double a = q.a, b = q.b, c = q.c, k = 4 * a * b - c * c;
    return {a + b, std::copysign(std::sqrt(std::fabs(k)), k)};
}

/// Where a point of the meshes lies in the picture: x to the right, y down, z to the viewer.
struct View {
    V3d centre{0};
    double scale = 0;
    double half;

    View(std::span<const Mesh> meshes, int side) : half(side / 2.0) {
        V3d low(std::numeric_limits<double>::max()), high(-low);
        for (const Mesh& mesh : meshes)
            for (const V3d& p : mesh.positions) {
                const V3d q(p.dot(right), -p.dot(up), p.dot(viewer));
                if (!std::isfinite(q.x + q.y + q.z)) continue;
                for (int k = 0; k < 3; ++k) low[k] = std::min(low[k], q[k]), high[k] = std::max(high[k], q[k]);
            }
        constexpr double filled = 0.92;
        centre = low / 2 + high / 2;
        const double extent = std::max(high.x - low.x, high.y - low.y);
        if (extent > 0) scale = side * filled / extent;
    }

    V3d place(const V3d& p) const {
        const V3d q = (V3d(p.dot(right), -p.dot(up), p.dot(viewer)) - centre) * scale;
        return {q.x + half, q.y + half, q.z};
    }
};

/// Linear colour of x in [-1,1]: blue, light grey, red.
V3d diverging(double x) {
    const V3d blue(0.02, 0.10, 0.55), grey(0.75, 0.75, 0.75), red(0.60, 0.02, 0.03);
    const double t = std::min(std::fabs(x), 1.0);
    return grey * (1 - t) + (x < 0 ? blue : red) * t;
}

class Painter {
  public:
    Painter(const View& view, int side, double reach)
        : view_(view), reach_(reach), side_(side), depth_(side, side, -std::numeric_limits<double>::infinity()), colour_(2 * side, side, Quad{1, 1, 1, 1}) {}

    void draw(const Mesh& mesh) {
        for (const Triangle& t : mesh.triangles) draw(mesh, t);
    }

    const Image<Quad>& colour() const { return colour_; }

  private:
    void draw(const Mesh& mesh, const Triangle& t) {
        const V3d p[] = {view_.place(mesh.positions[t[0]]), view_.place(mesh.positions[t[1]]), view_.place(mesh.positions[t[2]])};
        const double area = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
        if (!std::isfinite(area) || area == 0) return;
        const auto [left, end_x] = std::minmax({p[0].x, p[1].x, p[2].x});
        const auto [top, end_y] = std::minmax({p[0].y, p[1].y, p[2].y});
        const auto last = [&](double x) { return int(std::clamp(std::floor(x), -1.0, side_ - 1.0)); };
        for (int y = std::max(0, last(top)); y <= last(end_y); ++y)
            for (int x = std::max(0, last(left)); x <= last(end_x); ++x) {
                const double u = x + 0.5, v = y + 0.5;
                const auto edge = [&](const V3d& a, const V3d& b) { return ((b.x - a.x) * (v - a.y) - (b.y - a.y) * (u - a.x)) / area; };
                const double w[] = {edge(p[1], p[2]), edge(p[2], p[0]), edge(p[0], p[1])};
                if (w[0] >= 0 && w[1] >= 0 && w[2] >= 0) shade(mesh, t, p, w, x, y);
            }
    }

    void shade(const Mesh& mesh, const Triangle& t, const V3d* p, const double* w, int x, int y) {
        const double z = w[0] * p[0].z + w[1] * p[1].z + w[2] * p[2].z;
        if (z <= depth_(x, y)) return;
        depth_(x, y) = z;
        Curvatures k{0, 0};
        V3d normal(0);
        for (int c = 0; c < 3; ++c) {
            const Curvatures at = curvatures_of(mesh.quadrics[t[std::size_t(c)]]);
            k.mean += w[c] * at.mean, k.gaussian += w[c] * at.gaussian;
            normal += V3d(mesh.normals[t[std::size_t(c)]]) * w[c];
        }
        constexpr double ambient = 0.35;
        const double length = normal.length(), light = ambient + (1 - ambient) * (length > 0 ? std::fabs(normal.dot(viewer)) / length : 1);
        const auto put = [&](int column, double value) {
            const V3d c = diverging(reach_ > 0 ? value / reach_ : 0) * light;
            colour_(column, y) = Quad{float(c.x), float(c.y), float(c.z), 1};
        };
        put(x, -k.mean); // convex is negative, and red
        put(x + side_, k.gaussian);
    }

    const View& view_;
    double reach_;
    int side_;
    Image<double> depth_;
    Image<Quad> colour_;
};

double reach_of(std::span<const Mesh> meshes) {
    std::vector<double> sizes;
    for (const Mesh& mesh : meshes)
        for (const Quadric& q : mesh.quadrics) {
            const Curvatures k = curvatures_of(q);
            sizes.push_back(std::fabs(k.mean)), sizes.push_back(std::fabs(k.gaussian));
        }
    if (sizes.empty()) return 0;
    const auto place = sizes.begin() + std::ptrdiff_t((sizes.size() - 1) * 95 / 100);
    std::nth_element(sizes.begin(), place, sizes.end());
    return *place;
}

} // namespace

RgbImage curvature_picture(std::span<const Mesh> meshes, int side) {
    const View view(meshes, samples * side);
    Painter painter(view, samples * side, reach_of(meshes));
    for (const Mesh& mesh : meshes) painter.draw(mesh);
    return resolve_picture(painter.colour(), samples);
}

} // namespace reliefbake
