#include "bake/signed_code.h"

#include "bake/stored_code.h"
#include "tests/support/fields.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace reliefbake;

TEST_CASE("Zero has a code of its own and decodes to exactly 0") {
    for (const BitDepth bits : {BitDepth::unorm8, BitDepth::unorm16}) {
        const float zero = stored_signed(0, bits, SignedCodes::centred);
        CHECK(zero == stored_value(StoredCode(centred_zero(bits)), bits));
        CHECK(decode_signed(zero, bits, SignedCodes::centred) == 0);
        // The codes of engines have none: the nearest is half a step away.
        CHECK(std::fabs(decode_signed(stored_signed(0, bits, SignedCodes::unorm), bits, SignedCodes::unorm)) == Approx(1.0 / max_code(bits)).margin(1e-7));
    }
    for (const BitDepth bits : {BitDepth::half, BitDepth::float32}) CHECK(decode_signed(stored_signed(0, bits, SignedCodes::centred), bits, SignedCodes::centred) == 0);
}

TEST_CASE("Every centred code comes back, its mirror image with the other sign") {
    for (const BitDepth bits : {BitDepth::unorm8, BitDepth::unorm16}) {
        const int zero = centred_zero(bits), steps = max_code(bits) - zero;
        int wrong = 0;
        for (int step = 0; step <= steps; ++step) {
            const float up = stored_value(StoredCode(zero + step), bits), down = stored_value(StoredCode(zero - step), bits);
            const float x = decode_signed(up, bits, SignedCodes::centred), y = decode_signed(down, bits, SignedCodes::centred);
            wrong += x != -y || stored_signed(x, bits, SignedCodes::centred) != up || stored_signed(y, bits, SignedCodes::centred) != down;
            wrong += std::fabs(x - double(step) / steps) > 1e-7;
        }
        CHECK(wrong == 0);
        CHECK(decode_signed(stored_signed(1, bits, SignedCodes::centred), bits, SignedCodes::centred) == 1);
        CHECK(decode_signed(stored_signed(-1, bits, SignedCodes::centred), bits, SignedCodes::centred) == -1);
    }
}

TEST_CASE("Signed values err by what is stated, and nearly so much") {
    std::mt19937 random(9);
    for (const BitDepth bits : {BitDepth::unorm8, BitDepth::unorm16, BitDepth::half, BitDepth::float32})
        for (const SignedCodes codes : {SignedCodes::centred, SignedCodes::unorm}) {
            const double limit = is_unorm(bits) ? 1 : 300;
            double worst = 0;
            for (int n = 0; n < 200000; ++n) {
                const double x = test::uniform(random, -limit, limit);
                worst = std::max(worst, std::fabs(decode_signed(stored_signed(x, bits, codes), bits, codes) - x));
            }
            CAPTURE(int(bits), int(codes), worst);
            CHECK(worst <= signed_error(bits, codes, limit));
            CHECK(worst > 0.4 * signed_error(bits, codes, limit)); // 300 is not a power of two: floats err less there
        }
    for (const double tiny : {1e-6, 3e-8, -2e-7, 1e-9})
        CHECK(std::fabs(stored_signed(tiny, BitDepth::half, SignedCodes::centred) - tiny) <= signed_error(BitDepth::half, SignedCodes::centred, std::fabs(tiny)));
}
