#pragma once
// The door for meshes: a half-edge mesh whose positions are finite and whose faces are manifold triangles.

#include "bake/error.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

namespace reliefbake {

/// Positions in double: a mesh far from the origin loses its curvature in float.
struct MeshTraits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
    using Normal = OpenMesh::Vec3d;
};
using TriangleMesh = OpenMesh::TriMesh_ArrayKernelT<MeshTraits>;

/// Triangles as a file gives them: nothing is checked yet.
struct TriangleSoup {
    std::vector<std::array<double, 3>> positions;
    std::vector<std::array<std::uint32_t, 3>> triangles; ///< indices into positions, counter-clockwise from outside
};

struct CheckedMesh {
    TriangleMesh mesh; ///< vertex k is position k, with or without faces
    std::size_t degenerate_triangles = 0;   ///< left out: two corners are one vertex
    std::size_t non_manifold_triangles = 0; ///< left out: they would join a third face to an edge, or turn one around
};

/// Errors: bad_data for a position that is not finite or an index out of range, with the count and the first place.
/// `name` is the file, for messages.
Result<CheckedMesh> make_mesh(const TriangleSoup& soup, const std::string& name);

} // namespace reliefbake
