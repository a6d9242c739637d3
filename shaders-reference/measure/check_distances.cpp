#include "shaders-reference/measure/compare_solid.h"

#include "bake/parallel.h"
#include "shaders-reference/measure/map_sample.h"
#include "shaders-reference/measure/random.h"

#include <algorithm>
#include <cmath>

namespace reliefbake {
namespace {

constexpr int chunk_points = 256; ///< one unit of parallel work; each chunk has its own random numbers
constexpr double rounding = 1e-6; ///< texels per texel of distance: float32 codes and what decoding costs

struct Point {
    double u, v;
};

/// Texel centres, middles of edges, corners; points close to the outline; anywhere.
Point point_of(int kind, const ShapeMap& map, const PixelShape& shape, SplitMix& random) {
    const auto on_lattice = [&](int count) { return double(random.below(2 * count + 1)) / (2 * count); };
    const Point anywhere{random.uniform(), random.uniform()};
    if (kind == 0) return {on_lattice(map.grid.width), on_lattice(map.grid.height)};
    if (kind == 1) return anywhere;
    const NearestPoint nearest = shape.nearest(anywhere.u, anywhere.v, !shape.contains(anywhere.u, anywhere.v));
    if (!std::isfinite(nearest.distance)) return anywhere;
    // Up to three texels off the outline.
    return {std::clamp(nearest.u + (6 * random.uniform() - 3) * map.grid.pitch_x(), 0.0, 1.0),
            std::clamp(nearest.v + (6 * random.uniform() - 3) / map.grid.height, 0.0, 1.0)};
}

} // namespace

DistanceCheck check_distances(const ShapeMap& map, const PixelShape& shape, int points, std::uint64_t seed, int threads) {
    const int chunks = (points + chunk_points - 1) / chunk_points;
    std::vector<DistanceCheck> parts(static_cast<std::size_t>(chunks));
    parallel_for(chunks, threads, [&](int chunk) {
        SplitMix random(seed + std::uint64_t(chunk) * 0x9e3779b97f4a7c15u);
        DistanceCheck& check = parts[std::size_t(chunk)];
        for (int k = chunk * chunk_points; k < std::min(points, (chunk + 1) * chunk_points); ++k) {
            const Point p = point_of(k % 3, map, shape, random);
            const double sampled = decoded_distance(filtered_code(map.distance, map.grid, p.u, p.v), map.info);
            const double safe = std::max(0.0, safe_distance(sampled, map.grid)) * map.grid.width;
            const double exact = shape.nearest(p.u, p.v, true).distance * map.grid.width;
            const double excess = safe - exact;
            ++check.points;
            check.violations += excess > rounding * (1 + safe);
            if (check.points == 1 || excess > check.worst) check.worst = excess, check.u = p.u, check.v = p.v;
        }
    });
    DistanceCheck total;
    for (const DistanceCheck& part : parts) {
        total.violations += part.violations;
        if (total.points == 0 || part.worst > total.worst) total.worst = part.worst, total.u = part.u, total.v = part.v;
        total.points += part.points;
    }
    return total;
}

} // namespace reliefbake
