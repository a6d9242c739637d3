#pragma once
// Triangles with one set of attributes a vertex, as GPUs draw them.

#include <Imath/ImathVec.h>

#include <array>
#include <cstdint>
#include <vector>

namespace reliefbake {

/// z = a x² + b y² + c x y over the tangent plane of a vertex: x along its tangent, y along its bitangent, z along its
/// outward normal, so a convex surface has negative a and b (a sphere of radius R: -1/(2R)). Unit: 1 / the mesh's unit.
struct Quadric {
    float a = 0, b = 0, c = 0;
};

using Triangle = std::array<std::uint32_t, 3>; ///< vertices, counter-clockwise from outside

/// Each attribute is empty or holds one value a vertex; `triangles` name vertices that exist (a reader's duty). Numbers
/// may be anything, NaN too.
struct Mesh {
    std::vector<Imath::V3d> positions; ///< double: text files far from the origin lose their curvature in float
    std::vector<Imath::V3f> normals;   ///< as the file gives them: any length
    std::vector<Imath::V2f> uvs;
    std::vector<Imath::V4f> tangents;  ///< xyz, and the sign of the bitangent: sign * cross(normal, tangent)
    std::vector<Quadric> quadrics;     ///< in the frame that normals and tangents span
    std::vector<Triangle> triangles;
    bool v_down = false; ///< uv (0, 0) is the image's top left corner (glTF), not its bottom left (OBJ, PLY)
};

} // namespace reliefbake
