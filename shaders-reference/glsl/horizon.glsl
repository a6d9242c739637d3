// Shadows from a baked horizon map (Max 1988; Sloan and Cohen 2000): the sun is seen where it stands above the horizon, which
// the map holds for eight azimuths. Two reads, no march.
//
// Azimuth k looks towards the k-th of the eight neighbours of a texel, from +u on towards +v, v down the image: along the axes
// and at the angle of a texel's diagonal. A value is the sine of the horizon's elevation.

uniform sampler2D horizon_map_0; // azimuths 0 to 3; linear filter, no mips; wrap as baked
uniform sampler2D horizon_map_1; // azimuths 4 to 7
uniform float horizon_diagonal;  // angle between +u and azimuth 1, radians: atan(pixel aspect)
uniform float horizon_deepen;    // depth of the relief as drawn over that of the bake; 1 if it is the same

// Sine of the horizon's elevation at uv towards (du, aspect dv), not 0: of the two azimuths beside it, mixed by angle.
float horizon_sine(vec2 uv, vec2 towards) {
    const float quarter = 1.5707963;
    float angle = atan(abs(towards.y), abs(towards.x));
    float along_u = max(1.0 - angle / horizon_diagonal, 0.0);
    float along_v = max((angle - horizon_diagonal) / (quarter - horizon_diagonal), 0.0);
    float diagonal = 1.0 - along_u - along_v;
    float right = step(0.0, towards.x);
    float down = step(0.0, towards.y);
    vec4 first = vec4(right * along_u, right * down * diagonal, down * along_v, (1.0 - right) * down * diagonal);
    vec4 second = vec4((1.0 - right) * along_u, (1.0 - right) * (1.0 - down) * diagonal, (1.0 - down) * along_v, right * (1.0 - down) * diagonal);
    float sine = dot(textureLod(horizon_map_0, uv, 0.0), first) + dot(textureLod(horizon_map_1, uv, 0.0), second);
    float tangent = horizon_deepen * sine / sqrt(max(1.0 - sine * sine, 1e-12));
    return tangent / sqrt(1.0 + tangent * tangent);
}

// Share of the sun seen. `sun`: unit vector towards it, x along u, y up the image, z out of the polygon. `sun_size`: difference
// of the sines of its upper and lower edge; as small as can be for a hard shadow.
float horizon_visibility(vec2 uv, vec3 sun, float sun_size) {
    float overhead = abs(sun.x) + abs(sun.y) > 0.0 ? 0.0 : 1.0;
    float horizon = horizon_sine(uv, vec2(sun.x + overhead, -sun.y));
    return clamp(0.5 + (sun.z - horizon) / sun_size, 0.0, 1.0);
}
