// Transmittance of dust and smoke for sunlight, from the map of render/scene/smoke_shadow.h. A texel holds the optical
// depth of its sun ray and the first two moments of the gas along it (as in variance shadow maps: Donnelly and
// Lauritzen 2006). With mean m and deviation s of the gas, the share of it on the sunny side of a position is taken to
// rise smoothly from m - spread to m + spread, and the light falls as exp(-that share of the optical depth).
#include "lib/frame.glsl"

uniform bool uHasSmoke;
uniform sampler2D uSmokeMap;  // r optical depth; g times the mean distance toward the sun, b times its mean square
uniform vec4 uSmokeRight, uSmokeUp;  // uv in the map = dot(xyz, position) + w

float sunThroughSmoke(vec3 position) {
    if (!uHasSmoke) return 1.0;
    vec2 place = vec2(dot(uSmokeRight.xyz, position) + uSmokeRight.w, dot(uSmokeUp.xyz, position) + uSmokeUp.w);
    if (place != clamp(place, 0.01, 0.99)) return 1.0;
    vec3 gas = texture(uSmokeMap, place).rgb;
    if (gas.r < 0.002) return 1.0;
    float middle = gas.g / gas.r, spread = 0.3 + 1.5 * sqrt(max(gas.b / gas.r - middle * middle, 0.0));
    return exp(-gas.r * smoothstep(-spread, spread, middle - dot(frame.sunDirection.xyz, position)));
}
