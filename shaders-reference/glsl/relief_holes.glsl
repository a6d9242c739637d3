// Where a ray falls through. Needs relief_map.glsl.
//
// A texel of depth 1 is a hole; solid ones end one code above. A cell whose four texels are holes has no floor: a ray that comes
// down to depth 1 there has met nothing, and its pixel is discarded. Everywhere else, walls beside holes included, the filtered
// depth is the relief, so no march needs to know of holes. Reads are unfiltered: no rounding of a filter counts.

bool relief_is_hole(ivec2 texel) { return relief_depth(texelFetch(relief_map, relief_address(texel), 0)) >= 1.0; }

bool relief_falls_through(ReliefRay ray, ReliefHit hit) {
    vec2 uv = ray.origin + min(hit.t, 1.0) * ray.direction;
    ivec2 cell = ivec2(floor(uv * vec2(textureSize(relief_map, 0)) - 0.5));
    return relief_is_hole(cell) && relief_is_hole(cell + ivec2(1, 0)) && relief_is_hole(cell + ivec2(0, 1)) &&
           relief_is_hole(cell + ivec2(1, 1));
}
