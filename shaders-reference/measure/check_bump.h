#pragma once
// Bump maps judged by definition: decoded values against finite differences and the oracle's horizons of the stored depth.

#include "bake/bump_map.h"
#include "bake/error.h"
#include "shaders-reference/measure/shadows.h"
#include "shaders-reference/renderer/gl_context.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace reliefbake {

struct BumpCheckOptions {
    int points = 20000;     ///< horizons to ask for; of derivatives and normals every texel is (--points)
    std::uint64_t seed = 1; ///< same seed, same horizons (--seed)
    int threads = 0;        ///< 0: all; the result does not depend on it (--threads)
    int rays = 300000;      ///< pixels over all pictures of shadows; horizons only (--rays)
    RendererBackend backend = RendererBackend::osmesa; ///< (--renderer)
};

/// Shadows under one sun, seen from above.
struct ShadowReport {
    double azimuth = 0, elevation = 0; ///< degrees; azimuth clockwise from up the image
    ShadowComparison horizons;         ///< by the horizon map
    ShadowComparison march;            ///< by the march of Shadow::hard, beside it
};

struct BumpReport {
    std::uint64_t points = 0;     ///< values compared
    std::uint64_t violations = 0; ///< that err by more than the map states
    double bound = 0;             ///< what it states
    double worst = 0;             ///< largest error
    int plane = 0, x = 0, y = 0;  ///< where
    std::vector<ShadowReport> shadows; ///< horizons only
};

/// Largest distance that horizons are asked for on repeated maps, texture widths: beyond, a height difference of 1 is a slope
/// below 1/64, and the baked value may be anything up to that.
constexpr double farthest_horizon = 64;

/// Errors (usage): no renderer for a horizon map. `map.depth` is there.
Result<BumpReport> verify_bump(const BumpMap& map, const BumpCheckOptions& options = {});

/// Keys: verdict ("holds" or "violated"), points, violations, bound, worst (error, plane, x, y), shadows (null but for horizons).
nlohmann::json to_json(const BumpReport& report);

} // namespace reliefbake
