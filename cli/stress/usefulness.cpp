#include "cli/stress/usefulness.h"

#include "cli/choices.h"
#include "cli/stress/stress_fields.h"

#include <cmath>

namespace reliefbake {
namespace {

constexpr int rows = 16;

DepthMap noise_strip(int width, BitDepth bits) {
    DepthMap depth{{width, rows, Wrap::repeat, Wrap::repeat, 1}, bits, Image<float>(width, rows)};
    constexpr int steps = 255; // of depth in every format, that all hold the same relief
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < width; ++x) {
            const double step = std::round(stress_noise(x, y) * steps);
            depth.level(x, y) = is_unorm(bits) ? float(step * (max_code(bits) / steps)) : float(std::round(step / steps * 256) / 256); // exact in a half
        }
    return depth;
}

Usefulness measure(const ConeMap& cones, const DepthMap& depth, ConeEncoding encoding) {
    const EncodedConeMap encoded = encode_cones(cones, depth, {encoding, depth.bits});
    Usefulness result{depth.grid.width, encoding, depth.bits};
    std::size_t counted = 0;
    for (int y = 0; y < depth.grid.height; ++y)
        for (int x = 0; x < depth.grid.width; ++x) {
            const double d = depth.depth(x, y), ratio = cones.ratio(x, y);
            result.ratio += ratio;
            if (encoding == ConeEncoding::radius && d == 0) continue; // every decoder knows its cone
            result.kept += decode_ratio(encoded.value(x, y), d, encoding, cones.options.ratio_max) / ratio;
            ++counted;
        }
    const double texels = double(depth.level.size());
    result.ratio /= texels;
    result.kept /= double(counted);
    result.dead = double(encoded.zero_codes) / texels;
    return result;
}

} // namespace

std::vector<Usefulness> measure_usefulness(int widest, int threads) {
    std::vector<Usefulness> result;
    for (int width = rows; width <= widest; width *= 2)
        for (const auto& [bits_word, bits] : bits_words) {
            const DepthMap depth = noise_strip(width, bits);
            ConeOptions options;
            options.threads = threads;
            const ConeMap cones = bake_cones(depth, options);
            for (const auto& [encoding_word, encoding] : encoding_words) result.push_back(measure(cones, depth, encoding));
        }
    return result;
}

double useful_slope(const std::vector<Usefulness>& measured, ConeEncoding encoding, BitDepth bits) {
    double greatest = 0;
    for (const Usefulness& at : measured) { // in order of width
        if (at.encoding != encoding || at.bits != bits) continue;
        if (!at.is_useful()) break;
        greatest = at.slope();
    }
    return greatest;
}

} // namespace reliefbake
