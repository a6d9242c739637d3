#pragma once
// A map's meaning in sentences.

#include "bake/relief_map.h"

#include <string>

namespace reliefbake {

/// One line a fact: what the file is, how a shader decodes each channel, what is guaranteed. `map` as
/// read_map gives it: absent channels are empty images.
std::string explain_text(const ReliefMap& map);

} // namespace reliefbake
