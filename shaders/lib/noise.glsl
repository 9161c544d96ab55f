// Random numbers for sampling, and noise for textures.
//
// Sampling uses blue noise with a low-discrepancy sequence over time. A 64x64 tile of blue noise gives each pixel a
// phase, so that the error of neighbouring pixels differs and filters remove it (Georgiev and Fajardo 2016, "Blue-noise
// dithered sampling"). Sample n of a pixel is that phase plus n times the R2 step, modulo 1: a Cranley-Patterson
// rotation of the R2 sequence, whose points stay evenly spread for every n (Roberts 2018). So each pixel converges
// faster than with white noise, while each frame is blue over the screen.
#include "lib/constants.glsl"
uniform sampler2D uBlueNoise;  // r the tile, g the tile moved aside: two numbers for one fetch

/// A hash of 32 bits: "lowbias32", found with Chris Wellons' hash prospector.
uint hashBits(uint x) {
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    x *= 0x846ca68bu;
    return x ^ (x >> 16);
}

/// Two numbers in [0, 1) for a pixel. `dimension` must differ between the uses in one frame; `index` counts the samples
/// over time. White noise if the settings ask for it. steps: from one index to the next. Numbers that a sample takes
/// together need different ones: with the same their differences would stay, and each pixel would come to a wrong mean
/// of its own.
vec2 blueNoise(ivec2 pixel, int dimension, int index, vec2 steps) {
#ifdef WHITE_NOISE
    uint seed = hashBits(uint(index) + hashBits(uint(dimension) + hashBits(uint(pixel.x) + hashBits(uint(pixel.y)))));
    return vec2(uvec2(seed, hashBits(seed ^ 0x9e3779b9u)) >> 8u) * (1.0 / 16777216.0);
#else
    vec2 base = texelFetch(uBlueNoise, (pixel + dimension * ivec2(23, 41)) & 63, 0).rg;
    // The index wraps, so that the product keeps enough bits for its fraction.
    return fract(base + float(index & 1023) * steps);
#endif
}

/// With the steps of R2: those for the two numbers that matter most.
vec2 blueNoise(ivec2 pixel, int dimension, int index) { return blueNoise(pixel, dimension, index, kR2Step); }

/// White noise in [0, 1) for a cell.
float hash01(ivec2 p) { return float(hashBits(uint(p.x) + hashBits(uint(p.y))) >> 8) * (1.0 / 16777216.0); }
float hash01(ivec3 p) {
    return float(hashBits(uint(p.x) + hashBits(uint(p.y) + hashBits(uint(p.z)))) >> 8) * (1.0 / 16777216.0);
}

/// Value noise: smooth, in [0, 1], with features of size 1.
float valueNoise(vec2 p) {
    vec2 cell = floor(p);
    vec2 f = p - cell;
    f = f * f * (3.0 - 2.0 * f);
    ivec2 i = ivec2(cell);
    float low = mix(hash01(i), hash01(i + ivec2(1, 0)), f.x);
    float high = mix(hash01(i + ivec2(0, 1)), hash01(i + ivec2(1, 1)), f.x);
    return mix(low, high, f.y);
}

/// Fractal noise: octaves of value noise in [0, 1], each rotated so that the grid does not show.
float fractalNoise(vec2 p, int octaves) {
    float sum = 0.0, weight = 0.5, total = 0.0;
    int i = loopBegin();
    do {
        sum += weight * valueNoise(p);
        total += weight;
        weight *= 0.5;
        p = mat2(1.62, 1.18, -1.18, 1.62) * p + 17.3;
    } while (++i < octaves);
    return sum / total;
}
