#pragma once
// The values a channel can hold, numbered in increasing order, so that "the next smaller one" is a
// subtraction.

#include "bake/bit_depth.h"

#include <cstdint>

namespace reliefbake {

/// A non-negative finite stored value: the integer code of a unorm format, the bit pattern of a half or a
/// float.
using StoredCode = std::uint32_t;

/// The largest finite value's code.
StoredCode largest_code(BitDepth bits);

/// What a sampler returns for a code: code / max_code rounded to float, or the half or float itself.
float stored_value(StoredCode code, BitDepth bits);

/// The smallest code whose value is at least x, or the largest code. x >= 0, may be inf.
StoredCode code_at_least(double x, BitDepth bits);

/// The code nearest to x, ties to the even code. 0 <= x <= largest value.
StoredCode nearest_code(double x, BitDepth bits);

} // namespace reliefbake
