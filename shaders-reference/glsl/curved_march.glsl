// Cone tracing over a curved polygon (000 Algorithm 7), conservative and relaxed, then halving of the last step. Needs relief_map.glsl,
// relief_cones.glsl and curved_finish.glsl.
//
//   CURVED_CONE 0  the ray is rectified (Algorithms 3, 4): a cone is met where the bent way, straight on from here, leaves it
//               1  the cone is (5, 6): its apex sinks with the surface, D' = D - (a Vx^2 + b Vy^2) t^2, below a ray that stays straight
//
// Over a surface that bulges the way bends out of the relief, so both steps end before the cone does; the second is the shorter.
// Where it is hollow the way bends in by `bend` s^2; with s + bend s^2 / sinks in place of s no step leaves its cone:
//
//     s' = 2 s / (1 + sqrt(1 + 4 s bend / sinks))

uniform int relief_max_steps;
uniform int relief_binary_steps;
uniform float relief_epsilon; // a ray this close above the relief has hit it

float curved_gap(CurvedRay ray, float t) {
    CurvedPlace place = curved_place(ray, t);
    return relief_depth(textureLod(relief_map, place.uv, 0.0)) - place.depth;
}

CurvedHit curved_march(CurvedRay ray) {
    float bend = max(curved_bend(ray), 0.0);
    float texels = length(ray.chart * ray.sight.xy * vec2(textureSize(relief_map, 0)));
    float least = 0.03125 / max(texels, 1e-3); // no step is shorter than a thirty-second of a texel: rays near the relief or in cones of width 0 do not creep
    float above = 0.0;
    CurvedHit hit = curved_start();
    for (int i = 0; i < relief_max_steps; ++i) {
        CurvedPlace place = curved_place(ray, hit.t);
        if (i > 0 && curved_is_out(ray, place)) {
            hit.status = CURVED_LEFT;
            return hit;
        }
        ReliefCourse course = relief_course(place.along, 1.0);
#if CURVED_CONE
        course.falls = -ray.sight.z;
#else
        course.falls = place.sinks;
#endif
        ReliefLook look = relief_look(place.uv, place.depth, course);
        hit.steps += 1;
        hit.fetches += look.fetches;
        hit.gap = look.gap;
        if (look.gap - relief_delta <= relief_epsilon) {
            hit.status = CURVED_HIT;
            break;
        }
        if (look.advance > 1e20) { // climbs out of a cone without end
            hit.status = CURVED_LEFT;
            return hit;
        }
        float step = curved_shortened(look.advance, bend, place.sinks);
        above = hit.t;
        hit.t += max(step, least);
    }
    return curved_finish(ray, above, hit, relief_binary_steps);
}

uniform int relief_linear_steps;

// Relief mapping over a curved polygon (Oliveira and Policarpo 2005): even steps up to where the ray leaves or is at the floor, then halving.
CurvedHit curved_search(CurvedRay ray) {
    float end = curved_end(ray);
    float above = 0.0;
    CurvedHit hit = curved_start();
    if (end >= 1e30) {
        hit.status = CURVED_LEFT;
        return hit;
    }
    for (int i = 0; i <= relief_linear_steps; ++i) {
        hit.t = end * (float(i) / float(relief_linear_steps));
        hit.gap = curved_gap(ray, hit.t);
        hit.steps += 1;
        hit.fetches += 1;
        if (hit.gap <= 0.0) {
            hit.status = CURVED_HIT;
            break;
        }
        above = hit.t;
    }
    // At the floor rounding may leave a last gap.
    CurvedPlace last = curved_place(ray, hit.t);
    if (hit.status != CURVED_HIT && last.depth > 0.5) hit.status = CURVED_HIT;
    if (hit.status != CURVED_HIT || (hit.t > 0.0 && curved_is_out(ray, last))) hit.status = CURVED_LEFT;
    return curved_finish(ray, above, hit, relief_binary_steps);
}
