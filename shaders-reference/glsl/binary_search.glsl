// Relief mapping (Policarpo, Oliveira and Comba 2005): a linear search, then halving of its last step.
// Needs linear_bracket.glsl.

uniform int relief_binary_steps;

ReliefHit binary_search(ReliefRay ray) {
    LinearSearch search = linear_bracket(ray, relief_linear_steps);
    return binary_refine(ray, search.bracket, search.hit, relief_binary_steps);
}
