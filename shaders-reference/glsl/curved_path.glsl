// Where a ray over a curved polygon stands in its map (000 and 004; MATHS section 7). The surface is taken for the quadric
// z = a x^2 + b y^2 + c x y in the fragment's tangent frame: x along the tangent, y along the bitangent, z outwards.
// Lengths are in depths of the relief, so that the floor is at depth 1 and no unit of the mesh appears.
//
//   CURVED_PATH  0  straight: the polygon is flat
//                1  the vertical distance to the quadric: depth(t) = -Vz t + (a Vx^2 + b Vy^2 + c Vx Vy) t^2 (000 formula 12)
//                2  the distance to a torus with the quadric's two curvatures: exact over spheres, cylinders and the equators of tori; uv is
//                   taken to second order, so that texture keeps its place where it widens or turns over the surface
//                3  as printed: curved_path_published.glsl

struct CurvedRay {
    vec2 origin;   // uv where it enters, depth 0
    vec3 sight;    // unit, in the tangent frame; z < 0 goes in
    vec3 quadric;  // a, b, c
    mat2 chart;    // uv per (x, y)
    vec3 bend_u;   // CURVED_PATH 2: second derivatives of u by x and y: xx, xy, yy;
    vec3 bend_v;   // and of v
    float unit;    // one unit of the mesh; CURVED_PATH 3 alone depends on it
    vec4 ends;     // least u, v and greatest u, v of the map on this mesh: where it ends with the mesh, so does the relief
};

struct CurvedPlace {
    vec2 uv;
    float depth;
    vec2 along;  // change of uv,
    float sinks; // and of depth, per length
    vec3 up;     // the surface's normal here, in the tangent frame
};

const int CURVED_HIT = 1;
const int CURVED_OUT_OF_STEPS = 2;
const int CURVED_LEFT = 3; // came out of the relief, beyond the silhouette or an end

struct CurvedHit {
    float t;     // way gone
    float gap;   // to the relief
    int steps;   // rounds of the loop
    int fetches; // texture reads
    int status;
};

CurvedHit curved_start() {
    CurvedHit hit;
    hit.t = 0.0;
    hit.gap = 0.0;
    hit.steps = 0;
    hit.fetches = 0;
    hit.status = CURVED_OUT_OF_STEPS;
    return hit;
}

bool curved_is_out(CurvedRay ray, CurvedPlace place) {
    return place.depth < 0.0 || any(lessThan(place.uv, ray.ends.xy)) || any(greaterThan(place.uv, ray.ends.zw));
}

// Half of how fast the way turns into the relief; < 0: out of it, over a surface that bulges.
float curved_bend(CurvedRay ray) {
#if CURVED_PATH == 0
    return 0.0;
#else
    vec2 v = ray.sight.xy;
    return ray.quadric.x * v.x * v.x + ray.quadric.y * v.y * v.y + ray.quadric.z * v.x * v.y;
#endif
}

// A step that must not leave a cone or circle when the way turns inwards by `bend` s^2: s + bend s^2 / sinks stands for s.
float curved_shortened(float step, float bend, float sinks) {
    return bend > 0.0 ? 2.0 * step / (1.0 + sqrt(1.0 + 4.0 * step * bend / max(sinks, 1e-6))) : step;
}

// First t > 0 at depth 0 or 1, 1e30 for none (the corrected tMax of 000). The floor: bend t^2 - Vz t - 1 = 0, without cancellation.
float curved_end(CurvedRay ray) {
    float bend = curved_bend(ray);
    float into = -ray.sight.z;
    float end = 1e30;
    if (into * bend < 0.0) end = -into / bend;
    float discriminant = into * into + 4.0 * bend;
    if (discriminant >= 0.0) {
        float sum = into + (into < 0.0 ? -1.0 : 1.0) * sqrt(discriminant);
        float first = abs(sum) > 1e-15 ? 2.0 / sum : 1e30;
        float second = bend != 0.0 ? -0.5 * sum / bend : 1e30;
        if (first > 0.0) end = min(end, first);
        if (second > 0.0) end = min(end, second);
    }
    return end;
}

