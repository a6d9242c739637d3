#include "shaders-reference/renderer/shape_texture.h"

#include <algorithm>
#include <string>

namespace reliefbake {

Result<GlTexture> upload_shape(const Offscreen& screen, const ShapeMap& map, SamplerFilter filter) {
    if (std::max(map.grid.width, map.grid.height) > screen.largest())
        return fail(ErrorCode::usage, "the map is larger than the OpenGL driver's textures (" + std::to_string(screen.largest()) + " texels a side)");
    if (filter == SamplerFilter::fixed8 && map.info.bits != BitDepth::unorm8)
        return fail(ErrorCode::usage, std::string("--filter fixed8 tests 8-bit maps only; this map is not 8-bit"));
    const TexelStorage storage = filter == SamplerFilter::fixed8 ? TexelStorage::unorm8 : is_unorm(map.info.bits) ? TexelStorage::unorm16 : TexelStorage::float32;
    return upload_texture(screen.gl(), {&map.gradient_x, &map.gradient_y, &map.distance, &map.shape}, map.grid, storage);
}

void set_shape_uniforms(const Uniforms& uniforms, int unit, const ShapeMapInfo& info, const TexelGrid& grid, double delta) {
    uniforms.set("shape_map", unit);
    uniforms.set("shape_tau", float(info.tau));
    uniforms.set("shape_aspect", float(grid.aspect()));
    uniforms.set("shape_delta", float(delta));
}

void set_profile_uniforms(const Uniforms& uniforms, const ShapeSolid& solid, const CircleCounts& counts, double epsilon) {
    uniforms.set("solid_outward", float(solid.outward));
    uniforms.set("solid_bevel", float(solid.bevel));
    uniforms.set("solid_chamfer", float(std::min(solid.chamfer, 1e30)));
    uniforms.set("solid_steps", counts.steps);
    uniforms.set("solid_binary_steps", counts.binary_steps);
    uniforms.set("solid_epsilon", float(epsilon));
}

} // namespace reliefbake
