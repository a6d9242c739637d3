#pragma once
// The vertices of a mesh as mesh_relief.vert takes them.

#include "bake/error.h"
#include "mesh/mesh.h"

#include <vector>

namespace reliefbake {

struct MeshVertex {
    Imath::V3f position, normal;
    Imath::V4f tangent;
    Imath::V2f uv;      ///< v down the map
    Quadric quadric;
    Imath::V4f chart;   ///< du/dx, du/dy, dv/dx, dv/dy over the vertex's frame: the mean of its triangles, by area
    Imath::V3f bend_u, bend_v; ///< second derivatives of u and of v, xx, xy, yy, per length squared
};

/// Three vertices a triangle. Triangles with a coordinate that is not finite are left out; an attribute that is not finite is 0.
/// Errors (usage): no normals, tangents or texture coordinates.
Result<std::vector<MeshVertex>> mesh_vertices(const Mesh& mesh);

} // namespace reliefbake
