#include "formats/pixel_hash.h"

#include <xxhash.h>

#include <bit>
#include <cstdint>
#include <memory>

namespace reliefbake {

static_assert(std::endian::native == std::endian::little, "the hash is defined on little-endian bytes");

std::string pixel_hash(const Image<float>& plane) {
    const std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> state(XXH3_createState(), XXH3_freeState);
    const std::uint32_t size[] = {std::uint32_t(plane.width()), std::uint32_t(plane.height())};
    XXH3_128bits_reset(state.get());
    XXH3_128bits_update(state.get(), size, sizeof size);
    XXH3_128bits_update(state.get(), plane.data(), plane.size() * sizeof(float));

    XXH128_canonical_t canonical;
    XXH128_canonicalFromHash(&canonical, XXH3_128bits_digest(state.get()));
    std::string hex;
    for (const unsigned char byte : canonical.digest) {
        hex += "0123456789abcdef"[byte >> 4];
        hex += "0123456789abcdef"[byte & 15];
    }
    return hex;
}

} // namespace reliefbake
