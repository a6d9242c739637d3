// Clay in a warm low sun under a blue sky, and the curve that pictures are made with: shared by all scenes.

uniform vec3 scene_sun; // unit vector towards the light

const vec3 SUN_COLOUR = vec3(2.75, 2.3, 1.75);
const vec3 SKY_COLOUR = vec3(0.34, 0.46, 0.68);
const vec3 BOUNCE_COLOUR = vec3(0.26, 0.18, 0.12);
const vec3 CLAY = vec3(0.62, 0.44, 0.31);

// Filmic curve with a toe, so that shadows stay dark (Narkowicz 2016, fit to ACES).
vec3 tone_map(vec3 colour) {
    vec3 x = 0.62 * colour;
    return clamp(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0);
}

vec3 ambient_light(vec3 normal) { return mix(BOUNCE_COLOUR, SKY_COLOUR, 0.5 + 0.5 * normal.z); }

// Matt clay without shadows, tone-mapped.
vec3 lit_clay(vec3 normal) { return tone_map(CLAY * (SUN_COLOUR * max(dot(normal, scene_sun), 0.0) + ambient_light(normal))); }
