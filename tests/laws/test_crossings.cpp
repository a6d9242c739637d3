// Guarantee R (MATHS section 3) as a shader meets it: rays from outside march with decoded, filtered cones, and behind each step
// the crossings of the exact surface are counted (tests/support/crossings.h).

#include "bake/cone.h"
#include "shaders-reference/measure/map_sample.h"
#include "tests/support/crossings.h"
#include "tests/support/marching.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace reliefbake;
using namespace reliefbake::test;

namespace {

constexpr double turn = 6.283185307179586;

ConeOptions relaxed_options(Metric metric = Metric::l2) {
    ConeOptions options;
    options.family = ConeFamily::relaxed, options.metric = metric;
    options.tolerance = 0, options.ratio_max = 4, options.threads = 1;
    return options;
}

struct Verdict {
    int steps = 0;      ///< from outside
    int pierced = 0;    ///< of these, with a crossing behind them
    int broken = 0;     ///< with more than one
    double deepest = 0; ///< that any step came below the surface that it met first
};

double course_of(const ReliefMap& map, const DescendingRay& ray) {
    const double dy = ray.dv * map.grid.aspect();
    return map.info.metric == Metric::l1 ? std::fabs(ray.du) + std::fabs(dy) : std::hypot(ray.du, dy);
}

/// The plane of the ray's sector; a border is the one that angles go on into.
const Image<float>& plane_for(const ReliefMap& map, const DescendingRay& ray) {
    const int sectors = int(map.cone_planes.size());
    double angle = std::atan2(ray.dv * map.grid.aspect(), ray.du);
    if (angle < 0) angle += turn;
    return map.cone_planes[std::size_t(std::floor(angle / turn * sectors + 1e-9)) % std::size_t(sectors)];
}

/// Follows a ray until a step meets the surface. Stops short of where steps become too small to tell.
void march(const ReliefMap& map, const DepthMap& depth, const DescendingRay& ray, Fetch fetch, Verdict& verdict) {
    constexpr int most_steps = 40;
    constexpr double least_gap = 1e-4;
    const double reach = course_of(map, ray);
    const Image<float>& plane = plane_for(map, ray);
    double t = 0;
    for (int k = 0; k < most_steps; ++k) {
        const double u = ray.u + t * ray.du, v = ray.v + t * ray.dv;
        const double gap = ray.h - t - surface_height(depth, u, v);
        if (gap < least_gap) return;
        const double ratio = sampled_ratio(map, plane, u, v, fetch);
        const double advance = ratio * gap / (reach + ratio);
        const Stretch behind = follow(depth, ray, t, t + advance);
        ++verdict.steps, verdict.pierced += behind.crossings > 0, verdict.broken += behind.crossings > 1;
        verdict.deepest = std::max(verdict.deepest, behind.deepest);
        if (behind.crossings > 0) return;
        t += advance;
    }
}

Verdict march_all(const ReliefMap& map, const DepthMap& depth, int rays) {
    std::mt19937 random(5);
    Verdict verdict;
    const bool cell = map.info.lookup == ConeLookup::cell, filtered_alone = map.info.encoding == ConeEncoding::radius;
    for (int k = 0; k < rays; ++k) {
        const DescendingRay ray = k % 2 == 0 ? draw_ray(depth, random, k / 2) : aim_ray(depth, random);
        const Fetch fetch = cell ? Fetch::cell : k / 2 % 4 == 1 && !filtered_alone ? Fetch::nearest : Fetch::bilinear;
        march(map, depth, ray, fetch, verdict);
    }
    return verdict;
}

/// Marches with what `bake` makes of each field; adds up what befell.
template <class Bake>
Verdict judge(const std::vector<DepthMap>& all, int rays, Bake bake) {
    Verdict sum;
    for (std::size_t k = 0; k < all.size(); ++k) {
        const Verdict one = march_all(stored(all[k], bake(all[k]), encodings[k % 4]), all[k], rays);
        CAPTURE(k, all[k].grid.width, all[k].grid.height);
        sum.steps += one.steps, sum.pierced += one.pierced, sum.broken += one.broken;
        sum.deepest = std::max(sum.deepest, one.deepest);
    }
    return sum;
}

std::vector<ConeMap> single(ConeMap map) {
    std::vector<ConeMap> maps;
    maps.push_back(std::move(map));
    return maps;
}

/// Steps there must be to call it a test.
void require_seen(const Verdict& verdict, int steps) {
    REQUIRE(verdict.steps > steps);
    REQUIRE(verdict.pierced > steps / 100);
}

} // namespace