#if CURVED_PATH == 2
// From flat to the circle of curvature k (> 0 bulges) that touches it: x becomes the arc, z the height above the circle, and the
// velocity is seen from there. (s, c): the sine and cosine of the turn.
void curved_turn(float k, inout float x, inout float z, inout float x_speed, inout float z_speed, out float s, out float c) {
    float off = k * x;
    float base = 1.0 + k * z;
    float size = max(length(vec2(off, base)), 1e-6);
    s = off / size;
    c = base / size;
    z = (2.0 * z + k * (x * x + z * z)) / (1.0 + size);
    x = abs(off) > 1e-4 ? atan(off, base) / k : x / max(base, 1e-6);
    float along = x_speed * c - z_speed * s;
    z_speed = x_speed * s + z_speed * c;
    x_speed = along / size;
}

// How much the chart has changed on the way to p, by no more than half of what it was; `mean`: the chart from the entry to p.
mat2 curved_bends(CurvedRay ray, vec2 place, out mat2 mean) {
    vec2 p = clamp(place, -1e6, 1e6);
    mat2 bend = mat2(ray.bend_u.x * p.x + ray.bend_u.y * p.y, ray.bend_v.x * p.x + ray.bend_v.y * p.y,
                     ray.bend_u.y * p.x + ray.bend_u.z * p.y, ray.bend_v.y * p.x + ray.bend_v.z * p.y);
    float size = length(bend[0]) + length(bend[1]);
    float most = 0.5 * (length(ray.chart[0]) + length(ray.chart[1]));
    bend = size > most ? bend * (most / size) : bend;
    mean = ray.chart + 0.5 * bend;
    return bend;
}

// First the wider circle, then the tighter one, whose height is that above both.
CurvedPlace curved_place(CurvedRay ray, float t) {
    float mean = ray.quadric.x + ray.quadric.y;
    float lean = ray.quadric.x - ray.quadric.y;
    float spread = length(vec2(lean, ray.quadric.z));
    vec2 first = lean >= 0.0 ? vec2(spread + lean, ray.quadric.z) : vec2(ray.quadric.z, spread - lean);
    float size = length(first);
    first = size > 0.0 ? first / size : vec2(1.0, 0.0);
    vec2 curvature = vec2(-(mean + spread), -(mean - spread)); // along `first`, and across it
    if (abs(curvature.x) > abs(curvature.y)) {
        curvature = curvature.yx;
        first = vec2(-first.y, first.x);
    }
    vec2 second = vec2(-first.y, first.x);

    vec2 wide = vec2(dot(ray.sight.xy, first), dot(ray.sight.xy, first) * t); // speed, place
    vec2 tight = vec2(dot(ray.sight.xy, second), dot(ray.sight.xy, second) * t);
    float height = ray.sight.z * t;
    float rise = ray.sight.z;
    float s1;
    float c1;
    float s2;
    float c2;
    curved_turn(curvature.x, wide.y, height, wide.x, rise, s1, c1);
    curved_turn(curvature.y, tight.y, height, tight.x, rise, s2, c2);

    CurvedPlace place;
    vec2 p = wide.y * first + tight.y * second;
    vec2 speed = wide.x * first + tight.x * second;
    mat2 chart;
    mat2 bend = curved_bends(ray, p, chart);
    place.uv = ray.origin + chart * p;
    place.depth = -height;
    place.along = (ray.chart + bend) * speed;
    place.sinks = -rise;
    place.up = vec3(s1 * c2 * first + s2 * second, c1 * c2);
    return place;
}
#endif

#if CURVED_PATH < 2
CurvedPlace curved_place(CurvedRay ray, float t) {
    float bend = curved_bend(ray);
    CurvedPlace place;
    place.along = ray.chart * ray.sight.xy;
    place.uv = ray.origin + t * place.along;
    place.depth = t * (bend * t - ray.sight.z);
    place.sinks = 2.0 * bend * t - ray.sight.z;
    vec2 p = t * ray.sight.xy;
    vec2 slope = vec2(2.0 * ray.quadric.x * p.x + ray.quadric.z * p.y, 2.0 * ray.quadric.y * p.y + ray.quadric.z * p.x);
#if CURVED_PATH == 0
    slope = vec2(0.0, 0.0);
#endif
    place.up = normalize(vec3(-slope, 1.0));
    return place;
}
#endif
