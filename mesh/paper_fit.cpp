#include "mesh/paper_fit.h"

#include "bake/parallel.h"
#include "mesh/least_squares.h"
#include "mesh/ring.h"

#include <algorithm>
#include <cmath>

namespace reliefbake {

namespace {

using Imath::V3d;

Quadric fit_in_frame(const Ring& ring, const WeldedSurface& surface, const V3d& normal, const Imath::V4f& tangent,
                     std::vector<Equation>& equations) {
    const V3d x_axis(tangent.x, tangent.y, tangent.z), y_axis = normal.cross(x_axis) * double(tangent.w);
    equations.clear();
    double largest = 0;
    for (const std::uint32_t neighbour : ring.neighbours()) {
        const V3d d = surface.points[neighbour] - surface.points[ring.position()];
        const double x = d.dot(x_axis), y = d.dot(y_axis);
        largest = std::max(largest, x * x + y * y);
        equations.push_back({x, y, 0, 0, 0, d.dot(normal)});
    }
    const double radius = std::sqrt(largest);
    if (!(radius > 0)) return {};
    for (Equation& e : equations) {
        const double x = e[0] / radius, y = e[1] / radius;
        e = {x * x, y * y, 0, 0, 0, e[5] / radius};
    }
    constexpr double independent = 1e-9; // as printed: nearly dependent columns give nearly absurd terms
    const ShortestSolution solution = solve_shortest(equations, independent);
    const double unit = surface.scale / radius;
    return {float(solution.x[0] * unit), float(solution.x[1] * unit), 0};
}

} // namespace

std::vector<Quadric> fit_as_printed(const Mesh& mesh, const std::vector<std::uint32_t>& source, const WeldedSurface& surface, int threads) {
    constexpr std::size_t block_vertices = 4096;
    std::vector<Quadric> quadrics(mesh.positions.size());
    parallel_for(int((quadrics.size() + block_vertices - 1) / block_vertices), threads, [&](int block) {
        Ring ring(surface);
        std::vector<Equation> equations;
        const std::size_t first = std::size_t(block) * block_vertices;
        for (std::size_t v = first; v < std::min(first + block_vertices, quadrics.size()); ++v) {
            const std::uint32_t position = surface.weld.position_of[source[v]];
            if (position == no_position) continue;
            ring.gather(position);
            quadrics[v] = fit_in_frame(ring, surface, V3d(mesh.normals[v]), mesh.tangents[v], equations);
        }
    });
    return quadrics;
}

} // namespace reliefbake
