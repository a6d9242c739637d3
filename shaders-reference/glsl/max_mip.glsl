// Maximum mipmaps (Tevs, Ihrke and Seidel 2008): a pyramid of the highest point of each block of cells; a ray leaps over
// every block that it stays above, goes down the pyramid where it may not, and solves the bilinear patch at the bottom.
// Exact, and needs no baked cone. Needs relief_map.glsl and patch_hit.glsl.
//
// Texel of level 0 = least depth of a cell's four texels. A repeated axis has `width` cells, cell i between texels i and
// i + 1; a clamped one has two more half cells, which reach to infinity: cell i lies at i + 1. Padded to powers of two.

uniform sampler2D relief_max_mip;
uniform ivec2 relief_mip_cells; // of one tile
uniform int relief_mip_top;     // level of one texel
uniform int relief_max_steps;

ReliefHit max_mip(ReliefRay ray) {
    vec2 size = vec2(textureSize(relief_map, 0));
    vec2 origin = ray.origin * size - 0.5;
    vec2 direction = ray.direction * size;

    ReliefHit hit = relief_start();
    ivec2 cell = ivec2(floor(origin));
    int level = relief_mip_top;
    for (int i = 0; i < relief_max_steps; ++i) {
        hit.steps += 1;
        hit.fetches += 1;

        // The block of this level that holds the cell: [low, high), in cells of the tile that starts at `tile`.
        ivec2 tile = ivec2(floor(vec2(cell) / vec2(relief_mip_cells))) * relief_mip_cells;
        tile = ivec2(relief_repeat.x == 1 ? tile.x : -1, relief_repeat.y == 1 ? tile.y : -1);
        ivec2 local = clamp(cell - tile, ivec2(0), relief_mip_cells - 1);
        ivec2 block = local >> level;
        ivec2 low = block << level;
        ivec2 high = min(low + (1 << level), relief_mip_cells);
        float highest = texelFetch(relief_max_mip, block, level).r;

        // Where the ray leaves it; clamped borders have no wall.
        vec2 far = vec2(1e30);
        bool open_x = relief_repeat.x == 0 && (direction.x > 0.0 ? high.x == relief_mip_cells.x : low.x == 0);
        bool open_y = relief_repeat.y == 0 && (direction.y > 0.0 ? high.y == relief_mip_cells.y : low.y == 0);
        if (direction.x != 0.0 && !open_x) far.x = (float(tile.x + (direction.x > 0.0 ? high.x : low.x)) - origin.x) / direction.x;
        if (direction.y != 0.0 && !open_y) far.y = (float(tile.y + (direction.y > 0.0 ? high.y : low.y)) - origin.y) / direction.y;
        float leave = min(far.x, far.y);

        if (leave >= highest) {
            // It may meet the block: not before it is as deep as its highest point.
            if (level > 0) {
                hit.t = max(hit.t, highest);
                ivec2 inside = ivec2(floor(origin + hit.t * direction)) - tile;
                cell = tile + clamp(inside, low, high - 1);
                level -= 1;
                continue;
            }
            float t = relief_patch_hit(origin, direction, tile + local, hit.t, leave);
            hit.fetches += 4;
            if (t >= 0.0) {
                hit.t = t;
                hit.status = RELIEF_HIT;
                return hit;
            }
        }
        // Over the wall, and up again where it is the parent's wall too.
        hit.t = max(hit.t, leave);
        ivec2 inside = clamp(ivec2(floor(origin + hit.t * direction)) - tile, low, high - 1);
        if (far.x <= far.y) inside.x = direction.x > 0.0 ? high.x : low.x - 1;
        else inside.y = direction.y > 0.0 ? high.y : low.y - 1;
        cell = tile + inside;
        if (level < relief_mip_top && any(notEqual(inside >> (level + 1), block >> 1))) level += 1;
    }
    return hit;
}
