// Relaxed cone stepping, then secants of the last step (001 sec. 4.3.3, table 4.10). Needs relaxed_bracket.glsl.

uniform int relief_binary_steps; // secants

ReliefHit relaxed_secant(ReliefRay ray) {
    RelaxedSearch search = relaxed_bracket(ray);
    if (!search.found) return search.hit;
    return secant_refine(ray, search.bracket, search.hit, relief_binary_steps);
}
