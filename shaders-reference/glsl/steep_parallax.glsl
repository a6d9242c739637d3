// Steep parallax mapping (McGuire and McGuire 2005): a linear search of n steps seen from above, 2 n at a grazing view.
// Its mip levels of the height are left out: no map here has any. Needs linear_bracket.glsl.

ReliefHit steep_parallax(ReliefRay ray) {
    float count = mix(2.0, 1.0, relief_cosine(ray.direction)) * float(relief_linear_steps);
    return linear_bracket(ray, int(ceil(count))).hit;
}
