#include "bake/seam.h"
#include "tests/unit/bake/planes.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace reliefbake;
using reliefbake::test::plane;

TEST_CASE("A ramp has a seam of its length along itself and none across") {
    const Seams seams = measure_seams(plane(5, 2, {0, .25f, .5f, .75f, 1, 0, .25f, .5f, .75f, 1}));
    CHECK(seams.x.border == Approx(4));
    CHECK(seams.x.steepest == Approx(1));
    CHECK(seams.y.border == 0);
    CHECK(wrap_for_seam(seams.x) == Wrap::clamp);
    CHECK(wrap_for_seam(seams.y) == Wrap::repeat);
}

TEST_CASE("One period of a wave tiles") {
    Image<float> wave(64, 48);
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x)
            wave(x, y) =
                float(0.5 + 0.25 * std::sin(x * 6.283185307 / 64) + 0.2 * std::cos(y * 6.283185307 / 48));
    const Seams seams = measure_seams(wave);
    CHECK(wrap_for_seam(seams.x) == Wrap::repeat);
    CHECK(wrap_for_seam(seams.y) == Wrap::repeat);
}

TEST_CASE("Constant maps and axes of one texel repeat") {
    CHECK(measure_seams(plane(1, 1, {0.5f})).x.border == 0);
    CHECK(measure_seams(plane(4, 1, {1, 1, 1, 1})).x.border == 0);
    CHECK(measure_seams(plane(1, 3, {0, 1, 0})).x.border == 0);
}

TEST_CASE("An edge along the border is no seam when the map has such edges inside") {
    // Two periods of a saw tooth, cut where it falls.
    Image<float> saw(32, 1);
    for (int x = 0; x < 32; ++x)
        saw(x, 0) = float(x % 16) / 16;
    const Seams seams = measure_seams(saw);
    CHECK(seams.x.border > 3);
    CHECK(wrap_for_seam(seams.x) == Wrap::repeat);
}
