#include "bake/stored_code.h"

#include <Imath/half.h>

#include <bit>
#include <cassert>
#include <cmath>
#include <limits>

namespace reliefbake {

namespace {

StoredCode half_code(float x) { return Imath::half(x).bits(); }

StoredCode float_code(float x) { return std::bit_cast<std::uint32_t>(x); }

} // namespace

StoredCode largest_code(BitDepth bits) {
    if (bits == BitDepth::float32) return float_code(std::numeric_limits<float>::max());
    return bits == BitDepth::half ? 0x7bff : StoredCode(max_code(bits));
}

float stored_value(StoredCode code, BitDepth bits) {
    if (bits == BitDepth::float32) return std::bit_cast<float>(code);
    if (bits == BitDepth::half) return Imath::half(Imath::half::FromBits, std::uint16_t(code));
    return float(code) / float(max_code(bits));
}

StoredCode code_at_least(double x, BitDepth bits) {
    assert(x >= 0);
    const StoredCode largest = largest_code(bits);
    if (x >= stored_value(largest, bits)) return largest;
    StoredCode code = nearest_code(x, bits);
    if (stored_value(code, bits) < x) ++code;
    return code;
}

StoredCode nearest_code(double x, BitDepth bits) {
    assert(x >= 0 && x <= stored_value(largest_code(bits), bits));
    if (is_unorm(bits)) return StoredCode(std::lrint(x * max_code(bits)));
    // |x| keeps the sign bit of -0.0 out of the bit pattern. The second rounding, float to half, can only
    // turn a near-tie into the other neighbour.
    const float rounded = std::fabs(float(x));
    return bits == BitDepth::half ? half_code(rounded) : float_code(rounded);
}

} // namespace reliefbake
