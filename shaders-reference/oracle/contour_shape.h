#pragma once
// An anti-aliased shape as its cut squares, and the exact distance to it. It never sees a distance map.

#include "bake/cut_square.h"

#include <vector>

namespace reliefbake {

class ContourShape {
  public:
    /// `coverage`: the part of each texel that is inside.
    ContourShape(const TexelGrid& grid, const Image<float>& coverage);

    /// Distance to the nearest point of the shape in texture widths; +inf for an empty one. Double precision.
    double distance(double u, double v) const;

    /// A point close to one of the texels that the shape cuts or fills; `pick` chooses which, `du` and `dv` are texels from its centre.
    /// The map's middle for an empty shape.
    void near_shape(std::size_t pick, double du, double dv, double& u, double& v) const;

  private:
    struct Touched {
        int x, y;
        CutSquare square;
    };

    TexelGrid grid_;
    std::vector<std::vector<Touched>> rows_; ///< by column
    std::vector<Touched> cut_;               ///< those that are not whole; all, if none is
};

} // namespace reliefbake
