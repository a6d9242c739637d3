// Holes: what they ask of cones (nothing), what rays do above them, and that all of it holds mirrored and with any threads.

#include "bake/cone.h"
#include "bake/mips.h"
#include "bake/normal_map.h"
#include "shaders-reference/oracle/cone_constraint.h"
#include "shaders-reference/oracle/first_hit.h"
#include "tests/support/cone_fields.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>

using namespace reliefbake;
using namespace reliefbake::test;

namespace {

constexpr double turn = 6.283185307179586;

ConeOptions exact_options(Metric metric = Metric::l2) {
    ConeOptions options;
    options.metric = metric, options.tolerance = 0, options.ratio_max = 4, options.threads = 1;
    return options;
}

std::vector<DepthMap> fields() {
    std::vector<DepthMap> all;
    for (Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
        for (const char* name : {"ramp", "hill", "stairs", "checkerboard", "constant"})
            all.push_back(with_holes(adversarial(grid_of(37, 29, wrap), name)));
        all.push_back(with_holes(noise(grid_of(48, 20, wrap, 1.7), 2)));
        all.push_back(with_holes(noise(grid_of(33, 41, wrap, 0.6), 3)));
        all.push_back(with_holes(noise(grid_of(64, 1, wrap), 4)));
    }
    return all;
}

/// The maps of every conservative family: each takes a depth map and gives planes of cones.
std::vector<std::function<std::vector<ConeMap>(const DepthMap&)>> conservative_families() {
    std::vector<std::function<std::vector<ConeMap>(const DepthMap&)>> all;
    for (Metric metric : {Metric::l2, Metric::l1})
        for (ConeLookup lookup : {ConeLookup::filtered, ConeLookup::cell}) {
            ConeOptions options = exact_options(metric);
            options.lookup = lookup;
            all.push_back([=](const DepthMap& depth) { return std::vector<ConeMap>{bake_cones(depth, options)}; });
            all.push_back([=](const DepthMap& depth) { return bake_sector_cones(depth, metric == Metric::l2 ? 8 : 4, options); });
        }
    all.push_back([](const DepthMap& depth) { return bake_stacked_cones(depth, 3, exact_options()); });
    return all;
}

bool is_solid_around(const DepthMap& depth, int x, int y) {
    for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i)
            if (depth.is_hole(depth.grid.address_x(x + i), depth.grid.address_y(y + j))) return false;
    return true;
}

/// Whether the point lies in a cell whose four corners are holes: by the definition, not by the oracle.
bool is_open_at(const DepthMap& depth, double u, double v) {
    const TexelGrid& g = depth.grid;
    const int x = int(std::floor(u * g.width - 0.5)), y = int(std::floor(v * g.height - 0.5));
    for (int k = 0; k < 4; ++k)
        if (!depth.is_hole(g.address_x(x + k % 2), g.address_y(y + k / 2))) return false;
    return true;
}

ReliefRay random_ray(std::mt19937& random) {
    const double angle = uniform(random, 0, turn), reach = uniform(random, 0, 2);
    return {uniform(random, 0, 1), uniform(random, 0, 1), 1, reach * std::cos(angle), reach * std::sin(angle), -1};
}

} // namespace

TEST_CASE("a hole asks nothing of cones: any other height there narrows them, where nothing but solid ground is beside them") {
    for (const DepthMap& depth : fields())
        for (const auto& bake : conservative_families()) {
            const std::vector<ConeMap> open = bake(depth);
            for (const float fill : {0.0f, 0.4f, 1.0f}) {
                DepthMap filled = depth;
                filled.holes = false;
                std::mt19937 random(5);
                for (std::size_t k = 0; k < filled.level.size(); ++k)
                    if (depth.level[k] == float(max_code(depth.bits)))
                        filled.level[k] = std::floor(float(max_code(depth.bits)) * (fill == 0.4f ? float(uniform(random, 0, 1)) : fill));
                const std::vector<ConeMap> closed = bake(filled);
                for (std::size_t plane = 0; plane < open.size(); ++plane)
                    for (int y = 0; y < depth.grid.height; ++y)
                        for (int x = 0; x < depth.grid.width; ++x) {
                            if (fill < 1 && !is_solid_around(depth, x, y)) continue;
                            CAPTURE(x, y, plane, fill, depth.grid.width);
                            // Filled to the floor they are the same everywhere.
                            if (fill == 1) REQUIRE(open[plane].ratio(x, y) == closed[plane].ratio(x, y));
                            else REQUIRE(double(open[plane].ratio(x, y)) >= double(closed[plane].ratio(x, y)) * (1 - 1e-6));
                        }
            }
        }
}

