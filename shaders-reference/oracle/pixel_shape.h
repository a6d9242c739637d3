#pragma once
// A shape as its pixel squares, and the exact distance to it (MATHS section 6). It never sees a distance map.

#include "bake/binary_shape.h"
#include "bake/cut_square.h"
#include "bake/image.h"
#include "bake/texel_grid.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace reliefbake {

/// A point of the plane and how far it is, texture widths; infinite where there is none.
struct NearestPoint {
    double distance = std::numeric_limits<double>::infinity();
    double u = 0, v = 0; ///< unwrapped
};

/// The union of closed pixel squares [i, i+1] x [j, j+1] / size, whole or cut, or their centres alone (ShapeModel). On a repeated axis the pattern goes on for
/// ever, beyond a clamped border there is nothing. Distances: texture widths, |(du, dv)|^2 = du^2 + (aspect dv)^2; double precision.
class PixelShape {
  public:
    /// inside(i, j) != 0: that square belongs to the shape. `model`: squares or centres.
    PixelShape(const TexelGrid& grid, const Image<std::uint8_t>& inside, ShapeModel model = ShapeModel::squares);
    /// ShapeModel::contour: `coverage` is the part of each texel, 0 to 1, that is inside; texels are square. Of a square with a part, cut_square says which.
    PixelShape(const TexelGrid& grid, Image<float> coverage);

    const TexelGrid& grid() const { return grid_; }

    /// Whether (u, v) is in the shape; of a point between two squares, the right or lower one says. Centres hold nothing.
    bool contains(double u, double v) const;
    /// The nearest point of the squares, or parts of squares, or centres inside, or of those outside (clamped axes: of the map's own).
    NearestPoint nearest(double u, double v, bool inside) const;
    /// Distance to the shape outside of it, minus the distance to the squares outside within it. +inf: an empty shape; -inf: a
    /// full one. Within the map it changes by no more than the way gone.
    double signed_distance(double u, double v) const;

  private:
    /// What a block of the pyramid holds: bits.
    enum : std::uint8_t { has_outside = 1, has_inside = 2, cut = has_outside | has_inside };

    void build_pyramid(Image<std::uint8_t> squares);
    CutSquare cut_at(int i, int j, bool inside) const;

    TexelGrid grid_;
    double margin_ = 0; ///< of a square, on each side: 0, or 1/2 for centres
    Image<float> coverage_; ///< of a contour
    std::vector<Image<std::uint8_t>> levels_; ///< [k]: blocks of 2^k x 2^k squares
};

} // namespace reliefbake
