#pragma once
// Numbers in the lines of reports.

#include <string>

namespace reliefbake {

/// printf's patterns; at most 511 characters.
[[gnu::format(printf, 1, 2)]] std::string format(const char* pattern, ...);

/// The fewest digits that read back as the number.
std::string digits(double number);

} // namespace reliefbake
