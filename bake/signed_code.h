#pragma once
// Signed values in channels that hold none: where zero lies, and what a code means.

#include "bake/bit_depth.h"

namespace reliefbake {

/// How a value from -1 to 1 lies in an integer channel; half and float channels hold the value itself.
enum class SignedCodes {
    centred, ///< zero is code 128 (32768), exactly: x = (code - 128) / 127, (code - 32768) / 32767. Code 0 is never written
    unorm,   ///< x = 2 code / 255 - 1, as engines decode normals: no code means zero, the nearest is off by 1/255 (1/65535)
};

/// What a sampler returns for x, -1 <= x <= 1: the nearest code over max_code, or the nearest half or float (any finite x).
/// Ties go to the even step from zero (centred) or to the even code (unorm). A centred -x has the mirrored code of x.
float stored_signed(double x, BitDepth bits, SignedCodes codes);

/// The value that a sampled one stands for, in float32 arithmetic and in this order, as shaders compute it: so the code of
/// zero decodes to exactly 0 wherever a sampler returns code / max_code correctly rounded.
///
///     centred    x = (max_code v - zero) / (max_code - zero),   zero = 128, 32768
///     unorm      x = 2 v - 1
float decode_signed(float value, BitDepth bits, SignedCodes codes);

/// The code of zero: 128 or 32768.
int centred_zero(BitDepth bits);

/// Largest |decode_signed(stored_signed(x)) - x| over |x| <= limit (at most 1 for integers): half a step.
double signed_error(BitDepth bits, SignedCodes codes, double limit = 1);

} // namespace reliefbake
