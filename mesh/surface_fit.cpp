#include "mesh/surface_fit.h"

#include "bake/parallel.h"
#include "mesh/least_squares.h"
#include "mesh/ring.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace reliefbake {

namespace {

constexpr std::size_t block_positions = 4096;
int block_count(std::size_t positions) { return int((positions + block_positions - 1) / block_positions); }

/// The unknowns of a ring over its radius: two squares, the mixed term so that the solution's length does not depend on the
/// basis (it is the form's Frobenius norm), two linear terms.
constexpr double mixed_weight = std::numbers::sqrt2;

/// A power of two that brings the largest finite coordinate to [1/2, 1).
double box_scale(const Mesh& mesh, const Weld& weld) {
    double largest = 0;
    for (const std::uint32_t v : weld.first_vertex) {
        const Imath::V3d& p = mesh.positions[v];
        largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
    }
    if (largest == 0) return 1;
    constexpr int furthest = 1000; // both the scale and its reciprocal are normal numbers
    return std::ldexp(1.0, -std::clamp(std::ilogb(largest) + 1, -furthest, furthest));
}

class RingFitter {
  public:
    explicit RingFitter(const WeldedSurface& surface) : surface_(surface), ring_(surface) {}

    SurfaceForm fit(std::uint32_t position, std::size_t& zero_area_triangles) {
        ring_.gather(position);
        zero_area_triangles += ring_.zero_area_corners();
        SurfaceForm form;
        form.normal = ring_.normal();
        form.flags = ring_.flags();
        if (form.flags & (isolated | no_normal)) return form;

        // Where the ring is close to carrying fewer terms, its solution is close to noise.
        constexpr double well_conditioned = 0.05, independent = 1e-3;
        ShortestSolution solution = solve(form.normal, independent);
        if ((solution.rank < ring_unknowns || solution.smallest_pivot < well_conditioned) && ring_.extend()) {
            form.flags |= second_ring;
            solution = solve(form.normal, independent);
        }
        if (solution.rank < ring_unknowns) form.flags |= short_rank;
        if (radius_ > 0) store(solution, form);
        return form;
    }

  private:
    /// Heights of the ring over the tangent plane, in units of the ring's radius.
    ShortestSolution solve(const Imath::V3d& normal, double tolerance) {
        const TangentBasis basis = tangent_basis(normal);
        const Imath::V3d& here = surface_.points[ring_.position()];
        equations_.clear();
        double largest = 0;
        for (const std::uint32_t neighbour : ring_.neighbours()) {
            const Imath::V3d d = surface_.points[neighbour] - here;
            const double x = d.dot(basis.x), y = d.dot(basis.y);
            largest = std::max(largest, x * x + y * y);
            equations_.push_back({0, 0, 0, x, y, d.dot(normal)});
        }
        radius_ = std::sqrt(largest);
        if (!(radius_ > 0)) return {};
        const double inverse = 1 / radius_;
        for (Equation& e : equations_) {
            const double x = e[3] * inverse, y = e[4] * inverse;
            e = {x * x, y * y, mixed_weight * x * y, x, y, e[5] * inverse};
        }
        return solve_shortest(equations_, tolerance);
    }

    void store(const ShortestSolution& solution, SurfaceForm& form) const {
        const double unit = surface_.scale / radius_;
        form.xx = solution.x[0] * unit;
        form.yy = solution.x[1] * unit;
        form.xy = mixed_weight * solution.x[2] * unit;
        form.residual = float(std::sqrt(solution.residual_squared / double(equations_.size())));
    }

    const WeldedSurface& surface_;
    Ring ring_;
    std::vector<Equation> equations_;
    double radius_ = 0;
};

} // namespace

TangentBasis tangent_basis(const Imath::V3d& n) {
    const double sign = std::copysign(1.0, n.z), a = -1 / (sign + n.z), b = n.x * n.y * a;
    return {{1 + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}};
}

WeldedSurface weld_surface(const Mesh& mesh, int threads) {
    WeldedSurface surface;
    surface.weld = weld_positions(mesh.positions, threads);
    surface.lists = list_corners(mesh, surface.weld, threads);
    surface.scale = box_scale(mesh, surface.weld);
    surface.points.resize(surface.weld.first_vertex.size());
    parallel_for(block_count(surface.points.size()), threads, [&](int block) {
        const std::size_t first = std::size_t(block) * block_positions;
        for (std::size_t p = first; p < std::min(first + block_positions, surface.points.size()); ++p)
            surface.points[p] = mesh.positions[surface.weld.first_vertex[p]] * surface.scale;
    });
    return surface;
}

SurfaceFit fit_surface(const WeldedSurface& surface, int threads) {
    const std::size_t count = surface.points.size();
    const int blocks = block_count(count);
    SurfaceFit fit;
    fit.forms.resize(count);
    std::vector<std::size_t> zero_area(std::size_t(blocks), 0);
    parallel_for(blocks, threads, [&](int block) {
        RingFitter fitter(surface);
        const std::size_t first = std::size_t(block) * block_positions;
        for (std::size_t p = first; p < std::min(first + block_positions, count); ++p)
            fit.forms[p] = fitter.fit(std::uint32_t(p), zero_area[std::size_t(block)]);
    });
    for (const std::size_t n : zero_area) fit.zero_area_triangles += n;
    return fit;
}

} // namespace reliefbake
