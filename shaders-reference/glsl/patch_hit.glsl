// The exact test of a ray against one bilinear patch, from unfiltered texels. Needs relief_map.glsl.

float relief_texel_depth(ivec2 texel) { return relief_depth(texelFetch(relief_map, relief_address(texel), 0)); }

// Where the ray leaves a cell, and the cell it enters there. Positions in texels: cell c is [c, c + 1].
struct ReliefWall {
    float t;
    ivec2 next;
};

ReliefWall relief_wall(vec2 origin, vec2 direction, ivec2 cell) {
    vec2 far = vec2(1e30, 1e30);
    if (direction.x != 0.0) far.x = (float(cell.x) + (direction.x > 0.0 ? 1.0 : 0.0) - origin.x) / direction.x;
    if (direction.y != 0.0) far.y = (float(cell.y) + (direction.y > 0.0 ? 1.0 : 0.0) - origin.y) / direction.y;
    ivec2 over = far.x <= far.y ? ivec2(direction.x > 0.0 ? 1 : -1, 0) : ivec2(0, direction.y > 0.0 ? 1 : -1);
    ReliefWall wall;
    wall.t = min(far.x, far.y);
    wall.next = cell + over;
    return wall;
}

// First t in [t_in, t_out] with the ray on or under the patch of `cell`; -1 when there is none.
// The gap c + b s + a s^2, s = t - t_in, is solved without cancellation: q = -(b + sign(b) root) / 2, roots c/q, q/a.
float relief_patch_hit(vec2 origin, vec2 direction, ivec2 cell, float t_in, float t_out) {
    float d00 = relief_texel_depth(cell);
    float d10 = relief_texel_depth(cell + ivec2(1, 0));
    float d01 = relief_texel_depth(cell + ivec2(0, 1));
    float d11 = relief_texel_depth(cell + ivec2(1, 1));
    float twist = (d00 - d10) + (d11 - d01);
    vec2 p = origin - vec2(cell) + t_in * direction;
    vec2 gradient = vec2(d10 - d00 + twist * p.y, d01 - d00 + twist * p.x);

    float c = d00 + (d10 - d00) * p.x + (d01 - d00) * p.y + twist * p.x * p.y - t_in;
    float b = dot(gradient, direction) - 1.0;
    float a = twist * direction.x * direction.y;
    float span = t_out - t_in;
    if (c <= 0.0) return t_in;
    float discriminant = b * b - 4.0 * a * c;
    if (discriminant >= 0.0) {
        float root = sqrt(discriminant);
        float s = b < 0.0 ? 2.0 * c / (root - b) : a < 0.0 ? -0.5 * (b + root) / a : 1e30;
        if (s <= span) return t_in + s;
    }
    return c + (b + a * span) * span <= 0.0 ? t_out : -1.0;
}
