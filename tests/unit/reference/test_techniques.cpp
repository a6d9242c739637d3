#include "shaders-reference/measure/compare.h"
#include "shaders-reference/measure/stored_depth.h"
#include "shaders-reference/oracle/first_hit.h"
#include "shaders-reference/renderer/max_mip.h"
#include "shaders-reference/renderer/relief_renderer.h"
#include "tests/support/fields.h"
#include "tests/support/slow_cones.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace reliefbake;
using namespace reliefbake::test;

namespace {

constexpr TexelGrid square{32, 32, Wrap::repeat, Wrap::repeat, 1};

RenderOptions frame_of(Technique technique, double angle = 60, double azimuth = 25) {
    RenderOptions options;
    options.technique = technique;
    options.width = 96;
    options.height = 72;
    options.view.angle = angle;
    options.view.azimuth = azimuth;
    options.view.field_of_view = 12;
    options.max_steps = 1000;
    options.linear_steps = 128;
    options.binary_steps = 12;
    return options;
}

/// One renderer for all tests: it keeps its compiled programs.
Rendering drawn(const ReliefMap& map, const RenderOptions& options) {
    static ReliefRenderer renderer = std::move(*ReliefRenderer::create(RendererBackend::osmesa));
    REQUIRE(renderer.load(map));
    Result<Rendering> rendering = renderer.render(options);
    if (!rendering) FAIL(rendering.error().message);
    return std::move(*rendering);
}

Comparison judged(const ReliefMap& map, const RenderOptions& options) {
    return compare_with_oracle(BilinearSurface(stored_depth(map)), drawn(map, options));
}

/// Largest |t - t of the oracle| over all rays.
double worst_depth(const ReliefMap& map, const Rendering& rendering) {
    const BilinearSurface surface(stored_depth(map));
    double worst = 0;
    for (std::size_t i = 0; i < rendering.ray.size(); ++i) {
        if (rendering.status(i) == RayStatus::no_ray) continue;
        const Quad& ray = rendering.ray[i];
        const auto hit = first_hit(surface, {ray[0], ray[1], 1, ray[2], ray[3], -1});
        worst = !hit ? 1 : std::max(worst, std::abs(hit->t - double(rendering.counts[i][3])));
    }
    return worst;
}

DepthMap ramp() {
    return depth_of({32, 32, Wrap::clamp, Wrap::clamp, 1}, [](int i, int j) { return 0.1 + 0.6 * i / 31 + 0.2 * j / 31; });
}

DepthMap sphere() {
    return depth_of({32, 32, Wrap::clamp, Wrap::clamp, 1}, [](int i, int j) {
        const double x = (i - 15.5) / 12, y = (j - 15.5) / 12;
        return 0.2 + 0.7 * std::sqrt(std::max(0.0, 1 - x * x - y * y));
    });
}

ReliefMap float_map(const DepthMap& depth, ConeEncoding encoding = ConeEncoding::ratio) {
    MapChoices choices;
    choices.bits = BitDepth::float32;
    choices.encoding = encoding;
    return make_relief_map(depth, proven_l2_cones(depth, 1), 1, choices);
}

/// The same cones as planes of a kind: sectors all equal, or a stack whose upper levels say nothing.
ReliefMap as_kind(const ReliefMap& map, const std::string& kind, std::size_t planes) {
    ReliefMap other = map;
    other.info.kind = kind;
    other.cone_planes.assign(planes, map.cone);
    if (kind == "cone-stack")
        for (std::size_t k = 1; k < planes; ++k) std::fill(other.cone_planes[k].begin(), other.cone_planes[k].end(), 0.0f);
    other.cone = Image<float>();
    return other;
}

} // namespace

