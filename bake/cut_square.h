#pragma once
// A texel that a shape covers in part, as a square cut by one straight edge: S. Gustavson, R. Strand, "Anti-aliased Euclidean distance
// transform" (2011).

#include "bake/image.h"
#include "bake/texel_grid.h"

#include <array>

namespace reliefbake {

/// The points p of the square [-1/2, 1/2]^2, texels around its centre, with nx x + ny y <= reach; (nx, ny) has length 1 and points out
/// of the shape. Whole where reach is large.
struct CutSquare {
    double nx = 1, ny = 0, reach = 1;

    bool is_whole() const { return reach >= 0.70710678118654757; }
    bool holds(double x, double y) const { return nx * x + ny * y <= reach; }
    /// Of what is left the nearest point to one in texels around the square's centre; the point itself within it.
    std::array<double, 2> nearest(double x, double y) const;
    double distance(double x, double y) const; ///< to that point
};

/// The cut of a texel with coverage in (0, 1], across the gradient of the coverage around it, such that what is left has the coverage
/// as area. A texel with no gradient, or at a
/// clamped border, stays whole.
CutSquare cut_square(const Image<float>& coverage, const TexelGrid& grid, int x, int y);

} // namespace reliefbake
