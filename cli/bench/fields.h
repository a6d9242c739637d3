#pragma once
// Adversarial height fields for timing: shapes that defeat the usual pruning.

#include "bake/height_field.h"

#include <string>
#include <vector>

namespace reliefbake {

/// ramp, pyramid, hill, saw-tooth, stairs, checkerboard, spike, noise, constant, fbm.
const std::vector<std::string>& field_names();

/// A tiling size x size field of that name, stored as 16-bit depth.
DepthMap make_field(const std::string& name, int size);

} // namespace reliefbake
