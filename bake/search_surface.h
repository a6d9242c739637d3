#pragma once
// What the two halves of the cone bake share: heights and slopes in the search's own units.

#include "bake/cone.h"
#include "bake/height_field.h"
#include "bake/image.h"

#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace reliefbake {

/// Directions right and down the (possibly flipped) image, dx >= 0 and dy >= 0, with t0 <= dy / dx <= t1; lengths as the
/// metric counts them. The default is a whole quadrant.
struct Wedge {
    float t0 = 0, t1 = std::numeric_limits<float>::infinity();
};

/// What a ray must not meet a second time: points from which the surface falls along the wedge (docs/FAMILIES.md, relaxed).
struct ExitRule {
    float least_fall = 0;  ///< only falls steeper than this count; levels per texel
    bool from_top = false; ///< only falls that a ray from height 0 (the top) on the axis could leave through
    friend bool operator==(const ExitRule&, const ExitRule&) = default;
};

/// Texels whose cones must hold over the cells around a texel, as offsets: low..high on each axis.
struct Footprint {
    int x_low = 0, x_high = 0, y_low = 0, y_high = 0;
};

/// The stored surface in search units: heights are *stored levels*, negated (exact, no rounding), distances are in
/// texels along x (a row is pixel_aspect texels high). A slope is levels per texel; a cone's ratio is its inverse.
struct SearchSurface {
    TexelGrid grid;
    Metric metric;
    SurfaceModel model;
    Image<float> height;
    float slope_floor; ///< the slope of the widest cone: no slope below it is of interest
    Image<float> apex; ///< where cones stand, nowhere below `height`; empty: on it
    std::optional<Wedge> wedge;    ///< none: all directions
    std::optional<ExitRule> exits; ///< none: every point counts. Needs a wedge
    Footprint footprint;           ///< of one stored cone

    /// Squared L2 distances between lattice points shrink by this much (texels^2) when the bilinear surface between
    /// them is meant: docs/SAFETY.md, "Deflated distances". 0 where lattice distances are exact.
    float distance_deflation() const;
    /// Length of one texel's diagonal: how much farther apart than two texels points of cells around them can be.
    double widest_step() const;
    /// On a clamped border the surface goes on beyond the last texel, and that texel's cone serves there too.
    Footprint footprint_at(int x, int y) const {
        Footprint f = footprint;
        if (has_footprint() && grid.wrap_x == Wrap::clamp) f.x_low = x == 0 ? -1 : f.x_low, f.x_high = x == grid.width - 1 ? 1 : f.x_high;
        if (has_footprint() && grid.wrap_y == Wrap::clamp) f.y_low = y == 0 ? -1 : f.y_low, f.y_high = y == grid.height - 1 ? 1 : f.y_high;
        return f;
    }
    bool has_footprint() const { return footprint.x_low != footprint.x_high; }
    const Image<float>& apexes() const { return apex.empty() ? height : apex; }
};

/// Pairs of texels at most this far apart (Chebyshev, texels) are compared one by one; the pyramid serves the rest.
constexpr int near_radius = 10;

/// Slope that the near surface alone asks of each texel's cone, at least slope_floor: cells within one texel exactly,
/// half-texel lattice up to two texels, texels up to near_radius.
Image<float> near_slopes(const SearchSurface& surface, int threads);

/// The bounds of a texel depend on the block it is in: one of near_block_rows rows (fewer at the bottom), counted from row 0.
constexpr int near_block_rows = 64;

/// The same slopes for some rows of blocks alone; row k of block row b is that of texels b near_block_rows + k.
std::vector<Image<float>> near_slopes_of_block_rows(const SearchSurface& surface, std::span<const int> block_rows, int threads);

/// Distance in texels of a displacement by (dx, dy) lattice steps, in the surface's metric, deflated.
double deflated_distance(const SearchSurface& surface, double dx, double dy);

/// Whether a displacement by lattice steps between corners of two cells belongs to the wedge for some points of those cells:
/// corners differ from the points' displacement by less than one step an axis, and never in sign (monotone coupling).
bool is_in_wedge(const SearchSurface& surface, double dx, double dy);

} // namespace reliefbake
