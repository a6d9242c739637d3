#pragma once
// What marches of tests have in common: fields of all kinds, maps as a shader decodes them, and rays likely to break a cone.

#include "bake/cone.h"
#include "bake/relief_map.h"
#include "tests/support/cone_fields.h"
#include "tests/support/crossings.h"

#include <array>
#include <cmath>

namespace reliefbake::test {

struct Encoded {
    ConeEncoding encoding;
    BitDepth bits;
};

constexpr std::array<Encoded, 4> encodings{{{ConeEncoding::sqrt, BitDepth::unorm8},
                                 {ConeEncoding::ratio, BitDepth::unorm16},
                                 {ConeEncoding::radius, BitDepth::half},
                                 {ConeEncoding::normal, BitDepth::float32}}};

/// Small fields of all proportions and addressings; the adversarial ones first.
inline std::vector<DepthMap> fields_of_all_kinds(int random_fields) {
    std::vector<DepthMap> all;
    for (Wrap wrap : {Wrap::repeat, Wrap::clamp})
        for (const std::string& name : adversarial_names()) {
            all.push_back(adversarial(grid_of(37, 29, wrap), name));
            all.push_back(adversarial(grid_of(15, 33, wrap, 0.7), name));
        }
    std::mt19937 random(11);
    for (int k = 0; k < random_fields; ++k) {
        TexelGrid grid = grid_of(1 + int(random() % 45), 1 + int(random() % 45), Wrap::repeat, uniform(random, 0.5, 2));
        if (random() % 2 == 0) grid.wrap_x = Wrap::clamp;
        if (random() % 2 == 0) grid.wrap_y = Wrap::clamp;
        all.push_back(k % 4 == 0 ? noise(grid, random()) : bumpy(grid, random() % 100));
    }
    return all;
}

/// What a shader decodes; the depth as it is, so that codes are all that is rounded.
inline ReliefMap stored(const DepthMap& depth, const std::vector<ConeMap>& cones, Encoded encoded) {
    ReliefMap map;
    map.grid = depth.grid;
    map.info.encoding = encoded.encoding, map.info.cone_max = cones.front().options.ratio_max;
    map.info.metric = cones.front().options.metric, map.info.lookup = cones.front().options.lookup;
    map.depth = Image<float>(depth.grid.width, depth.grid.height);
    for (int j = 0; j < depth.grid.height; ++j)
        for (int i = 0; i < depth.grid.width; ++i) map.depth(i, j) = float(depth.depth(i, j));
    for (const ConeMap& sector : cones) map.cone_planes.push_back(encode_cones(sector, depth, {encoded.encoding, encoded.bits}).value);
    return map;
}

inline double clean(double x) { return std::fabs(x) < 1e-12 ? 0 : x; } // an axis, not 1e-17 beside it, which is another sector

/// From the top or from anywhere above the surface, flat and steep; every third ray along an axis or a diagonal, from a texel's centre.
inline DescendingRay draw_ray(const DepthMap& depth, std::mt19937& random, int index) {
    const TexelGrid& g = depth.grid;
    DescendingRay ray{uniform(random, 0, 1), uniform(random, 0, 1), 1, 0, 0};
    constexpr double turn = 6.283185307179586;
    double angle = uniform(random, 0, turn);
    if (index % 3 == 0) {
        angle = turn * double(random() % 8) / 8;
        ray.u = TexelGrid::centre(int(random() % unsigned(g.width)), g.width), ray.v = TexelGrid::centre(int(random() % unsigned(g.height)), g.height);
    }
    const double reach = 0.02 * std::pow(200.0, uniform(random, 0, 1));
    ray.du = reach * clean(std::cos(angle)), ray.dv = reach * clean(std::sin(angle)) / g.aspect();
    if (index % 2 == 0) {
        const double low = surface_height(depth, ray.u, ray.v);
        ray.h = low + (1 - low) * uniform(random, 0, 1);
    }
    return ray;
}

/// Through the tip of the texel that rises most steeply from where the ray starts, a little below it: in and out again, should
/// the first step go so far.
inline DescendingRay aim_ray(const DepthMap& depth, std::mt19937& random) {
    const TexelGrid& g = depth.grid;
    DescendingRay ray{uniform(random, 0, 1), uniform(random, 0, 1), 1, 0, 0};
    const double low = surface_height(depth, ray.u, ray.v);
    const int i = int(std::floor(ray.u * g.width)), j = int(std::floor(ray.v * g.height)), near = 1 + int(random() % 12);
    double steepest = 0, tip = 0;
    for (int b = j - near; b <= j + near; ++b)
        for (int a = i - near; a <= i + near; ++a) {
            const double du = TexelGrid::centre(a, g.width) - ray.u, dv = TexelGrid::centre(b, g.height) - ray.v;
            const double top = 1 - depth.depth(g.address_x(a), g.address_y(b)), slope = (top - low) / std::hypot(du, g.aspect() * dv);
            if (slope > steepest) steepest = slope, tip = top, ray.du = du, ray.dv = dv;
        }
    if (steepest == 0) return ray;
    const double sunk = tip - (tip - low) * std::pow(10.0, uniform(random, -4, -0.5));
    ray.h = tip + (1 - tip) * uniform(random, 0, 1);
    ray.du /= ray.h - sunk, ray.dv /= ray.h - sunk;
    return ray;
}

} // namespace reliefbake::test
