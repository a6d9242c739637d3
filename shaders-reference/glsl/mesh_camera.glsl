// Where a vertex of a mesh lies in the picture.

uniform vec3 camera_eye;
uniform vec3 camera_forward; // unit
uniform vec3 camera_right;   // half the picture's width at distance 1
uniform vec3 camera_up;      // half the picture's height at distance 1
uniform vec2 camera_range;   // near, far

// `sight`: from the eye.
vec4 camera_projected(vec3 sight) {
    float ahead = dot(sight, camera_forward);
    vec2 across = vec2(dot(sight, camera_right) / dot(camera_right, camera_right), dot(sight, camera_up) / dot(camera_up, camera_up));
    float depth = (ahead * (camera_range.y + camera_range.x) - 2.0 * camera_range.x * camera_range.y) / (camera_range.y - camera_range.x);
    return vec4(across, depth, ahead);
}
