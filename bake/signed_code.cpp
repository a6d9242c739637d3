#include "bake/signed_code.h"

#include "bake/stored_code.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace reliefbake {

int centred_zero(BitDepth bits) {
    assert(is_unorm(bits));
    return (max_code(bits) + 1) / 2;
}

float stored_signed(double x, BitDepth bits, SignedCodes codes) {
    if (!is_unorm(bits)) return float(std::copysign(double(stored_value(nearest_code(std::fabs(x), bits), bits)), x));
    assert(x >= -1 && x <= 1);
    if (codes == SignedCodes::unorm) return stored_value(nearest_code(0.5 * x + 0.5, bits), bits);
    const int zero = centred_zero(bits);
    return stored_value(StoredCode(zero + int(std::lrint(x * (max_code(bits) - zero)))), bits);
}

float decode_signed(float value, BitDepth bits, SignedCodes codes) {
    if (!is_unorm(bits)) return value;
    if (codes == SignedCodes::unorm) return 2 * value - 1;
    const float zero = float(centred_zero(bits)), largest = float(max_code(bits));
    return (value * largest - zero) / (largest - zero);
}

double signed_error(BitDepth bits, SignedCodes codes, double limit) {
    // A sampled value is a float, and the decoder computes in floats: their roundings come on top of half a code.
    constexpr double float_rounding = 0x1p-24;
    switch (bits) {
    case BitDepth::float32: return limit * float_rounding;
    case BitDepth::half: return std::max(limit * 0x1p-11, 0x1p-25) * (1 + 0x1p-10); // subnormal halfs are 2^-24 apart
    case BitDepth::unorm8:
    case BitDepth::unorm16: break;
    }
    const double steps = codes == SignedCodes::unorm ? 0.5 * max_code(bits) : max_code(bits) - centred_zero(bits);
    return 0.5 / steps + 6 * float_rounding;
}

} // namespace reliefbake
