// Parallax mapping with offset limiting (Welsh 2004; 001 formula 2.6): the offset is not divided by the cosine of the view,
// so that it never exceeds the depth and fades at grazing views. Needs relief_map.glsl and parallax.glsl.

ReliefHit parallax_limited(ReliefRay ray) {
    ReliefHit hit = parallax(ray);
    hit.t *= relief_cosine(ray.direction);
    return hit;
}
