// Fog that is thickest at its base and thins with height, so that how much of it lies along a ray has a closed form.
// frame.fog: x share taken in a metre at the base, y height of the base, z metres for 1/e, w mean cosine of scattering.
#include "lib/frame.glsl"

const float kMaxFogDistance = 400.0;  // metres: beyond it fog hides nothing that haze does not

float fogDensity(float height) { return frame.fog.x * exp(clamp((frame.fog.y - height) / frame.fog.z, -60.0, 4.0)); }

/// Optical depth of the first metres of a ray from the eye; directionY: its direction's y.
float fogOpticalDepth(float directionY, float metres) {
    float density = fogDensity(frame.cameraPosition.y), k = directionY / frame.fog.z;
    return density * (abs(k) * metres < 1e-3 ? metres : (1.0 - exp(clamp(-k * metres, -60.0, 30.0))) / k);
}

/// How far along the ray that optical depth lies.
float fogDistance(float directionY, float opticalDepth) {
    float density = max(fogDensity(frame.cameraPosition.y), 1e-9), k = directionY / frame.fog.z, straight = opticalDepth / density;
    return abs(k) * straight < 1e-3 ? straight : -log(max(1.0 - k * straight, 1e-6)) / k;
}

/// Share of the light a steradian that goes on at this cosine to where it came from (Henyey and Greenstein 1941).
float henyeyGreenstein(float cosine) {
    float g = frame.fog.w, a = 1.0 + g * g - 2.0 * g * cosine;
    return (1.0 - g * g) / (4.0 * 3.14159265 * a * sqrt(a));
}
