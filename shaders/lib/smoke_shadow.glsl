// How much of the sun comes through dust and smoke: see render/scene/smoke_shadow.h.
#include "lib/frame.glsl"

uniform bool uHasSmoke;
uniform sampler2D uSmokeMap;             // r optical depth; g times the distance toward the sun, b times its square
uniform vec4 uSmokeRight, uSmokeUp;      // place in the map = dot(xyz, position) + w

float sunThroughSmoke(vec3 position) {
    if (!uHasSmoke) return 1.0;
    vec2 place = vec2(dot(uSmokeRight.xyz, position) + uSmokeRight.w, dot(uSmokeUp.xyz, position) + uSmokeUp.w);
    if (place != clamp(place, 0.01, 0.99)) return 1.0;
    vec3 gas = texture(uSmokeMap, place).rgb;
    if (gas.r < 0.002) return 1.0;
    // All that is known of the ray: the gas lies around a middle, within a spread. Its share on the sunny side counts.
    float middle = gas.g / gas.r, spread = 0.3 + 1.5 * sqrt(max(gas.b / gas.r - middle * middle, 0.0));
    return exp(-gas.r * smoothstep(-spread, spread, middle - dot(frame.sunDirection.xyz, position)));
}
