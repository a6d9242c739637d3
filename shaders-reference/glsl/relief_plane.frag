// A tiled plane of relief under a perspective camera; the plane is the relief's top. RELIEF_TRACE names the technique.
// RELIEF_HOLES 1: rays fall through holes, and their pixels keep the background. (Not by discard: what became of the ray is kept.)

uniform vec3 camera_eye;
uniform vec3 camera_forward; // unit
uniform vec3 camera_right;   // half the picture's width at distance 1
uniform vec3 camera_up;      // half the picture's height at distance 1
uniform vec2 camera_range;   // near, far
uniform vec2 picture_size;   // pixels
uniform vec4 plane_bounds;   // u low, v low, u high, v high

layout(location = 0) out vec4 out_colour; // linear, tone-mapped; a: 1 on the relief
layout(location = 1) out vec4 out_hit;    // u, v (unwrapped, from the ray's own tile), h, gap
layout(location = 2) out vec4 out_counts; // steps, fetches, status, t
layout(location = 3) out vec4 out_ray;    // origin u, v and direction du, dv per unit of descent
layout(location = 4) out vec4 out_light;  // share of the sun seen, 0 where the relief faces away from it

vec3 background(float height) { return mix(vec3(0.06, 0.065, 0.075), vec3(0.035, 0.037, 0.042), clamp(height, 0.0, 1.0)); }

void main() {
    vec2 screen = 2.0 * gl_FragCoord.xy / picture_size - 1.0;
    vec3 view = camera_forward + screen.x * camera_right + screen.y * camera_up;
    out_colour = vec4(background(gl_FragCoord.y / picture_size.y), 0.0);
    out_hit = vec4(0.0);
    out_counts = vec4(0.0);
    out_ray = vec4(0.0);
    out_light = vec4(0.0);
    gl_FragDepth = 1.0;
    if (view.z >= 0.0) return;

    // Enter the relief at the polygon; count tiles apart, so that uv keeps its precision far away.
    vec3 entry = camera_eye - view * (camera_eye.z / view.z);
    vec2 uv = vec2(entry.x, -entry.y / relief_aspect);
    if (any(lessThan(uv, plane_bounds.xy)) || any(greaterThan(uv, plane_bounds.zw))) return;
    ReliefRay ray;
    ray.origin = uv - floor(uv) * vec2(relief_repeat);
    ray.direction = vec2(view.x, -view.y / relief_aspect) * (relief_depth_scale / -view.z);

    ReliefHit hit = RELIEF_TRACE(ray);
    bool through = hit.status == RELIEF_HOLE;
#if RELIEF_HOLES
    through = through || relief_falls_through(ray, hit); // out of steps above a hole, too
    if (through && hit.status == RELIEF_HIT) hit.status = RELIEF_HOLE;
#endif
    vec2 place = ray.origin + hit.t * ray.direction;
    out_hit = vec4(place, 1.0 - hit.t, hit.gap);
    out_counts = vec4(float(hit.steps), float(hit.fetches), float(hit.status), hit.t);
    out_ray = vec4(ray.origin, ray.direction);
    if (through) return;
    float lit = 0.0;
    out_colour = vec4(tone_map(shade_relief(place, normalize(view), lit)), 1.0);
    out_light.x = lit;

    vec3 point = entry + view * (hit.t * relief_depth_scale / -view.z);
    float distance_ahead = dot(point - camera_eye, camera_forward);
    gl_FragDepth = clamp(camera_range.y * (1.0 - camera_range.x / distance_ahead) / (camera_range.y - camera_range.x), 0.0, 1.0);
}
