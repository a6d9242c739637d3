#include "cli/tradeoff/judge.h"

#include "bake/normal_map.h"
#include "bake/parallel.h"
#include "cli/cone/assemble_map.h"
#include "shaders-reference/measure/compare.h"
#include "shaders-reference/measure/heat_map.h"
#include "shaders-reference/measure/structural_similarity.h"
#include "shaders-reference/measure/view_frame.h"
#include "shaders-reference/oracle/first_hit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace reliefbake {
namespace {

constexpr double nowhere = std::numeric_limits<double>::infinity();

/// The source itself as a map, of whose shading the oracle's pictures are made.
ReliefMap reference_map(const DepthMap& surface, double depth_scale, int threads) {
    ReliefMapInfo info;
    info.bits = surface.bits, info.holes = surface.holes, info.depth_scale = depth_scale;
    return assemble_map(info, surface, {}, bake_normals(surface, depth_scale, threads));
}

double descent_of_first_hit(const BilinearSurface& surface, const Quad& ray, double lowered_by) {
    const auto hit = first_hit(surface, {ray[0], ray[1], 1, ray[2], ray[3], -1}, lowered_by, 1);
    return hit ? hit->t : nowhere;
}

/// Largest of the smallest 99 %; `errors` is reordered.
double percentile_99(std::vector<float>& errors) {
    if (errors.empty()) return 0;
    const std::size_t rank = (errors.size() * 99 + 99) / 100 - 1;
    std::nth_element(errors.begin(), errors.begin() + std::ptrdiff_t(rank), errors.end());
    return errors[rank];
}

} // namespace

struct Judge::Sums {
    std::uint64_t rays = 0, missed = 0, early = 0, out_of_steps = 0;
    double error = 0, error_squares = 0, mse = 0, steps = 0, steps_max = 0, fetches = 0;
    std::vector<float> errors;

    void add(const Sums& other) {
        rays += other.rays, missed += other.missed, early += other.early, out_of_steps += other.out_of_steps;
        error += other.error, error_squares += other.error_squares, mse += other.mse, steps += other.steps, fetches += other.fetches;
        steps_max = std::max(steps_max, other.steps_max);
        errors.insert(errors.end(), other.errors.begin(), other.errors.end());
    }
};

std::vector<JudgeView> judge_views(double steepest) {
    return {{0, 0}, {steepest / 2, 0}, {steepest / 2, 115}, {steepest * 3 / 4, 225}, {steepest, 0}, {steepest, 115}, {steepest, 225}};
}

RenderOptions with_march(RenderOptions drawing, const March& march) {
    drawing.technique = march.technique;
    drawing.exact_finish = march.exact_finish;
    drawing.max_steps = drawing.linear_steps = march.steps;
    drawing.binary_steps = march.refinements;
    return drawing;
}

Judge::Judge(ReliefRenderer renderer, const DepthMap& surface, const JudgeOptions& options)
    : options_(options), renderer_(std::move(renderer)), surface_(surface), steepest_slope_(steepest_slope(surface_)) {}

Result<Judge> Judge::create(const DepthMap& surface, double depth_scale, const JudgeOptions& options) {
    Result<ReliefRenderer> renderer = ReliefRenderer::create(options.backend);
    if (!renderer) return tl::unexpected(renderer.error());
    Judge judge(std::move(*renderer), surface, options);
    if (Result<void> found = judge.find_truth(reference_map(surface, depth_scale, options.threads)); !found) return tl::unexpected(found.error());
    return judge;
}

Judge::RayTruth Judge::truth_of(const Quad& ray) const {
    // As CompareOptions::steepest says, at the ray's far end.
    const double u = std::max(std::abs(ray[0]), std::abs(ray[0] + ray[2])), v = std::max(std::abs(ray[1]), std::abs(ray[1] + ray[3]));
    const double tolerance = options_.missed_depth + position_rounding * std::max(u, v) * steepest_slope_;
    return {descent_of_first_hit(surface_, ray, 0), descent_of_first_hit(surface_, ray, tolerance), descent_of_first_hit(surface_, ray, -tolerance)};
}

Result<void> Judge::find_truth(const ReliefMap& reference) {
    if (Result<void> loaded = renderer_.load(reference); !loaded) return loaded;
    const std::vector<JudgeView> angles = judge_views(options_.steepest);
    for (const JudgeView& angle : angles) {
        ViewTruth view;
        view.drawing = view_frame(reference.grid, angle.angle, angle.azimuth, options_.rays / int(angles.size()));
        view.drawing.ambient = Ambient::none; // it would come from the cones, which candidates differ in
        Result<Rendering> rays = renderer_.render(with_march(view.drawing, {Technique::linear, false, 1, 0}));
        if (!rays) return tl::unexpected(rays.error());
        view.rays = std::move(rays->ray);
        view.hits.resize(view.rays.size());
        Image<Quad> given(rays->width(), rays->height(), Quad{});
        parallel_for(given.height(), options_.threads, [&](int row) {
            for (int column = 0; column < given.width(); ++column) {
                const std::size_t pixel = std::size_t(row) * std::size_t(given.width()) + std::size_t(column);
                if (rays->status(pixel) == RayStatus::no_ray) continue;
                const RayTruth truth = view.hits[pixel] = truth_of(view.rays[pixel]);
                const RayStatus status = truth.t == nowhere && surface_.has_holes() ? RayStatus::hole : RayStatus::hit;
                given[pixel] = {float(std::min(truth.t, 1.0)), 0, float(status), 0};
            }
        });
        RenderOptions shading = with_march(view.drawing, {Technique::given, false, 1, 0});
        shading.given = &given;
        Result<Rendering> picture = renderer_.render(shading);
        if (!picture) return tl::unexpected(picture.error());
        view.colour = std::move(picture->colour);
        views_.push_back(std::move(view));
    }
    return {};
}

