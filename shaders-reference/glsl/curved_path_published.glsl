// The way of 000 (formulas 9 to 12, Algorithms 1, 2, 7) and 004 (Algorithms 1, 2, 9) as printed, for comparison. With z into the surface
// (depths, and a, b of the other sign), V the ray, U perpendicular to it, in the plane of V and the normal, outwards; at P = V * one unit of the mesh
//
//     d = (-B + sqrt(D)) / 2A,   A = a Ux^2 + b Uy^2,   B = 2 a Px Ux + 2 b Py Uy - Uz,   C = a Px^2 + b Py^2 - Pz,   D = B^2 - 4 A C
//
//     D > 0   "inside":  the ray is straight, V + d U, U mirrored as only V is for depths: "the depths increase"
//     else    "outside": depth = Vz t - (a Vx^2 + b Vy^2) t^2
//
// Put right: Algorithm 1's second a (b), lengths and depths brought to one unit, quotients by 0. Left: the case and d are those of one unit
// of the mesh, whatever unit that is. Needs curved_path.glsl with CURVED_PATH 3.

struct CurvedCase {
    bool inside;
    vec3 w;    // what is added to (Vx, Vy, Vz) inside; z: depth
    float end; // tmax
};

float curved_form(CurvedRay ray, vec2 p, vec2 r) { return -(ray.quadric.x * p.x * r.x + ray.quadric.y * p.y * r.y); }

// The root of q t^2 + b t + c that the listings take, without its sign; 1e30 for none, and where q is 0, by which they divide.
float curved_root(float q, float b, float c) {
    float discriminant = b * b - 4.0 * q * c;
    return discriminant > 0.0 && q != 0.0 ? abs((b - sqrt(discriminant)) / (-2.0 * q)) : 1e30;
}

CurvedCase curved_case(CurvedRay ray) {
    vec3 v = vec3(ray.sight.xy, -ray.sight.z);
    float across = length(v.xy);
    vec3 u = across > 1e-6 ? vec3(v.xy * (v.z / across), -across) : vec3(1.0, 0.0, 0.0);
    float q = curved_form(ray, v.xy, v.xy);
    float a = curved_form(ray, u.xy, u.xy);
    float b = 2.0 * ray.unit * curved_form(ray, v.xy, u.xy) - u.z;
    float c = ray.unit * (ray.unit * q - v.z);
    float discriminant = b * b - 4.0 * a * c;

    CurvedCase found;
    found.inside = discriminant > 0.0;
    found.w = vec3(0.0, 0.0, 0.0);
    found.end = found.inside ? curved_root(q, 2.0 * curved_form(ray, v.xy, u.xy) - v.z, a - u.z) : curved_root(-q, v.z, -1.0);
    if (q != 0.0 && v.z / q > 0.0) found.end = min(found.end, v.z / q);
    if (found.inside) {
        float d = abs(a) > 1e-12 ? (-b + sqrt(discriminant)) / (2.0 * a) : b != 0.0 ? -c / b : 0.0;
        found.w = clamp(d / ray.unit, -1e6, 1e6) * vec3(u.xy, -u.z);
    }
    return found;
}

CurvedPlace curved_place_in(CurvedRay ray, CurvedCase found, float t) {
    vec2 across = ray.sight.xy;
    float into = -ray.sight.z;
    float bend = found.inside ? 0.0 : curved_bend(ray);
#if !CURVED_CONE
    across += found.w.xy; // Algorithm 5 widens the cone instead
    into += found.w.z;
#endif
    CurvedPlace place;
    place.along = ray.chart * across;
    place.uv = ray.origin + t * place.along;
    place.depth = t * (bend * t + into);
    place.sinks = 2.0 * bend * t + into;
    vec2 p = t * across;
    place.up = normalize(vec3(-2.0 * ray.quadric.xy * p, 1.0));
    return place;
}

CurvedPlace curved_place(CurvedRay ray, float t) { return curved_place_in(ray, curved_case(ray), t); }
