// Colour and bumps laid onto a solid. Needs shape_solid.glsl.
//
//   SOLID_PROJECTION  0 planar: (u, v) of the map;  1 cylindrical: angle, height;  2 spherical about the middle: longitude, latitude
//   SOLID_COLOUR, SOLID_BUMP  1 when there is such a texture

#if SOLID_COLOUR
uniform sampler2D solid_colour; // linear colour
#endif
#if SOLID_BUMP
uniform sampler2D solid_bump;   // (dH/du, dH/dv, -, -): height per width of this texture, v down
uniform float solid_bump_scale; // a of 003 (5); > 0: what is high stands out
#endif
uniform vec2 solid_texture_tiles; // repeats of both over the solid

vec2 solid_texture_place(vec3 p) {
#if SOLID_PROJECTION == 0
    return p.xy * solid_texture_tiles;
#else
    float longitude = 0.5 + atan(p.y, p.x) / 6.283185307;
#if SOLID_PROJECTION == 1
    return vec2(longitude, p.z) * solid_texture_tiles;
#else
    float up = shape_aspect * (0.5 * solid_tiles - p.z);
    float from_middle = length(vec3(p.xy, up));
    return vec2(longitude, from_middle > 0.0 ? acos(clamp(up / from_middle, -1.0, 1.0)) / 3.141592654 : 0.5) * solid_texture_tiles;
#endif
#endif
}

// Unit vectors on the surface towards +u and +v of the texture (v goes down). Of revolution: T around the axis, B = T x N down the
// meridian; 003's (6) is not tangent (N.T = Gx Gy), these are by construction. Planar: the texture's axes, cast onto the surface.
void solid_tangents(vec3 p, vec3 normal, out vec3 tangent, out vec3 bitangent) {
#if SOLID_PROJECTION == 0
    tangent = vec3(1.0, 0.0, 0.0) - normal.x * normal;
    bitangent = vec3(0.0, -1.0, 0.0) + normal.y * normal;
#else
    vec2 outward = dot(p.xy, p.xy) > 0.0 ? normalize(p.xy) : vec2(1.0, 0.0);
    tangent = vec3(-outward.y, outward.x, 0.0);
    bitangent = cross(tangent, normal);
#endif
}

// 003 (4), (5): N + a Hu (N x B) - a Hv (N x T) with B = N x T. (7) has B = T x N, which turns hills into pits.
vec3 solid_bumped(vec3 p, vec3 normal) {
#if SOLID_BUMP
    vec3 tangent;
    vec3 bitangent;
    solid_tangents(p, normal, tangent, bitangent);
    vec2 slope = textureLod(solid_bump, solid_texture_place(p), 0.0).rg;
    return normalize(normal - solid_bump_scale * (slope.x * tangent + slope.y * bitangent));
#else
    return normal;
#endif
}
