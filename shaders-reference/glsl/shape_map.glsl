// A shape map (003, 004): texel = (gradient u, gradient v, distance, 0 inside | 1 outside). Lengths are in texture widths,
// |(du, dv)|^2 = du^2 + (aspect dv)^2.
//
// Set before this text, from the map's metadata (`reliefbake explain`):
//   SHAPE_UNORM     1 when gradients are stored as 0.5 g + 0.5, and signed distances as 0.5 c + 0.5
//   SHAPE_SIGNED    1 when the distance inside is minus that to the outside

uniform sampler2D shape_map; // linear filter, no mips; wrap as baked
uniform float shape_tau;     // texture widths of the distance code 1
uniform float shape_aspect;  // height / width
uniform float shape_delta;   // how far a sampler with 8-bit weights may misplace a lookup, texture widths; 0 for exact filters

// Filtered distance to the shape: exact at texel centres, up to 0.7 texel off between them.
float shape_distance(vec4 texel) {
    float code = texel.b;
#if SHAPE_SIGNED
#if SHAPE_UNORM
    code = 2.0 * code - 1.0;
#endif
#endif
    return shape_tau * code;
}

// How far one may go without entering the shape (guarantee S): a distance averaged over four texels is at most sqrt(d^2 + 1/2 texel^2).
float shape_safe(float distance) {
    float texel = 1.0 / float(textureSize(shape_map, 0).x);
    return distance > 0.0 ? sqrt(max(distance * distance - 0.5 * texel * texel, 0.0)) - shape_delta : distance;
}

// Unit gradient of the distance towards +u and towards +v, which is down the image; 0 where it has none.
vec2 shape_gradient(vec4 texel) {
    vec2 g = texel.rg;
#if SHAPE_UNORM
    g = 2.0 * g - 1.0;
#endif
    float size = length(g);
    return size > 0.05 ? g / size : vec2(0.0, 0.0);
}
