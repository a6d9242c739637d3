// The guarantees of the families (MATHS sections 3 to 5) against the oracle's lines, which share no code with the bake.

#include "bake/cone.h"
#include "shaders-reference/oracle/cone_constraint.h"
#include "tests/support/cone_fields.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace reliefbake;
using namespace reliefbake::test;

namespace {

constexpr double turn = 6.283185307179586;

ConeOptions options_of(ConeFamily family, Metric metric = Metric::l2) {
    ConeOptions options;
    options.family = family, options.metric = metric;
    options.tolerance = 0, options.ratio_max = 4, options.threads = 1;
    return options;
}

std::vector<DepthMap> fields() {
    std::vector<DepthMap> all;
    for (Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
        for (const std::string& name : adversarial_names()) all.push_back(adversarial(grid_of(37, 29, wrap), name));
        all.push_back(bumpy(grid_of(61, 43, wrap), 1));
        all.push_back(bumpy(grid_of(48, 20, wrap, 1.7), 2));
        all.push_back(bumpy(grid_of(20, 48, wrap, 0.6), 3));
        all.push_back(noise(grid_of(33, 17, wrap), 4));
        all.push_back(noise(grid_of(7, 3, wrap), 5));
        all.push_back(bumpy(grid_of(64, 1, wrap), 6));
    }
    return all;
}

/// Widest stored cone of the texels whose footprint holds the point: what any fetch there may return.
double widest_around(const DepthMap& depth, const Image<float>& ratio, const BilinearSurface& surface, double u, double v, ConeLookup lookup) {
    const int i = int(std::floor(surface.to_x(u))), j = int(std::floor(surface.to_y(v)));
    const TexelGrid& g = depth.grid;
    double widest = ratio(g.address_x(i), g.address_y(j));
    if (lookup == ConeLookup::cell) return widest;
    for (int b = 0; b < 2; ++b)
        for (int a = 0; a < 2; ++a) widest = std::max<double>(widest, ratio(g.address_x(i + a), g.address_y(j + b)));
    return widest;
}

struct Probe {
    double u, v;
    Heading heading;
    double length; ///< of the heading in the metric
};

/// Random points and directions; every third one is along an axis or a diagonal of the lattice, from a texel's edge.
Probe draw_probe(const TexelGrid& grid, Metric metric, std::mt19937& random, int index) {
    double angle = uniform(random, 0, turn);
    double u = uniform(random, 0, 1), v = uniform(random, 0, 1);
    if (index % 3 == 0) {
        angle = turn * double(random() % 8) / 8;
        u = (std::floor(u * grid.width) + 0.5) / grid.width;
    }
    Heading heading = Heading::from_angle(angle);
    for (double* part : {&heading.x, &heading.y}) // an axis, not 1e-17 beside it, which is another sector
        if (std::abs(*part) < 1e-12) *part = 0;
    return {u, v, heading, metric == Metric::l1 ? std::abs(heading.x) + std::abs(heading.y) : 1.0};
}

/// No cone of `ratio` may hold a point that `rule` counts.
void require_holds(const DepthMap& depth, const Image<float>& ratio, const ConeOptions& options, const ConstraintRule& rule, int probes,
                   double share_lift = 0, int sector = -1, int sectors = 0) {
    const BilinearSurface surface(depth);
    std::mt19937 random(7);
    for (int k = 0; k < probes; ++k) {
        const Probe p = draw_probe(depth.grid, options.metric, random, k);
        if (sectors > 0) {
            double angle = std::atan2(p.heading.y, p.heading.x);
            if (angle < 0) angle += turn;
            const double place = angle / turn * sectors - sector; // borders belong to both
            if (!(place >= -1e-9 && place <= 1 + 1e-9) && !(place - sectors >= -1e-9)  && !(place + sectors <= 1 + 1e-9)) continue;
        }
        const double r = widest_around(depth, ratio, surface, p.u, p.v, options.lookup);
        ConstraintRule here = rule;
        here.lift += share_lift * (1 - surface.height(p.u, p.v));
        const double reach = std::min(8.0, 1.3 * r * 1.0 / p.length + 0.1);
        const double slope = cone_constraint(surface, p.u, p.v, p.heading, reach, 0, here).slope;
        CAPTURE(depth.grid.width, depth.grid.height, depth.grid.wrap_x == Wrap::repeat, p.u, p.v, p.heading.x, p.heading.y, sector, sectors, r, slope, int(options.family), int(options.metric), surface.to_x(p.u), surface.to_y(p.v), cone_constraint(surface, p.u, p.v, p.heading, reach, 0, here).distance);
        REQUIRE(slope * r / p.length <= 1 + 2e-6);
    }
}

} // namespace

TEST_CASE("relaxed strict cones hold no exit; slope cones none that is steep enough; top cones none that a ray from the top finds") {
    for (const DepthMap& depth : fields())
        for (Metric metric : {Metric::l2, Metric::l1}) {
            ConeOptions options = options_of(ConeFamily::relaxed, metric);
            ConstraintRule rule;
            rule.exits_only = true;
            require_holds(depth, bake_cones(depth, options).ratio, options, rule, 1500);
            options.rays = RelaxedRays::slope, options.relaxed_slope = 2;
            rule.least_fall = 2;
            require_holds(depth, bake_cones(depth, options).ratio, options, rule, 600);
            options.rays = RelaxedRays::top;
            rule.least_fall = 0, rule.from_top = true;
            require_holds(depth, bake_cones(depth, options).ratio, options, rule, 600);
        }
}

