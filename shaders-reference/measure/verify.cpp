#include "shaders-reference/measure/verify.h"

#include "shaders-reference/measure/heat_map.h"
#include "shaders-reference/measure/stored_depth.h"
#include "shaders-reference/measure/tightness.h"
#include "shaders-reference/measure/view_frame.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace reliefbake {
namespace {

constexpr double brightest_steps = 64;

/// From above once; else along the lattice, across it, and along a diagonal, where bilinear patches are steepest.
std::vector<ViewAngle> view_angles() {
    std::vector<ViewAngle> views{{0, 0}};
    for (const double angle : {45.0, 70.0, 85.0, 89.0})
        for (const double azimuth : {0.0, 115.0, 225.0}) views.push_back({angle, azimuth});
    return views;
}

RenderOptions frame(const TexelGrid& grid, const ViewAngle& view, int rays, const VerifyOptions& options) {
    RenderOptions result = view_frame(grid, view.angle, view.azimuth, rays);
    result.technique = options.technique;
    result.exact_finish = options.exact_finish;
    result.max_steps = options.max_steps;
    result.linear_steps = options.linear_steps;
    result.binary_steps = options.binary_steps;
    return result;
}

Result<ViewPictures> view_pictures(ReliefRenderer& renderer, const BilinearSurface& surface, Rendering& rendering,
                                   RenderOptions options, int threads) {
    const Image<Quad> hits = oracle_hits(surface, rendering, threads);
    options.technique = Technique::given;
    options.exact_finish = false;
    options.given = &hits;
    Result<Rendering> truth = renderer.render(options);
    if (!truth) return tl::unexpected<Error>(truth.error());
    return ViewPictures{std::move(rendering.colour), std::move(truth->colour), error_picture(rendering, hits),
                        steps_picture(rendering, brightest_steps)};
}

Result<double> largest_difference(const DepthMap& stored, const DepthMap& source) {
    if (stored.grid.width != source.grid.width || stored.grid.height != source.grid.height) {
        return fail(ErrorCode::usage, std::string("the source is ") + std::to_string(source.grid.width) + "x" +
                                          std::to_string(source.grid.height) + ", the map " +
                                          std::to_string(stored.grid.width) + "x" + std::to_string(stored.grid.height));
    }
    double largest = 0;
    for (int j = 0; j < stored.grid.height; ++j)
        for (int i = 0; i < stored.grid.width; ++i)
            largest = std::max(largest, std::abs(stored.depth(i, j) - source.depth(i, j)));
    return largest;
}

Verdict judge(const ReliefMap& map, const ConeCheck& cones, const Comparison& rays) {
    if (cones.violations > 0) return Verdict::unsafe;
    if (rays.missed == 0 && rays.pierced == 0) return Verdict::safe;
    const bool promised = map.info.surface == SurfaceModel::bilinear &&
                          (map.info.family == ConeFamily::conservative || map.info.rays == RelaxedRays::strict);
    return promised ? Verdict::unsafe : Verdict::not_conservative;
}

} // namespace

Result<VerifyReport> verify(const ReliefMap& map, const VerifyOptions& options) {
    VerifyReport report;
    if (map.depth.empty()) return fail(ErrorCode::usage, "the map has no depth channel: there is no surface to judge by");
    const DepthMap depth = stored_depth(map);
    report.has_holes = depth.holes;
    if (options.source) {
        const Result<double> difference = largest_difference(depth, *options.source);
        if (!difference) return tl::unexpected<Error>(difference.error());
        report.depth_difference = *difference;
    }
    std::optional<ReliefRenderer> own;
    ReliefRenderer* renderer = options.renderer;
    if (!renderer) {
        Result<ReliefRenderer> created = ReliefRenderer::create(options.backend);
        if (!created) return tl::unexpected<Error>(created.error());
        renderer = &own.emplace(std::move(*created));
    }
    if (Result<void> loaded = renderer->load(map, options.filter); !loaded) return tl::unexpected<Error>(loaded.error());

    // The cones themselves.
    const BilinearSurface surface(depth);
    ConeCheckOptions check;
    check.points = options.points;
    check.seed = options.seed;
    check.threads = options.threads;
    if (has_cones(map)) report.cones = check_cones(map, surface, check);
    TightnessOptions tight;
    tight.crop = options.crop;
    tight.threads = options.threads;
    // It compares with what one conservative, filtered cone a texel could be.
    const bool comparable = has_cones(map) && map.info.kind == "cone" && map.info.family == ConeFamily::conservative && map.info.lookup == ConeLookup::filtered;
    if (tight.crop > 0 && comparable) report.tightness = tightness(map, surface, tight);

    // What rays make of them.
    const std::vector<ViewAngle> views = options.views.empty() ? view_angles() : options.views;
    CompareOptions compare;
    compare.threads = options.threads;
    compare.filter_delta = options.filter == SamplerFilter::fixed8 ? map.info.filter_delta : 0;
    compare.steepest = steepest_slope(surface);
    // A hybrid step that nothing refines may end this deep; a refined one may not.
    if (map.info.family == ConeFamily::hybrid && options.technique == Technique::cone) compare.allowed_depth = map.info.hybrid_delta;
    double oracle_seconds = 0;
    for (const ViewAngle& view : views) {
        const RenderOptions drawing = frame(map.grid, view, options.rays / int(views.size()), options);
        Result<Rendering> rendering = renderer->render(drawing);
        if (!rendering) return tl::unexpected<Error>(rendering.error());
        ViewReport entry{view.angle, view.azimuth, {}, 1000 * rendering->seconds, std::nullopt};
        const auto start = std::chrono::steady_clock::now();
        entry.comparison = compare_with_oracle(surface, *rendering, compare);
        oracle_seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        report.total = combined(report.total, entry.comparison);
        if (options.pictures) {
            Result<ViewPictures> pictures = view_pictures(*renderer, surface, *rendering, drawing, options.threads);
            if (!pictures) return tl::unexpected<Error>(pictures.error());
            entry.pictures = std::move(*pictures);
        }
        report.views.push_back(std::move(entry));
    }
    report.tolerance = report.total.tolerance_max;
    report.oracle_rays_per_second = oracle_seconds > 0 ? double(report.total.rays) / oracle_seconds : 0;
    report.verdict = judge(map, report.cones, report.total);
    // Two roundings of the same height to codes.
    const double rounding = is_unorm(map.info.bits) ? 1.5 / max_code(map.info.bits) : map.info.bits == BitDepth::half ? 1e-3 : 1e-6;
    if (report.depth_difference && *report.depth_difference > rounding) report.verdict = Verdict::other_source;
    return report;
}

} // namespace reliefbake
