#pragma once
// The surface that a sampler with exact weights shows: the bilinear interpolant of the stored depth (MATHS section 1).

#include "bake/height_field.h"
#include "bake/image.h"
#include "bake/texel_grid.h"

#include <cstdint>
#include <vector>

namespace reliefbake {

/// One bilinear patch: the heights at its corners, named h(column)(row).
struct Patch {
    double h00, h10, h01, h11;

    /// Height at (x, y); [0,1]^2 is the cell. Constant patches stay constant at any x, y.
    double height(double x, double y) const { return h00 + (h10 - h00) * x + (h01 - h00) * y + twist() * x * y; }
    /// The coefficient of x y.
    double twist() const { return (h00 - h10) + (h11 - h01); }
    /// Slope per texel along (dx, dy) at (x, y).
    double slope(double x, double y, double dx, double dy) const {
        return (h10 - h00 + twist() * y) * dx + (h01 - h00 + twist() * x) * dy;
    }
    /// H(x + s dx, y + s dy) = height(x, y) + slope(x, y, dx, dy) s + curvature(dx, dy) s^2.
    double curvature(double dx, double dy) const { return twist() * dx * dy; }
    double highest() const;
};

/// A block of cells [x_low, x_high) x [y_low, y_high), unwrapped, and the height that the surface nowhere exceeds there.
/// Blocks on the border of a clamped axis reach to infinity.
struct CellBlock {
    std::int64_t x_low, x_high, y_low, y_high;
    double highest;
};

/// The bilinear surface of a stored depth map, in double precision, over the whole plane: repeated or extended
/// constantly, per axis. A cell whose four corners are holes is open: nothing is in it, and no floor below it. Positions are (u, v) or, in the oracle's own walk, texel units x = u * width - 0.5, in which
/// cell (i, j) is [i, i+1] x [j, j+1].
class BilinearSurface {
  public:
    explicit BilinearSurface(const DepthMap& depth);

    const TexelGrid& grid() const { return grid_; }
    double highest() const { return highest_; }
    bool has_holes() const { return has_holes_; }
    /// Of a cell's patch; heights of holes alone are 0.
    bool is_open(const Patch& patch) const { return has_holes_ && patch.highest() == 0; }

    double height(double u, double v) const;
    /// Height of a texel, addressed as the grid says.
    double texel(std::int64_t i, std::int64_t j) const;
    Patch patch(std::int64_t i, std::int64_t j) const;

    /// Levels of the max pyramid; a block of level k spans up to 2^k cells an axis.
    int levels() const { return int(pyramid_.size()) + 1; }
    CellBlock block(std::int64_t i, std::int64_t j, int level) const;

    double to_x(double u) const { return u * grid_.width - 0.5; }
    double to_y(double v) const { return v * grid_.height - 0.5; }

  private:
    TexelGrid grid_;
    Image<double> heights_;
    std::vector<Image<float>> pyramid_; ///< [k]: highest of blocks of level k + 1, rounded up
    double highest_ = 0;
    bool has_holes_ = false;
};

} // namespace reliefbake
