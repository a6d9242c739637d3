// Extrusion over a curved polygon in all its kinds (004 Algorithms 3 to 9): circle tracing along the bent way, then halving of the last
// step. Needs shape_solid.glsl and curved_finish.glsl. Steps as in circle_trace.glsl, with the speeds of the way where it stands.

vec3 curved_solid_place(CurvedPlace place) { return vec3(place.uv, place.depth); }

float curved_gap(CurvedRay ray, float t) { // to the solid, or the floor
    CurvedPlace place = curved_place(ray, t);
    return min(shape_safe(shape_distance(solid_texel(curved_solid_place(place)))) - solid_widened(place.depth), 1.0 - place.depth);
}

CurvedHit curved_extrusion(CurvedRay ray) {
    float bend = max(curved_bend(ray), 0.0);
    float above = 0.0;
    CurvedHit hit = curved_start();
    for (int i = 0; i < solid_steps; ++i) {
        CurvedPlace place = curved_place(ray, hit.t);
        if (i > 0 && curved_is_out(ray, place)) {
            hit.status = CURVED_LEFT;
            return hit;
        }
        float distance = shape_safe(shape_distance(solid_texel(curved_solid_place(place))));
        hit.steps += 1;
        hit.fetches += 1;
        float gap = distance - solid_widened(place.depth);
        hit.gap = min(gap, 1.0 - place.depth);
        if (gap <= solid_epsilon || place.depth >= 1.0) {
            hit.status = CURVED_HIT;
            break;
        }
        float speed = length(vec2(place.along.x, shape_aspect * place.along.y));
        bool widening = place.depth < solid_chamfer;
        float sinks = max(place.sinks, 0.0);
        float step = solid_quotient(gap, widening ? speed + solid_bevel * sinks : speed);
        float beyond_foot = distance - solid_widened(solid_chamfer);
        if (widening && beyond_foot > 0.0) step = max(step, solid_quotient(beyond_foot, speed));
        step = curved_shortened(step, bend, place.sinks);
        if (place.sinks > 0.0) step = min(step, (1.0 - place.depth) / place.sinks + 1e-4); // the floor
        if (step > 1e20) {
            hit.status = CURVED_LEFT;
            return hit;
        }
        above = hit.t;
        hit.t += step;
    }
    return curved_finish(ray, above, hit, solid_binary_steps);
}
