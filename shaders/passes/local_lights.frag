// Irradiance / pi from sphere and cone lights, added to the colour of `light`: one ray to a random point of the
// light. One draw a light, blended.
#include "lib/gbuffer.glsl"
#include "lib/frame.glsl"
#include "lib/noise.glsl"
#include "lib/sampling.glsl"
#include "lib/shadow_trace.glsl"

uniform vec4 uPlace;   // xyz centre, w radius
uniform vec4 uPower;   // rgb intensity, w reach
uniform vec3 uAxis;    // of a cone
uniform vec2 uCone;    // cosine of the outer half angle; 1 / (cosine of the inner - cosine of the outer)
uniform int uIndex;    // tells the noise of lights apart

const float kFaintest = 0.002;  // radiance of a white surface below which no ray is worth its price

in vec2 uv;
out vec4 light;

/// Inverse square, brought to zero at the reach (Karis, "Real shading in Unreal Engine 4").
float attenuation(float distanceMetres, float radius, float reach) {
    float ratio = distanceMetres / reach;
    float window = clamp(1.0 - ratio * ratio * ratio * ratio, 0.0, 1.0);
    return window * window / max(distanceMetres * distanceMetres, radius * radius);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Surface s = readSurface(pixel);
    light = vec4(0.0);
    vec3 position = worldFromDepth(uv, s.depth);
    vec3 toCentre = uPlace.xyz - position;
    float range = length(toCentre);
    float facing = dot(s.normal, toCentre) / range;
    float edge = clamp((-dot(toCentre, uAxis) / range - uCone.x) * uCone.y, 0.0, 1.0);
    vec3 arriving = uPower.rgb * (attenuation(range, uPlace.w, uPower.w) * edge * edge * facing / kPi);
    if (facing <= 0.0 || max(arriving.r, max(arriving.g, arriving.b)) < kFaintest) discard;
    vec3 origin = shadowOrigin(position, s.normal);
    vec3 toTarget = uPlace.xyz + uPlace.w * spherePoint(blueNoise(pixel, 2 + uIndex, frame.counters.x)) - origin;
    float distanceMetres = length(toTarget);
    float t;
    // The ray ends before the light's own glowing voxels.
    if (!shadowTrace(origin, toTarget / distanceMetres, distanceMetres - max(uPlace.w, 0.12), t)) light.rgb = arriving;
}
