#include "shaders-reference/measure/check_cones.h"

#include "bake/parallel.h"
#include "shaders-reference/measure/adversarial_points.h"
#include "shaders-reference/measure/check_pieces.h"
#include "shaders-reference/measure/map_sample.h"
#include "shaders-reference/oracle/cone_constraint.h"
#include "shaders-reference/oracle/steepest_texel.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace reliefbake {
namespace {

constexpr int chunk_points = 256; ///< one unit of parallel work; each chunk has its own random numbers
constexpr double farthest = 64; ///< texture widths; a constraint beyond it is a slope below 1/64, of cones wider than that
constexpr double look_farther = 1.25; ///< constraints are sought a little beyond the cone's reach, to see how tight it is

/// Length of a heading, 1 in the isotropic metric, in the metric of the cones.
double metric_length(const Heading& heading, Metric metric) {
    return metric == Metric::l1 ? std::abs(heading.x) + std::abs(heading.y) : 1.0;
}

/// The widest cone that any promised fetch gives at a point must hold; all others are inside it. `radius` is promised
/// for R and D from one filtered fetch alone (MATHS section 2): beside a filtered height, a nearest D may be 0.
double widest_ratio(const ReliefMap& map, const Image<float>& codes, const MapPoint& point) {
    if (map.info.lookup == ConeLookup::cell) return sampled_ratio(map, codes, point.u, point.v, Fetch::cell);
    const double ratio = sampled_ratio(map, codes, point.u, point.v, Fetch::bilinear);
    if (map.info.encoding == ConeEncoding::radius) return ratio;
    return std::max(ratio, sampled_ratio(map, codes, point.u, point.v, Fetch::nearest));
}

void note(ConeCheck& check, double excess, const MapPoint& point, const Heading& heading) {
    if (excess > check.worst) check = {check.points, check.violations, excess, point.u, point.v, std::atan2(heading.y, heading.x)};
}

/// Whether rays along a heading belong to sector k of n; borders belong to both sides.
bool is_in_sector(const Heading& heading, int k, int n) {
    constexpr double turn = 6.283185307179586, border = 1e-12;
    const double angle = std::atan2(heading.y, heading.x);
    const double beyond = (angle < 0 ? angle + turn : angle) / turn * n - k; // 0..1 inside
    return (beyond >= -border && beyond <= 1 + border) || beyond - n >= -border || beyond + n <= 1 + border;
}

/// Falls below this, height per texture width, are rounding: of a heading beside an axis, of a position beside a wall.
constexpr double level_enough = 1e-9;

/// What the family lets no cone of plane k hold, at a point of this height.
std::vector<ConstraintRule> rules_of(const ReliefMapInfo& info, int k, double height) {
    ConstraintRule exits;
    exits.exits_only = true;
    exits.least_fall = info.rays == RelaxedRays::slope ? info.relaxed_slope : level_enough;
    exits.from_top = info.rays == RelaxedRays::top;
    ConstraintRule all;
    if (info.kind == "cone-stack") all.lift = (1 - height) * k / info.planes;
    if (info.family == ConeFamily::hybrid) all.lift = info.hybrid_delta;
    switch (info.family) {
    case ConeFamily::conservative: return {all};
    case ConeFamily::relaxed: return {exits};
    case ConeFamily::hybrid: return {exits, all};
    }
    return {};
}

double check_plane(const ReliefMap& map, const BilinearSurface& surface, int plane, const MapPoint& point, SplitMix& random,
                   std::vector<Heading>& headings, ConeCheck& check) {
    const bool sectors = map.info.kind == "acm";
    const double height = surface.height(point.u, point.v);
    const double ratio = widest_ratio(map, map.cone_planes.empty() ? map.cone : map.cone_planes[std::size_t(plane)], point);
    const double rise = surface.highest() - height;
    const double reach = rise > 0 ? std::min(farthest, look_farther * ratio * rise) : 0;
    adversarial_headings(surface, point, ratio, map.info.metric, random, headings);
    double worst = 0;
    for (const ConstraintRule& rule : rules_of(map.info, plane, height))
        for (const Heading& heading : headings) {
            if (sectors && !is_in_sector(heading, plane, map.info.planes)) continue;
            const double slope = cone_constraint(surface, point.u, point.v, heading, reach, 0, rule).slope;
            const double excess = slope * ratio / metric_length(heading, map.info.metric);
            worst = std::max(worst, excess);
            note(check, excess, point, heading);
        }
    return worst;
}

double check_pieces(const ReliefMap& map, const BilinearSurface& surface, const MapPoint& point, SplitMix& random,
                    std::vector<Heading>& headings, ConeCheck& check) {
    adversarial_headings(surface, point, widest_ratio(map, map.cone_planes.front(), point), map.info.metric, random, headings);
    double worst = 0;
    for (const Heading& heading : headings) {
        const double excess = piece_excess(map, surface, point, heading, metric_length(heading, map.info.metric), random);
        worst = std::max(worst, excess);
        note(check, excess, point, heading);
    }
    return worst;
}

double check_point(const ReliefMap& map, const BilinearSurface& surface, const MapPoint& point, SplitMix& random,
                   std::vector<Heading>& headings, ConeCheck& check) {
    if (map.info.kind == "cone-pieces") return check_pieces(map, surface, point, random, headings, check);
    double worst = 0;
    for (int plane = 0; plane < std::max(1, int(map.cone_planes.size())); ++plane)
        worst = std::max(worst, check_plane(map, surface, plane, point, random, headings, check));
    return worst;
}

double check_texel(const ReliefMap& map, const BilinearSurface& surface, SplitMix& random, ConeCheck& check) {
    const MapPoint point{TexelGrid::centre(random.below(map.grid.width), map.grid.width),
                         TexelGrid::centre(random.below(map.grid.height), map.grid.height)};
    const double ratio = sampled_ratio(map, point.u, point.v, Fetch::nearest);
    if (ratio <= 0) return 0;
    const SteepestTexel limit = steepest_texel(surface, point.u, point.v, map.info.metric, std::max(0.5 / ratio, 1e-9));
    if (limit.slope <= 0) return 0;
    note(check, limit.slope * ratio, point, Heading::along(map.grid, limit.du, limit.dv));
    return limit.slope * ratio;
}

ConeCheck check_chunk(const ReliefMap& map, const BilinearSurface& surface, const AdversarialPoints& points,
                      const ConeCheckOptions& options, int chunk) {
    SplitMix random(SplitMix(options.seed + std::uint64_t(chunk) * 0x9e3779b97f4a7c15u).next());
    std::vector<Heading> headings;
    ConeCheck check;
    const int first = chunk * chunk_points;
    const int last = std::min(options.points, first + chunk_points);
    for (int index = first; index < last; ++index) {
        const double worst = map.info.surface == SurfaceModel::texel
                                 ? check_texel(map, surface, random, check)
                                 : check_point(map, surface, points.draw(std::uint64_t(index), random), random, headings, check);
        ++check.points;
        if (worst > 1 + options.slack) ++check.violations;
    }
    return check;
}

} // namespace

ConeCheck check_cones(const ReliefMap& map, const BilinearSurface& surface, const ConeCheckOptions& options) {
    const AdversarialPoints points(surface);
    std::vector<ConeCheck> chunks(std::size_t((options.points + chunk_points - 1) / chunk_points));
    parallel_for(int(chunks.size()), options.threads, [&](int chunk) {
        chunks[std::size_t(chunk)] = check_chunk(map, surface, points, options, chunk);
    });

    ConeCheck total;
    for (const ConeCheck& chunk : chunks) {
        const std::uint64_t seen = total.points + chunk.points;
        const std::uint64_t violations = total.violations + chunk.violations;
        if (chunk.worst > total.worst) total = chunk;
        total.points = seen;
        total.violations = violations;
    }
    return total;
}

} // namespace reliefbake