TEST_CASE("the oracle stops at solid ground alone, and lets fall what comes down to an open cell") {
    std::mt19937 random(9);
    int fell = 0, hits = 0;
    for (const DepthMap& depth : fields()) {
        const BilinearSurface surface(depth);
        for (int k = 0; k < 150; ++k) {
            const ReliefRay ray = random_ray(random);
            const auto hit = first_hit(surface, ray);
            // A dense march over the definition.
            constexpr int samples = 20000;
            double truth = 1;
            bool solid = false;
            for (int i = 0; i <= samples && !solid; ++i) {
                const double t = double(i) / samples, u = ray.u + t * ray.du, v = ray.v + t * ray.dv;
                solid = !is_open_at(depth, u, v) && 1 - t <= surface.height(u, v);
                if (solid) truth = t;
            }
            CAPTURE(k, ray.u, ray.v, ray.du, ray.dv, depth.grid.width);
            if (hit) {
                ++hits;
                CHECK(hit->t <= truth + 1e-12); // the march overlooks what is thinner than a sample
                CHECK_FALSE(is_open_at(depth, hit->u, hit->v));
                CHECK(hit->h == Approx(surface.height(hit->u, hit->v)).margin(1e-9));
            } else {
                ++fell;
                CHECK((!solid || truth > 1 - 2.0 / samples));
                CHECK(is_open_at(depth, ray.u + ray.du, ray.v + ray.dv));
            }
        }
    }
    CHECK(fell > 100);
    CHECK(hits > 1000);
}

TEST_CASE("no step of a march over cones with holes passes solid ground, and rays that fall come down to the floor") {
    std::mt19937 random(11);
    for (const DepthMap& depth : fields()) {
        const BilinearSurface surface(depth);
        const Image<float> ratio = bake_cones(depth, exact_options()).ratio;
        const TexelGrid& g = depth.grid;
        for (int k = 0; k < 200; ++k) {
            const ReliefRay ray = random_ray(random);
            const auto hit = first_hit(surface, ray);
            const double reach = std::hypot(ray.du, g.aspect() * ray.dv), end = hit ? hit->t : 1;
            double t = 0;
            for (int step = 0; step < 20000 && t < end - 1e-6; ++step) {
                const double u = ray.u + t * ray.du, v = ray.v + t * ray.dv, x = surface.to_x(u), y = surface.to_y(v);
                const int i = int(std::floor(x)), j = int(std::floor(y));
                const auto at = [&](int a, int b) { return double(ratio(g.address_x(i + a), g.address_y(j + b))); };
                const double fx = x - i, fy = y - j;
                const double r = (at(0, 0) * (1 - fx) + at(1, 0) * fx) * (1 - fy) + (at(0, 1) * (1 - fx) + at(1, 1) * fx) * fy;
                const double gap = 1 - t - surface.height(u, v);
                REQUIRE(gap > 0); // never under the filtered surface, holes included
                t += r * gap / (reach + r);
                CAPTURE(k, t, end, ray.u, ray.v, ray.du, ray.dv);
                REQUIRE(t <= end + 1e-7);
            }
        }
    }
}

TEST_CASE("no cone near holes holds a point of the surface, in any family") {
    for (const DepthMap& depth : fields()) {
        const BilinearSurface surface(depth);
        for (ConeFamily family : {ConeFamily::conservative, ConeFamily::relaxed, ConeFamily::hybrid}) {
            ConeOptions options = exact_options();
            options.family = family, options.hybrid_delta = 0.1f;
            const Image<float> ratio = bake_cones(depth, options).ratio;
            ConstraintRule rule;
            rule.exits_only = family != ConeFamily::conservative;
            std::mt19937 random(3);
            for (int k = 0; k < 800; ++k) {
                const double u = uniform(random, 0, 1), v = uniform(random, 0, 1);
                const int i = int(std::floor(surface.to_x(u))), j = int(std::floor(surface.to_y(v)));
                double widest = 0;
                for (int c = 0; c < 4; ++c)
                    widest = std::max<double>(widest, ratio(depth.grid.address_x(i + c % 2), depth.grid.address_y(j + c / 2)));
                const Heading heading = Heading::from_angle(uniform(random, 0, turn));
                CAPTURE(u, v, int(family), depth.grid.width);
                REQUIRE(cone_constraint(surface, u, v, heading, 6, 0, rule).slope * widest <= 1 + 2e-6);
            }
        }
    }
}

