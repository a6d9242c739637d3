// Even steps of depth until a sample lies under the relief. Misses what is thinner than a step. Needs bracket.glsl.

uniform int relief_linear_steps;

struct LinearSearch {
    ReliefHit hit;
    ReliefBracket bracket; // the last step
};

LinearSearch linear_bracket(ReliefRay ray, int count) {
    LinearSearch search;
    search.hit = relief_start();
    search.hit.status = RELIEF_HIT;
    search.bracket.above = 0.0;
    search.bracket.gap_above = 0.0;
    for (int i = 0; i <= count; ++i) {
        search.hit.t = float(i) / float(count);
        search.hit.gap = relief_gap(ray, search.hit.t);
        search.hit.steps += 1;
        search.hit.fetches += 1;
        if (search.hit.gap <= 0.0) break;
        search.bracket.above = search.hit.t;
        search.bracket.gap_above = search.hit.gap;
    }
    search.bracket.under = search.hit.t;
    search.bracket.gap_under = search.hit.gap;
    return search;
}
