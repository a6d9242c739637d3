// A plane that an extruded shape stands in, or a shape box that holds an extruded or revolved one, under a perspective camera.
// World: extrusion (u, -aspect v, -depth z); revolution (X, Y, -aspect v); z up. SOLID_TRACE names the way rays are followed.
//
//   SOLID_PLANE   1: the floor at z = 1 is drawn, and rays enter through the polygon alone
//   SOLID_SHADOW  1: hard shadows

uniform vec3 camera_eye;
uniform vec3 camera_forward; // unit
uniform vec3 camera_right;   // half the picture's width at distance 1
uniform vec3 camera_up;      // half the picture's height at distance 1
uniform vec2 camera_range;   // near, far
uniform vec2 picture_size;   // pixels
uniform vec4 plane_bounds;   // u low, v low, u high, v high
uniform vec2 solid_repeat;   // per axis: 1 when the plane goes on beyond the map

layout(location = 0) out vec4 out_colour;    // linear, tone-mapped; a: 1 on the solid
layout(location = 1) out vec4 out_origin;    // P at entry, t at exit
layout(location = 2) out vec4 out_counts;    // steps, fetches, status, t
layout(location = 3) out vec4 out_direction; // dP per unit of t, gap
layout(location = 4) out vec4 out_normal;    // in the world, not bumped; a: 1 on the face where the ray entered, 2 on the floor
layout(location = 5) out vec4 out_bumped;    // the normal that is shaded

const vec3 FLOOR = vec3(0.20, 0.21, 0.24);

vec3 background(float height) { return mix(vec3(0.06, 0.065, 0.075), vec3(0.035, 0.037, 0.042), clamp(height, 0.0, 1.0)); }

#if SOLID_REVOLUTION
vec3 to_solid(vec3 world) { return vec3(world.xy, -world.z / shape_aspect); }
vec3 to_world(vec3 p) { return vec3(p.xy, -shape_aspect * p.z); }
#else
vec3 to_solid(vec3 world) { return vec3(world.x, -world.y / shape_aspect, -world.z / solid_depth); }
#endif

// Where a ray is in [low, high] on one axis: x from, y to. Never, where it is empty.
vec2 slab(float origin, float direction, float low, float high) {
    if (direction == 0.0) return origin >= low && origin <= high ? vec2(-1e30, 1e30) : vec2(1e30, -1e30);
    float a = (low - origin) / direction;
    float b = (high - origin) / direction;
    return vec2(min(a, b), max(a, b));
}

// The stretch of a ray within the domain, t from x to y, and the outward normal of the face it enters through.
vec2 solid_domain(SolidRay ray, out vec3 face) {
    vec2 depth = slab(ray.origin.z, ray.direction.z, 0.0, SOLID_REVOLUTION == 1 ? solid_tiles : 1.0);
    face = vec3(0.0, 0.0, ray.direction.z > 0.0 ? 1.0 : -1.0);
#if SOLID_REVOLUTION
    // |o + t d|^2 = radius^2 in the plane
    float radius = 1.0 - solid_axis;
    float a = dot(ray.direction.xy, ray.direction.xy);
    float b = dot(ray.origin.xy, ray.direction.xy);
    float c = dot(ray.origin.xy, ray.origin.xy) - radius * radius;
    float discriminant = b * b - a * c;
    vec2 round = discriminant > 0.0 ? vec2(-b - sqrt(discriminant), -b + sqrt(discriminant)) / max(a, 1e-30) : vec2(1e30, -1e30);
    if (a < 1e-12) round = c <= 0.0 ? vec2(-1e30, 1e30) : vec2(1e30, -1e30);
    vec2 inside = vec2(max(depth.x, round.x), min(depth.y, round.y));
    if (round.x > depth.x) face = vec3(normalize(ray.origin.xy + round.x * ray.direction.xy), 0.0);
    return inside;
#else
    vec2 along_u = slab(ray.origin.x, ray.direction.x, 0.0, solid_tiles);
    vec2 along_v = slab(ray.origin.y, ray.direction.y, 0.0, solid_tiles);
#if SOLID_PLANE
    if (solid_repeat.x > 0.0) along_u = vec2(-1e30, 1e30);
    if (solid_repeat.y > 0.0) along_v = vec2(-1e30, 1e30);
#endif
    vec2 inside = vec2(max(depth.x, max(along_u.x, along_v.x)), min(depth.y, min(along_u.y, along_v.y)));
    if (along_u.x > depth.x && along_u.x >= along_v.x) face = vec3(ray.direction.x > 0.0 ? -1.0 : 1.0, 0.0, 0.0);
    else if (along_v.x > depth.x) face = vec3(0.0, ray.direction.y > 0.0 ? 1.0 : -1.0, 0.0);
    return inside;
#endif
}

