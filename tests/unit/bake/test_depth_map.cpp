#include "bake/height_field.h"
#include "bake/stored_code.h"

#include <catch2/catch.hpp>

#include <random>

using namespace reliefbake;

namespace {

/// Every code of a unorm format once, as a reader delivers it.
Image<float> all_codes(BitDepth bits) {
    Image<float> plane(max_code(bits) + 1, 1);
    for (int code = 0; code <= max_code(bits); ++code)
        plane(code, 0) = float(code) / float(max_code(bits));
    return plane;
}

DepthMap stored(const Image<float>& plane, BitDepth bits, const HeightOptions& options = {}) {
    const auto checked = make_height_field(plane, true, options, "codes.png");
    REQUIRE(checked);
    return quantise_depth(checked->field, bits);
}

} // namespace

TEST_CASE("Every 8- and 16-bit code comes back, as height and as depth") {
    const BitDepth bits = GENERATE(BitDepth::unorm8, BitDepth::unorm16);
    HeightOptions depth_input;
    depth_input.input = InputKind::depth;
    const DepthMap from_height = stored(all_codes(bits), bits);
    const DepthMap from_depth = stored(all_codes(bits), bits, depth_input);
    int wrong = 0;
    for (int code = 0; code <= max_code(bits); ++code) {
        wrong += from_height.level(code, 0) != float(max_code(bits) - code);
        wrong += from_depth.level(code, 0) != float(code);
    }
    CHECK(wrong == 0);
}

TEST_CASE("8-bit codes survive storage at 16 bits exactly: 255 divides 65535") {
    const DepthMap map = stored(all_codes(BitDepth::unorm8), BitDepth::unorm16);
    for (int code = 0; code < 256; ++code)
        CHECK(map.level(code, 0) == float((255 - code) * 257));
}

TEST_CASE("Stored levels are codes within the format") {
    std::mt19937 random(3);
    Image<float> plane(512, 8);
    for (float& h : plane)
        h = float(random() / 4294967296.0);
    for (const BitDepth bits : {BitDepth::unorm8, BitDepth::unorm16, BitDepth::half, BitDepth::float32}) {
        const DepthMap map = stored(plane, bits);
        double worst = 0;
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 512; ++x) {
                const double depth = map.depth(x, y);
                CHECK((depth >= 0 && depth <= 1));
                worst = std::max(worst, std::abs(depth - (1.0 - double(plane(x, y)))));
                if (bits == BitDepth::half)
                    CHECK(stored_value(nearest_code(depth, bits), bits) == map.level(x, y));
            }
        const double half_step = is_unorm(bits)           ? 0.5 / max_code(bits)
                                 : bits == BitDepth::half ? 0x1p-12
                                                          : 0x1p-25;
        CHECK(worst <= half_step * 1.001);
    }
}

TEST_CASE("The ends are exact in every format") {
    Image<float> plane(2, 1);
    plane(1, 0) = 1;
    for (const BitDepth bits : {BitDepth::unorm8, BitDepth::unorm16, BitDepth::half, BitDepth::float32}) {
        const DepthMap map = stored(plane, bits);
        CHECK(map.depth(0, 0) == 1);
        CHECK(map.depth(1, 0) == 0);
    }
}
