#pragma once
// The whole judgement of one baked map: its cones against the oracle, and its renderings from many views.

#include "bake/error.h"
#include "shaders-reference/measure/check_cones.h"
#include "shaders-reference/measure/compare.h"
#include "shaders-reference/renderer/relief_renderer.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace reliefbake {

enum class Verdict {
    safe,             ///< no cone too wide at any point tried, no ray missed its first hit
    unsafe,           ///< a cone holds a point of the surface it was baked for, or a ray of a bilinear map went through
    other_source,     ///< the stored depth is not that of VerifyOptions::source, by more than rounding
    not_conservative, ///< keeps what its surface model says (texel centres), but rays pass through the bilinear surface
};

struct ViewAngle {
    double angle, azimuth; ///< degrees, as View
};

struct VerifyOptions {
    RendererBackend backend = RendererBackend::osmesa;  ///< (--renderer)
    ReliefRenderer* renderer = nullptr;                 ///< draws in place of one of `backend`: many maps share its compiled shaders
    SamplerFilter filter = SamplerFilter::exact;        ///< (--filter)
    Technique technique = Technique::cone;              ///< (--technique)
    bool exact_finish = false; ///< its patch tests forgive cones that are too wide within a cell (--exact-finish)
    int rays = 300000;         ///< over all views, about (--rays)
    int max_steps = 512;       ///< of marches (--steps)
    int linear_steps = 64;     ///< of linear searches (--steps)
    int binary_steps = 8;      ///< halvings or secants of techniques that refine (--binary-steps)
    int points = 20000;        ///< for the direct check of cones (--points)
    std::uint64_t seed = 1;    ///< of the direct check (--seed)
    int crop = 64;             ///< side of the crop whose tightness is measured; 0: none, the slowest part (--crop)
    std::vector<ViewAngle> views; ///< empty: from above, and 45, 70, 85, 89 degrees at three azimuths each
    int threads = 0;           ///< of the oracle; the report does not depend on it (--threads)
    bool pictures = false;     ///< keep pictures of every view (--pictures)
    const DepthMap* source = nullptr; ///< the source's depth, quantised as the map's, to compare the stored depth with
};

struct ViewPictures {
    RgbImage rendering, oracle, error, steps;
};

struct ViewReport {
    double angle = 0;   ///< degrees from the plane's normal
    double azimuth = 0; ///< degrees
    Comparison comparison;
    double milliseconds = 0; ///< to draw the frame
    std::optional<ViewPictures> pictures;
};

struct VerifyReport {
    Verdict verdict = Verdict::safe;
    ConeCheck cones;
    Comparison total;
    bool has_holes = false;
    double tolerance = 0;  ///< height that a hit may be off, of the ray that was allowed most (CompareOptions)
    std::optional<double> tightness; ///< mean r / r_footprint over a crop, when one was asked for
    double oracle_rays_per_second = 0; ///< rays judged per second and all threads
    std::optional<double> depth_difference; ///< largest |stored - source| depth, when a source was given
    std::vector<ViewReport> views;
};

/// Errors (usage): no renderer, the map does not fit it, a source of another size.
Result<VerifyReport> verify(const ReliefMap& map, const VerifyOptions& options = {});

std::string to_string(Verdict verdict);

/// Keys: verdict, missed, skipped, early, holes, pierced and filled (shares of rays), mse, steps_mean, steps_max, fetches_mean, out_of_steps, violations
/// (of `points`), worst (with its place), tightness (null without a crop), tolerance, rays, oracle_rays_per_second, depth_difference, views.
nlohmann::json to_json(const VerifyReport& report);

} // namespace reliefbake
