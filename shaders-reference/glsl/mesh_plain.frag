// A mesh as it is, in clay; its front faces alone. Needs light.glsl.

in vec3 mesh_sight;
in vec3 mesh_normal;

layout(location = 0) out vec4 out_colour; // linear, tone-mapped
layout(location = 1) out vec4 out_place;  // distance from the eye

void main() {
    if (!gl_FrontFacing) discard;
    out_colour = vec4(lit_clay(normalize(mesh_normal)), 1.0);
    out_place = vec4(length(mesh_sight), 0.0, 0.0, 1.0);
}
