#pragma once
// `reliefbake verify` of a bump map.

#include "shaders-reference/measure/check_bump.h"

#include <string>

namespace reliefbake {

/// Gives a map of horizons alone the depth of its relief file, a cone map of the same heights; refuses (usage) one that is
/// missing or not wanted, and (bad_data) one that does not fit.
Result<void> take_depth(BumpMap& map, const std::string& file, const std::string& relief, std::uint64_t max_bytes);

/// For a person.
std::string verify_bump_text(const BumpMap& map, const BumpReport& report);

} // namespace reliefbake