TEST_CASE("a map without a hole is the plain map; one that is all hole has the widest cones, and every ray falls") {
    DepthMap none = noise(grid_of(21, 17, Wrap::repeat), 8);
    for (float& level : none.level) level = std::min(level, 254.0f);
    const Image<float> plain = bake_cones(none, exact_options()).ratio;
    none.holes = true;
    CHECK(bake_cones(none, exact_options()).ratio == plain);
    CHECK(count_holes(none).texels == 0);
    CHECK(first_hit(BilinearSurface(none), {0.5, 0.5, 1, 1, 0, -1}));

    const DepthMap all{grid_of(9, 7, Wrap::clamp), BitDepth::unorm8, Image<float>(9, 7, 255), true};
    for (float ratio : bake_cones(all, exact_options()).ratio) CHECK(double(ratio) == Approx(4));
    CHECK(count_holes(all).texels == 63);
    CHECK(count_holes(all).cells == 63);
    CHECK_FALSE(first_hit(BilinearSurface(all), {0.5, 0.5, 1, 1, 0, -1}));
}

TEST_CASE("a mirrored map with holes has the mirrored cones, with any number of threads") {
    for (Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
        const DepthMap depth = with_holes(noise(grid_of(70, 45, wrap), 6));
        DepthMap mirrored = depth;
        for (int j = 0; j < 45; ++j)
            for (int i = 0; i < 70; ++i) mirrored.level(i, j) = depth.level(69 - i, j);
        ConeOptions options = exact_options();
        const Image<float> one = bake_cones(depth, options).ratio;
        options.threads = 5;
        CHECK(bake_cones(depth, options).ratio == one);
        const Image<float> other = bake_cones(mirrored, options).ratio;
        for (int j = 0; j < 45; ++j)
            for (int i = 0; i < 70; ++i) REQUIRE(double(other(i, j)) == Approx(double(one(69 - i, j))).epsilon(1e-6));
    }
}

TEST_CASE("a level of a chain is solid where at least half of it is, and as deep as that half") {
    const DepthMap depth = with_holes(noise(grid_of(32, 16, Wrap::repeat), 12));
    const DepthMap level = bake_depth_mips(depth)[1];
    REQUIRE(level.holes);
    std::size_t holes = 0;
    for (int j = 0; j < 8; ++j)
        for (int i = 0; i < 16; ++i) {
            double sum = 0;
            int solid = 0;
            for (int c = 0; c < 4; ++c) {
                const int x = 2 * i + c % 2, y = 2 * j + c / 2;
                if (!depth.is_hole(x, y)) sum += double(depth.level(x, y)), ++solid;
            }
            CAPTURE(i, j, solid);
            REQUIRE(level.is_hole(i, j) == (solid < 2));
            if (solid >= 2) REQUIRE(std::fabs(double(level.level(i, j)) - sum / solid) <= 0.5);
            holes += level.is_hole(i, j);
        }
    CHECK(holes > 5);
    CHECK(holes < 100);
}

TEST_CASE("solid ground keeps its own slope up to the rim of a hole") {
    DepthMap ramp = adversarial(grid_of(24, 24, Wrap::clamp), "ramp", BitDepth::unorm16);
    const NormalMap whole = bake_normals(ramp, 0.1);
    DepthMap cut = ramp;
    cut.holes = true;
    for (float& level : cut.level) level = std::min(level, 65534.0f);
    for (int j = 8; j < 16; ++j)
        for (int i = 8; i < 16; ++i) cut.level(i, j) = 65535;
    const NormalMap rim = bake_normals(cut, 0.1);
    for (int j = 0; j < 24; ++j)
        for (int i = 0; i < 24; ++i)
            if (!cut.is_hole(i, j)) REQUIRE(double(rim.x(i, j)) == Approx(double(whole.x(i, j))).margin(1e-4));
    CHECK(rim.x(8, 12) > 0.3f); // the wall that leans over the hole faces into it
    CHECK(rim.x(15, 12) < -0.3f);
}
