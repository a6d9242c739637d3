// Clay under a warm low sun and a blue sky. Needs relief_map.glsl.
// World: x along u, y up the image, z up; unit: one texture width; z = 0 is the polygon, z = -scene_depth_scale the floor.

uniform float scene_depth_scale; // depth of the relief, texture widths
uniform vec3 scene_sun;          // unit vector towards the light, z > 0
uniform int scene_shadow_steps;  // 0: no shadow ray

const vec3 SUN_COLOUR = vec3(2.75, 2.3, 1.75);
const vec3 SKY_COLOUR = vec3(0.34, 0.46, 0.68);
const vec3 BOUNCE_COLOUR = vec3(0.26, 0.18, 0.12);

// Share of the sun seen from the relief at uv, by marching up through the cones: a ray that rises out of an apex cone at
// gap g and moves `reach` per unit of ascent stays inside it for ratio g / (reach - ratio).
float sun_visibility(vec2 uv, float height) {
    const float start = 0.004;      // lifts the ray off its own patch
    const float sun_width = 0.035;  // softness of the edge: widths of penumbra per width of distance
    vec2 along = vec2(scene_sun.x, -scene_sun.y / relief_aspect) * (scene_depth_scale / scene_sun.z);
    float reach = relief_length(along);
    float rise = start;
    float seen = 1.0;
    for (int i = 0; i < scene_shadow_steps; ++i) {
        if (height + rise >= 1.0) break;
        vec4 texel = textureLod(relief_map, uv + rise * along, 0.0);
        float gap = height + rise - (1.0 - relief_depth(texel));
        seen = min(seen, 0.5 + gap / (2.0 * sun_width * rise * max(reach, 1e-3)));
        if (seen <= 0.0) return 0.0;
        float ratio = relief_ratio(texel);
        if (ratio >= reach) break;
        rise += max(ratio * max(gap, 0.0) / (reach - ratio), 0.003 + 0.02 * rise);
    }
    return smoothstep(0.0, 1.0, seen);
}

// The empty cone above a texel is sky for certain: an ambient term that costs nothing.
float sky_visibility(float ratio) {
    float tangent = ratio / scene_depth_scale;
    float sky = tangent / sqrt(1.0 + tangent * tangent);
    return mix(0.2, 1.0, sky);
}

vec3 clay(float height) {
    vec3 low = vec3(0.24, 0.12, 0.075);
    vec3 middle = vec3(0.52, 0.32, 0.20);
    vec3 high = vec3(0.72, 0.58, 0.44);
    return mix(mix(low, middle, smoothstep(0.0, 0.55, height)), high, smoothstep(0.4, 1.0, height));
}

// Linear colour of the relief at uv, seen along the unit vector `view` (away from the eye).
vec3 shade_relief(vec2 uv, vec3 view) {
    vec4 texel = textureLod(relief_map, uv, 0.0);
    float height = 1.0 - relief_depth(texel);
    vec3 normal = relief_normal(texel);
    float facing = dot(normal, scene_sun);
    float sun = max(facing, 0.0);
    if (facing > 0.0 && scene_shadow_steps > 0) sun *= sun_visibility(uv, height);

    vec3 ambient = mix(BOUNCE_COLOUR, SKY_COLOUR, 0.5 + 0.5 * normal.z) * sky_visibility(relief_ratio(texel));
    vec3 colour = clay(height) * (SUN_COLOUR * sun + ambient);
    vec3 half_way = normalize(scene_sun - view);
    colour += 0.16 * SUN_COLOUR * sun * pow(max(dot(normal, half_way), 0.0), 36.0);
    return colour;
}
