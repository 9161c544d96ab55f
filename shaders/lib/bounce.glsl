// What a ray sees where it meets the world: the lit colour if the last picture shows that place, else an estimate.
// Needs lib/frame, gbuffer, sky, shadow_trace.
#include "lib/surface_history.glsl"
uniform sampler2D uLastRadiance;  // last frame's picture before post-processing
uniform sampler2D uLastSurface;   // lib/surface_history.glsl
uniform bool uLastValid;
uniform bool uSunUp;
uniform bool uBounce;

const float kBounceAlbedo = 0.3;  // of what no picture shows: the mean of the town
const float kShadowCellMetres = 0.1;

/// The cell face that a ray has come through at a point on the shadow volume's cells.
vec3 faceNormal(vec3 hitWorld, vec3 direction) {
    vec3 fromEdge = abs(fract(hitWorld / kShadowCellMetres + 0.5) - 0.5);
    // An axis along which the ray hardly moves cannot have been entered.
    fromEdge += 1.0 - step(0.02, abs(direction));
    if (fromEdge.x <= fromEdge.y && fromEdge.x <= fromEdge.z) return vec3(-sign(direction.x), 0, 0);
    if (fromEdge.y <= fromEdge.z) return vec3(0, -sign(direction.y), 0);
    return vec3(0, 0, -sign(direction.z));
}

/// normal: of the face that was hit. What the picture shows there must face the same way: the far side of a thin wall is another place.
bool radianceOnScreen(vec3 hitWorld, vec3 normal, out vec3 radiance) {
    radiance = vec3(0.0);
    if (!uLastValid) return false;
    vec4 clip = frame.previousViewProjection * vec4(hitWorld, 1.0);
    if (clip.w < 0.1 || any(greaterThan(abs(clip.xy), vec2(clip.w)))) return false;
    ivec2 pixel = ivec2((clip.xy / clip.w * 0.5 + 0.5) * frame.targetSize.xy);
    vec2 surface = texelFetch(uLastSurface, pixel, 0).xy;
    if (abs(surface.x - clip.w) > 0.12 + 0.01 * clip.w || dot(unpackNormal(surface.y), normal) < 0.6) return false;
    // Without the air between the eye and the place: it does not light a closed room. Bright dots met by few rays would speckle.
    vec3 fromEye = hitWorld - frame.cameraPosition.xyz;
    float range = length(fromEye);
    float haze = hazeAmount(range);
    radiance = texelFetch(uLastRadiance, pixel, 0).rgb - hazeRadiance(fromEye / max(range, 1e-3)) * haze;
    radiance = clamp(radiance / (1.0 - haze), vec3(0.0), vec3(3.0));
    return haze < 0.9;
}

/// lightHere: mean radiance where the ray started. A hit that no picture shows is taken to be lit as much: right in the long
/// run inside a room, where it sums up all bounces, and zero in a closed one.
vec3 bounceRadiance(vec3 hitWorld, vec3 direction, vec3 lightHere) {
    vec3 radiance;
    if (!uBounce) return vec3(0.0);
    vec3 normal = faceNormal(hitWorld, direction);
    if (radianceOnScreen(hitWorld, normal, radiance)) return radiance;
    vec3 irradiance = 0.9 * lightHere;
    float facing = dot(normal, frame.sunDirection.xyz);
    float t;
    if (uSunUp && facing > 0.0 && !shadowTrace(shadowOrigin(hitWorld, normal), frame.sunDirection.xyz, 64.0, t))
        irradiance += frame.sunColor.rgb * (facing / 3.14159265);
    return irradiance * kBounceAlbedo;
}
