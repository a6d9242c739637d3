#pragma once
// The truth of curved relief: the mesh itself, really displaced. It looks at the height alone, never at cones or quadrics.
//
//   P = B - depth_scale (1 - h(u, v)) n
//
// B: a point of a flat triangle; n: its vertices' normals, interpolated and made unit, as a rasteriser's shader has them; h: the bilinear
// relief. So a coarse mesh displaces its own flat triangles, not the smooth surface that somebody meant by it; from 64 segments around on
// the two differ by 1.2 thousandths of the radius.

#include "bake/error.h"
#include "mesh/mesh.h"
#include "shaders-reference/mesh_relief.h"
#include "shaders-reference/oracle/bilinear_surface.h"

#include <functional>
#include <span>

namespace reliefbake {

struct DisplacedVertex {
    Imath::V3f position;
    Imath::V3f normal; ///< unit, of the relief
    Imath::V2f uv;     ///< in maps, unwrapped, v down: (tiles_u u, tiles_v v)
};

struct DisplaceOptions {
    double longest_edge = 1;       ///< texels that an edge may cover, > 0
    std::size_t batch = 1 << 16;   ///< triangles handed over at a time, at least 1
    std::uint64_t most_triangles = std::uint64_t(1) << 28; ///< refuses to make more
};

/// Takes triangles, three vertices each, counter-clockwise from outside as the mesh's own.
using TriangleSink = std::function<void(std::span<const DisplacedVertex>)>;

/// Hands over the displaced mesh in batches; nothing else of it is held. Two triangles that share an edge, and its normals, share every
/// vertex on it to the last bit, across a seam of the texture too where the map repeats into itself; edges whose copies differ in
/// normal or height part, as they do on the GPU. Triangles with a coordinate that is not finite are left out. The mesh must have
/// unit normals and texture coordinates. Returns the number of triangles. Errors (budget): more than `most_triangles`.
Result<std::uint64_t> displace(const Mesh& mesh, const BilinearSurface& relief, const MeshRelief& how, const DisplaceOptions& options,
                               const TriangleSink& sink);

} // namespace reliefbake
