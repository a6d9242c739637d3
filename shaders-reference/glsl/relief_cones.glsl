// How far a ray may go on from where it stands: the one text that knows how a map keeps its cones. Needs relief_map.glsl.
//
// Set before this text:
//   RELIEF_SECTORS  0; 4 or 8: a cone for each sector of azimuth (002). Sector k of n holds the rays whose (du, aspect dv)
//                   has an angle in [2 pi k/n, 2 pi (k+1)/n), v down the image
//   RELIEF_LEVELS   1; 2 to 8: cones stacked above each texel (001 sec. 3.4). The apex of level k of n is (1 - h) k/n above
//                   the relief's height h; the longest step of the cones that the ray is in wins
//   RELIEF_PIECES   1: the levels are pieces of one cone instead. Piece k of n ends (1 - h) (k + 1)/n above the relief, with a
//                   radius of its ratio times that; between ends the radius is linear
//   RELIEF_PLANES   sectors or levels. 1: the cone is relief_map's blue. Else planes 0 to 3 are the channels of
//                   relief_cones_0, planes 4 to 7 those of relief_cones_1; size, filter and wrap as relief_map
//   RELIEF_LOOKUP   0 filtered; 1 unfiltered, a cone for each cell (maps baked with --lookup cell); 2 unfiltered, the
//                   least of the cell's four texels (001 sec. 4.3.1, a baseline). The height is filtered always

#if RELIEF_PLANES > 1
uniform sampler2D relief_cones_0;
#endif
#if RELIEF_PLANES > 4
uniform sampler2D relief_cones_1;
#endif

// What cones must be told of a ray; the same all along it.
struct ReliefCourse {
    float reach; // texture widths per unit of height, in the metric of the cones
    float falls; // 1: the ray goes down, -1: up
    vec4 sector; // 1 in the channel of its sector, else 0
    bool second; // its sector is one of 4 to 7
};

// A ray lies at or past the border at angle a when cross((cos a, sin a), d) >= 0; it lies in the sector whose first border
// it is at or past and whose second it is not. Signs of x, y, y - x and x + y are exact in floats.
ReliefCourse relief_course(vec2 direction, float falls) {
    ReliefCourse course;
    course.reach = relief_length(direction);
    course.falls = falls;
    course.sector = vec4(1.0, 0.0, 0.0, 0.0);
    course.second = false;
#if RELIEF_SECTORS > 0
    vec2 d = vec2(direction.x, relief_aspect * direction.y);
    d.x = course.reach > 0.0 ? d.x : 1.0; // straight down any sector's cone will do
    const vec4 zero = vec4(0.0, 0.0, 0.0, 0.0);
#endif
#if RELIEF_SECTORS == 4
    vec4 past = step(zero, vec4(d.y, -d.x, -d.y, d.x));
    course.sector = past * (1.0 - past.yzwx);
#endif
#if RELIEF_SECTORS == 8
    vec4 side = vec4(d.y, d.y - d.x, -d.x, -d.x - d.y);
    vec4 past = step(zero, side);
    vec4 opposite = step(zero, -side);
    vec4 first = past * (1.0 - vec4(past.yzw, opposite.x));
    vec4 second = opposite * (1.0 - vec4(opposite.yzw, past.x));
    course.sector = first + second;
    course.second = second.x + second.y + second.z + second.w > 0.5;
#endif
    return course;
}

// Ratios of the cones that a ray may use: x of `low` for one cone or the ray's sector, else levels 0 to 3 and 4 to 7.
struct ReliefCones {
    vec4 low;
    vec4 high;
};

ReliefCones relief_decode(vec4 texel, vec4 low, vec4 high, ReliefCourse course) {
    ReliefCones cones;
#if RELIEF_PIECES
#if RELIEF_ENCODING == 2
#else
    // Pieces hold for means of texels; a sampler that rounds what it filtered to 8 bits may return more. (A radius sees to it itself.)
    low = max(low - relief_code_delta, 0.0);
    high = max(high - relief_code_delta, 0.0);
#endif
#endif
    cones.low = vec4(0.0, 0.0, 0.0, 0.0);
    cones.high = cones.low;
#if RELIEF_SECTORS > 0
    cones.low.x = relief_ratio(dot(low, course.sector), texel.a);
#elif RELIEF_LEVELS > 1
    cones.low = vec4(relief_ratio(low.x, texel.a), relief_ratio(low.y, texel.a), relief_ratio(low.z, texel.a), relief_ratio(low.w, texel.a));
    cones.high = vec4(relief_ratio(high.x, texel.a), relief_ratio(high.y, texel.a), relief_ratio(high.z, texel.a), relief_ratio(high.w, texel.a));
#else
    cones.low.x = relief_ratio(texel.b, texel.a);
#endif
    return cones;
}

#if RELIEF_LOOKUP == 0
// `texel` is relief_map filtered at uv: equal weights, so that radius and depth are of one fetch.
ReliefCones relief_cones_filtered(vec4 texel, vec2 uv, ReliefCourse course) {
    vec4 low = vec4(0.0, 0.0, 0.0, 0.0);
    vec4 high = low;
#if RELIEF_SECTORS == 8
    if (course.second) low = textureLod(relief_cones_1, uv, 0.0);
    else low = textureLod(relief_cones_0, uv, 0.0);
#elif RELIEF_PLANES > 1
    low = textureLod(relief_cones_0, uv, 0.0);
#endif
#if RELIEF_LEVELS > 4
    high = textureLod(relief_cones_1, uv, 0.0);
#endif
    return relief_decode(texel, low, high, course);
}
#endif

