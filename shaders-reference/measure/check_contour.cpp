#include "shaders-reference/measure/check_contour.h"

#include "bake/parallel.h"
#include "shaders-reference/measure/map_sample.h"
#include "shaders-reference/measure/random.h"

#include <algorithm>

namespace reliefbake {

namespace {

constexpr double rounding = 1e-6; ///< texels per texel of distance: codes in float, and what decoding costs

struct Place {
    double u = 0, v = 0;
};

Place place_of(int kind, const ShapeMap& map, const ContourShape& shape, SplitMix& random) {
    const auto on_lattice = [&](int count) { return double(random.below(2 * count + 1)) / (2 * count); };
    Place place{random.uniform(), random.uniform()};
    if (kind == 0) place = {on_lattice(map.grid.width), on_lattice(map.grid.height)};
    if (kind == 2) {
        const std::size_t pick = std::size_t(random.next() >> 1);
        const double du = 6 * random.uniform() - 3, dv = 6 * random.uniform() - 3;
        shape.near_shape(pick, du, dv, place.u, place.v);
    }
    return place;
}

} // namespace

ContourShape stored_contour(const ShapeMap& map) {
    Image<float> coverage = map.shape;
    for (float& c : coverage) c = 1 - c;
    return {map.grid, coverage};
}

DistanceCheck check_contour(const ShapeMap& map, const ContourShape& shape, int points, std::uint64_t seed, int threads) {
    std::vector<double> excess(std::size_t(points), 0.0);
    std::vector<Place> places(excess.size());
    parallel_for(points, threads, [&](int k) {
        SplitMix random(seed + std::uint64_t(k) * 0x9e3779b97f4a7c15u);
        const Place p = places[std::size_t(k)] = place_of(k % 3, map, shape, random);
        const double sampled = decoded_distance(filtered_code(map.distance, map.grid, p.u, p.v), map.info);
        const double safe = safe_distance(sampled, map.grid) * map.grid.width;
        excess[std::size_t(k)] = safe - shape.distance(p.u, p.v) * map.grid.width - rounding * (1 + safe);
    });
    DistanceCheck check;
    check.points = std::uint64_t(points);
    check.violations = std::uint64_t(std::count_if(excess.begin(), excess.end(), [](double e) { return e > 0; }));
    if (points == 0) return check;
    const std::size_t worst = std::size_t(std::max_element(excess.begin(), excess.end()) - excess.begin());
    check.worst = excess[worst], check.u = places[worst].u, check.v = places[worst].v;
    return check;
}

} // namespace reliefbake
