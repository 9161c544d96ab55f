// Transparent and emissive particles, drawn from far to near: dust, smoke, flames, sparks and embers.
#include "lib/particle.glsl"

/// A sphere of uneven gas: two layers of noise that drift apart. Its opacity is 1 - exp(-density x visible chord).
vec4 gas(vec3 coarse, float fine) {
    float r2 = dot(corner, corner);
    float lumps = coarse.r * 0.65 + fine * 0.35;
    float density = smoothstep(0.0, 0.55, lumps * 1.25 - sqrt(r2) * 0.78 - 0.02 + 0.18 * (1.0 - r2));
    float height = sqrt(1.0 - r2);
    float alpha = 1.0 - exp(-tintOut.a * density * softFade(height * particle.w) * (kind == kSmoke ? 3.2 : 2.4));
    // The noise bends the normal; light wraps around the edge and shines through thin parts.
    vec2 bent = corner * 0.85 - (coarse.gb - 0.5) * 3.2;
    vec3 normal = normalize(frame.cameraRight.xyz * bent.x + frame.cameraUp.xyz * bent.y -
                            frame.cameraForward.xyz * max(height, 0.25));
    float wrapped = clamp(dot(normal, frame.sunDirection.xyz) * 0.6 + 0.4, 0.0, 1.0);
    vec3 light = sunLight * (wrapped + (1.0 - density) * depths.z) + airLight * (0.75 + 0.25 * normal.y);
    return vec4(tintOut.rgb * light * alpha, alpha);
}

/// Colour of fire from white (heat 1) through orange to dark red (0).
vec3 fireColor(float heat) {
    float h2 = heat * heat;
    return vec3(1.0, 0.27, 0.035) * (3.4 * h2) + vec3(0.9, 0.5, 0.16) * (3.2 * h2 * h2 * heat) +
           vec3(0.30, 0.03, 0.0) * heat;
}

/// A flame: noise that moves upward through a shape with a narrow tip.
vec4 flame(float coarse, float fine) {
    vec2 p = vec2(corner.x * (1.0 + 0.55 * max(corner.y, 0.0)), corner.y * 0.9);
    float r2 = dot(p, p);
    float body = smoothstep(0.05, 0.80, (coarse * 0.7 + fine * 0.3) * 1.25 - sqrt(r2) * 0.80 + 0.14);
    float strength = body * tintOut.a * clamp(softFade(sqrt(max(1.0 - r2, 0.0)) * particle.w) * 2.0, 0.0, 1.0);
    float heat = clamp(body * (1.15 - 0.75 * stateOut.x) - 0.15 * max(corner.y, 0.0), 0.0, 1.0);
    return vec4(fireColor(heat) * strength * 0.55, strength * 0.35);
}

/// A spark or ember, which cools with age.
vec4 glow() {
    if (depths.x - particle.w > surfaceDepth()) return vec4(0.0);
    return vec4(tintOut.rgb * (14.0 * (1.0 - stateOut.x * stateOut.x)), 0.25) *
           (tintOut.a * max(0.0, 1.0 - dot(corner, corner) * 0.6));
}

void main() {
    if (dot(corner, corner) >= 1.0 && kind <= kFlame) discard;
    vec3 coarse = texture(uPuffNoise, noiseUv.xy).rgb;
    float fine = texture(uPuffNoise, noiseUv.zw).r;
    color = kind < kFlame ? gas(coarse, fine) : kind == kFlame ? flame(coarse.r, fine) : glow();
    if (color.a < 0.002) discard;
    color = applyHaze(color);
}
