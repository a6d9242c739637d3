#include "bake/height_field.h"
#include "tests/unit/bake/planes.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace reliefbake;
using reliefbake::test::plane;

namespace {

HeightOptions fixed_range(float low, float high) {
    HeightOptions options;
    options.range = RangeMode::fixed;
    options.range_low = low;
    options.range_high = high;
    return options;
}

Image<float> heights(const Image<float>& source, bool is_integer, const HeightOptions& options = {}) {
    const Result<CheckedHeight> checked = make_height_field(source, is_integer, options, "test.png");
    REQUIRE(checked);
    return checked->field.heights();
}

Error refusal(const Image<float>& source, bool is_integer, const HeightOptions& options) {
    const Result<CheckedHeight> checked = make_height_field(source, is_integer, options, "test.png");
    REQUIRE_FALSE(checked);
    CHECK(checked.error().message.find("test.png") == 0);
    return checked.error();
}

} // namespace

TEST_CASE("Automatic range: integers and floats within 0..1 as they are, other floats by their extremes") {
    CHECK(heights(plane(2, 1, {.25f, .5f}), true) == plane(2, 1, {.25f, .5f}));
    CHECK(heights(plane(2, 1, {.25f, .5f}), false) == plane(2, 1, {.25f, .5f}));
    CHECK(heights(plane(3, 1, {100, 150, 300}), false) == plane(3, 1, {0, .25f, 1}));
    CHECK(heights(plane(3, 1, {-2, 0, 2}), false) == plane(3, 1, {0, .5f, 1}));
}

TEST_CASE("The report says what became 0 and 1, and where it comes from") {
    const auto metres = make_height_field(plane(3, 1, {100, 150, 300}), false, {}, "dem.tif");
    CHECK(metres->report.range_low == 100);
    CHECK(metres->report.range_high == 300);
    CHECK(metres->report.range_from_data);
    const auto format = make_height_field(plane(2, 1, {.25f, .5f}), true, {}, "map.png");
    CHECK(format->report.source_high == .5);
    CHECK(format->report.range_high == 1);
    CHECK_FALSE(format->report.range_from_data);
}

TEST_CASE("Depth input is turned over, after the range") {
    HeightOptions options = fixed_range(0, 4);
    options.input = InputKind::depth;
    CHECK(heights(plane(3, 1, {0, 1, 4}), false, options) == plane(3, 1, {1, .75f, 0}));
}

TEST_CASE("A fixed range refuses what lies outside, with count and place") {
    const Error error = refusal(plane(2, 2, {0, 1, 5, 6}), false, fixed_range(0, 4));
    CHECK(error.code == ErrorCode::bad_data);
    CHECK(error.message.find("found 2 outside, the first 5 at (0, 1)") != std::string::npos);
    CHECK(refusal(plane(1, 1, {0}), false, fixed_range(4, 4)).code == ErrorCode::usage);
}

TEST_CASE("A flat source by its data is flat at the top, whatever white means") {
    HeightOptions options;
    options.range = RangeMode::data;
    CHECK(heights(plane(2, 1, {7, 7}), false, options) == plane(2, 1, {1, 1}));
    options.input = InputKind::depth;
    CHECK(heights(plane(2, 1, {7, 7}), false, options) == plane(2, 1, {1, 1}));
}

TEST_CASE("NaN is refused with count and place, or filled and counted") {
    const Image<float> source = plane(3, 1, {.5f, NAN, INFINITY});
    const Error error = refusal(source, false, {});
    CHECK(error.code == ErrorCode::bad_data);
    CHECK(error.message.find("found 2 NaN") != std::string::npos);
    CHECK(error.message.find("(1, 0)") != std::string::npos);

    HeightOptions options;
    options.nan = NanPolicy::fill;
    const auto filled = make_height_field(source, false, options, "test.exr");
    CHECK(filled->field.heights() == plane(3, 1, {.5f, .5f, .5f}));
    CHECK(filled->report.bad_texels == 2);
    CHECK(refusal(plane(1, 1, {NAN}), false, options).code == ErrorCode::bad_data);
}

TEST_CASE("No-data values take no part in the data range") {
    HeightOptions options;
    options.nan = NanPolicy::fill;
    options.no_data = -9999.0f;
    CHECK(heights(plane(3, 1, {-9999, 10, 20}), false, options) == plane(3, 1, {0, 0, 1}));
}

TEST_CASE("Scale and bias act on the height and may not leave 0..1") {
    HeightOptions options;
    options.scale = -0.5;
    options.bias = 0.75;
    CHECK(heights(plane(2, 1, {0, 1}), true, options) == plane(2, 1, {.75f, .25f}));
    options.bias = 0.25;
    CHECK(refusal(plane(2, 1, {0, 1}), true, options).code == ErrorCode::bad_data);
    CHECK(heights(plane(2, 1, {0, .5f}), true, options) == plane(2, 1, {.25f, 0}));
}

TEST_CASE("Texels longer than the proof of the cones covers are refused") {
    HeightOptions options;
    for (const double aspect : {0.5, 1.0, 2.0}) {
        options.pixel_aspect = aspect;
        const auto checked = make_height_field(plane(1, 1, {0}), true, options, "test.png");
        REQUIRE(checked);
        CHECK(checked->field.grid().pixel_aspect == aspect);
    }
    for (const double aspect : {0.499, 2.001, 0.0, -1.0, double(NAN), double(INFINITY)}) {
        options.pixel_aspect = aspect;
        const Error error = refusal(plane(1, 1, {0}), true, options);
        CHECK(error.code == ErrorCode::usage);
        CHECK(error.message.find("resample") != std::string::npos);
    }
}

TEST_CASE("Wrap is chosen per axis, and a given one is kept") {
    const Image<float> ramp = plane(5, 1, {0, .25f, .5f, .75f, 1});
    HeightOptions options;
    auto checked = make_height_field(ramp, true, options, "ramp.png");
    CHECK(checked->field.grid().wrap_x == Wrap::clamp);
    CHECK(checked->field.grid().wrap_y == Wrap::repeat);
    options.wrap_x = WrapChoice::repeat;
    options.wrap_y = WrapChoice::clamp;
    checked = make_height_field(ramp, true, options, "ramp.png");
    CHECK(checked->field.grid().wrap_x == Wrap::repeat);
    CHECK(checked->field.grid().wrap_y == Wrap::clamp);
}

TEST_CASE("Denormals and signed zeros are heights like others") {
    const Image<float> h = heights(plane(3, 1, {-0.0f, 1e-40f, 1}), false);
    CHECK(h[0] == 0);
    CHECK(h[1] == 1e-40f);
    CHECK(h[2] == 1);
}
