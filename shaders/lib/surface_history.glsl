// The target `surface`: what light accumulation remembers of each pixel, and what the filters compare.
//   x linear depth (65000: sky) · y normal, packed (-1: sky) · z frames accumulated, a whole number, plus the mean of `hitProximity` (sky.frag) · w mean of the squared luminance of `light` (-1: glows)
// Needs lib/frame.glsl.

/// How far apart the depths of one surface may lie in pixels beside each other, metres.
float depthTolerance(vec3 position, vec3 normal, float depth) {
    float slant = max(0.08, abs(dot(normal, normalize(position - frame.cameraPosition.xyz))));
    float pixelMetres = 2.0 * frame.cameraUp.w * frame.targetSize.w * depth;
    return 0.03 + 2.0 * pixelMetres / slant;
}

/// A unit vector as a whole number below 2^24, which float holds exactly: octahedral, 12 bits an axis.
float packNormal(vec3 n) {
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
