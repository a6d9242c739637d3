#pragma once
// The curvature of a mesh at each of its positions, by least squares over the ring of neighbours.

#include "mesh/corner_lists.h"
#include "mesh/mesh.h"
#include "mesh/weld.h"

namespace reliefbake {

/// What was unusual about a position; several may hold.
enum PositionFlag : std::uint16_t {
    isolated = 1,        ///< no triangle: the quadric is 0
    no_normal = 2,       ///< its triangles' normals cancel or have no length: 0
    boundary = 4,        ///< an edge with one triangle
    non_manifold = 8,    ///< an edge with more than two triangles, or two that run the same way; or several open fans
    low_valence = 16,    ///< 1 to 3 neighbours
    second_ring = 32,    ///< the neighbours' neighbours were taken too: the ring alone cannot carry five terms
    short_rank = 64,     ///< even so: the shortest solution
};

/// z = xx x² + yy y² + xy x y in the basis of `tangent_basis(normal)`.
struct SurfaceForm {
    Imath::V3d normal{0};
    double xx = 0, yy = 0, xy = 0;
    float residual = 0; ///< root mean square of the ring's heights that the fit leaves, over the ring's radius
    std::uint16_t flags = 0;
};

/// Two unit vectors that make a right-handed basis with the unit vector `normal` (Duff et al., Building an Orthonormal
/// Basis, Revisited, JCGT 2017).
struct TangentBasis {
    Imath::V3d x, y;
};
TangentBasis tangent_basis(const Imath::V3d& normal);

/// Welded positions, scaled by a power of two to a box of about 1 (so that squares of tiny and huge units stay in range),
/// and the triangles around each.
struct WeldedSurface {
    Weld weld;
    CornerLists lists;
    LargeArray<Imath::V3d> points; ///< for each position: its coordinates times `scale`
    double scale = 1;
};
WeldedSurface weld_surface(const Mesh& mesh, int threads);

struct SurfaceFit {
    LargeArray<SurfaceForm> forms; ///< for each position
    std::size_t zero_area_triangles = 0;
};

/// The normal is the mean of the triangles' by Max's weights (Weights for Computing Vertex Normals from Facet Normals,
/// 1999), exact where the neighbours lie on a sphere with the position. The fit has five terms: three quadratic, and two linear that take up the
/// normal's error. Rings that cannot carry five take in their neighbours' neighbours; if these cannot either, the shortest
/// solution counts. The same bits for every number of threads; scaling the mesh by a power of two scales the forms exactly.
SurfaceFit fit_surface(const WeldedSurface& surface, int threads);

} // namespace reliefbake
