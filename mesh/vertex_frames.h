#pragma once
// The frame at each vertex: unit normal and tangent, and on which side the bitangent lies.

#include "mesh/quadric_bake.h"

namespace reliefbake {

/// Replaces normals that are missing, zero or not finite by their positions' (0, 0, 1 where these have none), and brings all
/// to unit length. Returns how many were replaced.
std::size_t complete_normals(Mesh& mesh, const Weld& weld, const SurfaceFit& fit);

/// Gives every vertex a unit tangent across its normal. For `uv`, a vertex whose triangles need several tangents is split:
/// copies are appended to mesh and `source`. Where `kind` gives none, the principal direction stands in, counted.
void complete_tangents(Mesh& mesh, std::vector<std::uint32_t>& source, FrameKind kind, const Weld& weld, const SurfaceFit& fit,
                       QuadricCounts& counts);

/// Unit direction of the strongest curvature, its largest component positive; some tangent where all directions are alike.
Imath::V3d principal_direction(const SurfaceForm& form);

/// The form over the vertex's own x and y, z along its normal.
Quadric turn_into_frame(const SurfaceForm& form, const Imath::V3f& normal, const Imath::V4f& tangent);

} // namespace reliefbake
