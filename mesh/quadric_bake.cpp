#include "mesh/quadric_bake.h"

#include "bake/parallel.h"
#include "mesh/jet_fit.h"
#include "mesh/paper_fit.h"
#include "mesh/vertex_frames.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace reliefbake {

namespace {

Result<FrameKind> choose_frame(const Mesh& mesh, FrameKind asked, const std::string& name) {
    const bool has_uvs = !mesh.uvs.empty(), has_tangents = !mesh.tangents.empty();
    if (asked == FrameKind::uv && !has_uvs)
        return fail(ErrorCode::usage, name + ": --frame uv: the mesh has no texture coordinates; use principal, or unwrap it");
    if (asked == FrameKind::mesh && !has_tangents)
        return fail(ErrorCode::usage, name + ": --frame mesh: the mesh has no tangents; use " + (has_uvs ? "uv" : "principal"));
    if (asked != FrameKind::automatic) return asked;
    return has_tangents ? FrameKind::mesh : has_uvs ? FrameKind::uv : FrameKind::principal;
}

void count_positions(const WeldedSurface& surface, const SurfaceFit& fit, QuadricCounts& counts) {
    counts.positions = surface.points.size();
    counts.non_finite_triangles = surface.lists.non_finite_triangles;
    counts.degenerate_triangles = surface.lists.degenerate_triangles;
    counts.zero_area_triangles = fit.zero_area_triangles;
    for (const std::uint32_t place : surface.weld.position_of) counts.non_finite_vertices += place == no_position;
    for (const SurfaceForm& form : fit.forms) {
        counts.isolated += (form.flags & isolated) != 0;
        counts.no_normal += (form.flags & no_normal) != 0 && !(form.flags & isolated);
        counts.boundary += (form.flags & boundary) != 0;
        counts.non_manifold += (form.flags & non_manifold) != 0;
        counts.low_valence += (form.flags & low_valence) != 0;
        counts.second_ring += (form.flags & second_ring) != 0;
        counts.short_rank += (form.flags & short_rank) != 0;
    }
}

bool holds_floats(const Quadric& q) { return std::isfinite(q.a) && std::isfinite(q.b) && std::isfinite(q.c); }

void measure_residuals(const SurfaceFit& fit, QuadricBake& bake) {
    double squares = 0;
    for (const SurfaceForm& form : fit.forms) {
        squares += double(form.residual) * form.residual;
        bake.residual_max = std::max(bake.residual_max, double(form.residual));
    }
    if (!fit.forms.empty()) bake.residual_rms = std::sqrt(squares / double(fit.forms.size()));
}

/// The forms in each vertex's frame, whichever fit made them.
std::vector<Quadric> all_quadrics(const Mesh& mesh, const WeldedSurface& surface, const SurfaceFit& fit,
                                  const std::vector<std::uint32_t>& source, int threads) {
    constexpr std::size_t block_vertices = 8192;
    std::vector<Quadric> quadrics(mesh.positions.size());
    parallel_for(int((quadrics.size() + block_vertices - 1) / block_vertices), threads, [&](int block) {
        const std::size_t first = std::size_t(block) * block_vertices;
        for (std::size_t v = first; v < std::min(first + block_vertices, quadrics.size()); ++v) {
            const std::uint32_t position = surface.weld.position_of[source[v]];
            if (position != no_position) quadrics[v] = turn_into_frame(fit.forms[position], mesh.normals[v], mesh.tangents[v]);
        }
    });
    return quadrics;
}

/// What the frames dropped: how much of the curvature lies in c, weighed by 1/2 as in the form's Frobenius norm.
double share_of_twist(const std::vector<Quadric>& quadrics) {
    double twist = 0, all = 0;
    for (const Quadric& q : quadrics) {
        if (!holds_floats(q)) continue;
        twist += double(q.c) * q.c / 2;
        all += double(q.a) * q.a + double(q.b) * q.b + double(q.c) * q.c / 2;
    }
    return all > 0 ? std::sqrt(twist / all) : 0;
}

} // namespace

Result<QuadricBake> bake_quadrics(const Mesh& mesh, const QuadricOptions& options, const std::string& name) {
    if (options.fit == QuadricFit::jet && !has_jet_fit())
        return fail(ErrorCode::usage, "--fit jet: this build holds no CGAL, for its licence; configure with -DRELIEFBAKE_CGAL=ON, or use --fit ring");
    const Result<FrameKind> frame = choose_frame(mesh, options.frame, name);
    if (!frame) return tl::unexpected(frame.error());
    QuadricBake bake{mesh, std::vector<std::uint32_t>(mesh.positions.size()), *frame, {}};
    std::iota(bake.source.begin(), bake.source.end(), 0u);
    QuadricCounts& counts = bake.counts;
    counts.vertices = mesh.positions.size(), counts.triangles = mesh.triangles.size();

    // Fit once a position.
    const WeldedSurface surface = weld_surface(mesh, options.threads);
    SurfaceFit fit = fit_surface(surface, options.threads);
    if (options.fit == QuadricFit::jet) fit = fit_jets(surface, fit, options.threads);
    count_positions(surface, fit, counts);
    measure_residuals(fit, bake);

    // Frames.
    counts.made_normals = complete_normals(bake.mesh, surface.weld, fit);
    complete_tangents(bake.mesh, bake.source, *frame, surface.weld, fit, counts);

    // Turn the fits into them.
    std::vector<Quadric> quadrics = all_quadrics(bake.mesh, surface, fit, bake.source, options.threads);
    bake.twist_share = share_of_twist(quadrics);
    if (options.fit == QuadricFit::paper) quadrics = fit_as_printed(bake.mesh, bake.source, surface, options.threads);
    for (std::size_t v = 0; v < quadrics.size(); ++v) {
        if (!options.twist) quadrics[v].c = 0;
        if (!holds_floats(quadrics[v])) quadrics[v] = {}, ++counts.out_of_range;
        const std::uint32_t position = surface.weld.position_of[bake.source[v]];
        if (position != no_position) counts.against_winding += Imath::V3d(bake.mesh.normals[v]).dot(fit.forms[position].normal) < 0;
    }
    bake.mesh.quadrics = std::move(quadrics);
    return bake;
}

} // namespace reliefbake
