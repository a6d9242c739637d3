#include "shaders-reference/renderer/map_textures.h"

#include "shaders-reference/renderer/shader_source.h"

#include <algorithm>
#include <string>

namespace reliefbake {
namespace {

const Image<float>* channel_or_null(const Image<float>& channel) { return channel.empty() ? nullptr : &channel; }

/// (normal x, normal y, cone or nothing, depth). A map without normals is shaded as a flat one: its texture needs zeros
/// that mean "flat", which unorm channels store as 0.5.
GlTexture upload_relief(const GlFunctions& gl, const ReliefMap& map, SamplerFilter filter) {
    const bool no_normals = map.normal_x.empty() || map.normal_y.empty();
    const Image<float> flat(no_normals ? map.grid.width : 1, no_normals ? map.grid.height : 1, is_unorm(map.info.bits) ? 0.5f : 0.0f);
    return upload_texture(gl, {no_normals ? &flat : &map.normal_x, no_normals ? &flat : &map.normal_y, channel_or_null(map.cone), &map.depth},
                  map.grid, storage_of(map.info.bits, filter));
}

} // namespace

TexelStorage storage_of(BitDepth bits, SamplerFilter filter) {
    if (filter == SamplerFilter::fixed8) return TexelStorage::unorm8;
    return is_unorm(bits) ? TexelStorage::unorm16 : TexelStorage::float32;
}

GlTexture upload_group(const GlFunctions& gl, const std::vector<Image<float>>& images, std::size_t group, const TexelGrid& grid,
                       TexelStorage storage) {
    Channels channels{};
    for (std::size_t k = 4 * group; k < std::min(4 * group + 4, images.size()); ++k) channels[k % 4] = &images[k];
    return upload_texture(gl, channels, grid, storage);
}

Result<MapTextures> upload_map(const Offscreen& screen, const ReliefMap& map, SamplerFilter filter) {
    if (map.depth.empty()) return fail(ErrorCode::usage, "the map has no depth channel: nothing can be drawn without one");
    if (std::max(map.grid.width, map.grid.height) > screen.largest())
        return fail(ErrorCode::usage, "the map is larger than the OpenGL driver's textures (" + std::to_string(screen.largest()) + " texels a side)");
    if (filter == SamplerFilter::fixed8 && map.info.bits != BitDepth::unorm8)
        return fail(ErrorCode::usage, "--filter fixed8 tests 8-bit maps only; this map is not 8-bit");
    if (map.cone_planes.size() > 8)
        return fail(ErrorCode::usage, "the renderer takes up to 8 sectors or levels; this map has " + std::to_string(map.cone_planes.size()));
    MapTextures textures;
    textures.map = upload_relief(screen.gl(), map, filter);
    for (std::size_t group = 0; group < 2; ++group)
        if (map.cone_planes.size() > 4 * group)
            textures.cones[group] = upload_group(screen.gl(), map.cone_planes, group, map.grid, storage_of(map.info.bits, filter));
    return textures;
}

void set_map_uniforms(const Uniforms& uniforms, const MapUnits& units, const ReliefMapInfo& info, const TexelGrid& grid, double delta) {
    uniforms.set("relief_map", units.map);
    uniforms.set("relief_cones_0", units.cones);
    uniforms.set("relief_cones_1", units.cones + 1);
    uniforms.set("relief_cone_max", std::min(info.cone_max, widest_ratio));
    uniforms.set("relief_aspect", float(grid.aspect()));
    uniforms.set("relief_delta", float(delta));
    uniforms.set("relief_code_delta", delta > 0 ? filtered_code_error : 0.0f);
    uniforms.set("relief_repeat", grid.wrap_x == Wrap::repeat, grid.wrap_y == Wrap::repeat);
    uniforms.set("relief_depth_scale", float(info.depth_scale));
}

} // namespace reliefbake
