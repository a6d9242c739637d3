// Cone tracing over a curved polygon as 000 prints it (Algorithms 3 to 7), for comparison: the same count of steps for every ray, each
// from the way gone in total; discarded where t > tmax. Needs relief_map.glsl, relief_cones.glsl and curved_path_published.glsl.
//
//   CURVED_CONE    0 Algorithms 3, 4;  1 Algorithms 5, 6
//   CURVED_HALVES  1 for relaxed cones: Algorithm 7 halves the way from the entry
// One cone a texel alone.

uniform int relief_max_steps;
uniform int relief_binary_steps;
uniform float relief_epsilon; // what still counts as a hit at the end, to tell hits from rays without enough steps

CurvedHit curved_march_published(CurvedRay ray) {
    CurvedCase found = curved_case(ray);
    float into = max(-ray.sight.z, 1e-6);
    ReliefCourse course = relief_course(ray.chart * ray.sight.xy, into);
    CurvedHit hit = curved_start();
    for (int i = 0; i < relief_max_steps && hit.t <= found.end; ++i) {
        CurvedPlace place = curved_place_in(ray, found, hit.t);
        vec4 texel = textureLod(relief_map, place.uv, 0.0);
        float depth = relief_depth(texel);
        float ratio = relief_cones_at(texel, place.uv, course).low.x;
#if CURVED_CONE
        float deeper = depth + found.w.z * hit.t;
        ratio = deeper > 0.0 ? (ratio * depth + relief_length(ray.chart * found.w.xy) * hit.t) / deeper : ratio;
        depth = deeper;
#endif
        hit.gap = depth - place.depth;
        hit.steps += 1;
        hit.fetches += 1 + RELIEF_CONE_FETCHES;
        hit.t += ratio > 0.0 ? ratio * max(hit.gap, 0.0) / (course.reach + into * ratio) : 0.0;
    }
    if (hit.t > found.end || curved_is_out(ray, curved_place_in(ray, found, hit.t))) {
        hit.status = CURVED_LEFT;
        return hit;
    }
    hit.status = hit.gap <= 16.0 * relief_epsilon ? CURVED_HIT : CURVED_OUT_OF_STEPS;
#if CURVED_HALVES
    float half_way = 0.5 * hit.t;
    hit.t = half_way;
    for (int i = 0; i < relief_binary_steps; ++i) {
        CurvedPlace place = curved_place_in(ray, found, hit.t);
        half_way *= 0.5;
        hit.gap = relief_depth(textureLod(relief_map, place.uv, 0.0)) - place.depth;
        hit.steps += 1;
        hit.fetches += 1;
        hit.t += hit.gap > 0.0 ? half_way : -half_way;
    }
#endif
    return hit;
}
