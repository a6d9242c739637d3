#pragma once
// What curved relief can be at best: the rays of a shader that knows the mesh at a pixel and no more, followed without limits on steps, in
// double precision, by height alone. What still differs from the displaced mesh is the model's, not the march's.

#include "bake/image.h"
#include "mesh/mesh.h"
#include "shaders-reference/oracle/bilinear_surface.h"
#include "shaders-reference/oracle/displaced_mesh.h"
#include "shaders-reference/renderer/scene.h"

namespace reliefbake {

/// How the surface is thought to go on beside the pixel. P = t V in the pixel's frame: x, y, z along tangent, bitangent, normal.
enum class BendModel {
    flat,   ///< depth = -z: no correction
    ab,     ///< depth = a x^2 + b y^2 - z (000 formula 10; the twist is left out)
    abc,    ///< depth = a x^2 + b y^2 + c x y - z
    circle, ///< the circle with the quadric's curvature along the ray: depth = (1 - |(k s, 1 + k z)|) / k, and texture runs along its arc
};

struct QuadricMarchOptions {
    BendModel model = BendModel::abc; ///< (--bend)
    /// The map ends with the mesh's texture coordinates, at 0 and 1, on this axis: a ray that comes there above the relief falls off (--ends).
    bool ends_u = false, ends_v = false;
    int width = 1024, height = 768;
    int threads = 0; ///< as in parallel_for; the result does not depend on it
};

/// Planes of one sample a pixel, the top row first.
struct QuadricMarch {
    Image<float> distance;       ///< from the eye; +inf where no ray ends on the relief
    std::vector<Imath::V3f> normal; ///< of the relief there, unit, in the mesh's space
};

/// As a rasteriser draws: of all triangles seen from outside that cover a
/// pixel's centre the nearest hit counts. A ray ends where it first is as deep as the relief; it is discarded where it comes back to depth 0. The
/// mesh needs unit normals, texture coordinates, tangents and quadrics.
QuadricMarch march_quadrics(const Mesh& mesh, const BilinearSurface& relief, const MeshRelief& how, const Camera& camera,
                            const QuadricMarchOptions& options);

} // namespace reliefbake