TEST_CASE("techniques that converge find what the oracle finds on a ramp and on a sphere", "[techniques]") {
    struct Claim {
        Technique technique;
        double tolerance; ///< depth: a bisected step of 1/128, the march's epsilon, or float rounding
    };
    const Claim claims[] = {{Technique::cone, 3e-3},    {Technique::cone_raw, 3e-3},       {Technique::relaxed, 3e-3},
                            {Technique::binary, 1e-4},  {Technique::relaxed_secant, 3e-3}, {Technique::interval, 1e-4},
                            {Technique::dynamic, 1e-4}, {Technique::max_mip, 2e-5},        {Technique::pom, 2e-3},
                            {Technique::linear, 9e-3},  {Technique::steep, 9e-3}};
    for (const DepthMap& depth : {ramp(), sphere()}) {
        const ReliefMap map = float_map(depth);
        for (const Claim& claim : claims)
            for (const double angle : {0.0, 35.0, 60.0}) {
                INFO("technique " << technique_info(claim.technique).word << " angle " << angle);
                CHECK(worst_depth(map, drawn(map, frame_of(claim.technique, angle))) < claim.tolerance);
            }
    }
}

TEST_CASE("the exact finish of filtered and unfiltered cones is exact", "[techniques]") {
    const ReliefMap map = float_map(sphere());
    for (const Technique technique : {Technique::cone, Technique::cone_raw}) {
        RenderOptions options = frame_of(technique);
        options.exact_finish = true;
        CHECK(worst_depth(map, drawn(map, options)) < 2e-5);
    }
}

TEST_CASE("maximum mipmaps miss nothing and need no cones", "[techniques]") {
    const TexelGrid grids[] = {{16, 16, Wrap::repeat, Wrap::repeat, 1}, {13, 9, Wrap::repeat, Wrap::repeat, 1},
                               {7, 12, Wrap::clamp, Wrap::clamp, 0.7},  {12, 5, Wrap::repeat, Wrap::clamp, 1.3},
                               {1, 1, Wrap::repeat, Wrap::repeat, 1},   {1, 6, Wrap::clamp, Wrap::repeat, 1}};
    std::uint32_t seed = 40;
    for (const TexelGrid& grid : grids) {
        ReliefMap map = float_map(noise(grid, seed++));
        map.info.bits = BitDepth::unorm16;
        map.cone = Image<float>();
        for (const double angle : {0.0, 60.0, 85.0})
            for (const double azimuth : {0.0, 70.0, 200.0}) {
                const Comparison result = judged(map, frame_of(Technique::max_mip, angle, azimuth));
                INFO("grid " << grid.width << "x" << grid.height << " angle " << angle << " azimuth " << azimuth);
                CHECK(result.rays > 20);
                CHECK(result.missed == 0);
                CHECK(result.early == 0);
                CHECK(result.out_of_steps == 0);
            }
    }
}

TEST_CASE("a pyramid's top is the least depth, and clamped axes have a half cell more at either end", "[techniques]") {
    const DepthMap depth = noise({7, 12, Wrap::clamp, Wrap::repeat, 1}, 3);
    Image<float> plane(7, 12);
    for (std::size_t i = 0; i < plane.size(); ++i) plane[i] = depth.level[i] / 255;
    const MaxMip mip = build_max_mip(plane, depth.grid);
    CHECK(mip.cells_x == 8);
    CHECK(mip.cells_y == 12);
    CHECK(mip.levels.front().height() == 16);
    REQUIRE(mip.levels.back().size() == 1);
    const float least = *std::min_element(plane.begin(), plane.end());
    CHECK(mip.levels.back()[0] <= least);
    CHECK(mip.levels.back()[0] == Approx(least).epsilon(1e-6));
}

TEST_CASE("parallax takes the relief for flat, and offset limiting shortens its way", "[techniques]") {
    const DepthMap flat = depth_of({4, 4, Wrap::repeat, Wrap::repeat, 1}, [](int, int) { return 0.4; });
    const ReliefMap map = float_map(flat);
    CHECK(worst_depth(map, drawn(map, frame_of(Technique::parallax))) < 1e-6);
    RenderOptions options = frame_of(Technique::parallax_limited, 60);
    options.view.field_of_view = 0.1;
    const Rendering limited = drawn(map, options);
    CHECK(limited.counts(48, 36)[3] == Approx(0.6 * 0.5).epsilon(1e-2)); // cos 60
    CHECK(limited.counts(48, 36)[1] == 1);
}

