// Fields of `stress`: what a name promises is so after rounding to each format.

#include "cli/stress/stress_case.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <set>

using namespace reliefbake;

namespace {

constexpr BitDepth all_bits[] = {BitDepth::unorm8, BitDepth::unorm16, BitDepth::half, BitDepth::float32};

StressField field(const std::string& name, StressExtent extent = StressExtent::quick) {
    for (const StressField& field : stress_fields(extent))
        if (field.name == name) return field;
    FAIL("no field " << name);
    return {};
}

std::set<float> levels(const std::string& name, BitDepth bits) {
    const auto source = stress_source(field(name), bits, Wrap::repeat);
    REQUIRE(source);
    const DepthMap depth = quantise_depth(*source->field, bits);
    return {depth.level.begin(), depth.level.end()};
}

} // namespace

TEST_CASE("Plateaus are one code apart in every format", "[stress]") {
    for (const BitDepth bits : all_bits) {
        CAPTURE(int(bits));
        const std::set<float> found = levels("plateaus", bits);
        REQUIRE(found.size() == 2);
        const float low = *found.begin(), high = *found.rbegin();
        if (is_unorm(bits)) CHECK(high == low + 1);
        else if (bits == BitDepth::half) CHECK(double(high) == double(low) + 0x1p-11); // halfs from 1/2 to 1 are that far apart
        else CHECK(high == std::nextafter(low, 1.0f));
    }
}

TEST_CASE("What a float cannot hold beside 1e6 is gone; what it can is stretched", "[stress]") {
    // Floats above 1e6 are 1/16 apart: of a detail of 1e-3 nothing is left, of 1 all 17 steps.
    CHECK(levels("offset-1e6-detail-1e-3", BitDepth::float32).size() == 1);
    CHECK(levels("offset-1e6-detail-1", BitDepth::float32).size() == 17);
    CHECK(levels("detail-1e-3", BitDepth::unorm8).size() <= 2);
    CHECK(levels("detail-1e-3", BitDepth::float32).size() > 200);
}

TEST_CASE("Denormals vanish below 1, and count when they are stretched", "[stress]") {
    CHECK(levels("denormals", BitDepth::float32) == std::set<float>{1});
    CHECK(levels("denormals-stretched", BitDepth::float32).size() == 8);
    CHECK(levels("depths-of-2^-24", BitDepth::half) == std::set<float>{0, 0x1p-24f}); // the smallest half
    CHECK(levels("depths-of-2^-24", BitDepth::unorm16) == std::set<float>{0});
}

TEST_CASE("Walls are one texel wide, a spike is one texel", "[stress]") {
    const StressField walls = field("walls"), spike = field("spike");
    int high = 0;
    for (int y = 0; y < spike.height; ++y)
        for (int x = 0; x < spike.width; ++x) {
            high += spike.value(x, y, 0) == 1;
            if (walls.value(x, y, 0) == 1) CHECK((walls.value(x - 1, y, 0) == 0 && walls.value(x + 1, y, 0) == 0));
        }
    CHECK(high == 1);
}

TEST_CASE("Every extent has the fields of the smaller one, and its own sizes; names are words", "[stress]") {
    const auto names = [](StressExtent extent) {
        std::set<std::string> found;
        for (const StressField& field : stress_fields(extent)) {
            CHECK(found.insert(field.name).second);
            CHECK(field.name.find(' ') == std::string::npos);
            CHECK(*std::max_element(field.angles.begin(), field.angles.end()) == 89.9);
        }
        return found;
    };
    const auto quick = names(StressExtent::quick), standard = names(StressExtent::standard), full = names(StressExtent::full);
    CHECK(std::includes(standard.begin(), standard.end(), quick.begin(), quick.end()));
    CHECK(std::includes(full.begin(), full.end(), standard.begin(), standard.end()));
    for (const char* name : {"size-1x1", "size-1024x16", "size-16x1024", "depth-scale-1e-4-hills", "depth-scale-1e4-white-noise"}) CHECK(quick.contains(name));
    for (const char* name : {"size-16384x256", "size-256x16384"}) CHECK(standard.contains(name));
    CHECK_FALSE(standard.contains("size-16384x16384"));
    CHECK(full.contains("size-16384x16384"));
}
