// Relaxed cone stepping, then halving of the last step. Needs relaxed_bracket.glsl.

uniform int relief_binary_steps;

ReliefHit relaxed_march(ReliefRay ray) {
    RelaxedSearch search = relaxed_bracket(ray);
    if (!search.found) return search.hit;
    return binary_refine(ray, search.bracket, search.hit, relief_binary_steps);
}
