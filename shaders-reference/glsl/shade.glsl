// Clay under a warm low sun and a blue sky. Needs relief_map.glsl, relief_cones.glsl and light.glsl.
// World: x along u, y up the image, z up; unit: one texture width; z = 0 is the polygon, z = -relief_depth_scale the floor.
//
//   SCENE_SHADOW        0 none, 1 hard, 2 by height, 3 by cones (001 sec. 4.4), 4 by a horizon map (needs horizon.glsl)
//   SCENE_AMBIENT       0 none, 1 cone ratio, 2 cone normal (001 sec. 4.5)
//   RELIEF_EMPTY_CONES  1 when the cones hold nothing of the relief

uniform int scene_shadow_steps;

#if SCENE_SHADOW == 4
float sun_visibility(vec2 uv, float height) { return horizon_visibility(uv, scene_sun, 0.035); }
#else
// Share of the sun seen from the relief at uv, by marching up to the polygon: by leaps through empty cones where the map
// has such, else by even steps. By height: how narrowly the ray passes over the relief (Tatarchuk 2006). By cones: how
// small the ball around it that is known to be free (001 sec. 3.2; the penumbra of a distance field).
float sun_visibility(vec2 uv, float height) {
    const float start = 0.004;      // lifts the ray off its own patch
    const float sun_width = 0.035;  // softness of the edge: widths of penumbra per width of distance
    vec2 along = vec2(scene_sun.x, -scene_sun.y / relief_aspect) * (relief_depth_scale / scene_sun.z);
    ReliefCourse course = relief_course(along, -1.0);
    float length_per_rise = relief_depth_scale / scene_sun.z;
    float rise = start;
    float seen = 1.0;
    for (int i = 0; i < scene_shadow_steps; ++i) {
        if (height + rise >= 1.0) break;
        ReliefLook look = relief_look(uv + rise * along, 1.0 - (height + rise), course);
#if SCENE_SHADOW == 1
        if (look.gap < 0.0) return 0.0;
#elif SCENE_SHADOW == 2
        seen = min(seen, 0.5 + look.gap / (2.0 * sun_width * rise * max(course.reach, 1e-3)));
#else
        seen = min(seen, look.gap < 0.0 ? 0.0 : look.distance / (sun_width * rise * length_per_rise));
#endif
        if (seen <= 0.0) return 0.0;
#if RELIEF_EMPTY_CONES
        rise += max(look.advance, 0.003 + 0.02 * rise);
#else
        rise += (1.0 - height) / float(scene_shadow_steps);
#endif
    }
    return smoothstep(0.0, 1.0, seen);
}
#endif

// The empty cone above a point is sky for certain: an ambient term that costs nothing.
float open_sky(float ratio) {
#if SCENE_AMBIENT == 1
    return min(ratio, 1.0);
#else
    float tangent = ratio / relief_depth_scale;
    return tangent / sqrt(1.0 + tangent * tangent);
#endif
}

// Share of the sky seen; the mean of all sectors, of a stack's cones the one on the relief, and of pieces a whole cone in them.
float sky_visibility(vec4 texel, vec2 uv) {
    float sky = 1.0;
#if SCENE_AMBIENT > 0
#if RELIEF_SECTORS > 0
    sky = 0.0;
    for (int k = 0; k < 4; ++k) {
        sky += open_sky(relief_ratio(textureLod(relief_cones_0, uv, 0.0)[k], texel.a)) / float(RELIEF_SECTORS);
#if RELIEF_SECTORS == 8
        sky += open_sky(relief_ratio(textureLod(relief_cones_1, uv, 0.0)[k], texel.a)) / float(RELIEF_SECTORS);
#endif
    }
#else
    ReliefCones cones = relief_cones_at(texel, uv, relief_course(vec2(0.0, 0.0), 1.0));
    float ratio = cones.low.x;
#if RELIEF_PIECES
    ratio = relief_piece_ratio(cones, relief_depth(texel), relief_depth(texel));
#endif
    sky = open_sky(ratio);
#endif
#endif
    return mix(0.2, 1.0, sky);
}

vec3 clay(float height) {
    vec3 low = vec3(0.24, 0.12, 0.075);
    vec3 middle = vec3(0.52, 0.32, 0.20);
    vec3 high = vec3(0.72, 0.58, 0.44);
    return mix(mix(low, middle, smoothstep(0.0, 0.55, height)), high, smoothstep(0.4, 1.0, height));
}

// Linear colour of the relief at uv, seen along the unit vector `view` (away from the eye). `lit`: share of the sun seen.
vec3 shade_relief(vec2 uv, vec3 view, out float lit) {
    vec4 texel = textureLod(relief_map, uv, 0.0);
    float height = 1.0 - relief_depth(texel);
    vec3 normal = relief_normal(texel);
    float facing = dot(normal, scene_sun);
    float sun = max(facing, 0.0);
    lit = facing > 0.0 ? 1.0 : 0.0;
#if SCENE_SHADOW > 0
    if (facing > 0.0) lit = sun_visibility(uv, height);
#endif
    sun *= lit;

    vec3 ambient = ambient_light(normal) * sky_visibility(texel, uv);
    vec3 colour = clay(height) * (SUN_COLOUR * sun + ambient);
    vec3 half_way = normalize(scene_sun - view);
    colour += 0.16 * SUN_COLOUR * sun * pow(max(dot(normal, half_way), 0.0), 36.0);
    return colour;
}
