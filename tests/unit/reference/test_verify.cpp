#include "bake/filter_delta.h"
#include "shaders-reference/measure/heat_map.h"
#include "shaders-reference/measure/tightness.h"
#include "shaders-reference/measure/stored_depth.h"
#include "shaders-reference/measure/verify.h"
#include "tests/support/fields.h"
#include "tests/support/slow_cones.h"

#include <catch2/catch.hpp>

using namespace reliefbake;
using namespace reliefbake::test;

namespace {

constexpr TexelGrid square16{16, 16, Wrap::repeat, Wrap::repeat, 1};

VerifyOptions quick() {
    VerifyOptions options;
    options.rays = 13000;
    options.points = 2000;
    return options;
}

VerifyReport verified(const ReliefMap& map, const VerifyOptions& options = quick()) {
    Result<VerifyReport> report = verify(map, options);
    REQUIRE(report);
    return std::move(*report);
}

} // namespace

TEST_CASE("a proven map is judged safe", "[verify]") {
    const DepthMap depth = noise(square16, 1);
    const ReliefMap map = make_relief_map(depth, proven_l2_cones(depth, 1), 1, {});
    VerifyOptions options = quick();
    options.source = &depth;
    const VerifyReport report = verified(map, options);
    CHECK(report.verdict == Verdict::safe);
    CHECK(report.total.missed == 0);
    CHECK(report.total.rays > 10000);
    CHECK(report.tightness.value() > 0.5);
    CHECK(report.tightness.value() < 1);
    REQUIRE(report.depth_difference);
    CHECK(*report.depth_difference < 1.0 / 65535);
    CHECK_FALSE(report.views.front().pictures);
}

TEST_CASE("cones twice too wide are judged unsafe by rays and by points", "[verify]") {
    const DepthMap depth = noise(square16, 2);
    Image<float> cones = footprint_cones(depth, 1, 4, 64);
    for (float& cone : cones) cone *= 2;
    const VerifyReport report = verified(make_relief_map(depth, cones, 1, {}));
    CHECK(report.verdict == Verdict::unsafe);
    CHECK(report.cones.violations > 0);
    CHECK(report.total.missed > 0);
    CHECK(report.tightness.value() > 1.5);
}

TEST_CASE("a texel map keeps its word and is not conservative", "[verify]") {
    const DepthMap depth = noise(square16, 3);
    ReliefMap map = make_relief_map(depth, texel_cones(depth, Metric::l2, 1), 1, {});
    map.info.surface = SurfaceModel::texel;
    CHECK(verified(map).verdict == Verdict::not_conservative);
}

TEST_CASE("8-bit filter weights are safe with the map's delta and not without", "[verify]") {
    // Coarse texels magnified: the error of the weights shows on every slope.
    const DepthMap depth = noise(square16, 4);
    ReliefMap map = make_relief_map(depth, proven_l2_cones(depth, 1), 1, {ConeEncoding::sqrt, BitDepth::unorm8});
    VerifyOptions options = quick();
    options.filter = SamplerFilter::fixed8;
    CHECK(verified(map, options).total.missed > 0);
    map.info.filter_delta = filter_delta(depth);
    const VerifyReport report = verified(map, options);
    CHECK(report.total.missed == 0);
    CHECK(report.verdict == Verdict::safe);
}

TEST_CASE("rays through holes are judged: by the shader that discards, by one that does not, and by one that discards too much", "[verify]") {
    DepthMap depth = noise(square16, 5);
    for (float& level : depth.level) level = std::min(level, 254.0f);
    for (int j = 4; j < 12; ++j)
        for (int i = 3; i < 13; ++i) depth.level(i, j) = 255;
    depth.holes = true;
    const ReliefMap map = make_relief_map(depth, proven_l2_cones(depth, 1), 1, {});
    const VerifyReport right = verified(map);
    CHECK(right.verdict == Verdict::safe);
    CHECK(right.has_holes);
    CHECK(right.total.holes > right.total.rays / 50);
    CHECK(right.total.pierced == 0);
    CHECK(right.total.filled == 0);

    // The same rays, and what they should have met.
    const BilinearSurface surface(depth);
    ReliefMap forgetful = map;
    forgetful.info.holes = false;
    RenderOptions look;
    look.width = 160, look.height = 120, look.endless = true, look.max_steps = 512, look.view = {40, 20, 10, 0};
    CHECK(compare_with_oracle(surface, render(map, look).value()).filled == 0);
    const Comparison filled = compare_with_oracle(surface, render(forgetful, look).value());
    CHECK(filled.filled > filled.rays / 50);
    CHECK(filled.holes == 0);

    // One hole more than there is: a floor that the ray should have met.
    DepthMap solid = depth;
    solid.level(8, 8) = 254;
    const Comparison pierced = compare_with_oracle(BilinearSurface(solid), render(map, look).value());
    CHECK(pierced.pierced > 10);
    CHECK(pierced.missed > 0);
}

