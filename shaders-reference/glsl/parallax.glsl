// Parallax mapping (Kaneko et al. 2001; 001 formula 2.5): the relief is taken for flat, as deep as where the ray enters.
// Needs relief_map.glsl.

ReliefHit parallax(ReliefRay ray) {
    ReliefHit hit = relief_start();
    hit.t = relief_depth(textureLod(relief_map, ray.origin, 0.0));
    hit.steps = 1;
    hit.fetches = 1;
    hit.status = RELIEF_HIT;
    return hit;
}
