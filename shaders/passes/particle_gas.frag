// Dust and smoke: spheres of uneven gas, two layers of noise that drift apart so that they churn as they age.
#include "lib/particle.glsl"

void main() {
    float r2 = dot(corner, corner);
    if (r2 >= 1.0) discard;
    vec3 coarse = texture(uPuffNoise, noisePlaces.xy).rgb;
    float lumps = coarse.r * 0.65 + texture(uPuffNoise, noisePlaces.zw).r * 0.35;
    float density = smoothstep(0.0, 0.55, lumps * 1.25 - sqrt(r2) * 0.78 - 0.02 + 0.18 * (1.0 - r2));
    float height = sqrt(1.0 - r2);
    float alpha = 1.0 - exp(-tintOut.a * density * visibleShare(height * particle.w) * (kind == 1 ? 3.2 : 2.4));
    if (alpha < 0.003) discard;
    // Lit like a ball of cotton: its lumps turn the normal, light bleeds round the edge and through thin parts.
    vec2 bent = corner * 0.85 - (coarse.gb - 0.5) * 3.2;
    vec3 normal = normalize(frame.cameraRight.xyz * bent.x + frame.cameraUp.xyz * bent.y - frame.cameraForward.xyz * max(height, 0.25));
    float wrapped = clamp(dot(normal, frame.sunDirection.xyz) * 0.6 + 0.4, 0.0, 1.0);
    vec3 light = sunLight * (wrapped + (1.0 - density) * depths.z) + airLight * (0.75 + 0.25 * normal.y);
    color = throughAir(vec4(tintOut.rgb * light * alpha, alpha));
}
