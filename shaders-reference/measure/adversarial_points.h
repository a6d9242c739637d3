#pragma once
// Points and directions in which a cone map is most likely to be wrong.

#include "shaders-reference/measure/random.h"
#include "bake/cone.h"
#include "shaders-reference/oracle/cone_constraint.h"

#include <vector>

namespace reliefbake {

struct MapPoint {
    double u, v;
};

/// Draws points of seven kinds in turn: anywhere, texel centres, cell centres, edges, 1e-6 texels off an edge, the
/// steepest cells, and near local minima.
class AdversarialPoints {
  public:
    explicit AdversarialPoints(const BilinearSurface& surface);

    MapPoint draw(std::uint64_t index, SplitMix& random) const;

  private:
    MapPoint at(double x, double y) const; ///< from texel units
    MapPoint near_minimum(SplitMix& random) const;

    const BilinearSurface& surface_;
    std::vector<MapPoint> steep_cells_; ///< texel indices of the cells with the greatest rise between corners
};

/// Directions to try from a point whose cone has `ratio`.
void adversarial_headings(const BilinearSurface& surface, const MapPoint& point, double ratio, Metric metric,
                          SplitMix& random, std::vector<Heading>& headings);

} // namespace reliefbake
