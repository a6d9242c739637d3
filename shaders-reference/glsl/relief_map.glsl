// A baked relief map and what its channels mean.
//
// Texel = (normal x, normal y, cone, depth); maps with several cones a texel keep them apart (relief_cones.glsl). Depth 0
// is the polygon, 1 the floor. Horizontal lengths are in texture widths, so that cones are round on maps of any shape:
// |(du, dv)|^2 = du^2 + (aspect dv)^2.
//
// Set before this text, from the map's metadata (`reliefbake explain`):
//   RELIEF_ENCODING       0 ratio, 1 sqrt, 2 radius, 3 normal
//   RELIEF_METRIC_L1      1 when the cones are squares |du| + aspect |dv| <= ratio z
//   RELIEF_NORMAL_UNORM   1 when normals are stored as 0.5 n + 0.5
//   RELIEF_NORMAL_DX      1 when the stored y points down the image

uniform sampler2D relief_map;   // linear filter, no mips; wrap as baked
uniform float relief_cone_max;  // ratio of the largest code (ratio, sqrt)
uniform float relief_aspect;    // R = height / width * pixel aspect
uniform float relief_code_delta; // how far it may err in a code, for `radius`: 2/255 for 8-bit textures whose filter rounds to 8 bits, else 0
uniform float relief_delta;     // how far the sampler's filter may err in height; 0 for exact filters
uniform ivec2 relief_repeat;    // per axis: 1 repeat, 0 clamp
uniform float relief_depth_scale; // depth of the relief, texture widths

float relief_depth(vec4 texel) { return texel.a; }

// Cone ratio of a sampled code: radius in texture widths per unit of height. A wider one may hit the relief.
// `depth` must come from the same fetch as the code (radius alone reads it).
float relief_ratio(float code, float depth) {
#if RELIEF_ENCODING == 0
    return code * relief_cone_max;
#elif RELIEF_ENCODING == 1
    return code * code * relief_cone_max;
#elif RELIEF_ENCODING == 2
    // Where a sampler's weights have 8 bits, both may be off, and to the side that widens the cone.
    float largest_depth = depth + relief_delta;
    return largest_depth > 0.0 ? max(code - relief_code_delta, 0.0) / largest_depth : relief_cone_max;
#else
    return code / sqrt(max(1.0 - code * code, 1e-12));
#endif
}

// The texel that a sampler would read for an index outside the map.
ivec2 relief_address(ivec2 texel) {
    ivec2 size = textureSize(relief_map, 0);
    ivec2 tile = ivec2(floor(vec2(texel) / vec2(size)));
    ivec2 repeated = texel - tile * size;
    ivec2 clamped = clamp(texel, ivec2(0, 0), size - 1);
    return ivec2(relief_repeat.x == 1 ? repeated.x : clamped.x, relief_repeat.y == 1 ? repeated.y : clamped.y);
}

// Unit normal: x along +u, y up the image, z out of the relief.
vec3 relief_normal(vec4 texel) {
    vec2 xy = texel.rg;
#if RELIEF_NORMAL_UNORM
    xy = 2.0 * xy - 1.0;
#endif
#if RELIEF_NORMAL_DX
    xy.y = -xy.y;
#endif
    return normalize(vec3(xy, sqrt(max(1.0 - dot(xy, xy), 0.0))));
}

// Length of a texture-space vector in the metric of the cones, texture widths.
float relief_length(vec2 uv) {
#if RELIEF_METRIC_L1
    return abs(uv.x) + abs(relief_aspect * uv.y);
#else
    return length(vec2(uv.x, relief_aspect * uv.y));
#endif
}

// A ray that enters at depth 0 and goes down one unit of depth for each unit of its parameter t:
// uv = origin + t direction, depth = t.
struct ReliefRay {
    vec2 origin;
    vec2 direction;
};

const int RELIEF_NO_RAY = 0;
const int RELIEF_HIT = 1;
const int RELIEF_OUT_OF_STEPS = 2; // t is where the march stood, above the relief
const int RELIEF_HOLE = 4;         // came down to where there is no floor

struct ReliefHit {
    float t;     // depth reached
    float gap;   // height above the sampled relief there
    int steps;   // rounds of the loop
    int fetches; // texture reads
    int status;
};

ReliefHit relief_start() {
    ReliefHit hit;
    hit.t = 0.0;
    hit.gap = 0.0;
    hit.steps = 0;
    hit.fetches = 0;
    hit.status = RELIEF_OUT_OF_STEPS;
    return hit;
}

// Cosine of the angle between a ray and the polygon's normal, in the relief's true proportions.
float relief_cosine(vec2 direction) {
    float tangent = length(vec2(direction.x, relief_aspect * direction.y)) / relief_depth_scale;
    return 1.0 / sqrt(1.0 + tangent * tangent);
}
