// A mesh as it is, in clay; its front faces alone.

uniform vec3 scene_sun; // unit vector towards the light

in vec3 mesh_sight;
in vec3 mesh_normal;

layout(location = 0) out vec4 out_colour; // linear, tone-mapped
layout(location = 1) out vec4 out_place;  // distance from the eye

const vec3 SUN_COLOUR = vec3(2.75, 2.3, 1.75);
const vec3 SKY_COLOUR = vec3(0.34, 0.46, 0.68);
const vec3 BOUNCE_COLOUR = vec3(0.26, 0.18, 0.12);
const vec3 CLAY = vec3(0.62, 0.44, 0.31);

void main() {
    if (!gl_FrontFacing) discard;
    vec3 normal = normalize(mesh_normal);
    vec3 ambient = mix(BOUNCE_COLOUR, SKY_COLOUR, 0.5 + 0.5 * normal.z);
    vec3 x = 0.62 * CLAY * (SUN_COLOUR * max(dot(normal, scene_sun), 0.0) + ambient);
    out_colour = vec4(clamp(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0), 1.0); // as in solid_scene.frag
    out_place = vec4(length(mesh_sight), 0.0, 0.0, 1.0);
}
