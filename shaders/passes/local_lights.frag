// Irradiance / pi from sphere and cone lights, added to the colour of `light`: one ray to a random point of each light
// whose reach meets the pixel.
#include "lib/gbuffer.glsl"
#include "lib/frame.glsl"
#include "lib/noise.glsl"
#include "lib/sampling.glsl"
#include "lib/shadow_trace.glsl"

// Three texels a light: position, radius | intensity, reach | direction of a cone, scale of its edge | w of texel 3: see below
uniform sampler2D uLights;  // row = light: 0 xyz position w radius, 1 rgb intensity w reach, 2 xyz direction w unused, 3 x cos outer, y 1 / (cos inner - cos outer)

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
    if (s.sky) return;
    vec3 position = worldFromDepth(uv, s.depth);
    vec3 origin = shadowOrigin(position, s.normal);
    for (int i = 0; i < frame.counters.z; ++i) {
        vec4 place = texelFetch(uLights, ivec2(0, i), 0);
        vec4 power = texelFetch(uLights, ivec2(1, i), 0);
        vec3 toCentre = place.xyz - position;
        float range = length(toCentre);
        if (range >= power.w) continue;
        float facing = dot(s.normal, toCentre);
        if (facing <= 0.0) continue;
        vec4 cone = texelFetch(uLights, ivec2(3, i), 0);
        float along = -dot(toCentre, texelFetch(uLights, ivec2(2, i), 0).xyz) / range;
        float edge = clamp((along - cone.x) * cone.y, 0.0, 1.0);
        vec3 arriving = power.rgb * (attenuation(range, place.w, power.w) * edge * edge * facing / range / kPi);
        if (max(arriving.r, max(arriving.g, arriving.b)) < 0.002) continue;
        vec3 target = place.xyz + place.w * spherePoint(blueNoise(pixel, 2 + i, frame.counters.x));
        vec3 toTarget = target - origin;
        float distanceMetres = length(toTarget);
        float t;
        // The ray ends before the light's own glowing voxels.
        if (!shadowTrace(origin, toTarget / distanceMetres, distanceMetres - max(place.w, 0.12), t)) light.rgb += arriving;
    }
}
