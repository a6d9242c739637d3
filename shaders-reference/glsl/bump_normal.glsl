// A tangent-space normal map. Needs signed_code.glsl.
//
// Set before this text, from the map's metadata:
//   BUMP_NORMAL_DX  1 when the stored y points down the image

uniform sampler2D bump_map; // normal x, y, z, depth; linear filter; wrap as baked

// Unit normal: x along +u, y up the image, z out of the polygon.
vec3 bump_normal(vec2 uv) {
    vec3 n = signed_value(textureLod(bump_map, uv, 0.0).rgb);
#if BUMP_NORMAL_DX
    n.y = -n.y;
#endif
    return normalize(n);
}

float bump_depth(vec2 uv) { return textureLod(bump_map, uv, 0.0).a; }
