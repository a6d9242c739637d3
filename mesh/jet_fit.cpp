#include "mesh/jet_fit.h"

#ifdef RELIEFBAKE_CGAL

#include "bake/parallel.h"
#include "mesh/ring.h"

#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>

namespace reliefbake {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Imath::V3d;

V3d vector_of(const Kernel::Vector_3& v) { return {v.x(), v.y(), v.z()}; }

/// Keeps `form` where there are too few points.
void fit_jet(Ring& ring, const WeldedSurface& surface, std::vector<Kernel::Point_3>& points, SurfaceForm& form) {
    constexpr int degree = 2;
    constexpr std::size_t unknowns = 6;
    if (ring.neighbours().size() + 1 < unknowns && !ring.extend()) return;
    const V3d here = surface.points[ring.position()];
    points.assign(1, {0, 0, 0});
    for (const std::uint32_t neighbour : ring.neighbours()) {
        const V3d d = surface.points[neighbour] - here;
        points.emplace_back(d.x, d.y, d.z);
    }
    if (points.size() < unknowns) return;
    CGAL::Monge_via_jet_fitting<Kernel> fitter;
    auto monge = fitter(points.begin(), points.end(), degree, degree);
    monge.comply_wrt_given_normal({form.normal.x, form.normal.y, form.normal.z});

    // z = (k1 x² + k2 y²) / 2 along the principal directions, in our basis.
    form.normal = vector_of(monge.normal_direction()).normalized();
    const TangentBasis basis = tangent_basis(form.normal);
    const V3d d1 = vector_of(monge.maximal_principal_direction()), d2 = vector_of(monge.minimal_principal_direction());
    const double k1 = monge.principal_curvatures(0) * surface.scale, k2 = monge.principal_curvatures(1) * surface.scale;
    const double x1 = d1.dot(basis.x), y1 = d1.dot(basis.y), x2 = d2.dot(basis.x), y2 = d2.dot(basis.y);
    form.xx = (k1 * x1 * x1 + k2 * x2 * x2) / 2;
    form.yy = (k1 * y1 * y1 + k2 * y2 * y2) / 2;
    form.xy = k1 * x1 * y1 + k2 * x2 * y2;
    form.residual = 0;
}

} // namespace

bool has_jet_fit() { return true; }

SurfaceFit fit_jets(const WeldedSurface& surface, const SurfaceFit& rings, int threads) {
    constexpr std::size_t block_positions = 1024;
    SurfaceFit fit = rings;
    parallel_for(int((fit.forms.size() + block_positions - 1) / block_positions), threads, [&](int block) {
        Ring ring(surface);
        std::vector<Kernel::Point_3> points;
        const std::size_t first = std::size_t(block) * block_positions;
        for (std::size_t p = first; p < std::min(first + block_positions, fit.forms.size()); ++p) {
            ring.gather(std::uint32_t(p));
            if (!(ring.flags() & (isolated | no_normal))) fit_jet(ring, surface, points, fit.forms[p]);
        }
    });
    return fit;
}

} // namespace reliefbake

#else

#include <cstdlib>

namespace reliefbake {

bool has_jet_fit() { return false; }

SurfaceFit fit_jets(const WeldedSurface&, const SurfaceFit&, int) { std::abort(); }

} // namespace reliefbake

#endif
