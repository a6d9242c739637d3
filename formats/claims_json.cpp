#include "formats/claims_json.h"

namespace reliefbake {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ImageClaims, width, height, depth, top_width, top_height, tile_width, tile_height, sample, bit_depth, deep,
                                   srgb_tagged, channels, relief)

nlohmann::json claims_to_json(const ImageClaims& claims) { return claims; }

std::optional<ImageClaims> claims_from_json(const nlohmann::json& json) {
    try {
        ImageClaims claims = json.get<ImageClaims>();
        if (int(claims.sample) < 0 || claims.sample > SampleType::float64 || claims.bit_depth < 1 || claims.bit_depth > 64)
            return std::nullopt;
        return claims;
    } catch (const nlohmann::json::exception&) {
        return std::nullopt;
    }
}

std::uint64_t unsigned_member(const nlohmann::json& json, const char* key) {
    const auto member = json.find(key);
    return member != json.end() && member->is_number_unsigned() ? member->get<std::uint64_t>() : 0;
}

} // namespace reliefbake
