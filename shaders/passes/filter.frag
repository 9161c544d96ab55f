// One step of an edge-stopping a-trous filter on light (Dammertz et al. 2010; variance guidance after Schied et al. 2017):
// five taps, at a stride along the rows and columns or along the diagonals by turns, each weighted by plane distance and by how far its light differs from the centre's in standard
// deviations; only taps of the same orientation count, which for voxels is the same number. What one pixel takes of its neighbour the
// neighbour takes of it, as far as both see the same deviation: light is moved, and hardly any is lost. A constant stays itself.
#include "lib/frame.glsl"
#include "lib/color.glsl"
#include "lib/noise.glsl"
#include "lib/half.glsl"
#include "lib/surface_history.glsl"

uniform sampler2D uLight;
uniform sampler2D uSurface;   // lib/surface_history.glsl
uniform int uStride;
uniform bool uDiagonal;
uniform float uSunRays;

in vec2 uv;
out vec4 filtered;

const int kTaps = 5;  // the first is the pixel itself
const float kCentreWeight = 1.5;
const float kLongHistory = 12.0;  // frames
const float kLowNoise = 0.10;     // deviation of what is accumulated, as a share of it
const float kProximityDeviation = 0.3;  // one sample of it, times the most that a number from 0 to 1 of its mean can; the first ones tell little

/// 1 for no difference, 0 from twice the scale on: a biweight without an exponential.
float biweight(float x) {
    float y = max(0.0, 1.0 - 0.25 * x * x);
    return y * y;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ivec2 high = ivec2(frame.targetSize.xy) - 1;
    vec4 centre = texelFetch(uSurface, pixel, 0);
    float frames = floor(centre.z), hitProximity = fract(centre.z);
    float proximityDeviation = mix(1.0, kProximityDeviation * sqrt(hitProximity * (1.0 - hitProximity)), clamp((frames - 1.0) / 4.0, 0.0, 1.0));
    float proximityScale = 1.0 / (2.0 * proximityDeviation * inversesqrt(max(frames, 1.0)) + 0.03);
    vec4 centreLight = texelFetch(uLight, pixel, 0);
    // Wide steps are for places without a past, or that are noisy in spite of it: they cost detail that time keeps.
    float centreSquared = luminance(centreLight.rgb) * luminance(centreLight.rgb);
    bool isLowNoise = centre.w - centreSquared < kLowNoise * kLowNoise * centreSquared * centre.z;
    if (uStride > 2 && centre.z >= kLongHistory && isLowNoise) {
        filtered = centreLight;
        return;
    }
    vec3 normal = unpackNormal(centre.y);
    // Height of a tap over the centre's plane = dot(normal, ray) x depth - centreLight height, and dot(normal, ray) is linear in pixels.
    float facing = dot(normal, viewRay(uv));
    float facingX = dot(normal, frame.cameraRight.xyz) * 2.0 * frame.cameraRight.w * frame.targetSize.z;
    float facingY = dot(normal, frame.cameraUp.xyz) * 2.0 * frame.cameraUp.w * frame.targetSize.w;
    float planeScale = 1.0 / (0.01 + 0.0015 * centre.x);

    vec4 lights[kTaps];
    float lums[kTaps];
    float weights[kTaps];
    float proximityWeights[kTaps];
    float sun = 0.0, total = 0.0, lum = 0.0, squares = 0.0, temporal = 0.0;
    for (int i = 0; i < kTaps; ++i) {
        ivec2 offset = ivec2(i == 1 ? 1 : i == 2 ? -1 : 0, i == 3 ? 1 : i == 4 ? -1 : 0);
        if (uDiagonal) offset = ivec2(offset.x + offset.y, offset.x - offset.y);
        ivec2 p = clamp(pixel + offset * uStride, ivec2(0), high);
        vec4 there = i == 0 ? centre : texelFetch(uSurface, p, 0);
        vec2 away = vec2(p - pixel);
        float height = (facing + facingX * away.x + facingY * away.y) * there.x - facing * centre.x;
        float w = i == 0 ? kCentreWeight : there.y == centre.y ? max(0.0, 1.0 - abs(height) * planeScale) : 0.0;
        proximityWeights[i] = biweight((fract(there.z) - hitProximity) * proximityScale);
        vec4 light = i == 0 ? centreLight : texelFetch(uLight, p, 0);
        float l = luminance(light.rgb);
        weights[i] = w;
        lights[i] = light;
        lums[i] = l;
        sun += w * light.a;
        lum += w * l;
        squares += w * l * l;
        temporal += w * max(there.w - l * l, 0.0) / max(there.z, 1.0);
        total += w;
    }
    sun /= total;
    lum /= total;
    // Deviation of the accumulated value: from moments over time once there are some (of the neighbours too: one pixel's centreLight
    // few samples may agree by chance), else from how the neighbours differ.
    float centreLum = lums[0];
    float spatial = max(squares / total - lum * lum, 0.0);
    float skyDeviation = sqrt(mix(spatial, temporal / total, clamp((centre.z - 3.0) / 6.0, 0.0, 1.0)));
    float sunDeviation = sqrt(max(sun * (1.0 - sun), 1e-6) / max(uSunRays * centre.z, 1.0));
    // In shares of the pair's mean, so that both see the same difference.
    float skyShare = 2.0 * skyDeviation / max(lum, 1e-5) + 0.025;
    // The sun's noise lies in narrow penumbras: wide steps would only soften shadows.
    float sunScale = uStride > 1 ? 1e4 : 1.0 / (1.5 * sunDeviation + 0.004);

    filtered = centreLight;
    for (int i = 1; i < kTaps; ++i) {
        float sky = biweight((lums[i] - centreLum) / (skyShare * (lums[i] + centreLum) + 1e-4));
        float w = weights[i] / (kCentreWeight + float(kTaps - 1));
        sky *= proximityWeights[i];
        filtered += (lights[i] - centreLight) * vec2(w * sky, w * biweight((lights[i].a - centreLight.a) * sunScale)).xxxy;
    }
    filtered = stochasticRoundToHalf(filtered, pixel, uStride);
}
