#include "tests/support/slow_distances.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

namespace reliefbake::test {

namespace {

struct Texel {
    int x, y;
};

int apart(int a, int b, int count, bool wrap) {
    const int d = std::abs(a - b);
    return wrap ? std::min(d, count - d) : d;
}

/// Four times the squared distance along one axis.
std::int64_t square(int d, DistanceTo to) {
    const std::int64_t twice = to == DistanceTo::centres ? 2 * std::int64_t(d) : std::max<std::int64_t>(0, 2 * std::int64_t(d) - 1);
    return twice * twice;
}

} // namespace

Image<float> slow_distances(const Image<std::uint8_t>& picture, const DistanceOptions& options) {
    const int width = picture.width(), height = picture.height();
    std::vector<Texel> set;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            if (picture(x, y) == options.set) set.push_back({x, y});
    Image<float> out(width, height, std::numeric_limits<float>::infinity());
    if (set.empty()) return out;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            std::int64_t least = std::numeric_limits<std::int64_t>::max();
            for (const Texel& t : set)
                least = std::min(least, square(apart(x, t.x, width, options.wrap_x), options.to) +
                                            square(apart(y, t.y, height, options.wrap_y), options.to));
            out(x, y) = float(std::sqrt((long double)(least)) / 2); // 64-bit mantissa: the second rounding is harmless
        }
    return out;
}

} // namespace reliefbake::test
