// Relaxed cone stepping (Policarpo and Oliveira 2007, GPU Gems 3, chapter 18; 001 sec. 2.4): steps until one ends under the
// relief. A strictly relaxed cone lets a ray pierce the relief once, so that the last step holds the first hit alone
// (guarantee R). Over a conservative map it creeps up to the relief. Needs relief_cones.glsl, patch_hit.glsl, bracket.glsl.
//
// GPU Gems 3 narrows down all of the ray from its entry; the last step is shorter, and as right.

uniform int relief_max_steps;
uniform float relief_epsilon; // a ray this close above the relief has hit it

struct RelaxedSearch {
    ReliefHit hit;
    ReliefBracket bracket;
    bool found; // `bracket` holds the surface; else `hit` is the end
};

RelaxedSearch relaxed_bracket(ReliefRay ray) {
    vec2 size = vec2(textureSize(relief_map, 0));
    vec2 origin = ray.origin * size - 0.5;
    vec2 direction = ray.direction * size;
    ReliefCourse course = relief_course(ray.direction, 1.0);

    RelaxedSearch search;
    search.hit = relief_start();
    search.found = false;
    search.bracket.above = 0.0;
    search.bracket.under = 0.0;
    search.bracket.gap_above = 0.0;
    search.bracket.gap_under = 0.0;
    for (int i = 0; i < relief_max_steps; ++i) {
        ReliefLook look = relief_look(ray.origin + search.hit.t * ray.direction, search.hit.t, course);
        search.hit.steps += 1;
        search.hit.fetches += look.fetches;
        search.hit.gap = look.gap;
        if (look.gap - relief_delta <= relief_epsilon) {
            search.hit.status = RELIEF_HIT;
            search.found = look.gap <= 0.0 && search.hit.t > 0.0;
            search.bracket.under = search.hit.t;
            search.bracket.gap_under = look.gap;
            return search;
        }
        search.bracket.above = search.hit.t;
        search.bracket.gap_above = look.gap;
        if (look.advance > 0.0) {
            search.hit.t += look.advance;
            continue;
        }
        // A cone of width 0 says nothing: solve the cell, or go to its wall and a little beyond.
        ivec2 cell = ivec2(floor(origin + search.hit.t * direction));
        ReliefWall wall = relief_wall(origin, direction, cell);
        float t = relief_patch_hit(origin, direction, cell, search.hit.t, wall.t);
        search.hit.fetches += 4;
        if (t >= 0.0) {
            search.hit.t = t;
            search.hit.gap = 0.0;
            search.hit.status = RELIEF_HIT;
            return search;
        }
        search.hit.t = wall.t + 1e-4 / (abs(direction.x) + abs(direction.y));
    }
    // Out of steps: the last one may have ended under the relief, and then holds the hit.
    search.bracket.under = search.hit.t;
    search.bracket.gap_under = relief_gap(ray, search.hit.t);
    search.hit.fetches += 1;
    search.hit.gap = search.bracket.gap_under;
    search.found = search.hit.gap <= 0.0 && search.hit.t > 0.0;
    if (search.found) search.hit.status = RELIEF_HIT;
    return search;
}
