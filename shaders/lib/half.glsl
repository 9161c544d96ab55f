// Stochastic rounding to half floats, for histories that are averaged over many frames. A GL may truncate the bits that
// do not fit instead of rounding to nearest; each frame then loses half of the last digit on average, and a long mean
// sinks. Rounding up with a probability equal to the truncated fraction has the right expected value:
//   E[round(x)] = floor(x) + P(up) ulp = x    with P(up) = (x - floor(x)) / ulp    (Croci et al. 2022, a survey)
// A half float keeps 10 of the 23 bits of a float's mantissa: adding a random number below 2^13 to the bits and then
// clearing the lower 13 does just that. Needs lib/noise.

/// `dimension` must differ between the calls of one frame for a pixel.
vec4 stochasticRoundToHalf(vec4 value, ivec2 pixel, int dimension) {
    uint random = uint(hash01(ivec3(pixel, frame.counters.x * 16 + dimension)) * 8192.0);
    return uintBitsToFloat((floatBitsToUint(value) + random) & 0xffffe000u);
}
