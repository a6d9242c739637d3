#include "bake/filter_delta.h"

#include <algorithm>
#include <cmath>

namespace reliefbake {

namespace {

constexpr double weight_error = 1.0 / 512;        // half of the last of 8 fractional bits
constexpr double unorm8_result_error = 2.0 / 255; // two truncations

/// Largest step between horizontal (dx = 1) or vertical (dy = 1) neighbours, in code units.
double largest_step(const DepthMap& depth, int dx, int dy) {
    float largest = 0;
    for (int y = 0; y < depth.grid.height; ++y)
        for (int x = 0; x < depth.grid.width; ++x) {
            const float next = depth.level(depth.grid.address_x(x + dx), depth.grid.address_y(y + dy));
            largest = std::max(largest, std::fabs(next - depth.level(x, y)));
        }
    return largest;
}

} // namespace

double filter_delta(const DepthMap& depth) {
    const double steps = (largest_step(depth, 1, 0) + largest_step(depth, 0, 1)) / max_code(depth.bits);
    return steps * weight_error + (depth.bits == BitDepth::unorm8 ? unorm8_result_error : 0);
}

} // namespace reliefbake
