#pragma once
// A rendering judged by the oracle, ray by ray (MATHS section 9).

#include "shaders-reference/oracle/bilinear_surface.h"
#include "shaders-reference/renderer/rendering.h"

namespace reliefbake {

struct CompareOptions {
    /// Height by which a hit may lie under the true first hit's surface, or above it: 1/4096 is a sixteenth of an 8-bit level.
    double tolerance = 1.0 / 4096;
    /// Steepest slope of the surface, height per unit of u plus height per unit of v (steepest_slope). A shader's position has
    /// float32 rounding, position_rounding times its distance from the tile's corner; on a cliff that is a height, and it is
    /// added to the tolerance of the ray. 6 widths away on a cliff of one texel in a 1024 map it is 1.5e-3.
    double steepest = 0;
    /// Largest height error of the sampler; the march subtracts it, so a hit may lie twice as high and not be early.
    double filter_delta = 0;
    /// How far below the first hit's surface a hit may lie besides (ConeFamily::hybrid).
    double allowed_depth = 0;
    int threads = 0; ///< 0: all; the result does not depend on it
};

/// Four roundings of a float32 position: direction times t, plus origin, times size, minus a half texel.
constexpr double position_rounding = 0x1p-22;

/// Largest |dH/du| + |dH/dv| over all cells.
double steepest_slope(const BilinearSurface& surface);

struct Comparison {
    std::uint64_t rays = 0;
    std::uint64_t missed = 0;       ///< the hit lies beyond the first hit on the surface lowered by the tolerance
    std::uint64_t skipped = 0;      ///< of these, rays that came out of the relief again, by the tolerance, before they ended: whole features lost
    std::uint64_t early = 0;        ///< the hit lies before the first hit on the surface raised by the tolerance and 2 filter_delta
    std::uint64_t out_of_steps = 0; ///< marches that never arrived; mostly counted as early too
    std::uint64_t holes = 0;        ///< rays that the rendering let fall through
    std::uint64_t pierced = 0;      ///< of these, those that meet the lowered surface, or end where no cell is open
    std::uint64_t filled = 0;       ///< rendered hits of rays that fall through the raised surface too: early, or in open cells
    double mse = 0;                 ///< mean squared (hit height - surface height at the hit), 001 sec. 4.1
    double steps_mean = 0;
    double steps_max = 0;
    double fetches_mean = 0;
    double tolerance_max = 0; ///< largest tolerance of any ray
};

/// Follows each pixel's ray, as the shader recorded it, over `surface`.
Comparison compare_with_oracle(const BilinearSurface& surface, const Rendering& rendering, const CompareOptions& options = {});

/// Both together, weighted by rays.
Comparison combined(const Comparison& a, const Comparison& b);

/// The oracle's own hits for the rays of a rendering, as Technique::given takes them: (t, 0, status, 0).
Image<Quad> oracle_hits(const BilinearSurface& surface, const Rendering& rendering, int threads = 0);

} // namespace reliefbake
