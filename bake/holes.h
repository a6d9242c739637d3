#pragma once
// Holes: texels through which a ray falls (docs/FORMATS.md, "Holes"; docs/SAFETY.md).
// Below the floor of the relief there is nothing, so a hole is a pit down to depth 1 without a bottom: depth 1 is what every
// lookup of the surface may take a hole for, and the lowest height constrains no cone. Solid texels end one code above.

#include "bake/error.h"
#include "bake/image.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace reliefbake {

struct DepthMap;

/// 1 where a texel is a hole, else 0. Empty: a map that knows no holes and reserves no code for them.
using HoleMask = Image<std::uint8_t>;

/// Holes are the texels whose alpha is below `threshold`. Errors (bad_data): a NaN or infinite alpha. `name`: the file.
Result<HoleMask> find_holes(const Image<float>& alpha, float threshold, const std::string& name);

/// Of a stored map: its holes; empty without DepthMap::holes.
HoleMask stored_holes(const DepthMap& depth);

/// What is open in a map.
struct HoleCount {
    std::size_t texels = 0; ///< holes
    std::size_t cells = 0;  ///< open cells: all four corners are holes. There, and only there, a ray falls through
};
HoleCount count_holes(const DepthMap& depth);

} // namespace reliefbake
