#include "shaders-reference/renderer/mesh_vertices.h"

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

/// Adds a triangle's chart to that of a vertex, times its area in the map of the vertex's frame.
void add_chart(const Mesh& mesh, const Triangle& triangle, std::uint32_t v, V4d& sum, double& weight) {
    const V3d normal(mesh.normals[v]), tangent(V3d(mesh.tangents[v].x, mesh.tangents[v].y, mesh.tangents[v].z));
    const V3d bitangent = normal.cross(tangent) * (mesh.tangents[v].w < 0 ? -1.0 : 1.0);
    const auto flat = [&](std::uint32_t to, std::uint32_t from) {
        const V3d edge = mesh.positions[to] - mesh.positions[from];
        return V2d(edge.dot(tangent), edge.dot(bitangent));
    };
    const V2d p = flat(triangle[1], triangle[0]), q = flat(triangle[2], triangle[0]);
    const V2d s(map_uv(mesh, triangle[1]) - map_uv(mesh, triangle[0])), t(map_uv(mesh, triangle[2]) - map_uv(mesh, triangle[0]));
    const double area = p.x * q.y - p.y * q.x, size = p.length() * q.length();
    if (!(std::fabs(area) > 1e-6 * size)) return; // a sliver says nothing
    const double sign = area < 0 ? -1 : 1;
    sum += V4d(s.x * q.y - t.x * p.y, t.x * p.x - s.x * q.x, s.y * q.y - t.y * p.y, t.y * p.x - s.y * q.x) * sign;
    weight += std::fabs(area);
}

std::vector<V4f> charts(const Mesh& mesh) {
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

} // namespace

Result<std::vector<MeshVertex>> mesh_vertices(const Mesh& mesh) {
    if (mesh.uvs.empty()) return fail(ErrorCode::usage, "the mesh has no texture coordinates: no map can lie on it");
    if (mesh.normals.empty() || mesh.tangents.empty())
        return fail(ErrorCode::usage, "the mesh has no normals and tangents at its vertices; `reliefbake quadric` gives them");
    const std::vector<V4f> chart = charts(mesh);
    std::vector<MeshVertex> vertices;
    vertices.reserve(3 * mesh.triangles.size());
    for (const Triangle& triangle : mesh.triangles) {
        bool finite = true;
        for (const std::uint32_t v : triangle) finite = finite && is_finite(V3f(mesh.positions[v]));
        if (!finite) continue;
        for (const std::uint32_t v : triangle) {
            Quadric quadric = mesh.quadrics.empty() ? Quadric() : mesh.quadrics[v];
            if (!is_finite(V3f(quadric.a, quadric.b, quadric.c))) quadric = {};
            vertices.push_back({V3f(mesh.positions[v]), finite_or_zero(mesh.normals[v]), finite_or_zero(mesh.tangents[v]), map_uv(mesh, v), quadric, chart[v]});
        }
    }
    return vertices;
}

} // namespace reliefbake
