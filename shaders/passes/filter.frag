// One pass of an edge-avoiding a-trous wavelet filter on light (Dammertz et al. 2010; guided by variance as in SVGF,
// Schied et al. 2017). With holes between its taps that grow from pass to pass, a filter of five taps reaches far.
//
// A pass adds to a pixel p the weighted differences of its four neighbours q at the stride:
//   L'(p) = L(p) + sum_q w(p, q) (L(q) - L(p)),   w = w_plane w_light w_proximity / (1.5 + 4)
//   w_plane      1 - height of q over p's plane / scale, and 0 for another normal (voxels have few: they are equal)
//   w_light      biweight of the difference of luminance in standard deviations, which stops at edges of light
//   w_proximity  biweight of the difference of hit proximity, which stops at creases that hide the sky
// The deviation comes from the moments over time (Schied), or from those of the neighbours while history is short. The
// sum above, instead of a normalised mean, makes w(p, q) nearly equal w(q, p): what p takes from q, q takes from p. So
// light is moved and hardly any is lost, and a constant stays constant. Taps lie on rows and columns or on diagonals by
// turns.
#include "lib/frame.glsl"
#include "lib/color.glsl"
#include "lib/noise.glsl"
#include "lib/half.glsl"
#include "lib/surface_history.glsl"
#include "lib/atrous.glsl"

uniform sampler2D uLight;    // rgb light, a share of the sun
uniform sampler2D uSurface;  // lib/surface_history.glsl
uniform int uStride;         // pixels
uniform bool uDiagonal;
uniform float uSunRays;    // a pixel and frame
uniform float uSunFrames;  // of which the mean of the sun's visibility is made, at most

in vec2 uv;
out vec4 filtered;

const int kTaps = 5;  // the first is the pixel itself
const float kCentreWeight = 1.5;
const float kLongHistory = 12.0;                   // frames
const float kFewFrames = 12.0, kManyFrames = 24.0;  // between which the moments over time get to say what noise is left
const float kMinDifference = 0.025;                // of two pixels, relative to their sum, that always counts as noise
const float kNoiseShare = 0.64;                    // of the variance between neighbours at a stride of 1
const float kLowNoise = 0.10;                      // relative standard deviation of the accumulated light
// Deviation of one sample of hit proximity, relative to the largest that a number in [0, 1] with its mean can have.
// Where light is far noisier than a hidden sky makes it, few rays meet what is bright. It is near, and the rest is not:
// both are noisy alike, and what stops at one keeps the noise of the other.
const float kProximityDeviation = 0.3, kNoisyProximityDeviation = 1.0;
const vec2 kNoisyLight = vec2(15.0, 45.0);  // variances over that of a hidden sky between which that changes

/// Biweight of the difference of hit proximity of two pixels; a, b: their frames and proximity, as in the target
/// "surface". The deviation is that of both, so that one takes what the other gives: one of whose rays none has hit
/// would take nothing by its own. Early samples say little about it. lightNoise: the relative standard deviation of the
/// accumulated light.
float proximityWeight(float a, float b, float lightNoise) {
    float frames = max(0.5 * (floor(a) + floor(b)), 1.0), mean = 0.5 * (fract(a) + fract(b));
    float excess = lightNoise * lightNoise * frames * (1.0 - mean) / (mean + 0.05);
    float share = mix(kProximityDeviation, kNoisyProximityDeviation, smoothstep(kNoisyLight.x, kNoisyLight.y, excess));
    float deviation = mix(1.0, share * sqrt(mean * (1.0 - mean)), clamp((frames - 1.0) / 4.0, 0.0, 1.0));
    return biweight((fract(a) - fract(b)) / (2.0 * deviation * inversesqrt(frames) + 0.03));
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ivec2 high = ivec2(frame.targetSize.xy) - 1;
    vec4 centre = texelFetch(uSurface, pixel, 0);
    vec4 centreLight = texelFetch(uLight, pixel, 0);
    // Wide strides are for pixels with a short history or with noise in spite of it: they blur detail that time keeps.
    float centreSquared = luminance(centreLight.rgb) * luminance(centreLight.rgb);
    bool isLowNoise = centre.w - centreSquared < kLowNoise * kLowNoise * centreSquared * centre.z;
    if (uStride > 2 && centre.z >= kLongHistory && isLowNoise) {
        filtered = centreLight;
        return;
    }
    Plane plane = planeOf(uv, centre);
    vec4 lights[kTaps];
    float lums[kTaps], weights[kTaps], proximities[kTaps];
    float sun = 0.0, total = 0.0, lum = 0.0, squares = 0.0, temporal = 0.0;
    for (int i = 0; i < kTaps; ++i) {
        ivec2 p = clamp(pixel + tapOffset(i, uDiagonal) * uStride, ivec2(0), high);
        vec4 there = i == 0 ? centre : texelFetch(uSurface, p, 0);
        float w = i == 0 ? kCentreWeight : there.y == centre.y ? planeWeight(plane, vec2(p - pixel), there.x) : 0.0;
        proximities[i] = there.z;
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
    // Standard deviation of the accumulated light. The moments over time are averaged over the taps too, as a few
    // samples of one pixel may agree by chance.
    float centreLum = lums[0];
    // Neighbours differ by slopes of light too, and the wider the taps the more: the wide steps would level them.
    float spatial = kNoiseShare / float(max(uStride, 1)) * max(squares / total - lum * lum, 0.0);
    // The moments are those of unfiltered light. Each pass leaves about a quarter of the variance.
    temporal *= mix(1.0, 1.0 / float(max(uStride * uStride, 1)), smoothstep(kFewFrames, kManyFrames, centre.z)) / total;
    float skyDeviation = sqrt(mix(spatial, temporal, clamp((centre.z - 3.0) / 6.0, 0.0, 1.0)));
    float sunDeviation = sqrt(max(sun * (1.0 - sun), 1e-6) / max(uSunRays * min(centre.z, uSunFrames), 1.0));
    // Noise of few rays that meet what is bright: the variance of a pair is in proportion to its mean.
    float pairDeviation = 2.0 * skyDeviation * sqrt(2.0 / max(lum, 1e-5));
    // The sun is noisy in narrow penumbras only: wide strides would soften shadows.
    float sunScale = uStride > 1 ? 1e4 : 1.0 / (1.5 * sunDeviation + 0.004);
    float lightNoise = skyDeviation / max(lum, 1e-5);
    filtered = centreLight;
    for (int i = 1; i < kTaps; ++i) {
        float pair = lums[i] + centreLum, deviation = pairDeviation * sqrt(pair) + kMinDifference * pair + 1e-4;
        float sky = biweight((lums[i] - centreLum) / deviation);
        float w = weights[i] / (kCentreWeight + float(kTaps - 1));
        sky *= proximityWeight(centre.z, proximities[i], lightNoise);
        filtered +=
            (lights[i] - centreLight) * vec2(w * sky, w * biweight((lights[i].a - centreLight.a) * sunScale)).xxxy;
    }
    filtered = stochasticRoundToHalf(filtered, pixel, uStride);
}
