// Even steps of depth until a sample lies under the relief. Misses what is thinner than a step. Needs relief_map.glsl.

uniform int relief_linear_steps;

ReliefHit linear_search(ReliefRay ray) {
    ReliefHit hit = ReliefHit(0.0, 0.0, 0, 0, RELIEF_HIT);
    for (int i = 0; i <= relief_linear_steps; ++i) {
        hit.t = float(i) / float(relief_linear_steps);
        hit.gap = relief_depth(textureLod(relief_map, ray.origin + hit.t * ray.direction, 0.0)) - hit.t;
        hit.steps += 1;
        hit.fetches += 1;
        if (hit.gap <= 0.0) break;
    }
    return hit;
}
