#pragma once
// How a map lies on a mesh. Oracle and renderer share the description and nothing else.

namespace reliefbake {

/// How a map lies on a mesh.
struct MeshRelief {
    double depth_scale = 0.1;            ///< from the top, which is the mesh, to the floor, in the mesh's unit, >= 0 (Sz)
    double tiles_u = 1, tiles_v = 1;     ///< repeats of the map over one unit of the mesh's texture coordinates (Tx, Ty)
};

} // namespace reliefbake
