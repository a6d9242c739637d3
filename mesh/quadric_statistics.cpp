#include "mesh/quadric_statistics.h"

#include <algorithm>
#include <cmath>

namespace reliefbake {

namespace {

TermStatistics describe(std::vector<float> values) {
    TermStatistics s;
    if (values.empty()) return s;
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    s.lowest = *low, s.highest = *high;
    double sum = 0;
    for (const float v : values) sum += double(v);
    s.mean = sum / double(values.size());
    std::vector<float> sizes(values.size());
    std::transform(values.begin(), values.end(), sizes.begin(), [](float v) { return std::fabs(v); });
    const auto percentile = sizes.begin() + std::ptrdiff_t((sizes.size() - 1) * 99 / 100);
    std::nth_element(sizes.begin(), percentile, sizes.end());
    s.reach = double(*percentile);
    for (const float v : values) {
        const double place = s.reach > 0 ? (double(v) / s.reach + 1) / 2 * s.bins : s.bins / 2.0;
        ++s.histogram[std::size_t(std::clamp(place, 0.0, s.bins - 1.0))];
    }
    return s;
}

constexpr std::size_t QuadricCounts::*all_counts[] = {
    &QuadricCounts::vertices, &QuadricCounts::positions, &QuadricCounts::triangles, &QuadricCounts::non_finite_vertices,
    &QuadricCounts::non_finite_triangles, &QuadricCounts::degenerate_triangles, &QuadricCounts::zero_area_triangles,
    &QuadricCounts::isolated, &QuadricCounts::no_normal, &QuadricCounts::boundary, &QuadricCounts::non_manifold,
    &QuadricCounts::low_valence, &QuadricCounts::second_ring, &QuadricCounts::short_rank, &QuadricCounts::made_normals,
    &QuadricCounts::against_winding, &QuadricCounts::made_tangents, &QuadricCounts::mirrored, &QuadricCounts::split_vertices,
    &QuadricCounts::out_of_range};
static_assert(sizeof(QuadricCounts) == sizeof(std::size_t) * std::size(all_counts), "name every count");

} // namespace

QuadricStatistics summarise(std::span<const QuadricBake> bakes) {
    QuadricStatistics all;
    static constexpr float Quadric::*terms[] = {&Quadric::a, &Quadric::b, &Quadric::c};
    for (int k = 0; k < 3; ++k) {
        std::vector<float> values;
        for (const QuadricBake& bake : bakes)
            for (const Quadric& q : bake.mesh.quadrics) values.push_back(q.*terms[k]);
        all.terms[std::size_t(k)] = describe(std::move(values));
    }
    double squares = 0, positions = 0, twist = 0, vertices = 0;
    for (const QuadricBake& bake : bakes) {
        squares += bake.residual_rms * bake.residual_rms * double(bake.counts.positions);
        positions += double(bake.counts.positions);
        all.residual_max = std::max(all.residual_max, bake.residual_max);
        twist += bake.twist_share * bake.twist_share * double(bake.mesh.quadrics.size());
        vertices += double(bake.mesh.quadrics.size());
    }
    if (positions > 0) all.residual_rms = std::sqrt(squares / positions);
    if (vertices > 0) all.twist_share = std::sqrt(twist / vertices);
    return all;
}

QuadricCounts add_up(std::span<const QuadricBake> bakes) {
    QuadricCounts sum;
    for (const QuadricBake& bake : bakes)
        for (const auto count : all_counts) sum.*count += bake.counts.*count;
    return sum;
}

} // namespace reliefbake
