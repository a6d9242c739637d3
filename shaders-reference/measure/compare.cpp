#include "shaders-reference/measure/compare.h"

#include "bake/parallel.h"
#include "shaders-reference/oracle/comes_out.h"
#include "shaders-reference/oracle/first_hit.h"

#include <algorithm>
#include <cmath>

namespace reliefbake {
namespace {

ReliefRay ray_of(const Quad& ray) { return {ray[0], ray[1], 1, ray[2], ray[3], -1}; }

/// What float32 allows on this ray: see CompareOptions.
double ray_tolerance(const ReliefRay& ray, double t, const CompareOptions& options) {
    const double u = std::max(std::abs(ray.u), std::abs(ray.u + t * ray.du));
    const double v = std::max(std::abs(ray.v), std::abs(ray.v + t * ray.dv));
    return options.tolerance + position_rounding * std::max(u, v) * options.steepest;
}

/// Cells within a shader's rounding of a position: how many of them, and how many are open.
struct OpenCells {
    int open = 0, all = 0;
};
OpenCells cells_at(const BilinearSurface& surface, double u, double v) {
    const double x = surface.to_x(u), y = surface.to_y(v);
    const double rounding_x = position_rounding * std::max(std::abs(x), double(surface.grid().width));
    const double rounding_y = position_rounding * std::max(std::abs(y), double(surface.grid().height));
    OpenCells cells;
    for (auto j = std::int64_t(std::floor(y - rounding_y)); double(j) <= y + rounding_y; ++j)
        for (auto i = std::int64_t(std::floor(x - rounding_x)); double(i) <= x + rounding_x; ++i)
            ++cells.all, cells.open += surface.is_open(surface.patch(i, j));
    return cells;
}

/// What a ray and its rendering make of holes; `missed`, and `stops`: the raised surface stops the ray before its rendered end.
void compare_holes(const BilinearSurface& surface, const ReliefRay& ray, double t, double raised_by, RayStatus status, bool missed,
                   bool stops, Comparison& sum) {
    const OpenCells cells = cells_at(surface, ray.u + t * ray.du, ray.v + t * ray.dv);
    if (status == RayStatus::hole) {
        ++sum.holes;
        sum.pierced += missed || cells.open == 0;
    } else if (status == RayStatus::hit && !stops && !first_hit(surface, ray, -raised_by)) {
        sum.filled += t < 1 - raised_by || cells.open == cells.all;
    }
}

/// Sums over one row; divided only at the end, so that rows may be done in any order.
Comparison compare_row(const BilinearSurface& surface, const Rendering& rendering, const CompareOptions& options, int row) {
    Comparison sum;
    for (int column = 0; column < rendering.width(); ++column) {
        const std::size_t pixel = std::size_t(row) * std::size_t(rendering.width()) + std::size_t(column);
        const RayStatus status = rendering.status(pixel);
        if (status == RayStatus::no_ray) continue;
        const ReliefRay ray = ray_of(rendering.ray[pixel]);
        const Quad& counts = rendering.counts[pixel];
        const double t = counts[3];

        const double tolerance = ray_tolerance(ray, t, options);
        sum.tolerance_max = std::max(sum.tolerance_max, tolerance);
        const auto lowered = first_hit(surface, ray, tolerance + options.allowed_depth, t);
        const bool missed = lowered && lowered->t < t;
        const double raised_by = tolerance + 2 * options.filter_delta;
        const bool stops = missed || first_hit(surface, ray, -raised_by, t).has_value();
        sum.missed += missed;
        sum.skipped += missed && comes_out(surface, ray, lowered->t, t, tolerance);
        // Nothing stops a ray above a hole: it is early where it ends above the floor.
        sum.early += !stops && !(surface.has_holes() && t >= 1 - raised_by);
        if (surface.has_holes()) compare_holes(surface, ray, t, raised_by, status, missed, stops, sum);
        const double error = (1 - t) - surface.height(ray.u + t * ray.du, ray.v + t * ray.dv);
        ++sum.rays;
        sum.out_of_steps += status == RayStatus::out_of_steps;
        sum.mse += error * error;
        sum.steps_mean += counts[0];
        sum.steps_max = std::max<double>(sum.steps_max, counts[0]);
        sum.fetches_mean += counts[1];
    }
    return sum;
}

} // namespace

double steepest_slope(const BilinearSurface& surface) {
    const TexelGrid& grid = surface.grid();
    double steepest = 0;
    for (int j = -1; j < grid.height; ++j)
        for (int i = -1; i < grid.width; ++i) {
            const Patch p = surface.patch(i, j);
            const double along_u = std::max(std::abs(p.h10 - p.h00), std::abs(p.h11 - p.h01)) * grid.width;
            const double along_v = std::max(std::abs(p.h01 - p.h00), std::abs(p.h11 - p.h10)) * grid.height;
            steepest = std::max(steepest, along_u + along_v);
        }
    return steepest;
}

Comparison compare_with_oracle(const BilinearSurface& surface, const Rendering& rendering, const CompareOptions& options) {
    std::vector<Comparison> rows(std::size_t(rendering.height()));
    parallel_for(rendering.height(), options.threads,
                 [&](int row) { rows[std::size_t(row)] = compare_row(surface, rendering, options, row); });
    Comparison total;
    for (const Comparison& row : rows) {
        total.rays += row.rays;
        total.missed += row.missed;
        total.skipped += row.skipped;
        total.early += row.early;
        total.out_of_steps += row.out_of_steps;
        total.holes += row.holes;
        total.pierced += row.pierced;
        total.filled += row.filled;
        total.mse += row.mse;
        total.steps_mean += row.steps_mean;
        total.steps_max = std::max(total.steps_max, row.steps_max);
        total.fetches_mean += row.fetches_mean;
        total.tolerance_max = std::max(total.tolerance_max, row.tolerance_max);
    }
    if (total.rays == 0) return total;
    total.mse /= double(total.rays);
    total.steps_mean /= double(total.rays);
    total.fetches_mean /= double(total.rays);
    return total;
}

Comparison combined(const Comparison& a, const Comparison& b) {
    Comparison sum;
    sum.rays = a.rays + b.rays;
    if (sum.rays == 0) return sum;
    const double share_a = double(a.rays) / double(sum.rays);
    const double share_b = double(b.rays) / double(sum.rays);
    sum.missed = a.missed + b.missed;
    sum.skipped = a.skipped + b.skipped;
    sum.early = a.early + b.early;
    sum.out_of_steps = a.out_of_steps + b.out_of_steps;
    sum.holes = a.holes + b.holes;
    sum.pierced = a.pierced + b.pierced;
    sum.filled = a.filled + b.filled;
    sum.mse = share_a * a.mse + share_b * b.mse;
    sum.steps_mean = share_a * a.steps_mean + share_b * b.steps_mean;
    sum.steps_max = std::max(a.steps_max, b.steps_max);
    sum.fetches_mean = share_a * a.fetches_mean + share_b * b.fetches_mean;
    sum.tolerance_max = std::max(a.tolerance_max, b.tolerance_max);
    return sum;
}

Image<Quad> oracle_hits(const BilinearSurface& surface, const Rendering& rendering, int threads) {
    Image<Quad> hits(rendering.width(), rendering.height(), Quad{});
    parallel_for(rendering.height(), threads, [&](int row) {
        for (int column = 0; column < rendering.width(); ++column) {
            const std::size_t pixel = std::size_t(row) * std::size_t(rendering.width()) + std::size_t(column);
            if (rendering.status(pixel) == RayStatus::no_ray) continue;
            const auto hit = first_hit(surface, ray_of(rendering.ray[pixel]));
            const RayStatus status = hit || !surface.has_holes() ? RayStatus::hit : RayStatus::hole;
            hits[pixel] = {hit ? float(hit->t) : 1.0f, 0, float(status), 0};
        }
    });
    return hits;
}

} // namespace reliefbake
