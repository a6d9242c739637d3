// The step of 000's Algorithm 7, as printed, for comparison: the *whole* ray, its descent too, is scaled by
// |v.xy| / sqrt(vx^2 + R^2 vy^2). On a map that is not square it can overstep. One cone a texel alone.
// Needs relief_map.glsl.

uniform int relief_max_steps;
uniform float relief_epsilon;

ReliefHit cone_march_published(ReliefRay ray) {
    float round_length = length(vec2(ray.direction.x, relief_aspect * ray.direction.y));
    float scale = round_length > 0.0 ? length(ray.direction) / round_length : 1.0;
    float reach = scale * length(ray.direction);

    ReliefHit hit = relief_start();
    for (int i = 0; i < relief_max_steps; ++i) {
        vec4 texel = textureLod(relief_map, ray.origin + hit.t * ray.direction, 0.0);
        hit.steps += 1;
        hit.fetches += 1;
        hit.gap = relief_depth(texel) - hit.t;
        if (hit.gap <= relief_epsilon) {
            hit.status = RELIEF_HIT;
            return hit;
        }
        float ratio = relief_ratio(texel.b, texel.a);
        hit.t += scale * (ratio > 0.0 ? ratio * hit.gap / (reach + ratio) : 0.0);
    }
    return hit;
}
