#pragma once
// A rendering judged by the oracle, ray by ray (MATHS section 9).

#include "shaders-reference/oracle/bilinear_surface.h"
#include "shaders-reference/renderer/rendering.h"

namespace reliefbake {

struct CompareOptions {
    /// Height by which a hit may lie under the true first hit's surface, or above it. A shader's position has float32
    /// rounding, up to 2e-7 texture widths for rays a few tiles long: on a cliff of one texel in a 1024 map
    /// that is 2e-4 of height. 1/4096 is a sixteenth of an 8-bit level.
    double tolerance = 1.0 / 4096;
    /// Largest height error of the sampler; the march subtracts it, so a hit may lie twice as high and not be early.
    double filter_delta = 0;
    int threads = 0; ///< 0: all; the result does not depend on it
};

struct Comparison {
    std::uint64_t rays = 0;
    std::uint64_t missed = 0;       ///< the hit lies beyond the first hit on the surface lowered by the tolerance
    std::uint64_t early = 0;        ///< the hit lies before the first hit on the surface raised by the tolerance and 2 filter_delta
    std::uint64_t out_of_steps = 0; ///< marches that never arrived; mostly counted as early too
    double mse = 0;                 ///< mean squared (hit height - surface height at the hit), 001 sec. 4.1
    double steps_mean = 0;
    double steps_max = 0;
    double fetches_mean = 0;
};

/// Follows each pixel's ray, as the shader recorded it, over `surface`.
Comparison compare_with_oracle(const BilinearSurface& surface, const Rendering& rendering, const CompareOptions& options = {});

/// Both together, weighted by rays.
Comparison combined(const Comparison& a, const Comparison& b);

/// The oracle's own hits for the rays of a rendering, as Technique::given takes them: (t, 0, status, 0).
Image<Quad> oracle_hits(const BilinearSurface& surface, const Rendering& rendering, int threads = 0);

} // namespace reliefbake
