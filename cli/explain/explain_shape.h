#pragma once
// `reliefbake explain` of a shape map, for a person.

#include "bake/shape_map.h"

#include <string>

namespace reliefbake {

/// What the map means and how a shader decodes it.
std::string explain_shape_text(const ShapeMap& map);

} // namespace reliefbake
