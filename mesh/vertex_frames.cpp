#include "mesh/vertex_frames.h"

#include "mesh/tangent_space.h"

#include <algorithm>
#include <cmath>

namespace reliefbake {

namespace {

using Imath::V3d;
using Imath::V3f;
using Imath::V4f;

V3d xyz(const V4f& v) { return {v.x, v.y, v.z}; }

/// Unit vector, or 0 where there is no direction.
V3d unit(const V3d& v) {
    const double length = v.length();
    return length > 0 && std::isfinite(length) ? v / length : V3d(0);
}

const SurfaceForm& form_of(std::uint32_t vertex, const Weld& weld, const SurfaceFit& fit) {
    static const SurfaceForm flat{V3d(0), 0, 0, 0, 0, no_normal};
    const std::uint32_t position = weld.position_of[vertex];
    return position == no_position ? flat : fit.forms[position];
}

/// A vertex like another, at the end.
std::uint32_t append_copy(Mesh& mesh, std::vector<std::uint32_t>& source, std::uint32_t vertex) {
    const auto copy = [&](auto& values) {
        if (!values.empty()) values.push_back(decltype(values.back())(values[vertex]));
    };
    copy(mesh.positions), copy(mesh.normals), copy(mesh.uvs), copy(mesh.tangents);
    source.push_back(source[vertex]);
    return std::uint32_t(mesh.positions.size() - 1);
}

/// Brings tangents from corners to vertices; a vertex with several gets copies, one for each.
void take_corner_tangents(Mesh& mesh, std::vector<std::uint32_t>& source, const std::vector<V4f>& corners) {
    constexpr std::uint32_t none = 0xffffffff;
    mesh.tangents.assign(mesh.positions.size(), V4f(0));
    std::vector<std::uint8_t> taken(mesh.positions.size(), 0);
    std::vector<std::uint32_t> next_copy(mesh.positions.size(), none);
    for (std::size_t corner = 0; corner < corners.size(); ++corner) {
        std::uint32_t& vertex = mesh.triangles[corner / 3][corner % 3];
        if (corners[corner] == V4f(0)) continue; // any of its copies will do
        constexpr int most_compared = 64; // a hub of a million tangents must not cost their square
        const std::uint32_t first = vertex;
        std::uint32_t v = first;
        for (int k = 0; v != none && taken[v] && mesh.tangents[v] != corners[corner]; ++k) v = k < most_compared ? next_copy[v] : none;
        if (v == none) { // the newest copy stands first
            v = append_copy(mesh, source, first);
            next_copy.push_back(next_copy[first]), taken.push_back(0);
            next_copy[first] = v;
        }
        mesh.tangents[v] = corners[corner];
        taken[v] = 1;
        vertex = v;
    }
}

/// Vectors that a file gives as unit and perpendicular are so to this; they stay bit for bit.
constexpr double close_enough = 1e-3;

/// The vertex's tangent across its normal, or 0.
V4f straighten(const V4f& tangent, const V3f& normal) {
    const V3d n(normal), t = xyz(tangent);
    if (std::fabs(t.length() - 1) < close_enough && std::fabs(t.dot(n)) < close_enough && std::fabs(tangent.w) == 1) return tangent;
    constexpr double smallest = 1e-3; // sine of the angle to the normal: below it float tangents are noise
    const V3d direction = unit(t), flat = direction - n * n.dot(direction);
    if (!(flat.length() > smallest)) return V4f(0);
    const V3d result = flat.normalized();
    return {float(result.x), float(result.y), float(result.z), tangent.w < 0 ? -1.0f : 1.0f};
}

} // namespace

std::size_t complete_normals(Mesh& mesh, const Weld& weld, const SurfaceFit& fit) {
    const bool given = !mesh.normals.empty();
    mesh.normals.resize(mesh.positions.size(), V3f(0));
    std::size_t made = 0;
    for (std::uint32_t v = 0; v < mesh.normals.size(); ++v) {
        V3d normal = given ? V3d(mesh.normals[v]) : V3d(0);
        if (std::fabs(normal.length() - 1) < close_enough) continue;
        normal = unit(normal);
        if (normal == V3d(0)) {
            ++made;
            normal = form_of(v, weld, fit).normal;
            if (normal == V3d(0)) normal = V3d(0, 0, 1);
        }
        mesh.normals[v] = V3f(normal);
    }
    return made;
}

V3d principal_direction(const SurfaceForm& form) {
    const TangentBasis basis = tangent_basis(form.normal);
    const double difference = form.xx - form.yy, size = std::fabs(form.xx) + std::fabs(form.yy) + std::fabs(form.xy);
    const double spread = std::sqrt(difference * difference + form.xy * form.xy);
    constexpr double alike = 1e-6;
    V3d direction = basis.x;
    if (spread > alike * size) {
        // The eigenvector of the eigenvalue that is larger in size, from the better conditioned row.
        const double sum = form.xx + form.yy, eigenvalue = (sum + (sum < 0 ? -spread : spread)) / 2;
        const double u = eigenvalue - form.yy, v = eigenvalue - form.xx;
        direction = unit(std::fabs(u) > std::fabs(v) ? basis.x * u + basis.y * (form.xy / 2) : basis.x * (form.xy / 2) + basis.y * v);
    }
    int largest = 0;
    for (int k = 1; k < 3; ++k)
        if (std::fabs(direction[k]) > std::fabs(direction[largest])) largest = k;
    return direction[largest] < 0 ? -direction : direction;
}

void complete_tangents(Mesh& mesh, std::vector<std::uint32_t>& source, FrameKind kind, const Weld& weld, const SurfaceFit& fit,
                       QuadricCounts& counts) {
    const std::size_t before = mesh.positions.size();
    if (kind == FrameKind::uv) take_corner_tangents(mesh, source, tangent_space(mesh, weld));
    if (kind == FrameKind::principal) mesh.tangents.assign(before, V4f(0));
    counts.split_vertices = mesh.positions.size() - before;
    for (std::uint32_t v = 0; v < mesh.tangents.size(); ++v) {
        // The standard's own tangents stay bit for bit.
        V4f tangent = kind == FrameKind::uv ? mesh.tangents[v] : straighten(mesh.tangents[v], mesh.normals[v]);
        if (tangent == V4f(0)) {
            counts.made_tangents += kind != FrameKind::principal;
            SurfaceForm form = form_of(source[v], weld, fit);
            if (form.normal == V3d(0)) form.normal = V3d(mesh.normals[v]);
            const V3d direction = principal_direction(form);
            tangent = straighten({float(direction.x), float(direction.y), float(direction.z), 1}, mesh.normals[v]);
            if (tangent == V4f(0)) { // the vertex's normal lies along the surface
                const V3d other = tangent_basis(V3d(mesh.normals[v])).x;
                tangent = {float(other.x), float(other.y), float(other.z), 1};
            }
        }
        mesh.tangents[v] = tangent;
        counts.mirrored += tangent.w < 0;
    }
}

Quadric turn_into_frame(const SurfaceForm& form, const V3f& normal, const V4f& tangent) {
    if (form.normal == V3d(0)) return {};
    const V3d n(normal), t = xyz(tangent), b = n.cross(t) * double(tangent.w);
    const double side = n.dot(form.normal) < 0 ? -1 : 1; // z along the vertex's normal

    // Lay the frame onto the surface's own tangent plane, by the axis that leans less.
    const V3d flat_t = t - form.normal * form.normal.dot(t), flat_b = b - form.normal * form.normal.dot(b);
    const double turn = side * double(tangent.w);
    const bool by_tangent = flat_t.dot(flat_t) >= flat_b.dot(flat_b);
    const V3d x = by_tangent ? flat_t.normalized() : flat_b.normalized().cross(form.normal) * turn;
    const V3d y = by_tangent ? form.normal.cross(x) * turn : flat_b.normalized();

    const TangentBasis basis = tangent_basis(form.normal);
    const double x1 = x.dot(basis.x), x2 = x.dot(basis.y), y1 = y.dot(basis.x), y2 = y.dot(basis.y);
    const double a = form.xx * x1 * x1 + form.yy * x2 * x2 + form.xy * x1 * x2;
    const double b_term = form.xx * y1 * y1 + form.yy * y2 * y2 + form.xy * y1 * y2;
    const double c = 2 * (form.xx * x1 * y1 + form.yy * x2 * y2) + form.xy * (x1 * y2 + x2 * y1);
    return {float(side * a), float(side * b_term), float(side * c)};
}

} // namespace reliefbake