TEST_CASE("fewer steps are taken seen from above by dynamic, more at grazing views by steep", "[techniques]") {
    const DepthMap floor = depth_of({4, 4, Wrap::repeat, Wrap::repeat, 1}, [](int, int) { return 0.0; });
    const ReliefMap map = float_map(floor);
    const auto steps = [&](Technique technique, double angle) {
        RenderOptions options = frame_of(technique, angle);
        options.linear_steps = 40;
        options.binary_steps = 0;
        options.view.field_of_view = 0.1;
        return drawn(map, options).counts(48, 36)[0];
    };
    CHECK(steps(Technique::dynamic, 0) == Approx(11).margin(1));
    CHECK(steps(Technique::dynamic, 88) == Approx(41).margin(2));
    CHECK(steps(Technique::steep, 0) == Approx(41).margin(1));
    CHECK(steps(Technique::steep, 88) == Approx(80).margin(2));
    CHECK(steps(Technique::linear, 88) == 41);
}

TEST_CASE("halving gains a bit a step, and a secant is exact on a plane", "[techniques]") {
    const ReliefMap map = float_map(ramp());
    RenderOptions options = frame_of(Technique::binary);
    options.linear_steps = 16;
    options.binary_steps = 2;
    const double coarse = worst_depth(map, drawn(map, options));
    options.binary_steps = 6;
    const double fine = worst_depth(map, drawn(map, options));
    CHECK(fine < coarse / 8);
    options.technique = Technique::interval;
    options.binary_steps = 1;
    // Away from the clamped border the ramp is a plane, but rays of the border meet its kink.
    CHECK(worst_depth(map, drawn(map, options)) < coarse);
}

TEST_CASE("planes that are all equal draw what one cone draws", "[techniques]") {
    for (const ConeEncoding encoding : {ConeEncoding::ratio, ConeEncoding::sqrt, ConeEncoding::radius, ConeEncoding::normal})
        for (const ConeLookup lookup : {ConeLookup::filtered, ConeLookup::cell}) {
            ReliefMap map = float_map(noise(square, 12), encoding);
            map.info.lookup = lookup;
            for (const double azimuth : {0.0, 45.0, 100.0, 190.0, 350.0}) {
                const RenderOptions options = frame_of(Technique::cone, 70, azimuth);
                const Rendering one = drawn(map, options);
                for (const auto& [kind, planes] : {std::pair("acm", 4), std::pair("acm", 8), std::pair("cone-stack", 2), std::pair("cone-stack", 7)}) {
                    const Rendering other = drawn(as_kind(map, kind, std::size_t(planes)), options);
                    double difference = 0, steps = 0;
                    for (std::size_t i = 0; i < one.hit.size(); ++i) {
                        difference = std::max(difference, double(std::abs(one.hit[i][2] - other.hit[i][2])));
                        steps = std::max(steps, double(std::abs(one.counts[i][0] - other.counts[i][0])));
                    }
                    INFO(kind << " of " << planes << " encoding " << int(encoding) << " lookup " << int(lookup) << " azimuth " << azimuth);
                    CHECK(difference < 1e-5);
                    CHECK(steps <= 1);
                    CHECK(other.counts(48, 36)[1] >= one.counts(48, 36)[1]);
                }
            }
        }
}

