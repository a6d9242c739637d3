#pragma once
// The baked planes as the four channels of a file.

#include "bake/cone.h"
#include "bake/height_field.h"
#include "bake/normal_map.h"
#include "bake/relief_map.h"

namespace reliefbake {

/// Rounds the normals to codes of `info.bits` (unorm: 0.5 n + 0.5), turns y for NormalY::dx, and puts
/// normals, cones and depth side by side. All planes have the depth's grid.
ReliefMap assemble_map(const ReliefMapInfo& info, const DepthMap& depth, const EncodedConeMap& cones,
                       const NormalMap& normals);

} // namespace reliefbake
