// Temporal accumulation of mirror rays. A mirror's image lies behind its plane, as far as the ray goes before it. So
// history is fetched where the previous camera saw that virtual image in the same plane; the rougher the surface, the
// more the image sticks to it, by the dominance of the specular peak (Lagarde and de Rousiers 2014, 4.9.3). A tap
// counts if it lies in that plane. History is clamped to the mean of the neighbours +- their deviation, so that what
// moves in the mirror is followed: the mean of nine samples is uncertain by a third of it. Ideal mirrors have no noise
// and keep no history. There are two passes of it: passes/reflection_accumulate.frag where nothing is known to have
// changed, else passes/reflection_accumulate_changed.frag.
#include "lib/gbuffer.glsl"
#include "lib/frame.glsl"
#include "lib/noise.glsl"
#include "lib/half.glsl"
#include "lib/brdf.glsl"
#include "lib/color.glsl"
#include "lib/surface_history.glsl"
#include "lib/mirror.glsl"

uniform sampler2D uNoisyReflection;    // rgb radiance, a metres to the hit
uniform sampler2D uReflectionHistory;  // as `accumulated`
uniform sampler2D uMomentHistory;      // as `moments`
uniform sampler2D uSurfaceHistory;     // lib/surface_history.glsl
uniform bool uHistoryValid;

in vec2 uv;
layout(location = 0) out vec4 accumulated;  // rgb mean radiance, a frames, negative where the image has changed
layout(location = 1) out vec4 moments;      // x mean squared luminance, y radius over which the lobe blurs, pixels

const float kMaxFrames = 24.0;
const vec2 kGlossy = vec2(0.03, 0.12);  // roughness between which histories grow from none to kMaxFrames
const float kDeviations = 1.0;          // of the neighbours, beyond which history is clamped
const float kTolerance = 0.05;          // relative, of the same

/// Mean and deviation of the radiance of the 3x3 pixels around, and the harmonic mean of their hit distances, by which
/// an image's parallax is a mean: the sky beside something near hardly counts.
struct Around {
    vec3 mean, deviation;
    float metres;
};

Around gatherAround(ivec2 pixel) {
    ivec2 high = ivec2(frame.targetSize.xy) - 1;
    vec3 sum = vec3(0.0), squares = vec3(0.0);
    float inverses = 0.0, count = 0.0;
    int i = loopBegin();
    do {
        vec4 there = texelFetch(uNoisyReflection, clamp(pixel + ivec2(i % 3, i / 3) - 1, ivec2(0), high), 0);
        float counts = step(1e-6, there.a);
        sum += counts * there.rgb;
        squares += counts * there.rgb * there.rgb;
        inverses += counts / max(there.a, 1e-3);
        count += counts;
    } while (++i < 9);
    vec3 mean = sum / max(count, 1.0);
    return Around(mean, sqrt(max(squares / max(count, 1.0) - mean * mean, vec3(0.0))), count / max(inverses, 1e-6));
}

/// Where the previous frame shows what this mirror shows: xy uv, z linear depth of the mirror there; z below 0:
/// nowhere.
vec3 lastPlace(Mirror m, Surface s, float metres) {
    if (s.moving > 0.0)
        return vec3(uv - texelFetch(uMotion, ivec2(gl_FragCoord.xy), 0).rg, previousDepth(m.position));
    float alpha = ggxAlpha(m.roughness), smoothness = 1.0 - alpha, dominance = smoothness * (sqrt(smoothness) + alpha);
    vec3 image = m.position - m.view * (metres * dominance), eye = previousEyeOf(image), toImage = image - eye;
    float toPlane = dot(m.normal, m.position - eye), along = dot(m.normal, toImage);
    if (toPlane >= 0.0 || along >= 0.0) return vec3(-1.0);
    vec3 place = eye + toImage * (toPlane / along);
    vec4 clip = frame.previousViewProjection * vec4(place, 1.0);
    return vec3(clip.xy / max(clip.w, 1e-4) * 0.5 + 0.5, previousDepth(place));
}

/// The history of four pixels that show the same mirror. Their alpha is 0 if there is none.
vec4 reprojectHistory(Mirror m, Surface s, vec3 last, out vec4 lastMoments) {
    lastMoments = vec4(0.0);
    if (last.z < 0.0 || last.xy != clamp(last.xy, vec2(0.0), vec2(0.9999))) return vec4(0.0);
    float tolerance = depthTolerance(m.position, m.normal, s.depth) + s.moving * 0.5;
    Taps taps = tapsAt(last.xy);
    vec4 sum = vec4(0.0);
    float total = 0.0;
    int i = loopBegin();
    do {
        ivec2 p;
        float w = tapWeight(taps, i, p);
        vec4 surface = texelFetch(uSurfaceHistory, p, 0), there = texelFetch(uReflectionHistory, p, 0);
        there.a = abs(there.a);
        if (there.a > 0.0 && abs(surface.x - last.z) <= tolerance && dot(unpackNormal(surface.y), m.normal) >= 0.98) {
            sum += w * there;
            lastMoments += w * texelFetch(uMomentHistory, p, 0);
            total += w;
        }
    } while (++i < taps.count);
    if (total < 0.01) return vec4(0.0);
    lastMoments /= total;
    return sum / total;
}

/// The frames of history that are left to a mirror. seen: the place that it shows, of this luminance.
float framesLeft(Mirror m, vec3 seen, float lum);
/// Whether a mirror is known to show something else than in the previous frame. metres: to what it shows.
bool isImageChanged(Mirror m, float metres);

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 now = texelFetch(uNoisyReflection, pixel, 0);
    Surface s = readSurface(pixel);
    Mirror m = mirrorAt(pixel, uv);
    float lum = luminance(now.rgb);
    float sign_ = now.a > 0.0 && isImageChanged(m, now.a) ? -1.0 : 1.0;
    accumulated = vec4(now.rgb, sign_);
    moments = vec4(min(lum * lum, 6e4), 0.0, 0.0, 1.0);
    if (m.roughness <= kGlossy.x) return;
    Around around = gatherAround(pixel);
    float range = max(length(m.position - frame.cameraPosition.xyz), 1e-3);
    float parallax = isOrthographic() ? around.metres : around.metres / (range + around.metres);
    moments.y = min(m.roughness * m.roughness * parallax / pixelMetres(1.0), 64.0);
    vec4 lastMoments,
        history = uHistoryValid ? reprojectHistory(m, s, lastPlace(m, s, around.metres), lastMoments) : vec4(0.0);
    if (history.a <= 0.0) return;
    vec3 room = kDeviations * around.deviation + kTolerance * around.mean;
    history.rgb = clamp(history.rgb, around.mean - room, around.mean + room);
    float limit = mix(1.0, kMaxFrames, smoothstep(kGlossy.x, kGlossy.y, m.roughness));
    vec3 seen = m.position + reflect(-m.view, m.normal) * around.metres;
    float frames = min(min(history.a, framesLeft(m, seen, luminance(history.rgb))) + 1.0, limit);
    accumulated = stochasticRoundToHalf(vec4(mix(history.rgb, now.rgb, 1.0 / frames), 0.0), pixel, 8);
    accumulated.a = frames * sign_;
    moments.x = mix(lastMoments.x, moments.x, 1.0 / frames);
}
