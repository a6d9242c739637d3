// Cone step mapping over a conservative map (Dummer 2006; 001 sec. 2.4): never passes a point of the relief. Over a hybrid
// map it ends at most delta below the first surface that it meets. Needs relief_map.glsl, relief_cones.glsl, patch_hit.glsl.
//
//     step = ratio * gap / (reach + ratio),   gap = height above the apex,  reach = widths per unit of descent
//
// RELIEF_EXACT_FINISH 1: a step that would end inside its cell is replaced by the exact patch test, then by a step to the
// cell's wall. Costs four more reads in such cells, needs no epsilon, and no ray creeps.
// A cone of width 0 (a code rounded down to 0) says nothing: there the same is done in either mode.

uniform int relief_max_steps;
uniform float relief_epsilon; // a ray this close above the relief has hit it (unused by the exact finish)

ReliefHit cone_march(ReliefRay ray) {
    vec2 size = vec2(textureSize(relief_map, 0));
    vec2 origin = ray.origin * size - 0.5;
    vec2 direction = ray.direction * size;
    ReliefCourse course = relief_course(ray.direction, 1.0);

    ReliefHit hit = relief_start();
    ivec2 cell = ivec2(0, 0);
    bool at_wall = false; // then `cell` is the one entered; a rounded position might name the one left
    for (int i = 0; i < relief_max_steps; ++i) {
        ReliefLook look = relief_look(ray.origin + hit.t * ray.direction, hit.t, course);
        hit.steps += 1;
        hit.fetches += look.fetches;
        hit.gap = look.gap;
#if RELIEF_EXACT_FINISH
        bool test_cell = true;
#else
        if (look.gap - relief_delta <= relief_epsilon) {
            hit.status = RELIEF_HIT;
            return hit;
        }
        bool test_cell = look.advance <= 0.0;
#endif
        if (test_cell) {
            if (!at_wall) cell = ivec2(floor(origin + hit.t * direction));
            ReliefWall wall = relief_wall(origin, direction, cell);
            if (hit.t + look.advance < wall.t) {
                float t = relief_patch_hit(origin, direction, cell, hit.t, wall.t);
                hit.fetches += 4;
                if (t >= 0.0) {
                    hit.t = t;
                    hit.gap = 0.0;
                    hit.status = RELIEF_HIT;
                    return hit;
                }
                hit.t = wall.t;
                cell = wall.next;
                at_wall = true;
                continue;
            }
        }
        hit.t += look.advance;
        at_wall = false;
    }
    return hit;
}
