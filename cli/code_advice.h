#pragma once
// Which encoding would not lose the cones that this one loses.

#include "bake/cone.h"

#include <string>

namespace reliefbake {

/// For an encoding that left texels with code 0: tries the others at the same depth and names the one that
/// leaves the fewest, or more bits when none leaves fewer. Costs an encoding pass each.
std::string better_codes(const ConeMap& cones, const DepthMap& depth, const EncodedConeMap& encoded);

} // namespace reliefbake
