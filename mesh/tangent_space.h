#pragma once
// Tangents of texture coordinates as every baker of normal maps computes them.

#include "mesh/mesh.h"
#include "mesh/weld.h"

namespace reliefbake {

/// MikkTSpace (Mikkelsen, Simulation of Wrinkled Surfaces Revisited, 2008, ch. 3, and the program that became the standard):
/// for each corner of each triangle, in the order of the triangles, a unit tangent across the vertex's normal, and the sign
/// w of sign * cross(normal, tangent). (0, 0, 0, 0) where texture coordinates give no direction: they are not finite, or
/// all triangles around have no area in the texture or in space. In single precision, as the standard. The bitangent
/// points up the image for either `v_down`. Needs normals and uvs; vertices with equal values are one.
std::vector<Imath::V4f> tangent_space(const Mesh& mesh, const Weld& weld);

} // namespace reliefbake
