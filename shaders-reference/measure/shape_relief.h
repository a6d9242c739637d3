#pragma once
// The relief that an extrusion is: over each texel, how deep its solid begins.

#include "bake/height_field.h"
#include "bake/shape_map.h"
#include "shaders-reference/solid.h"

namespace reliefbake {

/// Depth z in [0, 1] where the gap of an extrusion first is 0 under each texel's centre: 0 within e of the shape, (D - e) / b down to c, else
/// the floor, 1. Walls that stand upright lean within a texel between centres. D is the map's, unfiltered.
DepthMap shape_relief(const ShapeMap& map, const ShapeSolid& solid);

} // namespace reliefbake