TEST_CASE("a source of another size is refused, another content is measured", "[verify]") {
    const DepthMap depth = noise(square16, 5);
    const ReliefMap map = make_relief_map(depth, proven_l2_cones(depth, 1), 1, {});
    const DepthMap other = noise({16, 8, Wrap::repeat, Wrap::repeat, 1}, 5);
    VerifyOptions options = quick();
    options.source = &other;
    CHECK_FALSE(verify(map, options));
    DepthMap changed = depth;
    changed.level[3] = changed.level[3] > 100 ? changed.level[3] - 51 : changed.level[3] + 51;
    options.source = &changed;
    CHECK(*verified(map, options).depth_difference == Approx(0.2).margin(1e-4));
}

TEST_CASE("pictures come in fours, and the oracle's matches a good map's", "[verify]") {
    const DepthMap depth = noise(square16, 6);
    VerifyOptions options = quick();
    options.pictures = true;
    options.exact_finish = true;
    for (const ViewReport& view : verified(make_relief_map(depth, proven_l2_cones(depth, 1), 1, {}), options).views) {
        REQUIRE(view.pictures);
        const ViewPictures& p = *view.pictures;
        for (const RgbImage* picture : {&p.rendering, &p.oracle, &p.error, &p.steps})
            CHECK(picture->rgb.size() == std::size_t(picture->width) * std::size_t(picture->height) * 3);
        double difference = 0;
        for (std::size_t i = 0; i < p.rendering.rgb.size(); ++i)
            difference += std::abs(int(p.rendering.rgb[i]) - int(p.oracle.rgb[i]));
        CHECK(difference / double(p.rendering.rgb.size()) < 0.2);
    }
}

TEST_CASE("the report's object has the keys that scripts read", "[verify]") {
    const DepthMap depth = noise({4, 4, Wrap::clamp, Wrap::clamp, 1}, 7);
    const nlohmann::json json = to_json(verified(make_relief_map(depth, proven_l2_cones(depth, 1), 1, {})));
    for (const char* key : {"missed", "early", "violations", "mse", "steps_mean", "steps_max", "tightness", "verdict", "rays",
                            "fetches_mean", "views", "points", "worst", "out_of_steps", "tolerance"}) {
        INFO(key);
        CHECK(json.contains(key));
    }
    CHECK(json["verdict"] == "safe");
    CHECK(json["views"].size() == 13);
    // Narrow views of one clamped tile still spend most of their rays on it.
    for (const auto& view : json["views"]) CHECK(view["rays"].get<int>() > 150);
}

TEST_CASE("tightness is 1 for footprint-exact cones and their fraction for narrower ones", "[verify]") {
    const DepthMap depth = noise(square16, 8);
    Image<float> cones = footprint_cones(depth, 1, 4, 64);
    MapChoices choices{ConeEncoding::ratio, BitDepth::unorm16};
    CHECK(tightness(make_relief_map(depth, cones, 1, choices), BilinearSurface(depth)) == Approx(1).margin(0.005));
    for (float& cone : cones) cone *= 0.5f;
    CHECK(tightness(make_relief_map(depth, cones, 1, choices), BilinearSurface(depth)) == Approx(0.5).margin(0.003));
    const DepthMap flat = depth_of({5, 5}, [](int, int) { return 0.25; });
    CHECK(tightness(make_relief_map(flat, Image<float>(5, 5, 1), 1, choices), BilinearSurface(flat)) == Approx(1));
}

TEST_CASE("heat grows lighter all the way", "[verify]") {
    double last = -1;
    for (int k = 0; k <= 100; ++k) {
        const auto rgb = viridis(k / 100.0);
        const double luma = 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
        CHECK(luma >= last - 0.5);
        last = luma;
    }
    CHECK(viridis(-1) == viridis(0));
    CHECK(viridis(2) == viridis(1));
}
