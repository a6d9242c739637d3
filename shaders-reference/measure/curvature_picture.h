#pragma once
// A mesh painted by the curvature that its quadrics hold.

#include "mesh/mesh.h"
#include "shaders-reference/renderer/rendering.h"

#include <span>

namespace reliefbake {

/// Two pictures side by side, each side x side, of the meshes seen obliquely from above (y up), without perspective. Left: mean
/// curvature a + b, red where the surface bulges, blue where it is hollow. Right: Gaussian curvature K = 4ab - c², as the square root of |K| so
/// that both share a unit: red for domes and bowls, blue for saddles. Light grey is flat; full colour is the value that 95 of 100
/// vertices stay below in size, of both. Drawn by a depth buffer of its own: no OpenGL is needed. Each mesh needs normals and quadrics.
RgbImage curvature_picture(std::span<const Mesh> meshes, int side);

} // namespace reliefbake
