#include "shaders-reference/measure/check_pieces.h"

#include "shaders-reference/measure/map_sample.h"
#include "shaders-reference/oracle/first_hit.h"

#include <algorithm>
#include <vector>

namespace reliefbake {
namespace {

constexpr double look_farther = 1.25; ///< than the radius, to see how tight it is
constexpr double farthest = 64;       ///< texture widths

double excess_at(const BilinearSurface& surface, const MapPoint& point, const Heading& heading, double height, double radius) {
    if (!(radius > 0)) return 0;
    const ReliefRay level{point.u, point.v, height, heading.x, heading.y / surface.grid().aspect(), 0};
    const auto hit = first_hit(surface, level, 0, std::min(farthest, look_farther * radius));
    return hit ? radius / hit->t : 0;
}

} // namespace

double piece_radius(std::span<const double> ratios, double share) {
    double end = 0, radius = 0;
    for (std::size_t k = 0; k < ratios.size(); ++k) {
        const double next_end = double(k + 1) / double(ratios.size()), next_radius = std::max(radius, ratios[k] * next_end);
        if (share <= next_end) return radius + (next_radius - radius) * (share - end) / (next_end - end);
        end = next_end, radius = next_radius;
    }
    return radius;
}

double piece_excess(const ReliefMap& map, const BilinearSurface& surface, const MapPoint& point, const Heading& heading,
                    double heading_length, SplitMix& random) {
    const double low = surface.height(point.u, point.v), room = 1 - low;
    const std::size_t pieces = map.cone_planes.size();
    std::vector<double> ratios(pieces);
    double worst = 0;
    for (const Fetch fetch : {Fetch::bilinear, Fetch::nearest}) {
        if (fetch == Fetch::nearest && map.info.encoding == ConeEncoding::radius) continue;
        for (std::size_t k = 0; k < pieces; ++k) ratios[k] = sampled_ratio(map, map.cone_planes[k], point.u, point.v, fetch);
        for (std::size_t k = 0; k < pieces; ++k)
            for (const double part : {1.0, random.uniform()}) {
                const double share = (double(k) + part) / double(pieces);
                worst = std::max(worst, excess_at(surface, point, heading, low + room * share, room * piece_radius(ratios, share) / heading_length));
            }
    }
    return worst;
}

} // namespace reliefbake