bool in_shadow(vec3 p, vec3 normal) {
#if SOLID_SHADOW
    float texel = 1.0 / float(textureSize(shape_map, 0).x);
    SolidRay ray;
    ray.origin = p;
    ray.direction = to_solid(normalize(scene_sun + 1e-5));
    vec3 face;
    float t_end = solid_domain(ray, face).y;
    // Off its own wall first: the map knows walls to a texel.
    float lift = 3.0 * texel;
    ray.origin = p + lift * (to_solid(normal) + ray.direction);
    return t_end > lift && circle_trace(ray, t_end - lift).status == SOLID_HIT;
#else
    return false;
#endif
}

vec3 shaded(vec3 p, vec3 base, vec3 normal, vec3 smooth_normal, vec3 view) {
    float sun = max(dot(normal, scene_sun), 0.0);
    if (sun > 0.0 && dot(smooth_normal, scene_sun) > 0.0 && in_shadow(p, smooth_normal)) sun = 0.0;
    // The sky above, light thrown back from below, and a weak lamp beside the eye, so that walls in the shade keep their form.
    vec3 ambient = ambient_light(normal);
    float lamp = 0.35 * pow(max(dot(normal, normalize(vec3(-view.y, view.x, 0.4) - 1.2 * view)), 0.0), 1.5);
    vec3 colour = base * (SUN_COLOUR * sun + ambient + lamp);
    vec3 half_way = normalize(scene_sun - view);
    return colour + 0.10 * SUN_COLOUR * sun * pow(max(dot(normal, half_way), 0.0), 36.0);
}

void main() {
    vec2 screen = 2.0 * gl_FragCoord.xy / picture_size - 1.0;
    vec3 view = normalize(camera_forward + screen.x * camera_right + screen.y * camera_up);
    out_colour = vec4(background(gl_FragCoord.y / picture_size.y), 0.0);
    out_origin = vec4(0.0);
    out_counts = vec4(0.0);
    out_direction = vec4(0.0);
    out_normal = vec4(0.0);
    out_bumped = vec4(0.0);
    gl_FragDepth = 1.0;

    // Enter the domain.
    SolidRay ray;
    ray.origin = to_solid(camera_eye);
    ray.direction = to_solid(view);
    vec3 face;
#if SOLID_PLANE
    if (ray.direction.z <= 0.0) return;
    float t_enter = -ray.origin.z / ray.direction.z;
    vec2 polygon = ray.origin.xy + t_enter * ray.direction.xy;
    if (any(lessThan(polygon, plane_bounds.xy)) || any(greaterThan(polygon, plane_bounds.zw))) return;
    ray.origin = vec3(polygon - floor(polygon) * solid_repeat, 0.0);
    float t_end = solid_domain(ray, face).y;
    face = vec3(0.0, 0.0, 1.0);
#else
    vec2 inside = solid_domain(ray, face);
    float t_enter = max(inside.x, 0.0);
    if (inside.y <= t_enter) return;
    ray.origin += t_enter * ray.direction;
#if SOLID_REVOLUTION
    ray.origin.z = clamp(ray.origin.z, 0.0, solid_tiles);
#else
    ray.origin = clamp(ray.origin, vec3(0.0), vec3(solid_tiles, solid_tiles, 1.0));
#endif
    float t_end = inside.y - t_enter;
#endif

    SolidHit hit = SOLID_TRACE(ray, t_end);
    vec3 p = ray.origin + hit.t * ray.direction;
    out_origin = vec4(ray.origin, t_end);
    out_counts = vec4(float(hit.steps), float(hit.fetches), float(hit.status), hit.t);
    out_direction = vec4(ray.direction, hit.gap);

    vec3 normal = face;
    vec3 base = CLAY;
    bool on_floor = false;
    if (hit.status == SOLID_PASSED) {
#if SOLID_PLANE
        on_floor = p.z > 0.999;
#endif
        if (!on_floor) return; // the silhouette: nothing is drawn
        normal = vec3(0.0, 0.0, 1.0);
        base = FLOOR;
    } else if (hit.t > 0.0) {
        normal = solid_normal(p, view);
    }
    out_normal = vec4(normal, on_floor ? 2.0 : hit.t > 0.0 ? 0.0 : 1.0);
    vec3 bumped = normal;
    if (!on_floor) {
        bumped = solid_bumped(p, normal);
#if SOLID_COLOUR
        base = textureLod(solid_colour, solid_texture_place(p), 0.0).rgb;
#endif
    }
    out_bumped = vec4(bumped, 0.0);
    out_colour = vec4(tone_map(shaded(p, base, bumped, normal, view)), 1.0);
    float distance_ahead = dot((t_enter + hit.t) * view, camera_forward);
    gl_FragDepth = clamp(camera_range.y * (1.0 - camera_range.x / distance_ahead) / (camera_range.y - camera_range.x), 0.0, 1.0);
}