TEST_CASE("every ray reads the cone of its own sector, borders included", "[techniques]") {
    // A flat floor under cones that differ by sector: the first step of a ray says which one it read.
    const DepthMap floor = depth_of({4, 2, Wrap::repeat, Wrap::repeat, 1}, [](int, int) { return 0.0; });
    for (const int sectors : {4, 8}) {
        ReliefMap map = as_kind(float_map(floor), "acm", std::size_t(sectors));
        const auto ratio_of = [](int sector) { return 0.1f * float(sector + 1); };
        for (int k = 0; k < sectors; ++k)
            std::fill(map.cone_planes[std::size_t(k)].begin(), map.cone_planes[std::size_t(k)].end(), ratio_of(k));
        for (int heading = 0; heading < 360; heading += 15) {
            RenderOptions options = frame_of(Technique::cone, 80, heading);
            options.width = options.height = 33;
            options.max_steps = 1;
            options.view.field_of_view = 3;
            const Rendering rendering = drawn(map, options);
            int rays = 0;
            for (std::size_t i = 0; i < rendering.ray.size(); ++i) {
                if (rendering.status(i) == RayStatus::no_ray) continue;
                const float x = rendering.ray[i][2], y = float(map.grid.aspect()) * rendering.ray[i][3];
                const long double turn = std::atan2((long double)(y), (long double)(x)) / 6.283185307179586476925287L;
                const int sector = (int(std::floor(turn * sectors)) + sectors) % sectors;
                const double ratio = ratio_of(sector);
                const double expected = ratio / (std::hypot(x, y) + ratio);
                if (std::abs(rendering.counts[i][3] - expected) > 1e-5) FAIL_CHECK("of " << sectors << " sectors not " << sector << " for " << x << ", " << y);
                ++rays;
            }
            CHECK(rays > 0);
        }
    }
}

TEST_CASE("the longest step of a stack's cones wins", "[techniques]") {
    // Floor at 0: apexes at 0 and 1/2. Straight ahead the upper cone is wide, and the ray enters a gap of 1/2 above it.
    const DepthMap floor = depth_of({4, 4, Wrap::repeat, Wrap::repeat, 1}, [](int, int) { return 0.0; });
    ReliefMap map = as_kind(float_map(floor), "cone-stack", 2);
    std::fill(map.cone_planes[0].begin(), map.cone_planes[0].end(), 0.1f);
    std::fill(map.cone_planes[1].begin(), map.cone_planes[1].end(), 1.0f);
    RenderOptions options = frame_of(Technique::cone, 60, 90);
    options.max_steps = 1;
    options.view.field_of_view = 0.1;
    const Rendering rendering = drawn(map, options);
    const Quad& ray = rendering.ray(48, 36);
    const double reach = std::hypot(ray[2], ray[3]);
    CHECK(rendering.counts(48, 36)[3] == Approx(std::max(0.1 / (reach + 0.1), 0.5 / (reach + 1))).epsilon(1e-5));
    CHECK(rendering.counts(48, 36)[1] == 2);
}

TEST_CASE("a step leaves a cone of pieces through one of them", "[techniques]") {
    // Floor at 0: the pieces meet at 1/2. The first step starts at 1, above both.
    const DepthMap floor = depth_of({4, 4, Wrap::repeat, Wrap::repeat, 1}, [](int, int) { return 0.0; });
    ReliefMap map = as_kind(float_map(floor), "cone-pieces", 2);
    RenderOptions options = frame_of(Technique::cone, 60, 90);
    options.max_steps = 1;
    options.view.field_of_view = 0.1;
    const auto step = [&](float lower, float upper) {
        std::fill(map.cone_planes[0].begin(), map.cone_planes[0].end(), lower);
        std::fill(map.cone_planes[1].begin(), map.cone_planes[1].end(), upper);
        const Rendering rendering = drawn(map, options);
        const Quad& ray = rendering.ray(48, 36);
        return std::pair(rendering.counts(48, 36)[3], std::hypot(ray[2], ray[3]));
    };
    const auto [low, reach] = step(1.0f, 0.6f);
    CHECK(low == Approx(1 / (reach + 1)).epsilon(1e-5)); // the lower piece is as wide as a cone of ratio 1
    const auto [high, same] = step(0.1f, 0.06f); // radii 0.05 at 1/2, 0.06 at 1
    REQUIRE(0.5 * same > 0.05);
    CHECK(high == Approx((0.05 + 0.02 * 0.5) / (same + 0.02)).epsilon(1e-5));
    const auto [flat, also] = step(0.1f, 0.01f); // a radius of 0.01 at 1 is 0.05, as below it
    CHECK(flat == Approx(0.05 / also).epsilon(1e-5));
}

