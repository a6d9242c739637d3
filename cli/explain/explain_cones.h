#pragma once
// What the cones of a map promise and where they lie, in sentences.

#include "bake/relief_map.h"

#include <string>

namespace reliefbake {

/// The channel, or the word, that a formula for the ratio names: "B", "relief.cone", or "cone" where the map has several.
std::string cone_word(const ReliefMapInfo& info);

/// Which channel holds which sector or level; empty for a map with one cone a texel.
std::string plane_lines(const ReliefMapInfo& info);

/// What a ray may do inside a cone, and how cones are fetched, where that is not the plain case.
std::string family_lines(const ReliefMapInfo& info);

/// What is guaranteed, of which surface.
std::string guarantee_line(const ReliefMapInfo& info);

} // namespace reliefbake
