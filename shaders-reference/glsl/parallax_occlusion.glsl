// Parallax occlusion mapping (Brawley and Tatarchuk 2004; Tatarchuk 2006): a linear search, then one secant, whose end is
// taken for the relief unseen. Needs linear_bracket.glsl.

ReliefHit parallax_occlusion(ReliefRay ray) {
    LinearSearch search = linear_bracket(ray, relief_linear_steps);
    ReliefBracket last = search.bracket;
    float span = last.gap_above - last.gap_under;
    if (span > 0.0) {
        search.hit.t = last.above + (last.under - last.above) * (last.gap_above / span);
        search.hit.gap = 0.0;
    }
    return search.hit;
}
