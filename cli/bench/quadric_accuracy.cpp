#include "cli/bench/quadric_accuracy.h"

#include <algorithm>
#include <cmath>

namespace reliefbake {

using Imath::V3d;

CurvatureError curvature_error(const SurfaceMesh& s, const QuadricBake& bake) {
    double squares = 0, worst = 0, largest = 0;
    for (std::size_t v = 0; v < bake.mesh.quadrics.size(); ++v) {
        const V3d p = bake.mesh.positions[v], n = s.surface.gradient(p).normalized();
        const Imath::V4f& t = bake.mesh.tangents[v];
        V3d x(t.x, t.y, t.z);
        x = (x - n * n.dot(x)).normalized();
        const ExactQuadric e = exact_quadric(s.surface, p, x, n.cross(x) * double(t.w));
        const Quadric& q = bake.mesh.quadrics[v];
        const double a = q.a - e.a, b = q.b - e.b, c = q.c - e.c; // the form is (2a, c; c, 2b)
        const double square = 4 * a * a + 4 * b * b + 2 * c * c;
        squares += square;
        worst = std::max(worst, square);
        const V3d k = strongest_direction(s.surface, p);
        largest = std::max(largest, std::fabs(second_form(s.surface, p, k, k)));
    }
    return {std::sqrt(squares / double(bake.mesh.quadrics.size())) / largest, std::sqrt(worst) / largest};
}

} // namespace reliefbake
