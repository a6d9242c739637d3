layout(location = 0) in vec3 in_position;
layout(location = 1) in vec3 in_normal;

out vec3 mesh_sight;  // from the eye
out vec3 mesh_normal;

void main() {
    mesh_sight = in_position - camera_eye;
    mesh_normal = in_normal;
    gl_Position = camera_projected(mesh_sight);
}
