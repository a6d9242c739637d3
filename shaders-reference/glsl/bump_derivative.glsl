// Bump mapping from derivatives of the height: the depth map of revolution-bump mapping (003, formulas 4 and 5; Blinn 1978).
// Needs signed_code.glsl.

uniform sampler2D bump_map;     // dH/du, dH/dv, depth; linear filter; wrap as baked
uniform float bump_scale;       // derivative of the largest code; 1 for half and float channels
uniform float bump_aspect;      // R = height / width * pixel aspect

// Height 0 to 1 per texture width and per texture height, v down the image.
vec2 bump_derivatives(vec2 uv) {
    vec3 value = signed_value(textureLod(bump_map, uv, 0.0).rgb);
    return vec2(value.x * bump_scale, value.y * bump_scale);
}

// Unit normal of a surface with unit normal n, unit tangents t along u and b along v, under a relief `depth` texture widths deep.
vec3 bump_normal(vec2 uv, vec3 n, vec3 t, vec3 b, float depth) {
    vec2 d = bump_derivatives(uv);
    return normalize(n + depth * (d.x * cross(n, b) - d.y / bump_aspect * cross(n, t)));
}

float bump_depth(vec2 uv) { return textureLod(bump_map, uv, 0.0).b; }
