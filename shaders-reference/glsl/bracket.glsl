// A stretch of a ray with the relief's surface in it, and the two ways to narrow it down. Needs relief_map.glsl.

struct ReliefBracket {
    float above;     // depths: above the relief,
    float under;     // and under it
    float gap_above; // > 0
    float gap_under; // <= 0
};

float relief_gap(ReliefRay ray, float t) { return relief_depth(textureLod(relief_map, ray.origin + t * ray.direction, 0.0)) - t; }

// Halves the bracket `count` times; each costs a fetch and halves the error (Policarpo, Oliveira and Comba 2005; 001 sec. 2.3).
ReliefHit binary_refine(ReliefRay ray, ReliefBracket bracket, ReliefHit hit, int count) {
    for (int i = 0; i < count; ++i) {
        hit.t = 0.5 * (bracket.above + bracket.under);
        hit.gap = relief_gap(ray, hit.t);
        hit.steps += 1;
        hit.fetches += 1;
        if (hit.gap <= 0.0) bracket.under = hit.t;
        else bracket.above = hit.t;
    }
    return hit;
}

// Takes the relief for straight between both ends, `count` times (interval mapping, Risser et al. 2005; 001 sec. 2.3).
// Ends where the surface itself is, unlike halving, when a step brings nothing any more.
ReliefHit secant_refine(ReliefRay ray, ReliefBracket bracket, ReliefHit hit, int count) {
    for (int i = 0; i < count; ++i) {
        float span = bracket.gap_above - bracket.gap_under;
        if (span <= 0.0) break;
        hit.t = bracket.above + (bracket.under - bracket.above) * (bracket.gap_above / span);
        hit.gap = relief_gap(ray, hit.t);
        hit.steps += 1;
        hit.fetches += 1;
        if (hit.gap <= 0.0) {
            bracket.under = hit.t;
            bracket.gap_under = hit.gap;
        } else {
            bracket.above = hit.t;
            bracket.gap_above = hit.gap;
        }
    }
    return hit;
}
