// Circle tracing as printed, for comparison: steps by the whole filtered distance until `gap` changes sign, then a search that
// halves the last distance (004 formulas 2-7, Algorithms 7 and 8; 003 formulas 8-10, 13). It can jump a bevelled wall, and the
// filtered distance can be longer than what is free. Needs shape_solid.glsl.

SolidHit circle_trace_published(SolidRay ray, float t_end) {
    float speed = max(solid_speed(ray.direction), 1e-6);
    SolidHit hit = solid_start();
    float distance = 0.0;
#if SOLID_REVOLUTION
    float foot = solid_chamfer; // 003 (13) has the chamfer in the test,
#else
    float foot = 1e30;          // 004 bevels first and searches on below c
#endif
    for (int i = 0; i < solid_steps && hit.t < t_end; ++i) {
        vec3 place = solid_place(ray.origin + hit.t * ray.direction);
        distance = max(shape_distance(solid_texel(place)) - solid_outward, 0.0);
        hit.steps += 1;
        hit.fetches += 1;
        hit.gap = distance - solid_bevel * min(place.z, foot);
        if (hit.gap <= 0.0) break;
        hit.t += distance / speed;
    }
    if (solid_bevel > 0.0) {
        float half_way = distance / speed;
        for (int i = 0; i < solid_binary_steps; ++i) {
            half_way *= 0.5;
            vec3 place = solid_place(ray.origin + hit.t * ray.direction);
            hit.steps += 1;
            hit.fetches += 1;
            hit.gap = max(shape_distance(solid_texel(place)) - solid_outward, 0.0) - solid_bevel * min(place.z, foot);
            hit.t += hit.gap > 0.0 ? half_way : -half_way;
        }
    }
#if SOLID_REVOLUTION == 0
    if (solid_place(ray.origin + hit.t * ray.direction).z > solid_chamfer) {
        for (int i = 0; i < solid_steps && hit.t < t_end; ++i) {
            vec3 place = solid_place(ray.origin + hit.t * ray.direction);
            hit.steps += 1;
            hit.fetches += 1;
            hit.gap = max(shape_distance(solid_texel(place)) - solid_outward - solid_bevel * solid_chamfer, 0.0);
            hit.t += hit.gap / speed;
        }
    }
#endif
    if (hit.t >= t_end) {
        hit.t = t_end;
        hit.status = SOLID_PASSED;
        return hit;
    }
    hit.t = max(hit.t, 0.0);
    if (hit.gap <= 16.0 * solid_epsilon) hit.status = SOLID_HIT;
    return hit;
}