TEST_CASE("relaxed cones widen from conservative over strict to slope and top; hybrid ones lie between") {
    DepthMap depth = bumpy(grid_of(61, 43, Wrap::repeat), 9);
    for (int j = 0; j < 43; ++j) // smooth hills: rough ones limit all families close by
        for (int i = 0; i < 61; ++i) depth.level(i, j) = std::floor(60.0f * float(2 + std::sin(i * 0.412) + std::cos(j * 0.4383)));
    const auto mean = [](const Image<float>& ratio) {
        double sum = 0;
        for (float r : ratio) sum += r;
        return sum / double(ratio.size());
    };
    ConeOptions options = options_of(ConeFamily::conservative);
    const Image<float> conservative = bake_cones(depth, options).ratio;
    options.family = ConeFamily::relaxed;
    const Image<float> strict = bake_cones(depth, options).ratio;
    options.rays = RelaxedRays::top;
    const Image<float> top = bake_cones(depth, options).ratio;
    for (std::size_t k = 0; k < strict.size(); ++k) REQUIRE(double(strict[k]) >= double(conservative[k]) * (1 - 2e-6));
    for (std::size_t k = 0; k < strict.size(); ++k) REQUIRE(double(top[k]) >= double(strict[k]) * (1 - 2e-6));
    REQUIRE(mean(strict) > 1.1 * mean(conservative));
    REQUIRE(mean(top) > 1.002 * mean(strict));
    options = options_of(ConeFamily::hybrid);
    double last = mean(conservative);
    for (float delta : {0.02f, 0.1f, 0.3f, 1.0f}) {
        options.hybrid_delta = delta;
        const double now = mean(bake_cones(depth, options).ratio);
        REQUIRE(now >= last);
        last = now;
    }
    options.hybrid_delta = 1;
    REQUIRE(bake_cones(depth, options).ratio == strict);
    options.hybrid_delta = 0;
    const Image<float> none = bake_cones(depth, options).ratio;
    for (std::size_t k = 0; k < none.size(); ++k) REQUIRE(double(none[k]) == Approx(double(conservative[k])).epsilon(1e-6));
}

TEST_CASE("hybrid cones hold no exit, and no point more than delta below the surface") {
    for (const DepthMap& depth : fields()) {
        ConeOptions options = options_of(ConeFamily::hybrid);
        options.hybrid_delta = 0.1f;
        const Image<float> ratio = bake_cones(depth, options).ratio;
        ConstraintRule exits, deep;
        exits.exits_only = true;
        deep.lift = 0.1;
        require_holds(depth, ratio, options, exits, 600);
        require_holds(depth, ratio, options, deep, 600);
    }
}

TEST_CASE("sector cones hold nothing in their sector, borders included") {
    for (const DepthMap& depth : fields())
        for (int sectors : {4, 8})
            for (ConeFamily family : {ConeFamily::conservative, ConeFamily::relaxed})
                for (Metric metric : {Metric::l2, Metric::l1}) {
                    if (sectors == 8 && metric == Metric::l1) continue;
                    const ConeOptions options = options_of(family, metric);
                    ConstraintRule rule;
                    rule.exits_only = family == ConeFamily::relaxed;
                    const std::vector<ConeMap> maps = bake_sector_cones(depth, sectors, options);
                    for (int k = 0; k < sectors; ++k) require_holds(depth, maps[std::size_t(k)].ratio, options, rule, 800, 0, k, sectors);
                }
}

TEST_CASE("the narrowest sector is the cone of all directions") {
    for (const DepthMap& depth : fields()) {
        const Image<float> whole = bake_cones(depth, options_of(ConeFamily::conservative)).ratio;
        for (int sectors : {4, 8}) {
            const std::vector<ConeMap> maps = bake_sector_cones(depth, sectors, options_of(ConeFamily::conservative));
            for (std::size_t k = 0; k < whole.size(); ++k) {
                float least = 1e30f;
                for (const ConeMap& map : maps) least = std::min(least, map.ratio[k]);
                CAPTURE(depth.grid.width, depth.grid.height, k, sectors);
                REQUIRE(double(least) == Approx(double(whole[k])).epsilon(1e-5));
            }
        }
    }
}

TEST_CASE("stacked cones hold nothing above their apex") {
    for (const DepthMap& depth : fields()) {
        const ConeOptions options = options_of(ConeFamily::conservative);
        const std::vector<ConeMap> maps = bake_stacked_cones(depth, 3, options);
        REQUIRE(maps[0].ratio == bake_cones(depth, options).ratio);
        for (int k = 0; k < 3; ++k) require_holds(depth, maps[std::size_t(k)].ratio, options, {}, 800, k / 3.0);
    }
}

TEST_CASE("a cell's cone holds over that cell, and is no narrower than the filtered one") {
    for (const DepthMap& depth : fields())
        for (ConeFamily family : {ConeFamily::conservative, ConeFamily::relaxed}) {
            ConeOptions options = options_of(family);
            const Image<float> filtered = bake_cones(depth, options).ratio;
            options.lookup = ConeLookup::cell;
            const Image<float> cell = bake_cones(depth, options).ratio;
            ConstraintRule rule;
            rule.exits_only = family == ConeFamily::relaxed;
            require_holds(depth, cell, options, rule, 1500);
            for (std::size_t k = 0; k < cell.size(); ++k) REQUIRE(double(cell[k]) >= double(filtered[k]) * (1 - 1e-6));
        }
}
