#include "formats/image_gate.h"

#include <algorithm>
#include <limits>

namespace reliefbake {

namespace {

constexpr std::uint64_t mib = 1ull << 20;

std::uint64_t saturating_product(std::uint64_t a, std::uint64_t b) {
    std::uint64_t product;
    return __builtin_mul_overflow(a, b, &product) ? std::numeric_limits<std::uint64_t>::max() : product;
}

std::string in_mib(std::uint64_t bytes) { return std::to_string((bytes + mib - 1) / mib) + " MiB"; }

bool possible_side(std::int64_t side) { return side >= 1 && side <= max_side; }

} // namespace

int sample_bytes(SampleType sample) {
    constexpr int bytes[] = {1, 1, 2, 2, 4, 4, 2, 4, 8};
    return bytes[int(sample)];
}

std::uint64_t decode_budget(std::uint64_t file_bytes, std::uint64_t max_bytes) {
    if (max_bytes > 0) return max_bytes;
    return std::min(1024 * mib, std::max(64 * mib, saturating_product(file_bytes, 1000)));
}

std::uint64_t decoded_bytes(const ImageClaims& claims) {
    // Tiled files decode whole tiles: what sticks out of the image counts too.
    const auto padded = [](std::int64_t side, std::int64_t tile) {
        if (tile <= 0) return std::uint64_t(side);
        return saturating_product((std::uint64_t(side) + std::uint64_t(tile) - 1) / std::uint64_t(tile), std::uint64_t(tile));
    };
    std::uint64_t bytes = saturating_product(padded(claims.width, claims.tile_width), padded(claims.height, claims.tile_height));
    bytes = saturating_product(bytes, claims.channels.size());
    return saturating_product(bytes, std::uint64_t(sample_bytes(claims.sample)));
}

Result<void> check_claims(const ImageClaims& claims, std::uint64_t file_bytes, std::uint64_t max_bytes, int planes,
                          const std::string& name) {
    const std::string size = std::to_string(claims.width) + " x " + std::to_string(claims.height);
    if (!possible_side(claims.width) || !possible_side(claims.height))
        return fail(ErrorCode::bad_data, name + ": claims " + size + " pixels; sides of 1 to " + std::to_string(max_side) +
                                             " can be read");
    if (claims.depth != 1 || claims.deep)
        return fail(ErrorCode::bad_data, name + ": is a " + (claims.deep ? "deep" : "volume") +
                                             " image; a flat one is needed");
    if (claims.channels.empty() || std::int64_t(claims.channels.size()) > max_channels)
        return fail(ErrorCode::bad_data, name + ": claims " + std::to_string(claims.channels.size()) + " channels; 1 to " +
                                             std::to_string(max_channels) + " can be read");

    const std::uint64_t allowed = decode_budget(file_bytes, max_bytes);
    const std::uint64_t decoded = decoded_bytes(claims);
    if (decoded > allowed)
        return fail(ErrorCode::bad_data, name + ": " + size + " with " + std::to_string(claims.channels.size()) +
                                             " channels decodes to " + in_mib(decoded) + ", over the budget of " + in_mib(allowed) +
                                             " for a file of " + std::to_string(file_bytes) +
                                             " bytes; --max-bytes lifts it");
    // The caller's planes are bounded by the fixed part of the budget alone: a small file may well hold one bit a pixel.
    const std::uint64_t kept = saturating_product(saturating_product(std::uint64_t(claims.width), std::uint64_t(claims.height)),
                                                  4 * std::uint64_t(planes));
    const std::uint64_t kept_allowed = decode_budget(std::numeric_limits<std::uint64_t>::max(), max_bytes);
    if (kept > kept_allowed)
        return fail(ErrorCode::bad_data, name + ": " + size + " needs " + in_mib(kept) + " of memory, over the budget of " +
                                             in_mib(kept_allowed) + "; --max-bytes lifts it");
    return {};
}

} // namespace reliefbake
