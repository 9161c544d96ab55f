// What is kept from picture to picture in targets of half floats. A GL may cut off the digits that do not fit instead of rounding: a mean over
// many pictures then sinks by as many halves of the last digit. Needs lib/noise.

/// The value with the digits that a half float has, rounded up as often as what is cut off is near to one: right on average, whatever the
/// GL does. `dimension` tells those of one picture apart.
vec4 stochasticRoundToHalf(vec4 value, ivec2 pixel, int dimension) {
    uint random = uint(hash01(ivec3(pixel, frame.counters.x * 16 + dimension)) * 8192.0);
    return uintBitsToFloat((floatBitsToUint(value) + random) & 0xffffe000u);
}
