#include "cli/report/base64.h"

#include <cstdint>

namespace reliefbake {

std::string base64(std::string_view bytes) {
    constexpr char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t k = 0; k < bytes.size(); k += 3) {
        const auto byte = [&](std::size_t i) { return i < bytes.size() ? std::uint32_t(std::uint8_t(bytes[i])) : 0; };
        const std::uint32_t three = byte(k) << 16 | byte(k + 1) << 8 | byte(k + 2);
        for (int shift = 18; shift >= 0; shift -= 6) text += letters[three >> shift & 63];
    }
    for (std::size_t padding = (3 - bytes.size() % 3) % 3, k = 0; k < padding; ++k) text[text.size() - 1 - k] = '=';
    return text;
}

} // namespace reliefbake
