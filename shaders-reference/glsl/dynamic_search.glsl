// Dynamic relief mapping: as binary_search, with as many even steps as the angle of view asks for. Seen from above a ray
// crosses little of the relief and a quarter of the steps will do; at a grazing view it takes all of them.
// (001 sec. 2.2 on Policarpo and Oliveira; the quarter is ours.) Needs linear_bracket.glsl.

uniform int relief_binary_steps;

ReliefHit dynamic_search(ReliefRay ray) {
    float share = mix(1.0, 0.25, relief_cosine(ray.direction));
    LinearSearch search = linear_bracket(ray, int(ceil(share * float(relief_linear_steps))));
    return binary_refine(ray, search.bracket, search.hit, relief_binary_steps);
}
