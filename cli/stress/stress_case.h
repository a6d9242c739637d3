#pragma once
// One case: a field, stored and encoded in one way, baked and judged by all that can judge it.

#include "cli/cone/stored_height.h"
#include "cli/stress/stress_fields.h"
#include "cli/tradeoff/representation_baker.h"
#include "shaders-reference/measure/exact_check.h"
#include "shaders-reference/measure/verify.h"

#include <optional>

namespace reliefbake {

struct StressEffort {
    int rays = 6000;       ///< a case, over its views
    int points = 2000;     ///< of the direct check in doubles
    int exact_points = 16; ///< of the judge in rational numbers
    int crop = 6;          ///< side of the crop whose tightness is measured
    int threads = 0;       ///< 0: all; no result depends on it
    ReliefRenderer* renderer = nullptr; ///< kept from case to case; null: each makes one
};

struct StressResult {
    std::string field;
    TexelGrid grid;
    double depth_scale = 0;
    ConeEncoding encoding = ConeEncoding::sqrt;
    BitDepth bits = BitDepth::unorm8;
    std::size_t levels = 0; ///< different depths stored; 0: not counted
    double ratio_mean = 0;  ///< of the cones before encoding
    std::size_t dead = 0;   ///< texels of code 0 (`radius`: but for those of depth 0, whose cone every decoder knows)
    ConeCheck cones{};
    std::optional<ExactCheck> exact{};
    double tightness = 0;
    std::optional<Comparison> rays{};

    /// Guarantee C: neither judge of cones found one too wide, and no ray went through.
    bool holds() const;
};

/// The field as `make_height_field` accepts it. Errors: its own.
Result<BakeSource> stress_source(const StressField& field, BitDepth bits, Wrap wrap);

/// Any map of the field's size, with cones: what the judges say of it. Its counts of `dead` and `ratio_mean` are the map's statistics.
/// Errors: of the renderer.
Result<StressResult> judge_stress_map(const StressField& field, const ReliefMap& map, const StressEffort& effort);

/// Bakes and judges. Errors: of the bake, and of the renderer.
Result<StressResult> run_stress_case(const StressField& field, RepresentationBaker& baker, ConeEncoding encoding, BitDepth bits,
                                     const StressEffort& effort);

/// Of a field that is not marched: repeated, its cones alone, with no more in memory than they need (about 28 bytes a texel).
Result<StressResult> run_largest_case(const StressField& field, ConeEncoding encoding, BitDepth bits, const StressEffort& effort);

} // namespace reliefbake
