#pragma once
// The whole judgement of one shape map: its distances against the exact ones, and every kind of solid against the oracle.

#include "bake/error.h"
#include "shaders-reference/measure/compare_solid.h"
#include "shaders-reference/measure/verify.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace reliefbake {

struct ShapeVerifyOptions {
    RendererBackend backend = RendererBackend::osmesa; ///< (--renderer)
    SamplerFilter filter = SamplerFilter::exact;       ///< (--filter)
    CircleScheme scheme = CircleScheme::corrected;     ///< (--scheme)
    double outward = 0.05, bevel = 0.1, chamfer = 0.6; ///< of the kinds that have them (--e, --b, --c); less where the map's distances end earlier
    double axis = 0;           ///< (--axis)
    double depth_scale = 0.2;  ///< (--depth-scale)
    int rays = 200000;         ///< over all kinds and views, about (--rays)
    int points = 20000;        ///< of the direct check of distances (--points)
    std::uint64_t seed = 1;    ///< of the direct check (--seed)
    int steps = 1024;          ///< of the circle tracing (--steps)
    int binary_steps = 24;     ///< (--binary-steps)
    int threads = 0;           ///< of the oracle; the report does not depend on it (--threads)
    bool pictures = false;     ///< keep pictures of every kind's second view (--pictures)
};

struct SolidReport {
    std::string name;          ///< "extrusion, bevelled, plane", ...
    ShapeSolid solid;
    SolidComparison comparison;
    double milliseconds = 0;   ///< to draw all views
    std::optional<ViewPictures> pictures;
};

struct ShapeVerifyReport {
    Verdict verdict = Verdict::safe; ///< safe, unsafe (of a map with guarantee S), not_conservative (of one without)
    DistanceCheck distances;
    double allowed_gap = 0;    ///< texture widths that a hit may lie before the solid
    std::vector<SolidReport> solids;
    double oracle_rays_per_second = 0; ///< and all threads
};

/// Errors (usage): no renderer, the map does not fit it, numbers outside the ranges of solid.h.
Result<ShapeVerifyReport> verify_shape(const ShapeMap& map, const ShapeVerifyOptions& options = {});

/// Keys: verdict, points, violations, worst, allowed_gap, oracle_rays_per_second, solids: name, e, b, c (null: none), rays, hits, missed,
/// early, out_of_steps, not_finite (counts), gap_mean, gap_max (texture widths), normal_mean, normal_95 (degrees), steps_mean,
/// steps_max, fetches_mean, milliseconds.
nlohmann::json to_json(const ShapeVerifyReport& report);

} // namespace reliefbake
