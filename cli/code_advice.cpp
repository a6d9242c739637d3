#include "cli/code_advice.h"

#include "cli/choices.h"

#include <cmath>

namespace reliefbake {

std::string better_codes(const ConeMap& cones, const DepthMap& depth, const EncodedConeMap& encoded) {
    std::size_t fewest = encoded.zero_codes;
    std::string advice = encoded.bits == BitDepth::unorm8 ? "--bits 16" : "--bits float";
    if (!std::isfinite(encoded.ratio_max)) return advice;
    for (const auto& [word, encoding] : encoding_words) {
        if (encoding == encoded.encoding) continue;
        const std::size_t zeros = encode_cones(cones, depth, {encoding, encoded.bits}).zero_codes;
        if (zeros >= fewest) continue;
        fewest = zeros;
        advice = "--encoding " + word;
    }
    if (fewest == encoded.zero_codes) return advice + " leaves fewer";
    return advice + " leaves " + std::to_string(fewest);
}

} // namespace reliefbake
