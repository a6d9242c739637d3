// Solids of a shape map: extruded (004 formulas 2-7) or revolved (003 formulas 1-13), basic, extended, bevelled or chamfered.
// Needs shape_map.glsl.
//
//     gap(P) = D(u, v) - e - b min(z, c)
//
//   SOLID_REVOLUTION 0  P = (u, v, z): z the depth, 0 at the polygon, 1 at the floor
//   SOLID_REVOLUTION 1  P = (X, Y, v): X, Y texture widths from the axis, v down the map; u = axis + |(X, Y)|, z = v

uniform float solid_outward;  // e, texture widths
uniform float solid_bevel;    // b, texture widths per unit of z
uniform float solid_chamfer;  // c, in z; 1e30 for none
uniform float solid_axis;     // u of the axis of revolution
uniform float solid_depth;    // extrusion: depth of the whole relief, texture widths
uniform float solid_tiles;    // repeats: per axis of the plane, or along the axis of revolution
uniform int solid_steps;        // of the circle tracing
uniform int solid_binary_steps; // halvings at the end
uniform float solid_epsilon;  // a ray this close to the solid has hit it, texture widths

struct SolidRay {
    vec3 origin;    // P
    vec3 direction; // per unit of t
};

const int SOLID_HIT = 1;
const int SOLID_OUT_OF_STEPS = 2;
const int SOLID_PASSED = 3; // left the domain

struct SolidHit {
    float t;
    float gap;   // to the solid, as the map knows it, texture widths
    int steps;   // rounds of the loop
    int fetches; // texture reads
    int status;
};

SolidHit solid_start() {
    SolidHit hit;
    hit.t = 0.0;
    hit.gap = 0.0;
    hit.steps = 0;
    hit.fetches = 0;
    hit.status = SOLID_OUT_OF_STEPS;
    return hit;
}

vec3 solid_place(vec3 p) { // (u, v, z)
#if SOLID_REVOLUTION
    return vec3(solid_axis + length(p.xy), p.z, p.z);
#else
    return p;
#endif
}

// How fast the distance can change along a ray, texture widths per unit of t.
float solid_speed(vec3 direction) {
#if SOLID_REVOLUTION
    return length(vec3(direction.xy, shape_aspect * direction.z));
#else
    return length(vec2(direction.x, shape_aspect * direction.y));
#endif
}

float solid_widened(float z) { return solid_outward + solid_bevel * min(z, solid_chamfer); }

// Time for a way at a rate; none, where it is never gone.
float solid_quotient(float way, float rate) { return rate > 0.0 ? way / rate : 1e30; }

vec4 solid_texel(vec3 place) { return textureLod(shape_map, place.xy, 0.0); }

// Towards the outside of the solid at a place, in the world: x along u, y up the image (revolution: x, y around the axis), z up.
// The gradient of gap: (11) of 003 has -b Gy for -Gy + b. Faces the viewer where the map has no gradient.
vec3 solid_normal(vec3 p, vec3 view) {
    vec3 place = solid_place(p);
    vec2 g = shape_gradient(solid_texel(place));
#if SOLID_REVOLUTION
    vec2 outward = dot(p.xy, p.xy) > 0.0 ? normalize(p.xy) : vec2(1.0, 0.0);
    float lean = place.z < solid_chamfer ? solid_bevel / shape_aspect : 0.0;
    vec3 normal = vec3(g.x * outward, lean - g.y);
#else
    float lean = place.z < solid_chamfer ? solid_bevel / solid_depth : 0.0;
    vec3 normal = vec3(g.x, -g.y, lean);
#endif
    float size = length(normal);
    return dot(g, g) > 0.0 && size > 1e-6 ? normal / size : -view;
}
