// No search: hits computed elsewhere, one per pixel, so that the oracle's picture is shaded by the same text.
// Needs shape_solid.glsl.

uniform sampler2D given_hits; // (t, gap, status, -), the picture's bottom row first

SolidHit given_solid_hit(SolidRay ray, float t_end) {
    vec4 given = texelFetch(given_hits, ivec2(gl_FragCoord.xy), 0);
    SolidHit hit = solid_start();
    hit.t = given.x;
    hit.gap = given.y;
    hit.status = int(given.z);
    return hit;
}
