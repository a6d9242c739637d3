// How a march over a curved polygon ends. Needs curved_path.glsl and, after this text, the technique's curved_gap.

float curved_gap(CurvedRay ray, float t); // to what is drawn; <= 0 in it

// The last step was from `above`. A ray without steps left may stand in the relief, or outside; one that climbs above it is taken to have left, as most such
// rays do. Then halving of the last step.
CurvedHit curved_finish(CurvedRay ray, float above, CurvedHit hit, int halvings) {
    if (hit.status == CURVED_OUT_OF_STEPS) {
        CurvedPlace place = curved_place(ray, hit.t);
        hit.gap = curved_gap(ray, hit.t);
        hit.fetches += 1;
        if (hit.gap <= 0.0) hit.status = CURVED_HIT;
        else if (place.sinks < 0.0) hit.status = CURVED_LEFT;
        if (curved_is_out(ray, place)) hit.status = CURVED_LEFT;
    }
    if (hit.status != CURVED_HIT || hit.gap >= 0.0 || hit.t <= 0.0) return hit;
    float under = hit.t;
    for (int i = 0; i < halvings; ++i) {
        hit.t = 0.5 * (above + under);
        hit.gap = curved_gap(ray, hit.t);
        hit.steps += 1;
        hit.fetches += 1;
        if (hit.gap <= 0.0) under = hit.t;
        else above = hit.t;
    }
    return hit;
}
