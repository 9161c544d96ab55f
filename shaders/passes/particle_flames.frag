// Tongues of fire: noise runs upward through a shape that narrows to its tip, coloured by heat.
#include "lib/particle.glsl"

/// From white-hot through orange to a red that is gone.
vec3 fireColor(float heat) {
    float h2 = heat * heat;
    return vec3(1.0, 0.34, 0.07) * (7.0 * h2) + vec3(0.9, 0.55, 0.22) * (9.0 * h2 * h2 * heat) + vec3(0.35, 0.04, 0.0) * heat;
}

void main() {
    vec2 p = vec2(corner.x * (1.0 + 0.55 * max(corner.y, 0.0)), corner.y * 0.9);
    float r2 = dot(p, p);
    if (r2 >= 1.0) discard;
    float lick = texture(uPuffNoise, noisePlaces.xy).r * 0.7 + texture(uPuffNoise, noisePlaces.zw).r * 0.3;
    float body = smoothstep(0.12, 0.75, lick * 1.25 - sqrt(r2) * 0.72 + 0.12);
    float strength = body * tintOut.a * clamp(visibleShare(sqrt(1.0 - r2) * particle.w) * 2.0, 0.0, 1.0);
    if (strength < 0.004) discard;
    float heat = clamp(body * (1.15 - 0.75 * stateOut.x) - 0.15 * max(corner.y, 0.0), 0.0, 1.0);
    color = throughAir(vec4(fireColor(heat) * strength * 0.55, strength * 0.35));
}