#if RELIEF_LOOKUP > 0
ReliefCones relief_cones_of_texel(ivec2 index, ReliefCourse course) {
    ivec2 place = relief_address(index);
    vec4 texel = vec4(0.0, 0.0, 0.0, 0.0);
    vec4 low = texel;
    vec4 high = texel;
#if RELIEF_PLANES == 1
    texel = texelFetch(relief_map, place, 0);
#elif RELIEF_ENCODING == 2
    texel = texelFetch(relief_map, place, 0);
#endif
#if RELIEF_SECTORS == 8
    if (course.second) low = texelFetch(relief_cones_1, place, 0);
    else low = texelFetch(relief_cones_0, place, 0);
#elif RELIEF_PLANES > 1
    low = texelFetch(relief_cones_0, place, 0);
#endif
#if RELIEF_LEVELS > 4
    high = texelFetch(relief_cones_1, place, 0);
#endif
    return relief_decode(texel, low, high, course);
}
#endif

ReliefCones relief_cones_at(vec4 texel, vec2 uv, ReliefCourse course) {
#if RELIEF_LOOKUP == 0
    return relief_cones_filtered(texel, uv, course);
#else
    ivec2 cell = ivec2(floor(uv * vec2(textureSize(relief_map, 0)) - 0.5));
    ReliefCones cones = relief_cones_of_texel(cell, course);
#if RELIEF_LOOKUP == 2
    for (int k = 1; k < 4; ++k) {
        ReliefCones other = relief_cones_of_texel(cell + ivec2(k % 2, k / 2), course);
        cones.low = min(cones.low, other.low);
        cones.high = min(cones.high, other.high);
    }
#endif
    return cones;
#endif
}

// The ray leaves a cone of `ratio` after this much of its own height, from `gap` above the apex.
float relief_cone_step(float ratio, float gap, ReliefCourse course) {
    float closing = course.reach + course.falls * ratio;
    float advance = closing > 0.0 ? ratio * gap / closing : 1e30; // a ray that climbs more steeply than the cone never leaves it
    return ratio > 0.0 && gap > 0.0 ? advance : 0.0;
}

// Radius of the sphere around the ray that the cone holds (001 sec. 3.2), texture widths.
float relief_cone_distance(float ratio, float gap) {
#if RELIEF_METRIC_L1
    float slack = 2.0;
#else
    float slack = 1.0;
#endif
    float deep = relief_depth_scale;
    return deep * max(gap, 0.0) * ratio / sqrt(slack * deep * deep + ratio * ratio);
}

#if RELIEF_PIECES
// A ray leaves through the lowest piece whose upper end is around it, or above it. Radii that codes rounded down below those of
// lower ends are those; nothing higher is nearer. `room` is the height from the apex to the polygon.
float relief_piece_step(ReliefCones cones, float room, float gap, ReliefCourse course) {
    float end = 0.0;
    float radius = 0.0;
    if (gap <= 0.0 || room <= 0.0) return 0.0;
    for (int k = 0; k < RELIEF_LEVELS; ++k) {
        float ratio = k < 4 ? cones.low[k] : cones.high[k - 4];
        float next_end = room * (float(k + 1) / float(RELIEF_LEVELS));
        float next_radius = max(radius, ratio * next_end);
        if (next_end >= gap || course.reach * (gap - next_end) <= next_radius) {
            float slope = (next_radius - radius) / (next_end - end);
            float closing = course.reach + slope;
            return closing > 0.0 ? max(radius + slope * (gap - end), 0.0) / closing : 0.0;
        }
        end = next_end;
        radius = next_radius;
    }
    return 0.0;
}

// The widest whole cone in the pieces up to a height.
float relief_piece_ratio(ReliefCones cones, float room, float gap) {
    float ratio = cones.low.x;
    for (int k = 1; k < RELIEF_LEVELS; ++k) {
        float upper = k < 4 ? cones.low[k] : cones.high[k - 4];
        if (room * (float(k) / float(RELIEF_LEVELS)) < gap) ratio = min(ratio, upper);
    }
    return ratio;
}
#endif

// What a ray learns where it stands.
struct ReliefLook {
    float gap;      // height above the filtered relief
    float advance;  // how far it may go on, units of height; 0: no cone says anything
    float distance; // free of relief around it (for sectors: in its own), texture widths
    int fetches;
};

ReliefLook relief_look(vec2 uv, float depth, ReliefCourse course) {
    vec4 texel = textureLod(relief_map, uv, 0.0);
    ReliefCones cones = relief_cones_at(texel, uv, course);
    ReliefLook look;
    look.gap = relief_depth(texel) - depth;
    look.fetches = 1 + RELIEF_CONE_FETCHES;
#if RELIEF_PIECES
    float room = relief_depth(texel) - relief_delta;
    float ratio = relief_piece_ratio(cones, room, course.falls > 0.0 ? look.gap : room);
    look.distance = relief_cone_distance(ratio, look.gap - relief_delta);
    look.advance = relief_cone_step(ratio, look.gap - relief_delta, course);
    if (course.falls > 0.0) look.advance = relief_piece_step(cones, room, look.gap - relief_delta, course);
#else
    look.advance = relief_cone_step(cones.low.x, look.gap - relief_delta, course);
    look.distance = relief_cone_distance(cones.low.x, look.gap - relief_delta);
#if RELIEF_LEVELS > 1
    for (int k = 1; k < RELIEF_LEVELS; ++k) {
        float ratio = k < 4 ? cones.low[k] : cones.high[k - 4];
        float gap = relief_depth(texel) * (1.0 - float(k) / float(RELIEF_LEVELS)) - depth - relief_delta;
        look.advance = max(look.advance, relief_cone_step(ratio, gap, course));
        look.distance = max(look.distance, relief_cone_distance(ratio, gap));
    }
#endif
#endif
    return look;
}
