// Extrusion over a curved polygon as 004 prints it (Algorithms 3 to 9), for comparison: steps by the whole filtered distance, halving that
// starts from the distance at the point inside, the chamfer searched for after it; discarded where t > tmax. Needs shape_solid.glsl and
// curved_path_published.glsl.

float curved_published_distance(CurvedPlace place) { return max(shape_distance(solid_texel(vec3(place.uv, place.depth))) - solid_outward, 0.0); }

vec3 curved_solid_place(CurvedPlace place) { return vec3(place.uv, place.depth); }

CurvedHit curved_extrusion_published(CurvedRay ray) {
    CurvedCase found = curved_case(ray);
    vec2 along = ray.chart * ray.sight.xy;
    float speed = max(length(vec2(along.x, shape_aspect * along.y)), 1e-6); // t of the paper is the way across the map
    CurvedHit hit = curved_start();
    CurvedPlace place = curved_place_in(ray, found, 0.0);
    float distance = 0.0;
    for (int i = 0; i < solid_steps && place.depth < 1.0 && hit.t <= found.end; ++i) {
        distance = curved_published_distance(place);
        hit.steps += 1;
        hit.fetches += 1;
        hit.gap = distance - solid_bevel * place.depth;
        if (hit.gap <= 0.0) break;
        hit.t += distance / speed;
        place = curved_place_in(ray, found, hit.t);
    }
    if (hit.t > found.end || curved_is_out(ray, place)) {
        hit.status = CURVED_LEFT;
        return hit;
    }
    hit.status = hit.gap <= 16.0 * solid_epsilon || place.depth >= 1.0 ? CURVED_HIT : CURVED_OUT_OF_STEPS;
    if (solid_bevel > 0.0) {
        float half_way = distance / speed;
        for (int i = 0; i < solid_binary_steps; ++i) {
            half_way *= 0.5;
            place = curved_place_in(ray, found, hit.t);
            hit.steps += 1;
            hit.fetches += 1;
            hit.t += curved_published_distance(place) - solid_bevel * place.depth > 0.0 ? half_way : -half_way;
        }
    }
    place = curved_place_in(ray, found, hit.t);
    if (place.depth > solid_chamfer) {
        for (int i = 0; i < solid_steps && place.depth < 1.0; ++i) {
            hit.steps += 1;
            hit.fetches += 1;
            hit.t += max(curved_published_distance(place) - solid_bevel * solid_chamfer, 0.0) / speed;
            place = curved_place_in(ray, found, hit.t);
        }
    }
    hit.t = max(hit.t, 0.0);
    return hit;
}