TEST_CASE("crossings are counted right where they are known") {
    // Heights 0, 1, 0, 0 ... in a row: a tent between texels 0 and 2.
    const DepthMap tent = depth_of(grid_of(10, 1, Wrap::clamp), [](int i, int) { return i == 1 ? 1.0 : 0.0; });
    const auto at = [](double x) { return (x + 0.5) / 10; };
    REQUIRE(surface_height(tent, at(1.25), 0.3) == Approx(0.75));
    const DescendingRay level{at(0), 0.5, 0.5, 1e3, 0}; // hardly falls: one texel in t = 1e-4
    REQUIRE(follow(tent, level, 0, 0.4e-4).crossings == 0);
    REQUIRE(follow(tent, level, 0, 0.6e-4).crossings == 1);
    REQUIRE(follow(tent, level, 0, 1.6e-4).crossings == 2);
    REQUIRE(follow(tent, level, 0, 1.6e-4).deepest == Approx(0.5).epsilon(1e-3));
    REQUIRE(follow(tent, {at(0.5), 0.5, 1.5, 0, 0}, 0, 1.2).crossings == 1);
    // Inside one cell {0,1;1,0} along the diagonal from 0 to 0 the surface is 2 x (1 - x): in and out of it between walls.
    const DepthMap saddle = depth_of(grid_of(2, 2, Wrap::clamp), [](int i, int j) { return (i + j) % 2; });
    const DescendingRay diagonal{0.25, 0.25, 0.375, 1e3, 1e3};
    REQUIRE(follow(saddle, diagonal, 0, 0.5e-3).crossings == 2);
    REQUIRE(follow(saddle, diagonal, 0, 0.25e-3).crossings == 1);
    REQUIRE(follow(saddle, diagonal, 0, 0.5e-3).deepest == Approx(0.125).epsilon(1e-2));
}

TEST_CASE("behind each step with strict relaxed cones lies one crossing at most") {
    const std::vector<DepthMap> all = fields_of_all_kinds(60);
    for (Metric metric : {Metric::l2, Metric::l1})
        for (ConeLookup lookup : {ConeLookup::filtered, ConeLookup::cell}) {
            ConeOptions options = relaxed_options(metric);
            options.lookup = lookup;
            const Verdict verdict = judge(all, 300, [&](const DepthMap& depth) { return single(bake_cones(depth, options)); });
            CAPTURE(int(metric), int(lookup), verdict.steps, verdict.pierced);
            REQUIRE(verdict.broken == 0);
            require_seen(verdict, 50000);
        }
}

TEST_CASE("behind each step with relaxed cones of sectors lies one crossing at most, borders included") {
    const std::vector<DepthMap> all = fields_of_all_kinds(40);
    for (int sectors : {4, 8})
        for (Metric metric : {Metric::l2, Metric::l1}) {
            if (sectors == 8 && metric == Metric::l1) continue;
            const Verdict verdict =
                judge(all, 300, [&](const DepthMap& depth) { return bake_sector_cones(depth, sectors, relaxed_options(metric)); });
            CAPTURE(sectors, int(metric), verdict.steps, verdict.pierced);
            REQUIRE(verdict.broken == 0);
            require_seen(verdict, 50000);
        }
}

TEST_CASE("a step with hybrid cones crosses once at most, and goes no deeper than delta") {
    const std::vector<DepthMap> all = fields_of_all_kinds(30);
    for (float delta : {0.0f, 0.02f, 0.1f, 0.3f}) {
        ConeOptions options = relaxed_options();
        options.family = ConeFamily::hybrid, options.hybrid_delta = delta;
        const Verdict verdict = judge(all, 300, [&](const DepthMap& depth) { return single(bake_cones(depth, options)); });
        CAPTURE(delta, verdict.deepest);
        REQUIRE(verdict.broken == 0);
        REQUIRE(verdict.deepest <= double(delta) + 1e-9);
        REQUIRE(verdict.deepest >= 0.5 * double(delta)); // and it does use what it may
        REQUIRE(verdict.steps > 30000);
    }
}

TEST_CASE("mutations that break guarantee R are caught") {
    const std::vector<DepthMap> all = fields_of_all_kinds(40);
    const auto widened = [](ConeMap map, float factor) {
        for (float& ratio : map.ratio) ratio = std::min(ratio * factor, map.options.ratio_max);
        return single(std::move(map));
    };
    const auto broken = [&](auto bake) { return judge(all, 300, bake).broken; };
    const ConeOptions strict = relaxed_options();
    REQUIRE(broken([&](const DepthMap& d) { return widened(bake_cones(d, strict), 1); }) == 0);
    for (float factor : {1.03f, 1.1f, 1.5f}) {
        CAPTURE(factor);
        REQUIRE(broken([&](const DepthMap& d) { return widened(bake_cones(d, strict), factor); }) > 10);
    }
    // Rays that are already low leave through falls that rays from the top never find.
    ConeOptions top = strict;
    top.rays = RelaxedRays::top;
    REQUIRE(broken([&](const DepthMap& d) { return single(bake_cones(d, top)); }) > 0);
    // The falls of the next sector's rays.
    REQUIRE(broken([&](const DepthMap& d) {
                std::vector<ConeMap> maps = bake_sector_cones(d, 8, strict);
                std::rotate(maps.begin(), maps.begin() + 1, maps.end());
                return maps;
            }) > 10);
    // The other addressing along u.
    REQUIRE(broken([&](DepthMap d) {
                const TexelGrid grid = d.grid;
                d.grid.wrap_x = grid.wrap_x == Wrap::repeat ? Wrap::clamp : Wrap::repeat;
                ConeMap map = bake_cones(d, strict);
                map.grid = grid;
                return single(std::move(map));
            }) > 10);
    // Cones that hold over one cell, filtered.
    ConeOptions cell = strict;
    cell.lookup = ConeLookup::cell;
    REQUIRE(broken([&](const DepthMap& d) {
                ConeMap map = bake_cones(d, cell);
                map.options.lookup = ConeLookup::filtered;
                return single(std::move(map));
            }) > 10);
}
