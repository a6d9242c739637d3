#pragma once
// Adversarial height fields for the cone bake, and 8-bit grids of every small size.

#include "tests/support/fields.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace reliefbake::test {

inline TexelGrid grid_of(int width, int height, Wrap wrap, double pixel_aspect = 1) {
    return {width, height, wrap, wrap, pixel_aspect};
}

/// Heights in [0,1] of the named shape at (u, v) in [0,1]^2.
inline double adversarial_height(const std::string& name, double u, double v, int i, int j) {
    if (name == "ramp") return u;
    if (name == "diagonal ramp") return (u + v) / 2;
    if (name == "pyramid") return 1 - 2 * std::max(std::fabs(u - 0.5), std::fabs(v - 0.5));
    if (name == "hill") return std::max(0.0, 1 - 2 * std::hypot(u - 0.5, v - 0.5));
    if (name == "bowl") return 2 * ((u - 0.5) * (u - 0.5) + (v - 0.5) * (v - 0.5));
    if (name == "saw-tooth") return std::fmod(u * 8, 1.0);
    if (name == "stairs") return std::floor(u * 16) / 16;
    if (name == "checkerboard") return (i / 4 + j / 4) % 2;
    if (name == "fine checkerboard") return (i + j) % 2;
    if (name == "spike") return i == 3 && j == 2 ? 1 : 0;
    if (name == "constant") return 0.5;
    return 0;
}

inline const std::vector<std::string>& adversarial_names() {
    static const std::vector<std::string> names = {"ramp",   "diagonal ramp", "pyramid",           "hill",  "bowl",    "saw-tooth",
                                                   "stairs", "checkerboard",  "fine checkerboard", "spike", "constant"};
    return names;
}

inline DepthMap adversarial(const TexelGrid& grid, const std::string& name, BitDepth bits = BitDepth::unorm16) {
    DepthMap map{grid, bits, Image<float>(grid.width, grid.height)};
    for (int j = 0; j < grid.height; ++j)
        for (int i = 0; i < grid.width; ++i) {
            const double h = adversarial_height(name, TexelGrid::centre(i, grid.width), TexelGrid::centre(j, grid.height), i, j);
            map.level(i, j) = is_unorm(bits) ? float(std::round((1 - h) * max_code(bits))) : float(1 - h);
        }
    return map;
}

/// Hills and valleys with some noise: rays pierce it more than once.
inline DepthMap bumpy(const TexelGrid& grid, std::uint32_t seed) {
    DepthMap map = noise(grid, seed);
    for (int j = 0; j < grid.height; ++j)
        for (int i = 0; i < grid.width; ++i)
            map.level(i, j) = std::floor(0.15f * map.level(i, j) + 100.0f * float(1 + std::sin(i * 0.45 + seed) * std::cos(j * 0.31)));
    return map;
}

/// `depth` with round holes cut into it; unorm, solid texels above the floor.
inline DepthMap with_holes(DepthMap depth) {
    const float floor = float(max_code(depth.bits));
    for (float& level : depth.level) level = std::min(level, floor - 1);
    depth.holes = true;
    for (int j = 0; j < depth.grid.height; ++j)
        for (int i = 0; i < depth.grid.width; ++i)
            if (std::sin(0.55 * i + 1) * std::cos(0.4 * j) > 0.35) depth.level(i, j) = floor;
    return depth;
}

} // namespace reliefbake::test
