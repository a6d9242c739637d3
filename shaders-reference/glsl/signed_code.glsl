// Signed values in integer channels.
//
// Set before this text, from the map's metadata (`reliefbake explain`):
//   SIGNED_CODES  0 half or float channels; 1 centred, zero is a code of its own; 2 unorm, 2 v - 1

#if SIGNED_CODES == 1
uniform float signed_largest; // largest code
uniform float signed_zero;    // code of zero
#endif

// In this order zero comes out as exactly 0 where the sampler returns code / largest code correctly rounded.
vec3 signed_value(vec3 stored) {
#if SIGNED_CODES == 0
    return stored;
#elif SIGNED_CODES == 1
    return vec3(stored.x * signed_largest - signed_zero, stored.y * signed_largest - signed_zero, stored.z * signed_largest - signed_zero) /
           (signed_largest - signed_zero);
#else
    return vec3(2.0 * stored.x - 1.0, 2.0 * stored.y - 1.0, 2.0 * stored.z - 1.0);
#endif
}
