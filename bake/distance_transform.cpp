#include "bake/distance_transform.h"

#include "bake/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace reliefbake {

namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// Squared distance along one axis, times 1 (centres) or 4 (squares).
std::int64_t squared(std::int64_t d, DistanceTo to) {
    if (to == DistanceTo::centres) return d * d;
    return d == 0 ? 0 : (2 * d - 1) * (2 * d - 1);
}

/// Distance of every texel to the nearest of the set in its column, or `none`.
Image<std::uint32_t> column_distances(const Image<std::uint8_t>& picture, const DistanceOptions& options) {
    const int width = picture.width(), height = picture.height();
    Image<std::uint32_t> distance(width, height, none);
    const int turns = options.wrap_y ? 2 : 1;
    std::vector<std::uint32_t> since(std::size_t(width), none);
    const auto pass = [&](int y) {
        for (int x = 0; x < width; ++x) {
            std::uint32_t& d = since[std::size_t(x)];
            d = picture(x, y) == options.set ? 0 : d == none ? none : d + 1;
            distance(x, y) = std::min(distance(x, y), d);
        }
    };
    for (int k = 0; k < turns * height; ++k) pass(k % height);
    since.assign(std::size_t(width), none);
    for (int k = turns * height - 1; k >= 0; --k) pass(k % height);
    return distance;
}

} // namespace

Image<float> distance_transform(const Image<std::uint8_t>& picture, const DistanceOptions& options) {
    const int width = picture.width(), height = picture.height();
    const Image<std::uint32_t> column = column_distances(picture, options);
    Image<float> out(width, height);
    const double unit = options.to == DistanceTo::centres ? 1 : 0.5;
    parallel_for(height, options.threads, [&](int y) {
        const std::uint32_t* g = column.row(y);
        constexpr std::int64_t infinite = std::numeric_limits<std::int64_t>::max() / 2;
        const auto at = [&](int x) { return g[x] == none ? infinite : squared(g[x], options.to); };
        for (int x = 0; x < width; ++x) {
            std::int64_t best = at(x);
            const int most = options.wrap_x ? width / 2 : width - 1;
            for (int t = 1; t <= most && squared(t, options.to) < best; ++t) {
                const std::int64_t far = squared(t, options.to);
                if (options.wrap_x) {
                    best = std::min(best, far + std::min(at((x + t) % width), at((x + width - t) % width)));
                } else {
                    if (x >= t) best = std::min(best, far + at(x - t));
                    if (x + t < width) best = std::min(best, far + at(x + t));
                }
            }
            out(x, y) = best >= infinite ? std::numeric_limits<float>::infinity() : float(unit * std::sqrt(double(best)));
        }
    });
    return out;
}

} // namespace reliefbake
