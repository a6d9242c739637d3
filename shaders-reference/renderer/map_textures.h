#pragma once
// A relief map on the GPU: its textures, and the numbers that relief_map.glsl needs beside them.

#include "bake/error.h"
#include "bake/relief_map.h"
#include "shaders-reference/renderer/offscreen.h"
#include "shaders-reference/renderer/sampler_filter.h"

#include <vector>

namespace reliefbake {

struct MapTextures {
    GlTexture map;      ///< normal x, normal y, cone or nothing, depth
    GlTexture cones[2]; ///< planes of maps with several cones a texel, four each
};

/// Needs the screen's context to be current. Errors (usage): larger than the driver's textures; `fixed8` for a map that is not 8-bit; no
/// depth channel; more than 8 sectors or levels.
Result<MapTextures> upload_map(const Offscreen& screen, const ReliefMap& map, SamplerFilter filter);

/// Planes 4 `group` to 4 `group` + 3.
GlTexture upload_group(const GlFunctions& gl, const std::vector<Image<float>>& images, std::size_t group, const TexelGrid& grid,
                       TexelStorage storage);

TexelStorage storage_of(BitDepth bits, SamplerFilter filter);

/// Texture units: of the map, and of the first group of cones; the second takes the unit after it.
struct MapUnits {
    int map, cones;
};

/// `delta`: how far the sampler may err in height.
void set_map_uniforms(const Uniforms& uniforms, const MapUnits& units, const ReliefMapInfo& info, const TexelGrid& grid, double delta);

} // namespace reliefbake
