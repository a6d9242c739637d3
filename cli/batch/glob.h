#pragma once
// Patterns of file names.

#include <string>
#include <string_view>

namespace reliefbake {

/// Whether a relative path with '/' between its parts matches: `*`, `?`, `[...]` within one part, `**` for any number of folders.
/// A pattern without '/' is for the last part alone, in whichever folder. Case counts.
bool glob_matches(std::string_view pattern, std::string_view path);

bool is_glob(std::string_view text);

/// ASCII letters in lower case.
std::string lower(std::string text);

} // namespace reliefbake
