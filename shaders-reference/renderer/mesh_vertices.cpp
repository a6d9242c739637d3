#include "shaders-reference/renderer/mesh_vertices.h"

#include <array>
#include <cmath>

namespace reliefbake {

namespace {

using Imath::V2d;
using Imath::V2f;
using Imath::V3d;
using Imath::V3f;
using Imath::V4d;
using Imath::V4f;

template <class V>
bool is_finite(const V& v) {
    for (unsigned k = 0; k < V::dimensions(); ++k)
        if (!std::isfinite(v[int(k)])) return false;
    return true;
}

template <class V>
V finite_or_zero(const V& v) {
    return is_finite(v) ? v : V(0);
}

V2f map_uv(const Mesh& mesh, std::uint32_t v) {
    const V2f uv = finite_or_zero(mesh.uvs[v]);
    return {uv.x, mesh.v_down ? uv.y : 1 - uv.y};
}

/// The frame of a vertex: x, y, z.
std::array<V3d, 3> frame_of(const Mesh& mesh, std::uint32_t v) {
    const V3d normal(mesh.normals[v]), tangent(V3d(mesh.tangents[v].x, mesh.tangents[v].y, mesh.tangents[v].z));
    return {tangent, normal.cross(tangent) * (mesh.tangents[v].w < 0 ? -1.0 : 1.0), normal};
}

/// Adds a triangle's chart to that of a vertex, times its area in the map of the vertex's frame.
void add_chart(const Mesh& mesh, const Triangle& triangle, std::uint32_t v, V4d& sum, double& weight) {
    const std::array<V3d, 3> frame = frame_of(mesh, v);
    const auto flat = [&](std::uint32_t to, std::uint32_t from) {
        const V3d edge = mesh.positions[to] - mesh.positions[from];
        return V2d(edge.dot(frame[0]), edge.dot(frame[1]));
    };
    const V2d p = flat(triangle[1], triangle[0]), q = flat(triangle[2], triangle[0]);
    const V2d s(map_uv(mesh, triangle[1]) - map_uv(mesh, triangle[0])), t(map_uv(mesh, triangle[2]) - map_uv(mesh, triangle[0]));
    const double area = p.x * q.y - p.y * q.x, size = p.length() * q.length();
    if (!(std::fabs(area) > 1e-6 * size)) return; // a sliver says nothing
    const double sign = area < 0 ? -1 : 1;
    sum += V4d(s.x * q.y - t.x * p.y, t.x * p.x - s.x * q.x, s.y * q.y - t.y * p.y, t.y * p.x - s.y * q.x) * sign;
    weight += std::fabs(area);
}

std::vector<V4f> charts_of(const Mesh& mesh) {
    std::vector<V4d> sums(mesh.positions.size(), V4d(0));
    std::vector<double> weights(mesh.positions.size(), 0);
    for (const Triangle& triangle : mesh.triangles)
        for (const std::uint32_t v : triangle) {
            V4d sum(0);
            double weight = 0;
            add_chart(mesh, triangle, v, sum, weight);
            if (is_finite(sum) && std::isfinite(weight)) sums[v] += sum, weights[v] += weight;
        }
    std::vector<V4f> means(sums.size(), V4f(0));
    for (std::size_t v = 0; v < sums.size(); ++v)
        if (weights[v] > 0) means[v] = finite_or_zero(V4f(sums[v] / weights[v]));
    return means;
}

/// How u (axis 0) and v (1) bend over each vertex: their second derivatives xx, xy, yy in its frame, the mean over its triangles by area.
/// A triangle has the gradients of its corners as vectors in space; seen from the vertex's frame their differences are the bend, and the
/// turn of the corners' own frames is in them.
std::vector<V3f> chart_bends(const Mesh& mesh, const std::vector<V4f>& charts, int axis) {
    std::vector<V3d> sums(mesh.positions.size(), V3d(0));
    std::vector<double> weights(mesh.positions.size(), 0);
    const auto gradient = [&](std::uint32_t v) {
        const auto [x, y, z] = frame_of(mesh, v);
        return x * double(charts[v][2 * axis]) + y * double(charts[v][2 * axis + 1]);
    };
    for (const Triangle& triangle : mesh.triangles) {
        const V3d origin = mesh.positions[triangle[0]], start = gradient(triangle[0]);
        const V3d p = mesh.positions[triangle[1]] - origin, q = mesh.positions[triangle[2]] - origin;
        const V3d g = gradient(triangle[1]) - start, h = gradient(triangle[2]) - start;
        for (const std::uint32_t v : triangle) {
            const auto [x, y, z] = frame_of(mesh, v);
            const double px = p.dot(x), py = p.dot(y), qx = q.dot(x), qy = q.dot(y), area = px * qy - py * qx;
            if (!(std::fabs(area) > 1e-6 * p.length() * q.length())) continue;
            const double gx = g.dot(x), gy = g.dot(y), hx = h.dot(x), hy = h.dot(y);
            const double sign = area < 0 ? -1 : 1;
            const V3d bend(gx * qy - hx * py, 0.5 * (px * hx - qx * gx + gy * qy - hy * py), px * hy - qx * gy);
            if (!is_finite(bend)) continue;
            sums[v] += bend * sign, weights[v] += std::fabs(area);
        }
    }
    std::vector<V3f> means(sums.size(), V3f(0));
    for (std::size_t v = 0; v < sums.size(); ++v)
        if (weights[v] > 0) means[v] = finite_or_zero(V3f(sums[v] / weights[v]));
    return means;
}

} // namespace

Result<std::vector<MeshVertex>> mesh_vertices(const Mesh& mesh) {
    if (mesh.uvs.empty()) return fail(ErrorCode::usage, "the mesh has no texture coordinates: no map can lie on it");
    if (mesh.normals.empty() || mesh.tangents.empty())
        return fail(ErrorCode::usage, "the mesh has no normals and tangents at its vertices; `reliefbake quadric` gives them");
    const std::vector<V4f> charts = charts_of(mesh);
    const std::vector<V3f> bends_u = chart_bends(mesh, charts, 0), bends_v = chart_bends(mesh, charts, 1);
    std::vector<MeshVertex> vertices;
    vertices.reserve(3 * mesh.triangles.size());
    for (const Triangle& triangle : mesh.triangles) {
        bool finite = true;
        for (const std::uint32_t v : triangle) finite = finite && is_finite(V3f(mesh.positions[v]));
        if (!finite) continue;
        for (const std::uint32_t v : triangle) {
            Quadric quadric = mesh.quadrics.empty() ? Quadric() : mesh.quadrics[v];
            if (!is_finite(V3f(quadric.a, quadric.b, quadric.c))) quadric = {};
            vertices.push_back({V3f(mesh.positions[v]), finite_or_zero(mesh.normals[v]), finite_or_zero(mesh.tangents[v]), map_uv(mesh, v), quadric, charts[v], bends_u[v], bends_v[v]});
        }
    }
    return vertices;
}

} // namespace reliefbake
