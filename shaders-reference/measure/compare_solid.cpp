#include "shaders-reference/measure/compare_solid.h"

#include "bake/parallel.h"
#include "shaders-reference/measure/random.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace reliefbake {
namespace {

constexpr double half_turn = 180, pi = 3.14159265358979323846;
constexpr int angle_bins = 720; ///< of the histogram behind normal_95: a quarter of a degree each

/// Four roundings of a float32 position, as in compare.h, and of its distance.
constexpr double float_rounding = 0x1p-21;

SolidRay ray_of(const ShapeRendering& rendering, std::size_t pixel) {
    const Quad &o = rendering.origin[pixel], &d = rendering.direction[pixel];
    return {{o[0], o[1], o[2]}, {d[0], d[1], d[2]}};
}

Point3 point_at(const SolidRay& ray, double t) {
    return {ray.origin[0] + t * ray.direction[0], ray.origin[1] + t * ray.direction[1], ray.origin[2] + t * ray.direction[2]};
}

double farthest_coordinate(const SolidRay& ray, double t) {
    double farthest = 1;
    for (const Point3& p : {ray.origin, point_at(ray, t)})
        for (const double x : p) farthest = std::max(farthest, std::abs(x));
    return farthest;
}

double degrees_between(const Point3& a, const Quad& b) {
    const double dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2], size = std::hypot(b[0], b[1], b[2]);
    return std::acos(std::clamp(dot / size, -1.0, 1.0)) * half_turn / pi;
}

bool is_finite(const ShapeRendering& rendering, std::size_t pixel) {
    for (const Quad* quad : {&rendering.origin[pixel], &rendering.direction[pixel], &rendering.counts[pixel], &rendering.normal[pixel], &rendering.bumped[pixel]})
        for (const float x : *quad)
            if (!std::isfinite(x)) return false;
    return std::isfinite(rendering.depth[pixel]);
}

/// Sums over one row; divided only at the end, so that rows may be done in any order.
struct RowSums {
    SolidComparison sums;
    std::uint64_t normals = 0;
    std::array<std::uint64_t, angle_bins> angles{};
};

void judge_ray(const PixelShape& shape, const ShapeSolid& solid, const ShapeRendering& rendering, std::size_t pixel, const SolidCompareOptions& options,
               RowSums& row) {
    SolidComparison& sums = row.sums;
    const SolidRay ray = ray_of(rendering, pixel);
    const RayStatus status = rendering.status(pixel);
    const Quad& counts = rendering.counts[pixel];
    const double t = counts[3];
    ++sums.rays;
    sums.steps_mean += counts[0];
    sums.steps_max = std::max<double>(sums.steps_max, counts[0]);
    sums.fetches_mean += counts[1];

    // Was the solid passed? A ray that left the domain is followed to where it leaves exactly.
    const double rounding = float_rounding * farthest_coordinate(ray, t);
    const double end = status == RayStatus::passed ? domain_exit(shape.grid(), solid, ray) - rounding : t;
    const double lowered = rounding * (1 + solid.bevel) + chord_tolerance * shape.grid().pitch_x();
    const auto first = end > 0 ? first_solid_hit(shape, solid, ray, lowered, end) : std::nullopt;
    if (first && *first < end) ++sums.missed;
    if (status == RayStatus::out_of_steps) ++sums.out_of_steps;
    if (status != RayStatus::hit) return;

    // How far from the solid did it end?
    const Point3 point = point_at(ray, t);
    const double gap = solid_gap(shape, solid, point);
    ++sums.hits;
    if (gap > options.allowed_gap + rounding * (1 + solid.bevel)) ++sums.early;
    if (rendering.normal[pixel][3] != 0) return;
    sums.gap_mean += gap;
    sums.gap_max = std::max(sums.gap_max, gap);
    const double angle = degrees_between(solid_normal(shape, solid, point), rendering.normal[pixel]);
    sums.normal_mean += angle;
    ++row.normals;
    ++row.angles[std::size_t(std::min(angle_bins - 1, int(angle / half_turn * angle_bins)))];
}

} // namespace

