#pragma once
// printf's patterns for the lines of reports.

#include <string>

namespace reliefbake {

/// At most 511 characters.
[[gnu::format(printf, 1, 2)]] std::string format(const char* pattern, ...);

} // namespace reliefbake
