#include "bake/stored_code.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace reliefbake;

TEST_CASE("Stored values increase with their codes, and each is its own nearest and smallest code above") {
    const BitDepth bits = GENERATE(BitDepth::unorm8, BitDepth::unorm16, BitDepth::half);
    int wrong = 0;
    for (StoredCode code = 0; code <= largest_code(bits); ++code) {
        const float value = stored_value(code, bits);
        wrong += code > 0 && !(value > stored_value(code - 1, bits));
        wrong += nearest_code(value, bits) != code;
        if (bits == BitDepth::half) wrong += code_at_least(value, bits) != code;
    }
    CHECK(wrong == 0);
}

TEST_CASE("code_at_least is the smallest code that reaches x") {
    for (const BitDepth bits : {BitDepth::unorm8, BitDepth::unorm16, BitDepth::half, BitDepth::float32})
        for (const double x : {0.0, 1e-9, 0.1, 1 / 3.0, 0.5, 0.7071, 0.999999, 1.0}) {
            const StoredCode code = code_at_least(x, bits);
            CHECK(stored_value(code, bits) >= x);
            if (code > 0) CHECK(stored_value(code - 1, bits) < x);
        }
    CHECK(code_at_least(INFINITY, BitDepth::half) == largest_code(BitDepth::half));
    CHECK(code_at_least(7, BitDepth::unorm8) == 255);
}
