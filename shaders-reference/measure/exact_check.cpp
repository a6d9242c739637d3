#include "shaders-reference/measure/exact_check.h"

#include "bake/parallel.h"
#include "shaders-reference/measure/adversarial_points.h"
#include "shaders-reference/measure/stored_depth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace reliefbake {
namespace {

constexpr double slack = 1e-6; // ConeCheckOptions::slack

/// The stored values around a point of the lattice, twice or four times the same where it is a texel's centre.
std::array<Rational, 4> exact_values(const Image<float>& plane, const TexelGrid& grid, BitDepth bits, HalfTexel point) {
    const int left = grid.address_x(point.x >> 1), right = grid.address_x((point.x >> 1) + (point.x & 1));
    const int top = grid.address_y(point.y >> 1), below = grid.address_y((point.y >> 1) + (point.y & 1));
    const auto value = [&](int i, int j) {
        const float stored = plane(i, j);
        return is_unorm(bits) ? Rational(std::lround(stored * float(max_code(bits)))) / max_code(bits) : exactly(stored);
    };
    return {value(left, top), value(right, top), value(left, below), value(right, below)};
}

Rational mean(const std::array<Rational, 4>& values) { return (values[0] + values[1] + values[2] + values[3]) / 4; }

/// Greatest ratio * constraint that the oracle in doubles finds from a point.
double excess_in_doubles(const ReliefMap& map, const BilinearSurface& surface, const MapPoint& point, double ratio, SplitMix& random,
                         std::vector<Heading>& headings) {
    const double reach = std::min(64.0, 1.25 * ratio * (surface.highest() - surface.height(point.u, point.v)));
    adversarial_headings(surface, point, ratio, map.info.metric, random, headings);
    double worst = 0;
    for (const Heading& heading : headings) {
        const double length = map.info.metric == Metric::l1 ? std::abs(heading.x) + std::abs(heading.y) : 1;
        worst = std::max(worst, cone_constraint(surface, point.u, point.v, heading, reach).slope * ratio / length);
    }
    return worst;
}

void note(ExactCheck& check, HalfTexel point, ExactVerdict verdict, double excess) {
    ++check.points;
    if (verdict != ExactVerdict::holds && check.violated + check.undecided == 0) check.worst = point;
    check.violated += verdict == ExactVerdict::violated;
    check.undecided += verdict == ExactVerdict::undecided;
    if (verdict == ExactVerdict::undecided) return;
    check.doubles_wrong += (excess > 1 + slack) != (verdict == ExactVerdict::violated);
    check.doubles_above += verdict == ExactVerdict::holds && excess > 1;
}

} // namespace

std::optional<Rational> exact_ratio_squared(const ReliefMap& map, HalfTexel point) {
    const std::array<Rational, 4> codes = exact_values(map.cone, map.grid, map.info.bits, point);
    const Rational cap = exactly(map.info.cone_max);
    // A nearest fetch between texels may take any of them; `radius` is promised filtered alone.
    const Rational code = map.info.encoding == ConeEncoding::radius ? mean(codes) : *std::max_element(codes.begin(), codes.end());
    switch (map.info.encoding) {
    case ConeEncoding::ratio: return code * code * cap * cap;
    case ConeEncoding::sqrt: return code * code * code * code * cap * cap;
    case ConeEncoding::radius: {
        const Rational depth = mean(exact_values(map.depth, map.grid, map.info.bits, point));
        if (depth > 0) return code * code / (depth * depth);
        if (std::isinf(map.info.cone_max)) return std::nullopt;
        return cap * cap;
    }
    case ConeEncoding::normal:
        if (code >= 1) return std::nullopt;
        return code * code / (1 - code * code);
    }
    return std::nullopt;
}

ExactCheck check_exactly(const ReliefMap& map, int points, int threads) {
    const TexelGrid& grid = map.grid;
    const DepthMap depth = stored_depth(map);
    const ExactSurface exact(depth);
    const BilinearSurface surface(depth);
    // On a clamped axis the last lattice point is the last texel's centre.
    const int columns = grid.wrap_x == Wrap::repeat ? 2 * grid.width : 2 * grid.width - 1;
    const int rows = grid.wrap_y == Wrap::repeat ? 2 * grid.height : 2 * grid.height - 1;
    const std::int64_t all = std::int64_t(columns) * rows;
    const int count = int(std::min<std::int64_t>(points, all));
    std::vector<ExactCheck> each(std::size_t(count), ExactCheck{});
    parallel_for(count, threads, [&](int k) {
        const std::int64_t at = all * k / count;
        const HalfTexel point{int(at % columns), int(at / columns)};
        SplitMix random(std::uint64_t(k) + 1);
        std::vector<Heading> headings;
        const MapPoint place{(point.x + 1) / 2.0 / grid.width, (point.y + 1) / 2.0 / grid.height};
        const std::optional<Rational> squared = exact_ratio_squared(map, point);
        const double ratio = squared ? std::sqrt(double(*squared)) : std::numeric_limits<double>::max();
        const ExactVerdict verdict = judge_exactly(exact, point, squared, map.info.metric).verdict;
        note(each[std::size_t(k)], point, verdict, excess_in_doubles(map, surface, place, ratio, random, headings));
    });
    ExactCheck total;
    for (const ExactCheck& one : each) {
        if (total.violated + total.undecided == 0) total.worst = one.worst;
        total.points += one.points, total.violated += one.violated, total.undecided += one.undecided;
        total.doubles_wrong += one.doubles_wrong, total.doubles_above += one.doubles_above;
    }
    return total;
}

} // namespace reliefbake
