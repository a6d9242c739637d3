#pragma once
// Slow truth by another road: the height distributional distance transform (Paglieroni and Petersen 1994; MATHS section 5, rho).
// For each of the 256 levels of an 8-bit map, one exact distance transform to the texels above it: no cone is ever searched.

#include "bake/cone.h"

#include <vector>

namespace reliefbake::test {

/// Exact distance of each texel centre to the nearest one in `set`, texture widths; infinite where there is none.
/// Distances go around repeated axes (Felzenszwalb and Huttenlocher 2012 along rows, both metrics).
Image<double> distance_transform(const Image<char>& set, const TexelGrid& grid, Metric metric);

class HeightDistances {
  public:
    /// `depth` must be of 8 bits.
    HeightDistances(const DepthMap& depth, Metric metric);

    /// rho: distance from the centre of texel (i, j) to the nearest one higher than `height`.
    double to_higher(int i, int j, double height) const;

    /// Cone of texel centres whose apex stands `lift` (1 - h) of height above texel (i, j): min over levels z of rho(z) / (z - apex),
    /// z just below each level, capped.
    double cone(int i, int j, double lift, double ratio_max) const;

  private:
    static constexpr int levels = 255; ///< [k]: to texels of depth code k or less; code 255 is never above anything
    const DepthMap& depth_;
    std::vector<Image<double>> distance_;
};

} // namespace reliefbake::test
