// The surface of a water, in two draws that blend: what is left of the light from below, and what the water adds.
#include "lib/frame.glsl"
#include "lib/noise.glsl"
#include "lib/brdf.glsl"
#include "lib/sky.glsl"

uniform sampler2D uDepth;
uniform mat4 uOutline0, uOutline1, uOutline2, uOutline3;  // corners x, z, x, z ...
uniform int uCorners;
uniform float uSurface;   // height
uniform vec3 uColor;      // of the light that is left after uClarity metres
uniform float uClarity;
uniform vec4 uWaves;      // height, length, speed, direction
uniform float uSeconds;
uniform bool uAdds;

in vec2 uv;
out vec4 color;

vec2 cornerAt(int i) {
    mat4 part = i < 8 ? uOutline0 : i < 16 ? uOutline1 : i < 24 ? uOutline2 : uOutline3;
    vec4 pair = part[(i & 7) >> 1];
    return (i & 1) == 0 ? pair.xy : pair.zw;
}

bool insideOutline(vec2 p) {
    bool inside = false;
    for (int i = 0, j = uCorners - 1; i < uCorners; j = i++) {
        vec2 a = cornerAt(i), b = cornerAt(j);
        if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) inside = !inside;
    }
    return inside;
}

/// Slopes of a few sines, the longest first: each turned from the last and a little shorter.
vec2 rippleSlope(vec2 p, float far) {
    vec2 slope = vec2(0.0);
    float angle = uWaves.w, wavelength = uWaves.y, height = uWaves.x * 0.5;
    for (int i = 0; i < 7; ++i) {
        vec2 along = vec2(cos(angle), sin(angle));
        float k = 6.2831853 / wavelength;
        float fade = 1.0 / (1.0 + far * far * k * k * 2e-4);  // ripples smaller than a pixel average out
        slope += along * (k * height * fade * cos(k * (dot(p, along) - uWaves.z * sqrt(wavelength / uWaves.y) * uSeconds) + float(i) * 2.1));
        angle += 2.3999632;
        wavelength *= 0.71;
        height *= 0.60;
    }
    return slope;
}

void main() {
    vec3 ray = viewRay(uv);
    float over = frame.cameraPosition.y - uSurface;
    if (over <= 0.0 || ray.y >= 0.0) discard;
    float t = -over / ray.y;  // linear depth of the surface
    float behind = texelFetch(uDepth, ivec2(gl_FragCoord.xy), 0).r;
    vec3 place = frame.cameraPosition.xyz + ray * t;
    if (t >= behind || !insideOutline(place.xz)) discard;

    float stretch = length(ray);
    vec3 direction = ray / stretch;
    vec2 slope = rippleSlope(place.xz, t);
    vec3 normal = normalize(vec3(-slope.x, 1.0, -slope.y));
    float mirrored = fresnel(vec3(0.02), max(dot(normal, -direction), 0.0)).r;
    float way = min((behind - t) * stretch, 50.0);
    vec3 left = pow(uColor, vec3(way / uClarity));
    if (!uAdds) {
        color = vec4(left * (1.0 - mirrored), 1.0);
        return;
    }
    vec3 light = skyRadiance(vec3(0, 1, 0)) + frame.sunColor.rgb * max(frame.sunDirection.y, 0.0) * 0.3183;
    vec3 scattered = uColor * light * 0.35 * (1.0 - left);
    vec3 mirror = reflect(direction, normal);
    mirror = normalize(vec3(mirror.x, max(mirror.y, 0.03), mirror.z));
    vec3 sky = withHills(withClouds(skyRadiance(mirror), mirror), mirror);
    vec3 glint = frame.sunColor.rgb * min(specularLobe(normal, -direction, frame.sunDirection.xyz, 0.12), 30.0) *
                 max(dot(normal, frame.sunDirection.xyz), 0.0) * mirrored;
    color = vec4(scattered * (1.0 - mirrored) + sky * mirrored + min(glint, vec3(20.0)), 0.0);
}
