// The target "surface": what temporal accumulation remembers of each pixel, and what the filters compare.
//   x linear depth (kSkyDepth: sky)
//   y normal, packed by packNormal() (-1: sky, or the inside of a voxel)
//   z frames accumulated, a whole number, plus the mean hit proximity (passes/sky.frag), a fraction below 1
//   w mean squared luminance of the light (-1: the surface emits)
// Needs lib/frame.

/// Largest difference of depth between neighbouring pixels of one surface, metres.
float depthTolerance(vec3 position, vec3 normal, float depth) {
    float slant = max(0.08, abs(dot(normal, toEye(position))));
    return 0.03 + 2.0 * pixelMetres(depth) / slant;
}

/// A unit vector as a whole number below 2^24, which a float holds exactly: octahedral, 12 bits an axis. The sphere is
/// projected onto the octahedron |x| + |y| + |z| = 1 and its lower half is folded over the square's corners (Meyer et
/// al. 2010; Cigolle et al. 2014, "A survey of efficient representations for independent unit vectors"). -1: no normal.
float packNormal(vec3 n) {
    if (n == vec3(0.0)) return -1.0;
    vec2 p = n.xy / (abs(n.x) + abs(n.y) + abs(n.z));
    if (n.z < 0.0) p = (1.0 - abs(p.yx)) * vec2(p.x < 0.0 ? -1.0 : 1.0, p.y < 0.0 ? -1.0 : 1.0);
    vec2 q = floor((p * 0.5 + 0.5) * 4095.0 + 0.5);
    return q.x * 4096.0 + q.y;
}

vec3 unpackNormal(float packed_) {
    float x = floor(packed_ / 4096.0);
    vec2 p = vec2(x, packed_ - x * 4096.0) * (2.0 / 4095.0) - 1.0;
    vec3 n = vec3(p, 1.0 - abs(p.x) - abs(p.y));
    if (n.z < 0.0) n.xy = (1.0 - abs(n.yx)) * vec2(n.x < 0.0 ? -1.0 : 1.0, n.y < 0.0 ? -1.0 : 1.0);
    return normalize(n);
}

/// The pixels of the previous frame of which a place has its history: four for bilinear interpolation, or one where it
/// lies on that pixel's centre, as it does where the camera stands still.
struct Taps {
    ivec2 low;
    vec2 fraction;
    int count;
};

const float kOnCentre = 0.004;  // pixels from a pixel's centre within which a place counts as there

Taps tapsAt(vec2 lastUv) {
    vec2 corner = lastUv * frame.targetSize.xy - 0.5, low = floor(corner + kOnCentre),
         fraction = max(corner - low, vec2(0.0));
    return Taps(ivec2(low), fraction, max(fraction.x, fraction.y) < kOnCentre ? 1 : 4);
}

/// The weight of tap i, and its pixel.
float tapWeight(Taps taps, int i, out ivec2 pixel) {
    ivec2 offset = ivec2(i & 1, i >> 1);
    pixel = clamp(taps.low + offset, ivec2(0), ivec2(frame.targetSize.xy) - 1);
    vec2 weights = mix(1.0 - taps.fraction, taps.fraction, vec2(offset));
    return weights.x * weights.y;
}