Result<void> Judge::load(const ReliefMap& map) { return renderer_.load(map); }

void Judge::judge_view(const ViewTruth& view, const Rendering& rendering, Sums& sums) const {
    std::vector<Sums> rows(std::size_t(rendering.height()));
    parallel_for(rendering.height(), options_.threads, [&](int row) {
        Sums& sum = rows[std::size_t(row)];
        for (int column = 0; column < rendering.width(); ++column) {
            const std::size_t pixel = std::size_t(row) * std::size_t(rendering.width()) + std::size_t(column);
            const RayStatus status = rendering.status(pixel);
            if (status == RayStatus::no_ray) continue;
            const Quad& ray = rendering.ray[pixel];
            const RayTruth truth = ray == view.rays[pixel] ? view.hits[pixel] : truth_of(ray); // another map's proportions may round otherwise
            const double t = rendering.counts[pixel][3];
            const bool missed = truth.lowered < t, early = !missed && truth.raised > t;
            const double off = std::abs(t - std::min(truth.t, 1.0));
            const double error = missed || early ? off : std::min(off, options_.missed_depth);
            const double gap = (1 - t) - surface_.height(ray[0] + t * ray[2], ray[1] + t * ray[3]);
            ++sum.rays, sum.missed += missed, sum.early += early, sum.out_of_steps += status == RayStatus::out_of_steps;
            sum.error += error, sum.error_squares += error * error, sum.errors.push_back(float(error)), sum.mse += gap * gap;
            sum.steps += rendering.counts[pixel][0], sum.steps_max = std::max<double>(sum.steps_max, rendering.counts[pixel][0]);
            sum.fetches += rendering.counts[pixel][1];
        }
    });
    for (const Sums& row : rows) sums.add(row);
}

Result<Measurement> Judge::measure(const March& march) {
    Sums sums;
    Measurement result;
    double marching = 0;
    for (const ViewTruth& view : views_) {
        double seconds = nowhere, cpu_seconds = nowhere;
        for (int k = 0; k < options_.repeat; ++k) {
            Result<Rendering> rendering = renderer_.render(with_march(view.drawing, march));
            if (!rendering) return tl::unexpected(rendering.error());
            seconds = std::min(seconds, rendering->seconds), cpu_seconds = std::min(cpu_seconds, rendering->cpu_seconds);
            if (k > 0) continue;
            judge_view(view, *rendering, sums);
            result.dissimilarity += (1 - structural_similarity(rendering->colour, view.colour)) / double(views_.size());
        }
        if (march.refinements > 0 && technique_info(march.technique).refines) { // what it takes without is the march
            March plain = march;
            plain.refinements = 0;
            Result<Rendering> rendering = renderer_.render(with_march(view.drawing, plain));
            if (!rendering) return tl::unexpected(rendering.error());
            for (const Quad& counts : rendering->counts) marching += counts[0];
        }
        result.ms_per_frame += 1000 * seconds / double(views_.size());
        result.cpu_ms_per_frame += 1000 * cpu_seconds / double(views_.size());
    }
    result.rays = sums.rays;
    if (sums.rays == 0) return result;
    const double rays = double(sums.rays);
    result.missed = double(sums.missed) / rays, result.early = double(sums.early) / rays;
    result.out_of_steps = double(sums.out_of_steps) / rays;
    result.error_mean = sums.error / rays, result.mse = sums.mse / rays;
    result.error_deviation = std::sqrt(std::max(sums.error_squares / rays - result.error_mean * result.error_mean, 0.0));
    result.error_max = *std::max_element(sums.errors.begin(), sums.errors.end());
    result.error_p99 = percentile_99(sums.errors);
    result.steps_mean = sums.steps / rays, result.steps_max = sums.steps_max;
    result.refining_steps_mean = marching > 0 ? (sums.steps - marching) / rays : 0;
    result.fetches_mean = sums.fetches / rays;
    return result;
}

Result<JudgePicture> Judge::picture(const March& march) {
    const TexelGrid& grid = surface_.grid();
    RenderOptions drawing;
    drawing.width = 160, drawing.height = 108;
    drawing.endless = grid.wrap_x == Wrap::repeat && grid.wrap_y == Wrap::repeat;
    drawing.view = {options_.steepest * 2 / 3, 30, 30, 0.6};
    drawing.ambient = Ambient::none;
    Result<Rendering> rendering = renderer_.render(with_march(drawing, march));
    if (!rendering) return tl::unexpected(rendering.error());
    return JudgePicture{rendering->colour, error_picture(*rendering, oracle_hits(surface_, *rendering, options_.threads))};
}

} // namespace reliefbake
