// Piecewise cones (001 sec. 3.4, method 2; docs/FAMILIES.md): nothing of the exact surface is in them, as a shader decodes them.

#include "bake/cone.h"
#include "shaders-reference/measure/map_sample.h"
#include "shaders-reference/oracle/cone_constraint.h"
#include "shaders-reference/oracle/first_hit.h"
#include "tests/support/height_distances.h"
#include "tests/support/marching.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace reliefbake;
using namespace reliefbake::test;

namespace {

ConeOptions exact(Metric metric = Metric::l2) {
    ConeOptions options;
    options.metric = metric;
    options.tolerance = 0, options.ratio_max = 4, options.threads = 1;
    return options;
}

using Ratios = std::vector<double>;

Ratios ratios_at(const ReliefMap& map, double u, double v, Fetch fetch) {
    Ratios ratios;
    for (const Image<float>& plane : map.cone_planes) ratios.push_back(sampled_ratio(map, plane, u, v, fetch));
    return ratios;
}

/// Radius at height z above the apex, with `room` above it: the greatest of any chord's at or below z.
double radius_at(const Ratios& ratios, double room, double z) {
    const double n = double(ratios.size()), share = z / room * n;
    const auto end = [&](int k) { return k == 0 ? 0.0 : ratios[std::size_t(k - 1)] * room * k / n; };
    double radius = 0;
    for (int k = 0; k <= int(n) && k <= share; ++k) {
        radius = std::max(radius, end(k));
        if (k < int(n)) radius = std::max(radius, end(k) + (end(k + 1) - end(k)) * std::min(share - k, 1.0));
    }
    return radius;
}

/// How far a ray descends within the pieces, by halving.
double step_of(const Ratios& ratios, double room, double gap, double reach) {
    double inside = 0, outside = gap;
    for (int k = 0; k < 60; ++k) {
        const double s = 0.5 * (inside + outside);
        (reach * s <= radius_at(ratios, room, gap - s) ? inside : outside) = s;
    }
    return inside;
}

struct Verdict {
    int steps = 0, broken = 0;
    double covered = 0; ///< sum of the shares of their gaps that steps went down
};

void march(const ReliefMap& map, const DepthMap& depth, const DescendingRay& ray, Fetch fetch, Verdict& verdict) {
    const double dy = ray.dv * map.grid.aspect(), reach = map.info.metric == Metric::l1 ? std::fabs(ray.du) + std::fabs(dy) : std::hypot(ray.du, dy);
    double t = 0;
    for (int k = 0; k < 25; ++k) {
        const double u = ray.u + t * ray.du, v = ray.v + t * ray.dv, low = surface_height(depth, u, v), gap = ray.h - t - low;
        if (gap < 1e-4) return;
        const double advance = step_of(ratios_at(map, u, v, fetch), 1 - low, gap, reach);
        ++verdict.steps, verdict.covered += advance / gap;
        if (follow(depth, ray, t, t + advance).crossings > 0) ++verdict.broken;
        t += advance;
    }
}

template <class Bake>
Verdict judge(const std::vector<DepthMap>& all, int rays, Bake bake) {
    Verdict verdict;
    for (std::size_t k = 0; k < all.size(); ++k) {
        const Encoded encoded = encodings[k % encodings.size()];
        const ReliefMap map = stored(all[k], bake(all[k]), encoded);
        std::mt19937 random(5);
        for (int r = 0; r < rays; ++r) {
            const DescendingRay ray = r % 2 == 0 ? draw_ray(all[k], random, r / 2) : aim_ray(all[k], random);
            march(map, all[k], ray, r / 2 % 4 == 1 && encoded.encoding != ConeEncoding::radius ? Fetch::nearest : Fetch::bilinear, verdict);
        }
    }
    return verdict;
}

/// Points at which a radius passes the nearest point as high, along a random heading, at ends of pieces and between.
template <class Bake>
int points_with_surface_inside(const std::vector<DepthMap>& all, int points, Metric metric, Bake bake) {
    int broken = 0;
    for (std::size_t k = 0; k < all.size(); ++k) {
        const ReliefMap map = stored(all[k], bake(all[k]), encodings[k % encodings.size()]);
        const BilinearSurface surface(all[k]);
        std::mt19937 random(6);
        for (int p = 0; p < points; ++p) {
            const double u = uniform(random, 0, 1), v = uniform(random, 0, 1), low = surface.height(u, v), room = 1 - low;
            const Heading heading = Heading::from_angle(6.283185307179586 * (p % 2 == 0 ? uniform(random, 0, 1) : double(random() % 8) / 8));
            const double length = metric == Metric::l1 ? std::fabs(heading.x) + std::fabs(heading.y) : 1;
            const Ratios ratios = ratios_at(map, u, v, Fetch::bilinear);
            const double share = p % 3 == 0 ? double(1 + random() % ratios.size()) / double(ratios.size()) : uniform(random, 0, 1);
            const double radius = radius_at(ratios, room, room * share) / length;
            if (radius == 0) continue;
            const auto hit = first_hit(surface, {u, v, low + room * share, heading.x, heading.y / all[k].grid.aspect(), 0}, 0, radius);
            broken += hit && hit->t < radius * (1 - 1e-6);
        }
    }
    return broken;
}

} // namespace

