// Circle tracing: steps by the distance that is free, then halving of the last one. Needs shape_solid.glsl.
//
// The distance falls by `speed` at most, and min(z, c) grows by dz above c, not at all below it (MATHS section 6; the printed step
// D / speed jumps bevelled walls):
//
//     z < c:   step = max( gap / (speed + b dz), (D - e - b c) / speed )
//     z >= c:  step = gap / speed
//
// with the distance that guarantee S leaves: no step enters the solid. A denominator <= 0: the ray flees and never arrives.

SolidHit circle_trace(SolidRay ray, float t_end) {
    float speed = solid_speed(ray.direction);
    SolidHit hit = solid_start();
    float before = 0.0;
    for (int i = 0; i < solid_steps; ++i) {
        vec3 place = solid_place(ray.origin + hit.t * ray.direction);
        float distance = shape_safe(shape_distance(solid_texel(place)));
        hit.steps += 1;
        hit.fetches += 1;
        hit.gap = distance - solid_widened(place.z);
        if (hit.gap <= solid_epsilon) {
            hit.status = SOLID_HIT;
            break;
        }
        bool widening = place.z < solid_chamfer;
        float step = solid_quotient(hit.gap, widening ? speed + solid_bevel * ray.direction.z : speed);
        float beyond_foot = distance - solid_widened(solid_chamfer);
        if (widening && beyond_foot > 0.0) step = max(step, solid_quotient(beyond_foot, speed));
        before = hit.t;
        hit.t += step;
        if (hit.t >= t_end) {
            hit.t = t_end;
            hit.status = SOLID_PASSED;
            return hit;
        }
    }
    // The filtered distance may fall a little faster than the way gone: then the last step ended inside what the map takes for solid.
    if (hit.status != SOLID_HIT || hit.gap >= 0.0) return hit;
    float inside = hit.t;
    for (int i = 0; i < solid_binary_steps; ++i) {
        float middle = 0.5 * (before + inside);
        vec3 place = solid_place(ray.origin + middle * ray.direction);
        hit.steps += 1;
        hit.fetches += 1;
        hit.gap = shape_safe(shape_distance(solid_texel(place))) - solid_widened(place.z);
        if (hit.gap <= 0.0) inside = middle;
        else before = middle;
    }
    hit.t = inside;
    return hit;
}
