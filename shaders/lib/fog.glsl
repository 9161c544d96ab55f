// Fog whose density falls exponentially with height: s(y) = s0 exp((base - y) / h). Extinction s0, base, scale height h
// and mean cosine of scattering are the components of the frame's fog.
//
// Along a ray that begins at the height y0 with direction d the density is s(y0) exp(-k t), k = d.y / h. So the optical
// depth of its first t metres has a closed form, and so has its inverse, by which distances are drawn:
//   tau(t) = s(y0) (1 - exp(-k t)) / k        t(tau) = -log(1 - k tau / s(y0)) / k
// Both go over into tau = s(y0) t where k is near 0. Transmittance is exp(-tau) (Beer-Lambert).
#include "lib/constants.glsl"
#include "lib/frame.glsl"

const float kMaxFogDistance = 400.0;  // metres: beyond it the haze hides everything

/// Extinction at a height, 1 / m.
float fogDensity(float height) { return frame.fog.x * exp(clamp((frame.fog.y - height) / frame.fog.z, -60.0, 4.0)); }

/// Optical depth of the first metres of a camera ray that begins at a height.
float fogOpticalDepth(float startY, float directionY, float metres) {
    float density = fogDensity(startY), k = directionY / frame.fog.z;
    return density * (abs(k) * metres < 1e-3 ? metres : (1.0 - exp(clamp(-k * metres, -60.0, 30.0))) / k);
}

/// Distance along such a ray at which it has an optical depth, metres.
float fogDistance(float startY, float directionY, float opticalDepth) {
    float density = max(fogDensity(startY), 1e-9), k = directionY / frame.fog.z, straight = opticalDepth / density;
    return abs(k) * straight < 1e-3 ? straight : -log(max(1.0 - k * straight, 1e-6)) / k;
}

/// The phase function of Henyey and Greenstein (1941), 1 / sr. cosine: between the ray and the direction to the light.
float henyeyGreenstein(float cosine) {
    float g = frame.fog.w, a = 1.0 + g * g - 2.0 * g * cosine;
    return (1.0 - g * g) / (4.0 * kPi * a * sqrt(a));
}

/// What a ray that leaves a mirror or water brings through the fog on its way. No rays are traced in it: it scatters
/// the mean radiance `around`, and the sun's light where that is not in shadow.
vec3 throughFog(vec3 radiance, vec3 start, vec3 direction, float metres, vec3 around, bool isSunlit) {
    float left = exp(-fogOpticalDepth(start.y, direction.y, min(metres, kMaxFogDistance)));
    float above = fogDensity(start.y) * frame.fog.z / max(frame.sunDirection.y, 0.05);
    float sun = isSunlit ? henyeyGreenstein(dot(direction, frame.sunDirection.xyz)) * exp(-above) : 0.0;
    return mix((around + frame.sunColor.rgb * sun) * frame.fogTint.rgb, radiance, left);
}
/// The same of a ray that leaves the level: the fog is lit by all of the sky.
vec3 throughOpenFog(vec3 background, vec3 start, vec3 direction, bool isSunUp) {
    // Its mean over all directions, by skyRadiance().
    vec3 sky = mix(mix(frame.horizonColor.rgb, frame.skyColor.rgb, 0.8), frame.groundColor.rgb, 0.5);
    return throughFog(background, start, direction, kMaxFogDistance, sky, isSunUp);
}
