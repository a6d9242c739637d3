#pragma once
// The baked planes as the four channels of a file.

#include "bake/cone.h"
#include "bake/height_field.h"
#include "bake/normal_map.h"
#include "bake/relief_map.h"

namespace reliefbake {

/// The ordinary cone map that goes with cones alone: its cone at a texel is the narrowest of theirs that stand on the surface.
ReliefMap relief_map_for(const ReliefMap& map);

/// Rounds the normals to codes of `info.bits` (unorm: 0.5 n + 0.5), turns y for NormalY::dx, and puts
/// normals, cones and depth side by side. All planes have the depth's grid. By value: a caller that is done with a
/// plane moves it in and saves its memory.
ReliefMap assemble_map(const ReliefMapInfo& info, DepthMap depth, std::vector<EncodedConeMap> cones, NormalMap normals);

} // namespace reliefbake
