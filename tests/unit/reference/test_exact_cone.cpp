// The rational judge: on cones known in closed form, one rounding apart; on bakes; against the judge in doubles.

#include "bake/cone.h"
#include "shaders-reference/measure/check_cones.h"
#include "shaders-reference/measure/exact_check.h"
#include "shaders-reference/measure/stored_depth.h"
#include "tests/support/cone_fields.h"
#include "tests/support/slow_cones.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace reliefbake;
using namespace reliefbake::test;

namespace {

/// A spike of height `high` at texel (7, 8) of 16 x 16, seen from the centre of texel (4, 4): 3 and 4 texels away.
DepthMap spike(double high) {
    return depth_of(grid_of(16, 16, Wrap::clamp), [high](int i, int j) { return i == 7 && j == 8 ? high : 0; });
}

ExactVerdict judge(const DepthMap& depth, HalfTexel apex, float ratio, Metric metric = Metric::l2) {
    const Rational r = exactly(ratio);
    return judge_exactly(ExactSurface(depth), apex, Rational(r * r), metric).verdict;
}

ReliefMap baked(const DepthMap& depth, ConeEncoding encoding, BitDepth bits, Metric metric = Metric::l2) {
    ConeOptions options;
    options.metric = metric;
    options.threads = 1;
    const ConeMap cones = bake_cones(depth, options);
    MapChoices choices{encoding, bits, metric};
    ReliefMap map = make_relief_map(depth, cones.ratio, 1, choices);
    map.cone = encode_cones(cones, depth, {encoding, bits}).value;
    return map;
}

} // namespace

TEST_CASE("A spike five texels away: one rounding of a float decides", "[exact]") {
    const float touching = 5.0f / 16; // distance 5/16 over height 1
    CHECK(judge(spike(1), {8, 8}, std::nextafter(touching, 1.0f)) == ExactVerdict::violated);
    CHECK(judge(spike(1), {8, 8}, std::nextafter(touching, 0.0f)) == ExactVerdict::holds);
    CHECK(judge(spike(1), {8, 8}, touching) != ExactVerdict::violated);
    // In l1 it is seven texels away.
    CHECK(judge(spike(1), {8, 8}, std::nextafter(7.0f / 16, 1.0f), Metric::l1) == ExactVerdict::violated);
    CHECK(judge(spike(1), {8, 8}, std::nextafter(7.0f / 16, 0.0f), Metric::l1) == ExactVerdict::holds);
}

TEST_CASE("Doubles cannot tell a cone that is one rounding too wide", "[exact]") {
    const DepthMap depth = spike(1);
    ReliefMap map = make_relief_map(depth, Image<float>(16, 16, 1e-3f), 1, {ConeEncoding::ratio, BitDepth::float32});
    map.cone(4, 4) = std::nextafter(5.0f / 16, 1.0f);
    const ExactCheck wide = check_exactly(map, 1 << 20);
    map.cone(4, 4) = std::nextafter(5.0f / 16, 0.0f);
    const ExactCheck narrow = check_exactly(map, 1 << 20);
    CHECK(wide.violated == narrow.violated + 1);
    CHECK(wide.doubles_wrong == narrow.doubles_wrong + 1);
}

TEST_CASE("A spike five texels away: one code of 255 decides", "[exact]") {
    ReliefMap map = make_relief_map(spike(1), Image<float>(16, 16, 1e-3f), 1, {ConeEncoding::ratio, BitDepth::unorm8});
    for (const int code : {79, 80}) { // 255 * 5 / 16 = 79.7
        map.cone(4, 4) = float(code) / 255;
        const std::optional<Rational> squared = exact_ratio_squared(map, {8, 8});
        CHECK(*squared == Rational(code * code) / (255 * 255));
        const ExactVerdict verdict = judge_exactly(ExactSurface(stored_depth(map)), {8, 8}, squared, Metric::l2).verdict;
        CHECK(verdict == (code == 80 ? ExactVerdict::violated : ExactVerdict::holds));
    }
}

TEST_CASE("Beside a wall the gradient decides, to one rounding", "[exact]") {
    // Height 1/2 a texel of 1/16: slope 8 along x, ratio 1/8.
    const DepthMap ramp = depth_of(grid_of(16, 4, Wrap::clamp), [](int i, int) { return i < 4 ? 0 : i < 6 ? (i - 3) / 2.0 : 1; });
    for (const HalfTexel apex : {HalfTexel{6, 2}, HalfTexel{7, 2}, HalfTexel{7, 3}, HalfTexel{8, 2}}) {
        CAPTURE(apex.x, apex.y);
        CHECK(judge(ramp, apex, std::nextafter(0.125f, 1.0f)) == ExactVerdict::violated);
        CHECK(judge(ramp, apex, 0.125f) != ExactVerdict::violated); // chords touch the cone all along
        CHECK(judge(ramp, apex, std::nextafter(0.125f, 0.0f)) == ExactVerdict::holds);
    }
    // A saddle's steepest chord lies on its diagonal, where the twist bends it.
    const DepthMap saddle = depth_of(grid_of(2, 2, Wrap::clamp), [](int i, int j) { return (i + j) % 2; });
    CHECK(judge(saddle, {0, 0}, 0.36f) == ExactVerdict::violated); // slope 2 sqrt(2), ratio 0.35355
    CHECK(judge(saddle, {0, 0}, 0.35f) == ExactVerdict::holds);
}

TEST_CASE("A cone without bound holds only where nothing is higher", "[exact]") {
    CHECK(judge_exactly(ExactSurface(spike(1)), {0, 0}, std::nullopt, Metric::l2).verdict == ExactVerdict::violated);
    CHECK(judge_exactly(ExactSurface(spike(1)), {14, 16}, std::nullopt, Metric::l2).verdict == ExactVerdict::holds);
}

TEST_CASE("Baked cones hold exactly, in every encoding and metric; a code too wide is caught", "[exact]") {
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp})
        for (const Metric metric : {Metric::l2, Metric::l1})
            for (const ConeEncoding encoding : {ConeEncoding::ratio, ConeEncoding::sqrt, ConeEncoding::radius, ConeEncoding::normal})
                for (const BitDepth bits : {BitDepth::unorm8, BitDepth::float32}) {
                    if (metric == Metric::l1 && encoding == ConeEncoding::normal) continue;
                    CAPTURE(int(wrap), int(metric), int(encoding), int(bits));
                    DepthMap depth = noise(grid_of(7, 5, wrap, metric == Metric::l2 ? 0.75 : 1), 3);
                    if (bits == BitDepth::float32) {
                        depth.bits = bits;
                        for (float& level : depth.level) level /= 255;
                    }
                    ReliefMap map = baked(depth, encoding, bits, metric);
                    const ExactCheck check = check_exactly(map, 1 << 20);
                    CHECK(check.points >= 9 * 13);
                    CHECK(check.violated == 0);
                    CHECK(check.undecided == 0);
                    CHECK(check.doubles_wrong == 0);
                    // A cone also holds at the far corners of its cells, where no fetch returns it alone: it can be narrower than
                    // any point of the lattice asks, but not by half.
                    for (float& code : map.cone) code = std::min(1.0f, std::ceil(code * 2 * 255) / 255);
                    CHECK(check_exactly(map, 1 << 20).violated > 0);
                }
}
