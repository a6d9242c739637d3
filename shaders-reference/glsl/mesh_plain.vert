layout(location = 0) in vec3 in_position;
layout(location = 1) in vec3 in_normal;

uniform vec3 camera_eye;
uniform vec3 camera_forward; // unit
uniform vec3 camera_right;   // half the picture's width at distance 1
uniform vec3 camera_up;      // half the picture's height at distance 1
uniform vec2 camera_range;   // near, far

out vec3 mesh_sight;  // from the eye
out vec3 mesh_normal;

void main() {
    mesh_sight = in_position - camera_eye;
    mesh_normal = in_normal;
    float ahead = dot(mesh_sight, camera_forward);
    vec2 across = vec2(dot(mesh_sight, camera_right) / dot(camera_right, camera_right), dot(mesh_sight, camera_up) / dot(camera_up, camera_up));
    float depth = (ahead * (camera_range.y + camera_range.x) - 2.0 * camera_range.x * camera_range.y) / (camera_range.y - camera_range.x);
    gl_Position = vec4(across, depth, ahead);
}
