// Interval mapping (Risser, Shah and Pattanaik 2005; 001 algorithm 3): a linear search, then secants of its last step.
// Needs linear_bracket.glsl.

uniform int relief_binary_steps; // secants

ReliefHit interval_mapping(ReliefRay ray) {
    LinearSearch search = linear_bracket(ray, relief_linear_steps);
    return secant_refine(ray, search.bracket, search.hit, relief_binary_steps);
}
