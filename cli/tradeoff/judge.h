#pragma once
// Marches over a map, from fixed views, judged by the exact oracle on the *source's* surface: what a coarser map or fewer bits
// lose is an error like any other.

#include "bake/error.h"
#include "bake/height_field.h"
#include "bake/relief_map.h"
#include "cli/tradeoff/candidate.h"
#include "shaders-reference/oracle/bilinear_surface.h"
#include "shaders-reference/renderer/relief_renderer.h"

#include <vector>

namespace reliefbake {

struct JudgeOptions {
    double steepest = 80; ///< angle of the flattest views from the plane's normal, degrees, 1 to 89.9
    int rays = 60000;     ///< over all views, about
    /// Height by which a hit may lie under the true first hit's surface and not be missed, or above it and not be early. At 1/256 an
    /// exact march over 8-bit codes of the source misses nothing: they are off by 1/510.
    double missed_depth = 1.0 / 256;
    int repeat = 2;       ///< frames drawn of each view; the fastest counts
    RendererBackend backend = RendererBackend::osmesa;
    int threads = 0;      ///< of the oracle; 0: all. No figure but times depends on it
};

struct JudgeView {
    double angle, azimuth; ///< degrees, as View
};

/// From above; half as flat as the flattest, along rows and across; three quarters, along a diagonal; the flattest, along rows,
/// across, along a diagonal.
std::vector<JudgeView> judge_views(double steepest);

/// Figures of one candidate. Shares are of rays; heights are parts of the relief's depth.
struct Measurement {
    std::uint64_t rays = 0;
    double missed = 0;       ///< share of rays that went on beyond the first hit by more than JudgeOptions::missed_depth
    double early = 0;        ///< share that stopped before it by more
    double out_of_steps = 0; ///< share that never arrived
    /// A ray's error: how much lower or higher it ends than its true first hit; of a ray neither missed nor early at most missed_depth,
    /// since it ends that near to the surface, whichever of two peaks in one line it took.
    double error_mean = 0, error_p99 = 0, error_max = 0;
    double error_deviation = 0; ///< standard deviation of a ray's error: error_mean is known to error_deviation / sqrt(rays)
    double mse = 0;          ///< mean squared height of the hit above or below the surface at the hit's uv (001 sec. 4.1)
    double dissimilarity = 0; ///< 1 - structural similarity to the oracle's pictures, mean of the views: the perceptual measure
    double steps_mean = 0, steps_max = 0, fetches_mean = 0;
    double refining_steps_mean = 0; ///< of steps_mean, those that refine
    double instructions = 0; ///< SPIR-V instructions of the march for a ray, by its mean steps (instruction_cost)
    double bytes_per_texel = 0; ///< of the source: a map of half the resolution has a quarter
    double bytes = 0;           ///< of all channels of the whole map
    double bake_seconds = 0;
    double ms_per_frame = 0;     ///< mean of the views
    double cpu_ms_per_frame = 0; ///< of the process's processor time, all its threads
};

/// One frame for people, 160 x 108, of two thirds of the steepest angle.
struct JudgePicture {
    RgbImage colour;
    RgbImage error; ///< distance of each hit from the exact one (error_picture)
};

/// Holds the surface, and for each view its rays' exact hits, found once and used for every candidate.
class Judge {
  public:
    /// `surface`: the source's own, in floats for heights. Errors (usage): no renderer.
    static Result<Judge> create(const DepthMap& surface, double depth_scale, const JudgeOptions& options);

    /// Uploads the map that the next marches run over. Errors: those of ReliefRenderer::load.
    Result<void> load(const ReliefMap& map);

    /// Deterministic but for times; bytes and bake_seconds are the caller's. Errors: those of ReliefRenderer::render.
    Result<Measurement> measure(const March& march);

    /// The loaded map as people see it. Errors: those of ReliefRenderer::render.
    Result<JudgePicture> picture(const March& march);

    const JudgeOptions& options() const { return options_; }
    std::size_t source_texels() const { return std::size_t(surface_.grid().width) * std::size_t(surface_.grid().height); }

  private:
    struct RayTruth {
        double t, lowered, raised; ///< descent of the first hit on the surface, lowered and raised by missed_depth; inf: none
    };
    struct ViewTruth {
        RenderOptions drawing;
        Image<Quad> rays;
        std::vector<RayTruth> hits;
        RgbImage colour; ///< the oracle's
    };
    struct Sums;

    Judge(ReliefRenderer renderer, const DepthMap& surface, const JudgeOptions& options);
    Result<void> find_truth(const ReliefMap& reference);
    RayTruth truth_of(const Quad& ray) const;
    void judge_view(const ViewTruth& view, const Rendering& rendering, Sums& sums) const;

    JudgeOptions options_;
    ReliefRenderer renderer_;
    BilinearSurface surface_;
    double steepest_slope_;
    std::vector<ViewTruth> views_;
};

/// How a technique's steps go into a frame.
RenderOptions with_march(RenderOptions drawing, const March& march);

} // namespace reliefbake
