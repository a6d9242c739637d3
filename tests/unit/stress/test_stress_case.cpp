// The judges of `stress`: right bakes hold, broken ones are caught, by whom they must be.

#include "cli/stress/stress_case.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace reliefbake;

namespace {

constexpr StressEffort effort{800, 400, 64, 3, 1};

StressField field(const std::string& name) {
    for (const StressField& field : stress_fields(StressExtent::quick))
        if (field.name == name) return field;
    FAIL("no field " << name);
    return {};
}

ReliefMap baked(const StressField& field, ConeEncoding encoding, BitDepth bits) {
    const auto source = stress_source(field, bits, Wrap::repeat);
    REQUIRE(source);
    RepresentationBaker baker(*source, field.depth_scale, 1);
    Representation wanted;
    wanted.encoding = encoding, wanted.bits = bits;
    const auto map = baker.bake(wanted);
    REQUIRE(map);
    return (*map)->map;
}

StressResult judged(const StressField& field, const ReliefMap& map) {
    const auto result = judge_stress_map(field, map, effort);
    REQUIRE(result);
    return *result;
}

} // namespace

TEST_CASE("A bake with widened cones is caught: by doubles, by rational numbers, by rays", "[stress]") {
    for (const char* name : {"walls", "white-noise", "checkerboard", "hills"}) {
        const StressField what = field(name);
        ReliefMap map = baked(what, ConeEncoding::sqrt, BitDepth::unorm8);
        CAPTURE(name);
        CHECK(judged(what, map).holds());
        for (float& code : map.cone) code = std::min(1.0f, std::ceil(code * 255 * 1.7f) / 255); // cones 2.9 times as wide
        const StressResult wide = judged(what, map);
        CHECK_FALSE(wide.holds());
        CHECK(wide.cones.violations > 0);
        CHECK(wide.exact->violated > 0);
        CHECK(wide.rays->missed > 0);
        CHECK(wide.tightness > 1);
    }
}

TEST_CASE("One texel's cone that is too wide by one rounding of a float: rational numbers alone rule", "[stress]") {
    // Seen from texel (5, 4), the spike at (8, 8) of 16 x 16 is five texels away: a ratio of 5/16 touches it.
    const StressField what = field("spike");
    ReliefMap map = baked(what, ConeEncoding::ratio, BitDepth::float32);
    std::fill(map.cone.begin(), map.cone.end(), 1e-3f);
    StressEffort all = effort;
    all.exact_points = 1024; // the whole lattice
    map.cone(5, 4) = std::nextafter(5.0f / 16, 0.0f);
    auto result = judge_stress_map(what, map, all);
    REQUIRE(result);
    CHECK(result->exact->points == 1024);
    const auto narrow = result->exact->violated;
    map.cone(5, 4) = std::nextafter(5.0f / 16, 1.0f);
    result = judge_stress_map(what, map, all);
    REQUIRE(result);
    CHECK(result->exact->violated == narrow + 1);
    CHECK_FALSE(result->holds());
}

TEST_CASE("A missed ray, or a point left undecided, is a case that does not hold", "[stress]") {
    StressResult result;
    CHECK(result.holds());
    result.rays = Comparison{};
    result.exact = ExactCheck{};
    CHECK(result.holds());
    result.rays->missed = 1;
    CHECK_FALSE(result.holds());
    result.rays->missed = 0;
    result.exact->undecided = 1;
    CHECK_FALSE(result.holds());
    result.exact.reset();
    result.cones.violations = 1;
    CHECK_FALSE(result.holds());
}

TEST_CASE("The way of the largest field says the same of a small one as the way of all others", "[stress]") {
    StressField what = field("size-7x5");
    const StressResult marched = judged(what, baked(what, ConeEncoding::sqrt, BitDepth::unorm8));
    const auto alone = run_largest_case(what, ConeEncoding::sqrt, BitDepth::unorm8, effort);
    REQUIRE(alone);
    CHECK(alone->cones.points == marched.cones.points);
    CHECK(alone->cones.worst == marched.cones.worst);
    CHECK(alone->cones.violations == 0);
    CHECK(alone->tightness == marched.tightness);
    CHECK(alone->dead == marched.dead);
    CHECK(alone->ratio_mean == Approx(marched.ratio_mean));
    CHECK_FALSE(alone->rays);
    CHECK_FALSE(alone->exact);
}

TEST_CASE("One renderer for many maps shows each what its own would", "[stress]") {
    auto renderer = ReliefRenderer::create(RendererBackend::osmesa);
    REQUIRE(renderer);
    StressEffort shared = effort;
    shared.renderer = &*renderer;
    for (const char* name : {"walls", "size-7x5", "hills"})
        for (const ConeEncoding encoding : {ConeEncoding::sqrt, ConeEncoding::radius}) {
            CAPTURE(name, int(encoding));
            const StressField what = field(name);
            const ReliefMap map = baked(what, encoding, BitDepth::unorm8);
            const StressResult alone = judged(what, map);
            const auto together = judge_stress_map(what, map, shared);
            REQUIRE(together);
            CHECK(together->rays->rays == alone.rays->rays);
            CHECK(together->rays->steps_mean == alone.rays->steps_mean);
            CHECK(together->rays->mse == alone.rays->mse);
        }
}

TEST_CASE("Dead texels are those of code 0, counted from the stored map", "[stress]") {
    for (const ConeEncoding encoding : {ConeEncoding::ratio, ConeEncoding::sqrt, ConeEncoding::radius, ConeEncoding::normal}) {
        const StressField what = field("size-1024x16");
        const ReliefMap map = baked(what, encoding, BitDepth::unorm8);
        std::size_t zeros = 0;
        for (std::size_t k = 0; k < map.cone.size(); ++k) zeros += map.cone.data()[k] == 0 && (encoding != ConeEncoding::radius || map.depth.data()[k] > 0);
        CAPTURE(int(encoding));
        CHECK(judged(what, map).dead == zeros);
        if (encoding == ConeEncoding::sqrt) CHECK(zeros == 0);
        else CHECK(zeros > 8000); // cones of half a texel of 1024 are narrower than 1/255
    }
}
