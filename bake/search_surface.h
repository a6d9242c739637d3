#pragma once
// What the two halves of the cone bake share: heights and slopes in the search's own units.

#include "bake/cone.h"
#include "bake/height_field.h"
#include "bake/image.h"

namespace reliefbake {

/// The stored surface in search units: heights are *stored levels*, negated (exact, no rounding), distances are in
/// texels along x (a row is pixel_aspect texels high). A slope is levels per texel; a cone's ratio is its inverse.
struct SearchSurface {
    TexelGrid grid;
    Metric metric;
    SurfaceModel model;
    Image<float> height;
    float slope_floor; ///< the slope of the widest cone: no slope below it is of interest

    /// Squared L2 distances between lattice points shrink by this much (texels^2) when the bilinear surface between
    /// them is meant: docs/SAFETY.md, "Deflated distances". 0 where lattice distances are exact.
    float distance_deflation() const;
    /// Whether a texel's cone must hold in the four cells around it, and so over its 3x3 texels.
    bool has_footprint() const { return model == SurfaceModel::bilinear; }
};

/// Pairs of texels at most this far apart (Chebyshev, texels) are compared one by one; the pyramid serves the rest.
constexpr int near_radius = 10;

/// Slope that the near surface alone asks of each texel's cone, at least slope_floor: cells within one texel exactly,
/// half-texel lattice up to two texels, texels up to near_radius.
Image<float> near_slopes(const SearchSurface& surface, int threads);

/// Distance in texels of a displacement by (dx, dy) lattice steps, in the surface's metric, deflated.
double deflated_distance(const SearchSurface& surface, double dx, double dy);

} // namespace reliefbake
