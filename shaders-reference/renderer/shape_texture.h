#pragma once
// A shape map on the GPU: its texture, and the numbers that shape_map.glsl and shape_solid.glsl need beside it.

#include "bake/error.h"
#include "bake/shape_map.h"
#include "shaders-reference/renderer/offscreen.h"
#include "shaders-reference/renderer/sampler_filter.h"
#include "shaders-reference/solid.h"

namespace reliefbake {

/// Circles, then halvings.
struct CircleCounts {
    int steps, binary_steps;
};

/// Needs the screen's context to be current. Errors (usage): larger than the driver's textures; `fixed8` for a map that is not 8-bit.
Result<GlTexture> upload_shape(const Offscreen& screen, const ShapeMap& map, SamplerFilter filter);

/// `delta`: how far the sampler may misplace a lookup, texture widths.
void set_shape_uniforms(const Uniforms& uniforms, int unit, const ShapeMapInfo& info, const TexelGrid& grid, double delta);

/// e, b and c of a solid, and how it is traced. `epsilon`: gap that counts as a hit, texture widths.
void set_profile_uniforms(const Uniforms& uniforms, const ShapeSolid& solid, const CircleCounts& counts, double epsilon);

} // namespace reliefbake
