// Relief mapping (Policarpo, Oliveira and Comba 2005): a linear search, then halving of its last step.
// Needs relief_map.glsl and linear_search.glsl.

uniform int relief_binary_steps;

ReliefHit binary_search(ReliefRay ray) {
    ReliefHit hit = linear_search(ray);
    float under = hit.t;
    float above = max(hit.t - 1.0 / float(relief_linear_steps), 0.0);
    for (int i = 0; i < relief_binary_steps; ++i) {
        hit.t = 0.5 * (above + under);
        hit.gap = relief_depth(textureLod(relief_map, ray.origin + hit.t * ray.direction, 0.0)) - hit.t;
        hit.steps += 1;
        hit.fetches += 1;
        if (hit.gap <= 0.0) under = hit.t;
        else above = hit.t;
    }
    return hit;
}
