// A quad that covers a particle: it faces the camera, lies at the particle's near side and carries the light there.
#include "lib/constants.glsl"
#include "lib/particle_kinds.glsl"
#include "lib/frame.glsl"
#include "lib/sky.glsl"
#include "lib/shadow_trace.glsl"
#include "lib/smoke_shadow.glsl"

layout(location = 0) in vec4 place;   // xyz from the render origin, w radius
layout(location = 1) in vec4 tint;    // rgb linear, a opacity
layout(location = 2) in vec4 motion;  // xyz velocity, w kind
layout(location = 3) in vec4 state;   // x age, yzw random numbers of its own
layout(location = 4) in vec2 image;   // x radians by which it has turned, y seconds of motion by which it is longer

uniform vec4 uLightPosition0, uLightPosition1, uLightPosition2, uLightPosition3;  // xyz from the render origin, w reach
uniform vec3 uLightColor0, uLightColor1, uLightColor2, uLightColor3;

out vec2 corner;         // in radii
out vec4 noiseUv;        // of the two layers of noise
out vec3 sunLight;       // irradiance / pi of the sun
out vec3 airLight;       // mean radiance from all around
flat out vec4 particle;  // xyz centre, w radius
flat out vec4 tintOut;
flat out vec4 stateOut;
flat out vec4 haze;    // rgb radiance of the haze, a its share
flat out vec4 depths;  // x depth of the centre; y fade near the camera (0 = at it); z light through thin parts
                       // w radians by which a cube has turned
flat out int kind;

/// Mean radiance that a point light adds.
vec3 fromLight(vec4 lightPlace, vec3 color, vec3 position) {
    vec3 away = lightPlace.xyz - position;
    float d2 = dot(away, away), ratio = d2 / (lightPlace.w * lightPlace.w);
    float window = clamp(1.0 - ratio * ratio, 0.0, 1.0);
    return color * (window * window / (max(d2, 0.16) * 12.566));  // 4 pi: the mean over all directions
}

const float kSunDistance = 40.0, kRoofDistance = 12.0;  // metres of the rays that look for shadow and for a roof

/// 1 in the sun. Each corner of a quad asks for itself, so that a puff may be half in shadow; a corner inside a solid
/// asks for the centre.
float sunAt(vec3 position, vec3 center) {
    float t;
    if (frame.sunDirection.y <= 0.0) return 0.0;
    if (!shadowTrace(position, frame.sunDirection.xyz, kSunDistance, t)) return 1.0;
    return t <= 0.0 && !shadowTrace(center, frame.sunDirection.xyz, kSunDistance, t) ? 1.0 : 0.0;
}

void main() {
    const vec2 kCorners[6] = vec2[6](vec2(-1, -1), vec2(1, -1), vec2(1, 1), vec2(-1, -1), vec2(1, 1), vec2(-1, 1));
    kind = int(motion.w + 0.5);
    corner = kCorners[gl_VertexID];
    particle = place;
    tintOut = tint;
    stateOut = state;
    vec3 right = frame.cameraRight.xyz, up = frame.cameraUp.xyz;
    vec3 back = toEye(place.xyz);
    float depth = viewDepth(place.xyz);
    // Never smaller than a pixel: it gets fainter instead.
    float leastRadius = 0.5 * pixelMetres(max(depth, 0.1));
    float radius = place.w, solidity = 1.0;
    if (kind >= kSpark) {
        solidity = min(1.0, radius * radius / (leastRadius * leastRadius) * 1.5);
        radius = max(radius, leastRadius);
        tintOut.a *= max(solidity, 0.25);
    }
    particle.w = radius;
    float extent = kind == kCrumb || kind == kGlint ? 1.75 : 1.1;
    vec3 offset = (right * corner.x + up * corner.y) * (radius * extent);
    if (kind == kSpark) {
        // A streak as long as its path in 14 ms.
        vec3 streak = motion.xyz * 0.014;
        vec3 along = normalize(streak + vec3(0, 1e-4, 0)), side = normalize(cross(along, back) + vec3(1e-5));
        offset = side * (corner.x * radius) + streak * (corner.y * 0.5) + along * (corner.y * radius);
    }
    if (image.y > 0.0) {
        vec3 path = motion.xyz * image.y;
        path -= back * dot(path, back);
        offset += path * (dot(offset, path) * 0.5 / (radius * extent * max(length(path), 1e-6)));
    }
    if (kind == kFlame) offset = right * (corner.x * radius * 1.1) + vec3(0, 1, 0) * (corner.y * radius * 1.55);
    corner *= extent;
    float turn = (state.y + (state.z - 0.5) * 0.35 * state.x) * kTwoPi + image.x;
    vec2 turned = mat2(cos(turn), sin(turn), -sin(turn), cos(turn)) * corner * 0.22;
    noiseUv = vec4(turned + state.zw * 7.0, turned * 2.3 - state.zw * 7.0 + vec2(0.05, 0.09) * state.x);
    if (kind == kFlame)
        noiseUv = vec4(corner * vec2(0.30, 0.20) + state.zw * 5.0 - vec2(0.0, state.x * 0.55),
                       corner * vec2(0.62, 0.36) - state.zw * 5.0 - vec2(0.0, state.x * 0.9));
    float range = length(place.xyz - eyeOf(place.xyz));
    float towardSun = max(-dot(back, frame.sunDirection.xyz), 0.0);
    haze = vec4(hazeRadiance(-back), hazeAmount(range));
    depths = vec4(depth, smoothstep(0.2, 1.2, depth), towardSun * towardSun * towardSun * 1.6, image.x);
    vec3 near = place.xyz + offset + back * min(radius * (kind >= kSpark ? 0.0 : 1.0), max(depth - 0.1, 0.0));
    gl_Position = frame.viewProjection * vec4(near, 1.0);
    vec3 lit = place.xyz + offset * 0.45;
    sunLight = airLight = vec3(0.0);
    if (kind == kSpark || kind == kEmber || kind == kFlame) return;
    float clear = sunThroughSmoke(lit);
    sunLight = frame.sunColor.rgb * (sunAt(lit, place.xyz) * clear / kPi);
    float t;
    bool roof = shadowTrace(place.xyz, vec3(0.0, 1.0, 0.0), kRoofDistance, t);
    airLight = mix(skyRadiance(vec3(0, 1, 0)), frame.groundColor.rgb + frame.sunColor.rgb * 0.05, 0.4) *
               ((roof ? 0.25 : 0.9) * (0.4 + 0.6 * clear));
    airLight += fromLight(uLightPosition0, uLightColor0, lit) + fromLight(uLightPosition1, uLightColor1, lit) +
                fromLight(uLightPosition2, uLightColor2, lit) + fromLight(uLightPosition3, uLightColor3, lit);
}
