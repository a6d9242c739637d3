// Where encodings stop being useful: codes by their formulas, and the limit read off them.

#include "cli/stress/usefulness.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace reliefbake;

namespace {

const std::vector<Usefulness>& measured() {
    static const std::vector<Usefulness> all = measure_usefulness(1024, 1);
    return all;
}

Usefulness at(int width, ConeEncoding encoding, BitDepth bits) {
    for (const Usefulness& one : measured())
        if (one.width == width && one.encoding == encoding && one.bits == bits) return one;
    FAIL("not measured: " << width);
    return {};
}

} // namespace

TEST_CASE("Cones of white noise halve with each doubling of the width, in every format alike", "[stress]") {
    for (const BitDepth bits : {BitDepth::unorm8, BitDepth::float32})
        for (int width = 32; width <= 1024; width *= 2) {
            CAPTURE(width);
            CHECK(at(width, ConeEncoding::sqrt, bits).slope() == Approx(2 * at(width / 2, ConeEncoding::sqrt, bits).slope()).epsilon(0.1));
            CHECK(at(width, ConeEncoding::sqrt, bits).slope() == Approx(at(width, ConeEncoding::sqrt, BitDepth::unorm16).slope()).epsilon(0.02));
        }
}

TEST_CASE("No encoding keeps more than the cone; floats keep all; ratio at 8 bits dies below 1/255", "[stress]") {
    for (const Usefulness& one : measured()) {
        CAPTURE(one.width, int(one.encoding), int(one.bits));
        CHECK(one.kept <= 1);
        CHECK(one.kept >= 0);
        if (one.bits == BitDepth::float32) CHECK((one.kept > 0.9999 && one.dead == 0));
    }
    const Usefulness ratio = at(1024, ConeEncoding::ratio, BitDepth::unorm8), root = at(1024, ConeEncoding::sqrt, BitDepth::unorm8);
    CHECK(ratio.slope() > 255);
    CHECK(ratio.dead > 0.9);
    CHECK(root.dead == 0);
    CHECK(root.kept > 0.8);
}

TEST_CASE("The limit is the last slope before the first that is of no use", "[stress]") {
    const auto at_slope = [](double slope, double kept) { return Usefulness{16, ConeEncoding::ratio, BitDepth::half, 1 / slope, 0, kept}; };
    CHECK(useful_slope({at_slope(10, 0.9), at_slope(20, 0.8), at_slope(40, 0.7), at_slope(80, 0.9)}, ConeEncoding::ratio, BitDepth::half) == Approx(20));
    CHECK(useful_slope({at_slope(10, 0.5)}, ConeEncoding::ratio, BitDepth::half) == 0);
    CHECK(useful_slope({at_slope(10, 0.9)}, ConeEncoding::sqrt, BitDepth::half) == 0);
    Usefulness dead = at_slope(10, 1);
    dead.dead = 0.002;
    CHECK_FALSE(dead.is_useful());
}
