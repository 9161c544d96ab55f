// Where light has changed: each texel stands for 4x4 pixels and compares what has reached them in the last few pictures with
// what they remember. Both see the same surfaces, so what differs is noise or a change. Read by accumulate.frag.
#include "lib/frame.glsl"
#include "lib/color.glsl"

uniform sampler2D uLight;
uniform sampler2D uMotion;
uniform sampler2D uLightHistory;     // accumulated
uniform sampler2D uSurfaceHistory;   // z frames accumulated
uniform sampler2D uFastHistory;
uniform bool uHistoryValid;
uniform sampler2D uDepth;
uniform int uDirtyCornerCount;  // corners of boxes, low and high by turns, where what casts shadows has changed since the last picture
uniform vec4 uDirtyCorners[16];   // of these, world

const float kPulse = 4.0;  // pictures that the short memory holds

layout(location = 0) out vec4 pulse;    // of the last few pictures: mean luminance, its variance a sample, mean share of the sun; pictures
layout(location = 1) out vec4 trusted;  // x: 1 where memory holds, 0 where it must be forgotten

float trust(float difference, float deviation) { return 1.0 - smoothstep(2.0, 4.0, abs(difference) / deviation); }

const float kBeside = 1.2;  // metres from what changed within which all is forgotten
const float kAround = 4.0;  // beyond which only what is seen to differ is

/// What may be trusted of the memory of a place when something near it has changed.
float trustNear(vec3 position) {
    float nearest = kAround;
    for (int i = 0; i < uDirtyCornerCount; i += 2)
        nearest = min(nearest, length(max(max(uDirtyCorners[i].xyz - position, position - uDirtyCorners[i + 1].xyz), vec3(0.0))));
    return max(nearest - kBeside, 0.0) / (kAround - kBeside);
}

void main() {
    ivec2 tile = ivec2(gl_FragCoord.xy) * 4, high = ivec2(frame.targetSize.xy) - 1;
    vec3 now = vec3(0.0);
    for (int i = 0; i < 16; ++i) {
        vec4 light = texelFetch(uLight, min(tile + ivec2(i & 3, i >> 2), high), 0);
        float l = luminance(light.rgb);
        now += vec3(l, l * l, light.a);
    }
    now /= 16.0;
    now.y = max(now.y - now.x * now.x, 0.0);
    pulse = vec4(now, 1.0);
    trusted = vec4(1.0);
    if (!uHistoryValid) return;
    vec2 lastUv = (vec2(tile) + 2.0) * frame.targetSize.zw - texelFetch(uMotion, min(tile + 2, high), 0).rg;
    if (any(lessThan(lastUv, vec2(0.0))) || any(greaterThanEqual(lastUv, vec2(1.0)))) return;
    vec4 before = texture(uFastHistory, lastUv);
    float pictures = min(before.w + 1.0, kPulse);
    pulse = vec4(mix(before.xyz, now, 1.0 / pictures), pictures);

    vec4 then = vec4(0.0);
    for (int i = 0; i < 4; ++i) then += texture(uLightHistory, lastUv + vec2((i & 1) * 2 - 1, (i >> 1) * 2 - 1) * frame.targetSize.zw);
    then *= 0.25;
    float thenLum = luminance(then.rgb), frames = max(texture(uSurfaceHistory, lastUv).z, 1.0);
    // What a mean of that many samples strays by, here and in the memory.
    float share = (1.0 / pictures + 1.0 / frames) / 16.0;
    float sunVariance = max(then.a * (1.0 - then.a), pulse.z * (1.0 - pulse.z)) + 0.02;
    trusted.x = min(trust(pulse.x - thenLum, sqrt(pulse.y * share) + 0.03 * pulse.x + 1e-4), trust(pulse.z - then.a, sqrt(sunVariance * share)));
    ivec2 middle = min(tile + 2, high);
    trusted.x = min(trusted.x, trustNear(worldFromDepth((vec2(middle) + 0.5) * frame.targetSize.zw, texelFetch(uDepth, middle, 0).r)));
    if (trusted.x < 0.5) pulse = vec4(now, 1.0);  // what is new is all that counts from here on
}