PixelShape stored_shape(const ShapeMap& map) {
    if (map.info.model == ShapeModel::contour) {
        Image<float> coverage = map.shape;
        for (float& c : coverage) c = 1 - c;
        return PixelShape(map.grid, std::move(coverage));
    }
    Image<std::uint8_t> inside(map.grid.width, map.grid.height);
    for (std::size_t k = 0; k < inside.size(); ++k) inside[k] = map.shape[k] < 0.5f;
    return PixelShape(map.grid, inside, map.info.model);
}

double allowed_gap(const ShapeMap& map, SamplerFilter filter, double epsilon_texels) {
    const double code = is_unorm(map.info.bits) ? (map.info.signed_distance ? 2 : 1) * map.info.tau / max_code(map.info.bits)
                        : map.info.bits == BitDepth::half ? map.info.tau * 0x1p-10 : map.info.tau * 0x1p-23;
    const double sampler = filter == SamplerFilter::fixed8 ? 2 * map.info.filter_delta + map.info.tau * 2 / 255 : 0;
    return (2 * std::sqrt(0.5) + epsilon_texels) * map.grid.pitch_x() + code + sampler;
}

SolidComparison compare_solid(const PixelShape& shape, const ShapeSolid& solid, std::span<const ShapeRendering> views, const SolidCompareOptions& options) {
    std::vector<RowSums> rows;
    for (const ShapeRendering& view : views) {
        std::vector<RowSums> judged(std::size_t(view.height()));
        parallel_for(view.height(), options.threads, [&](int row) {
            for (int column = 0; column < view.width(); ++column) {
                const std::size_t pixel = std::size_t(row) * std::size_t(view.width()) + std::size_t(column);
                RowSums& sums = judged[std::size_t(row)];
                if (!is_finite(view, pixel)) ++sums.sums.not_finite;
                else if (view.status(pixel) != RayStatus::no_ray) judge_ray(shape, solid, view, pixel, options, sums);
            }
        });
        rows.insert(rows.end(), judged.begin(), judged.end());
    }
    RowSums total;
    for (const RowSums& row : rows) {
        total.sums.rays += row.sums.rays;
        total.sums.hits += row.sums.hits;
        total.sums.missed += row.sums.missed;
        total.sums.early += row.sums.early;
        total.sums.out_of_steps += row.sums.out_of_steps;
        total.sums.not_finite += row.sums.not_finite;
        total.sums.gap_mean += row.sums.gap_mean;
        total.sums.gap_max = std::max(total.sums.gap_max, row.sums.gap_max);
        total.sums.normal_mean += row.sums.normal_mean;
        total.sums.steps_mean += row.sums.steps_mean;
        total.sums.steps_max = std::max(total.sums.steps_max, row.sums.steps_max);
        total.sums.fetches_mean += row.sums.fetches_mean;
        total.normals += row.normals;
        for (std::size_t k = 0; k < angle_bins; ++k) total.angles[k] += row.angles[k];
    }
    SolidComparison& sums = total.sums;
    const auto mean = [](double& sum, std::uint64_t count) { sum = count > 0 ? sum / double(count) : 0; };
    mean(sums.gap_mean, total.normals);
    mean(sums.normal_mean, total.normals);
    mean(sums.steps_mean, sums.rays);
    mean(sums.fetches_mean, sums.rays);
    std::uint64_t below = 0;
    std::size_t bin = 0;
    while (bin < angle_bins && 20 * (below + total.angles[bin]) < 19 * total.normals) below += total.angles[bin++];
    sums.normal_95 = total.normals > 0 ? double(bin + 1) * half_turn / angle_bins : 0;
    return sums;
}

Image<Quad> oracle_solid_hits(const PixelShape& shape, const ShapeSolid& solid, const ShapeRendering& rendering, int threads) {
    Image<Quad> hits(rendering.width(), rendering.height(), Quad{});
    parallel_for(rendering.height(), threads, [&](int row) {
        for (int column = 0; column < rendering.width(); ++column) {
            const std::size_t pixel = std::size_t(row) * std::size_t(rendering.width()) + std::size_t(column);
            if (rendering.status(pixel) == RayStatus::no_ray) continue;
            const double end = rendering.origin[pixel][3];
            const auto hit = first_solid_hit(shape, solid, ray_of(rendering, pixel), 0, end);
            hits[pixel] = {hit ? float(*hit) : float(end), 0, float(hit ? RayStatus::hit : RayStatus::passed), 0};
        }
    });
    return hits;
}

} // namespace reliefbake
