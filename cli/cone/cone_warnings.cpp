#include "cli/cone/cone_warnings.h"

#include "cli/choices.h"
#include "formats/map_format.h"

#include <cmath>

namespace reliefbake {

namespace {

std::string more_bits(BitDepth bits) { return bits == BitDepth::unorm8 ? "--bits 16" : "--bits float"; }

/// The encoding that leaves the fewest texels with code 0 at the same depth, or more bits when none leaves
/// fewer.
std::string better_codes(const DepthMap& depth, const std::vector<ConeMap>& maps, const EncodedConeMap& encoded,
                         std::size_t fewest) {
    std::string better;
    for (const auto& [word, encoding] : encoding_words) {
        if (encoding == encoded.encoding || !std::isfinite(encoded.ratio_max)) continue;
        std::size_t zeros = 0;
        for (const ConeMap& cones : maps) zeros += encode_cones(cones, depth, {encoding, encoded.bits}).zero_codes;
        if (zeros >= fewest) continue;
        fewest = zeros;
        better = word;
    }
    if (better.empty()) return more_bits(encoded.bits) + " loses fewer";
    return "--encoding " + better + " loses " + std::to_string(fewest);
}

/// Alphas that most likely are not what was meant.
std::string holes_warning(const ConeCommandOptions& given, const DepthMap& depth) {
    const HoleCount holes = count_holes(depth);
    const std::string start = "--alpha " + given.alpha.from + ": ";
    if (holes.texels == 0) return start + "no texel lies below the threshold: the map has no hole";
    if (holes.texels == depth.level.size()) return start + "every texel lies below the threshold: all of the map is a hole";
    if (holes.cells == 0) return start + "no hole is two texels wide both ways: all are pits, through which no ray falls";
    return {};
}

} // namespace

std::vector<std::string> cone_warnings(const ConeCommandOptions& given, const SourceImage& source,
                                       const DepthMap& depth, const std::vector<ConeMap>& cones,
                                       const std::vector<EncodedConeMap>& encoded) {
    std::vector<std::string> warnings;
    if (source.srgb_tagged)
        warnings.push_back(given.input +
                           ": tagged sRGB, which heights are not; its codes are taken as they stand");
    const Result<MapFormat> format = map_format_of(given.output);
    if (format == MapFormat::targa || format == MapFormat::dds)
        warnings.push_back(given.output + ": " + (format == MapFormat::dds ? "DDS" : "TGA") +
                           " keeps no metadata; whoever reads the map must know what it means");
    if (depth.holes) {
        const std::string words = holes_warning(given, depth);
        if (!words.empty()) warnings.push_back(words);
    }
    std::size_t zero_codes = 0;
    for (const EncodedConeMap& map : encoded) zero_codes += map.zero_codes;
    if (zero_codes > 0)
        warnings.push_back(given.output + ": " + std::to_string(zero_codes) +
                           (encoded.size() > 1 ? " cones" : " texels") +
                           " have cone code 0, where a ray goes on cell by cell; " +
                           better_codes(depth, cones, encoded.front(), zero_codes));
    return warnings;
}

} // namespace reliefbake