TEST_CASE("no step with piecewise cones passes the surface, and no radius the nearest point as high") {
    const std::vector<DepthMap> all = fields_of_all_kinds(40);
    for (Metric metric : {Metric::l2, Metric::l1})
        for (int pieces : {1, 2, 4, 7}) {
            CAPTURE(int(metric), pieces);
            const auto bake = [&](const DepthMap& depth) { return bake_piecewise_cones(depth, pieces, exact(metric)); };
            const Verdict verdict = judge(all, 60, bake);
            REQUIRE(verdict.broken == 0);
            REQUIRE(verdict.steps > 10000);
            REQUIRE(points_with_surface_inside(all, 300, metric, bake) == 0);
        }
}

TEST_CASE("a piece that is a little too wide is caught, whichever it is") {
    const std::vector<DepthMap> all = fields_of_all_kinds(40);
    for (std::size_t k = 0; k < 3; ++k) {
        CAPTURE(k);
        const auto widened = [&](const DepthMap& depth) {
            std::vector<ConeMap> maps = bake_piecewise_cones(depth, 3, exact());
            for (float& ratio : maps[k].ratio) ratio = std::min(1.1f * ratio, 4.0f);
            return maps;
        };
        REQUIRE(judge(all, 60, widened).broken + points_with_surface_inside(all, 300, Metric::l2, widened) > 0);
    }
}

TEST_CASE("one piece is no narrower than a cone; more pieces go farther") {
    const std::vector<DepthMap> all = fields_of_all_kinds(12);
    double covered = 0;
    for (const DepthMap& depth : all) {
        const Image<float> cone = bake_cones(depth, exact()).ratio, piece = bake_piecewise_cones(depth, 1, exact())[0].ratio;
        for (std::size_t k = 0; k < cone.size(); ++k) REQUIRE(double(piece[k]) >= double(cone[k]) * (1 - 4e-6));
    }
    for (int pieces : {1, 2, 4}) {
        const Verdict verdict = judge(all, 60, [&](const DepthMap& depth) { return bake_piecewise_cones(depth, pieces, exact()); });
        REQUIRE(verdict.covered / verdict.steps > covered);
        covered = verdict.covered / verdict.steps;
    }
}

TEST_CASE("at the ends of pieces, the radius is at most the distance to higher texels") {
    for (Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
        const DepthMap depth = bumpy(grid_of(61, 43, wrap), 4);
        const TexelGrid& g = depth.grid;
        const HeightDistances distances(depth, Metric::l2);
        const std::vector<ConeMap> maps = bake_piecewise_cones(depth, 3, exact());
        for (int j = 0; j < g.height; ++j)
            for (int i = 0; i < g.width; ++i)
                for (int n = 0; n < 9; ++n) // the cone of a texel holds at its neighbours, too
                    for (int k = 0; k < 3; ++k) {
                        const int x = g.address_x(i + n % 3 - 1), y = g.address_y(j + n / 3 - 1);
                        const double room = depth.depth(x, y), z = room * (k + 1) / 3;
                        CAPTURE(i, j, x, y, k);
                        REQUIRE(double(maps[std::size_t(k)].ratio(i, j)) * z <= distances.to_higher(x, y, 1 - room + z) * (1 + 1e-6));
                    }
    }
}

TEST_CASE("pieces have the same bits for every number of threads, and are wide where nothing rises") {
    const DepthMap depth = bumpy(grid_of(83, 57, Wrap::repeat), 2);
    ConeOptions options = exact();
    const std::vector<ConeMap> one = bake_piecewise_cones(depth, 4, options);
    options.threads = 3;
    const std::vector<ConeMap> three = bake_piecewise_cones(depth, 4, options);
    for (std::size_t k = 0; k < 4; ++k) REQUIRE(one[k].ratio == three[k].ratio);
    for (const double height : {0.0, 0.5, 1.0})
        for (const ConeMap& map : bake_piecewise_cones(depth_of(grid_of(9, 5, Wrap::clamp), [&](int, int) { return height; }), 3, exact()))
            for (float ratio : map.ratio) REQUIRE(ratio == Approx(4).epsilon(1e-5));
}
