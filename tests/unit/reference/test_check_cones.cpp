#include "shaders-reference/measure/check_cones.h"
#include "shaders-reference/measure/stored_depth.h"
#include "tests/support/fields.h"
#include "tests/support/slow_cones.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace reliefbake;
using namespace reliefbake::test;

namespace {

constexpr TexelGrid square16{16, 16, Wrap::repeat, Wrap::repeat, 1};

ConeCheck check(const ReliefMap& map, int points = 4000) {
    ConeCheckOptions options;
    options.points = points;
    return check_cones(map, BilinearSurface(stored_depth(map)), options);
}

DepthMap saddle() {
    return depth_of({2, 2, Wrap::clamp, Wrap::clamp, 1}, [](int i, int j) { return (i + j) % 2; });
}

/// Tight and safe: brute force, a hair narrower than what its sampling can overlook.
Image<float> tight_cones(const DepthMap& depth) {
    Image<float> cones = footprint_cones(depth, 1, 8, 256);
    for (float& cone : cones) cone *= 0.95f;
    return cones;
}

} // namespace

TEST_CASE("proven maps pass in every encoding, depth, size and wrap", "[check]") {
    std::uint32_t seed = 20;
    for (const TexelGrid& grid : {square16, TexelGrid{1, 1}, TexelGrid{2, 1}, TexelGrid{1, 3, Wrap::clamp, Wrap::clamp, 2},
                                  TexelGrid{17, 13, Wrap::clamp, Wrap::repeat, 0.6}, TexelGrid{7, 16, Wrap::repeat, Wrap::clamp, 1}})
        for (const ConeEncoding encoding : {ConeEncoding::ratio, ConeEncoding::sqrt, ConeEncoding::radius, ConeEncoding::normal})
            for (const BitDepth bits : {BitDepth::unorm8, BitDepth::unorm16}) {
                DepthMap depth = noise(grid, seed++);
                if (bits == BitDepth::unorm16) {
                    depth.bits = bits;
                    for (float& level : depth.level) level *= 257;
                }
                const ReliefMap map = make_relief_map(depth, proven_l2_cones(depth, 1), 1, {encoding, bits});
                const ConeCheck result = check(map, 600);
                INFO("size " << grid.width << "x" << grid.height << " encoding " << int(encoding) << " worst " << result.worst);
                CHECK(result.points == 600);
                CHECK(result.violations == 0);
            }
}

TEST_CASE("square cones pass in their own metric and fail as round ones", "[check]") {
    const DepthMap depth = noise(square16, 5);
    MapChoices choices;
    choices.metric = Metric::l1;
    ReliefMap map = make_relief_map(depth, minimum_3x3(texel_cones(depth, Metric::l1, 1), square16), 1, choices);
    CHECK(check(map).violations == 0);
    map.info.metric = Metric::l2;
    CHECK(check(map).violations > 0);
}

TEST_CASE("a tight map passes, and is seen to be tight", "[check]") {
    const DepthMap depth = noise(square16, 6);
    const ConeCheck result = check(make_relief_map(depth, tight_cones(depth), 1, {}));
    INFO(result.worst);
    CHECK(result.violations == 0);
    CHECK(result.worst > 0.9);
}

TEST_CASE("cones without a cap are checked too", "[check]") {
    const DepthMap depth = depth_of({16, 16, Wrap::repeat, Wrap::repeat, 1}, [](int i, int) { return i == 3 ? 0.9 : 0.2; });
    const MapChoices choices{ConeEncoding::normal, BitDepth::float32};
    CHECK(check(make_relief_map(depth, proven_l2_cones(depth, 1e3), 1e3, choices), 1000).violations == 0);
    CHECK(check(make_relief_map(depth, Image<float>(16, 16, 1e30f), 1e30, choices), 1000).violations > 500);
}

TEST_CASE("the plain 3x3 minimum of round texel cones is caught", "[check]") {
    for (const DepthMap& depth : {saddle(), noise(square16, 7)}) {
        const Image<float> cones = minimum_3x3(texel_cones(depth, Metric::l2, 1), depth.grid);
        const ConeCheck result = check(make_relief_map(depth, cones, 1, {}));
        CHECK(result.violations > 0);
        CHECK(result.worst > 1.2);
        CHECK(result.worst < 1.4143);
    }
}

TEST_CASE("texel cones without any minimum are caught", "[check]") {
    const DepthMap depth = noise(square16, 8);
    CHECK(check(make_relief_map(depth, texel_cones(depth, Metric::l2, 1), 1, {})).worst > 1.5);
}

TEST_CASE("the tightest cone widened by three per cent is caught", "[check]") {
    for (const DepthMap& depth : {saddle(), noise(square16, 9)}) {
        Image<float> cones = tight_cones(depth);
        REQUIRE(check(make_relief_map(depth, cones, 1, {}), 20000).violations == 0);
        // The texels around the surface's tightest point share its cone.
        const Image<float> exact = footprint_cones(depth, 1, 8, 256);
        const float least = *std::min_element(exact.begin(), exact.end());
        for (std::size_t i = 0; i < exact.size(); ++i)
            if (exact[i] == least) cones[i] = 1.03f * least;
        CHECK(check(make_relief_map(depth, cones, 1, {}), 20000).violations > 0);
    }
}

TEST_CASE("rounding up instead of down is caught", "[check]") {
    // Heights 0 and 1/2 in columns: the cones of the low columns end exactly at the next high one.
    const DepthMap depth = depth_of({8, 8, Wrap::repeat, Wrap::repeat, 1}, [](int i, int) { return i % 2 * 0.5; });
    for (const BitDepth bits : {BitDepth::unorm8, BitDepth::unorm16}) {
        DepthMap coded = depth;
        coded.bits = bits;
        for (float& level : coded.level) level = std::round(level * float(max_code(bits)));
        const Image<float> exact = footprint_cones(coded, 0.9, 8, 256);
        CHECK(check(make_relief_map(coded, exact, 0.9, {ConeEncoding::ratio, bits, Metric::l2, Rounding::down})).violations == 0);
        CHECK(check(make_relief_map(coded, exact, 0.9, {ConeEncoding::ratio, bits, Metric::l2, Rounding::up})).violations > 0);
    }
}

TEST_CASE("texel maps are held to their own definition", "[check]") {
    const DepthMap depth = noise(square16, 10);
    ReliefMap map = make_relief_map(depth, texel_cones(depth, Metric::l2, 1), 1, {});
    map.info.surface = SurfaceModel::texel;
    CHECK(check(map).violations == 0);
    for (float& cone : map.cone) cone *= 1.03f;
    CHECK(check(map).violations > 0);
}

TEST_CASE("the check is the same for every thread count and follows its seed", "[check]") {
    const DepthMap depth = noise(square16, 11);
    const ReliefMap map = make_relief_map(depth, texel_cones(depth, Metric::l2, 1), 1, {});
    const BilinearSurface surface(depth);
    ConeCheckOptions options;
    options.points = 3000;
    options.threads = 1;
    const ConeCheck one = check_cones(map, surface, options);
    options.threads = 2;
    const ConeCheck many = check_cones(map, surface, options);
    CHECK(one.violations == many.violations);
    CHECK(one.worst == many.worst);
    CHECK(one.u == many.u);
    options.seed = 2;
    CHECK(check_cones(map, surface, options).violations != one.violations);
}