TEST_CASE("lookups cost what they read", "[techniques]") {
    ReliefMap map = float_map(noise(square, 5));
    RenderOptions options = frame_of(Technique::cone);
    options.max_steps = 1;
    const auto fetches = [&] { return drawn(map, options).counts(48, 36)[1]; };
    CHECK(fetches() == 1);
    options.technique = Technique::cone_raw;
    CHECK(fetches() == 5);
    options.technique = Technique::cone;
    map.info.lookup = ConeLookup::cell;
    CHECK(fetches() == 2);
    map = as_kind(map, "cone-stack", 5);
    CHECK(fetches() == 3);
    map = as_kind(float_map(noise(square, 5), ConeEncoding::radius), "acm", 8);
    CHECK(fetches() == 2);
    map.info.lookup = ConeLookup::cell;
    CHECK(fetches() == 3);
}

TEST_CASE("unfiltered texel cones are safe where the least of four taps is", "[techniques]") {
    // The least L1 cone of a cell's corners is safe in the cell (MATHS section 2): no 3x3 minimum needed.
    for (const ConeEncoding encoding : {ConeEncoding::sqrt, ConeEncoding::radius}) {
        MapChoices choices;
        choices.metric = Metric::l1;
        choices.encoding = encoding;
        const DepthMap depth = noise(square, 21);
        const ReliefMap map = make_relief_map(depth, texel_cones(depth, Metric::l1, 1), 1, choices);
        CHECK(judged(map, frame_of(Technique::cone_raw, 75, 33)).missed == 0);
        CHECK(judged(map, frame_of(Technique::cone, 75, 33)).missed > 0);
    }
}

TEST_CASE("shadows darken, and cones that may hold relief are refused where they must be empty", "[techniques]") {
    ReliefMap map = float_map(sphere());
    map.info.depth_scale = 0.4;
    RenderOptions options = frame_of(Technique::max_mip, 40);
    options.sun.elevation = 20;
    const auto light = [&] {
        double sum = 0;
        for (const std::uint8_t value : drawn(map, options).colour.rgb) sum += value;
        return sum;
    };
    const double lit = light();
    for (const Shadow shadow : {Shadow::hard, Shadow::height_soft, Shadow::cone_soft}) {
        options.shadow = shadow;
        CHECK(light() < 0.99 * lit);
    }
    options.shadow = Shadow::none;
    options.ambient = Ambient::none;
    const double open = light();
    for (const Ambient ambient : {Ambient::cone, Ambient::cone_normal}) {
        options.ambient = ambient;
        CHECK(light() < open);
    }

    map.info.family = ConeFamily::relaxed;
    CHECK_FALSE(render(map, options));
    options.ambient.reset();
    options.shadow = Shadow::hard;
    CHECK(render(map, options));
    CHECK(light() < 0.99 * open);
    options.shadow = Shadow::cone_soft;
    CHECK_FALSE(render(map, options));
}

TEST_CASE("techniques that a map does not serve are refused", "[techniques]") {
    const ReliefMap map = float_map(noise(square, 2));
    CHECK_FALSE(render(as_kind(map, "acm", 4), frame_of(Technique::cone_published)));
    ReliefMap cells = map;
    cells.info.lookup = ConeLookup::cell;
    CHECK_FALSE(render(cells, frame_of(Technique::cone_raw)));
    ReliefMap bare = map;
    bare.cone = Image<float>();
    CHECK_FALSE(render(bare, frame_of(Technique::cone)));
    CHECK(suitable_technique(bare) == Technique::max_mip);
    bare.depth = Image<float>();
    CHECK_FALSE(render(bare, frame_of(Technique::linear)));
    CHECK_FALSE(render(as_kind(map, "cone-stack", 9), frame_of(Technique::cone)));
}
