#pragma once
// Meshes of surfaces whose curvature is known in closed form.

#include "mesh/mesh.h"

#include <Imath/ImathMatrix.h>

#include <string>
#include <vector>

namespace reliefbake {

/// F(p) = 0 with gradient and second derivatives; F grows outward.
struct ImplicitSurface {
    std::string name;
    Imath::V3d (*gradient)(const Imath::V3d&);
    Imath::M33d (*hessian)(const Imath::V3d&);
};

/// Second fundamental form at a point of the surface, z along the outward normal: II(u, v) = -u H v / |gradient|.
double second_form(const ImplicitSurface& surface, const Imath::V3d& point, const Imath::V3d& u, const Imath::V3d& v);
/// The quadric that the surface has over unit tangents x and y at the point: a = II(x,x)/2, b = II(y,y)/2, c = II(x,y).
struct ExactQuadric {
    double a, b, c;
};
ExactQuadric exact_quadric(const ImplicitSurface& surface, const Imath::V3d& point, const Imath::V3d& x, const Imath::V3d& y);
/// Unit direction of the curvature that is larger in size; any tangent where both are equal.
Imath::V3d strongest_direction(const ImplicitSurface& surface, const Imath::V3d& point);

struct SurfaceMesh {
    ImplicitSurface surface;
    Mesh mesh; ///< positions and triangles; tangents when made with turned frames
};

/// "sphere", "ellipsoid" (subdivided icosahedra), "torus", "cylinder", "saddle" (grids; the last two are open). `detail` doubles
/// the number of vertices along an edge with each step from 0. Irregular: vertices moved along the surface by up to a quarter of an edge, at
/// random but always the same.
const std::vector<std::string>& surface_names();
SurfaceMesh make_surface(const std::string& name, int detail, bool irregular);

/// A torus of `rings` x `sides` vertices.
Mesh make_torus(int rings, int sides);

/// Gives the mesh tangents that are turned by `degrees` from the strongest direction, about the exact normal.
void set_turned_tangents(SurfaceMesh& surface, double degrees);

} // namespace reliefbake
