// A mesh with the attributes that curved relief needs: `reliefbake quadric` bakes them.

layout(location = 0) in vec3 in_position;
layout(location = 1) in vec3 in_normal;  // unit
layout(location = 2) in vec4 in_tangent; // unit, and the sign of the bitangent: sign cross(normal, tangent)
layout(location = 3) in vec2 in_uv;      // v down the map
layout(location = 4) in vec3 in_quadric; // a, b, c per length
layout(location = 5) in vec4 in_chart;   // du/dx, du/dy, dv/dx, dv/dy: x along the tangent, y along the bitangent, per length
layout(location = 6) in vec3 in_bend_u;  // u's second derivatives xx, xy, yy, per length^2
layout(location = 7) in vec3 in_bend_v;

out vec3 mesh_sight;  // from the eye
out vec3 mesh_normal;
out vec4 mesh_tangent;
out vec2 mesh_uv;
out vec3 mesh_quadric;
out vec4 mesh_chart;
out vec3 mesh_bend_u;
out vec3 mesh_bend_v;

void main() {
    mesh_sight = in_position - camera_eye;
    mesh_normal = in_normal;
    mesh_tangent = in_tangent;
    mesh_uv = in_uv;
    mesh_quadric = in_quadric;
    mesh_chart = in_chart;
    mesh_bend_u = in_bend_u;
    mesh_bend_v = in_bend_v;
    gl_Position = camera_projected(mesh_sight);
}
