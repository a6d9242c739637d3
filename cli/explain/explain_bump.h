#pragma once
// `reliefbake explain` of a bump map, for a person.

#include "bake/bump_map.h"

#include <string>

namespace reliefbake {

/// What the map means and how a shader decodes it.
std::string explain_bump_text(const BumpMap& map);

} // namespace reliefbake
