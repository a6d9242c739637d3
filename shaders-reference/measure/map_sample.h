#pragma once
// What a sampler returns for a map, with exact weights.

#include "bake/relief_map.h"

namespace reliefbake {

enum class Fetch { bilinear, nearest };

/// Cone ratio that a shader decodes at (u, v): the stored codes are filtered, then decoded.
double sampled_ratio(const ReliefMap& map, double u, double v, Fetch fetch);

} // namespace reliefbake
