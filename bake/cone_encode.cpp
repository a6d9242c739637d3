#include "bake/cone.h"

#include "bake/parallel.h"
#include "bake/stored_code.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cmath>
#include <limits>

namespace reliefbake {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// One rounding to float errs by at most 2^-24 of a value in [1/2, 1], and of 1 when the value is below 1.
constexpr double float_rounding = 1.0 / (1 << 24);

// What a shader's division and square root may add beyond one rounding: GLSL 4.60 sec. 4.7.1 and the SPIR-V
// Vulkan precision table allow 2.5 ulp for a / b and 2 ulp + 2.5 ulp for sqrt as 1 / inversesqrt; 2^-20 is 16
// ulp.
constexpr double shader_arithmetic = 1 + 1.0 / (1 << 20);

/// The largest float that a sampler may return for a stored value. Floating formats and the ends of a unorm
/// format are exact; code / max_code inside may come out one float too high (a multiplication by 1 /
/// max_code).
float sampled_at_most(float value, BitDepth bits) {
    return is_unorm(bits) && value > 0 && value < 1 ? std::nextafter(value, 1.0f) : value;
}

/// An upper bound of n / sqrt(1 - n^2) in float. Near n = 1 the subtraction is all rounding error: n*n is off
/// by up to half of 2^-24 and the difference is then exact, so a whole 2^-24 is taken from it.
double normal_ratio_at_most(double n) {
    const double sine2 = 1 - n * n - float_rounding;
    return sine2 > 0 ? n / std::sqrt(sine2) * shader_arithmetic : infinity;
}

/// How one map's cones are encoded. Every decoder is monotone in the value, which makes the largest safe code
/// one search downwards from the exact one.
class Encoder {
  public:
    Encoder(const EncodeOptions& options, float ratio_max) : options_(options), ratio_max_(ratio_max) {}

    /// The largest code that no decoder in float or double takes for a cone wider than `ratio`.
    StoredCode encode(double ratio, double depth) const {
        StoredCode code = code_at_least(exact_value(ratio, depth), options_.bits);
        while (code > 0 && decoded_at_most(stored_value(code, options_.bits), depth) > ratio)
            --code;
        return code;
    }

  private:
    /// Value of a format without rounding.
    double exact_value(double ratio, double depth) const {
        switch (options_.encoding) {
        case ConeEncoding::ratio:
            return ratio / ratio_max_;
        case ConeEncoding::sqrt:
            return std::sqrt(ratio / ratio_max_);
        case ConeEncoding::radius:
            return depth > 0 ? std::min(ratio * depth, widest_radius) : 0;
        case ConeEncoding::normal:
            return ratio == infinity ? 1 : ratio / std::sqrt(1 + ratio * ratio);
        }
        return 0;
    }

    /// An upper bound of what any decoder makes of a stored value: in double, or in float as a shader does.
    double decoded_at_most(float stored, double depth) const {
        const float v = sampled_at_most(stored, options_.bits);
        switch (options_.encoding) {
        case ConeEncoding::ratio:
            return std::max(double(v * ratio_max_), double(v) * ratio_max_);
        case ConeEncoding::sqrt:
            return sqrt_decoded_at_most(v);
        case ConeEncoding::radius:
            return depth > 0 ? v / depth * shader_arithmetic : ratio_max_;
        case ConeEncoding::normal:
            return v == 1 ? infinity : normal_ratio_at_most(v);
        }
        return infinity;
    }

    /// A compiler may multiply in either order.
    double sqrt_decoded_at_most(float v) const {
        const float in_float = std::max(v * v * ratio_max_, v * (v * ratio_max_));
        return std::max(double(in_float), double(v) * v * ratio_max_);
    }

    // The largest half: wider than any texture, and filtering it with 0 does not make a NaN as inf would.
    static constexpr double widest_radius = 65504;

    EncodeOptions options_;
    float ratio_max_;
};

/// Code 0 decodes to no cone at all, but for a radius at depth 0, where every decoder knows better.
bool loses_cone(StoredCode code, double depth, ConeEncoding encoding) {
    return code == 0 && !(encoding == ConeEncoding::radius && depth == 0);
}

/// The depth that a decoder divides a radius by: its own texel's; or, fetched for a cell beside a filtered depth, any in the
/// cell, of which the smallest makes the widest cone.
double depth_for_code(const DepthMap& depth, ConeLookup lookup, int x, int y) {
    if (lookup == ConeLookup::filtered) return depth.depth(x, y);
    const TexelGrid& g = depth.grid;
    const int right = g.address_x(x + 1), below = g.address_y(y + 1);
    return std::min(std::min(depth.depth(x, y), depth.depth(right, y)), std::min(depth.depth(x, below), depth.depth(right, below)));
}

} // namespace

double decode_ratio(double value, double depth, ConeEncoding encoding, double ratio_max) {
    switch (encoding) {
    case ConeEncoding::ratio:
        return value * ratio_max;
    case ConeEncoding::sqrt:
        return value * value * ratio_max;
    case ConeEncoding::radius:
        return depth > 0 ? value / depth : ratio_max;
    case ConeEncoding::normal:
        return value < 1 ? value / std::sqrt(1 - value * value) : infinity;
    }
    return 0;
}

EncodedConeMap encode_cones(const ConeMap& cones, const DepthMap& depth, const EncodeOptions& options) {
    return encode_cone_rows(cones, depth, options, 0, cones.grid.height);
}

EncodedConeMap encode_cone_rows(const ConeMap& cones, const DepthMap& depth, const EncodeOptions& options, int first, int end) {
    assert(0 <= first && first < end && end <= cones.grid.height);
    const float ratio_max = cones.options.ratio_max;
    assert(cones.grid == depth.grid);
    assert(std::isfinite(ratio_max) || options.encoding == ConeEncoding::normal ||
           (options.encoding == ConeEncoding::radius && !is_unorm(options.bits)));
    const int width = cones.grid.width, height = cones.grid.height;
    EncodedConeMap map{cones.grid, options.encoding, options.bits, ratio_max, Image<float>(width, height), 0};
    const Encoder encoder(options, ratio_max);
    std::atomic<std::size_t> zero_codes = 0;
    parallel_for(end - first, cones.options.threads, [&](int row) {
        const int y = first + row;
        std::size_t zeros = 0;
        for (int x = 0; x < width; ++x) {
            const double here = depth_for_code(depth, cones.options.lookup, x, y);
            const StoredCode code = encoder.encode(cones.ratio(x, y), here);
            map.value(x, y) = stored_value(code, options.bits);
            zeros += loses_cone(code, here, options.encoding);
        }
        zero_codes += zeros;
    });
    map.zero_codes = zero_codes;
    return map;
}

} // namespace reliefbake
