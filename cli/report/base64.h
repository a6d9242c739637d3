#pragma once
// Bytes as text that a page can hold (RFC 4648, section 4).

#include <string>
#include <string_view>

namespace reliefbake {

std::string base64(std::string_view bytes);

} // namespace reliefbake
