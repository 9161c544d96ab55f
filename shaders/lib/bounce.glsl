// What a ray sees where it meets the world: the lit colour if the last picture shows that place, else an estimate.
// Needs lib/frame, gbuffer, sky, shadow_trace.
#include "lib/surface_history.glsl"
uniform sampler2D uLastRadiance;  // last frame's picture before post-processing
uniform sampler2D uLastSurface;   // lib/surface_history.glsl
uniform bool uLastValid;
uniform bool uSunUp;
uniform bool uBounce;

const float kEdge = 0.15;         // of the picture's half width and height: how far the trust in it takes to grow
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
/// glow: the share that counts of voxels that shine: what the rays to their lamp bring must not come a second time.
/// a: 0 where it is not shown, 1 where it is, less toward the picture's edge.
vec4 radianceOnScreen(vec3 hitWorld, vec3 normal, float glow) {
    if (!uLastValid) return vec4(0.0);
    vec4 clip = frame.previousViewProjection * vec4(hitWorld, 1.0);
    if (clip.w < 0.1 || any(greaterThanEqual(abs(clip.xy), vec2(clip.w)))) return vec4(0.0);
    ivec2 pixel = ivec2((clip.xy / clip.w * 0.5 + 0.5) * frame.targetSize.xy);
    vec3 surface = texelFetch(uLastSurface, pixel, 0).xyw;
    if (abs(surface.x - clip.w) > 0.12 + 0.01 * clip.w || dot(unpackNormal(surface.y), normal) < 0.6) return vec4(0.0);
    // Without the air between the eye and the place: it does not light a closed room. Bright dots met by few rays would speckle.
    vec3 fromEye = hitWorld - frame.cameraPosition.xyz;
    float range = length(fromEye);
    float haze = hazeAmount(range);
    if (haze >= 0.9) return vec4(0.0);
    vec3 radiance = texelFetch(uLastRadiance, pixel, 0).rgb - hazeRadiance(fromEye / max(range, 1e-3)) * haze;
    vec2 fromEdge = (1.0 - abs(clip.xy / clip.w)) / kEdge;
    float counted = surface.z < 0.0 && frame.counters.z > 0 ? glow : 1.0;
    return vec4(clamp(radiance / (1.0 - haze), vec3(0.0), vec3(3.0)) * counted, clamp(min(fromEdge.x, fromEdge.y), 1e-3, 1.0));
}

/// Mean radiance on a face that no picture shows: the sun's, and as much of the rest as there is where the ray started. That is right
/// in the long run inside a room, where it sums up all bounces, and zero in a closed one.
vec3 unseenLight(vec3 hitWorld, vec3 normal, vec3 lightHere) {
    vec3 light = 0.9 * lightHere;
    float facing = dot(normal, frame.sunDirection.xyz);
    float t;
    if (uSunUp && facing > 0.0 && !shadowTrace(shadowOrigin(hitWorld, normal), frame.sunDirection.xyz, 64.0, t))
        light += frame.sunColor.rgb * (facing / 3.14159265);
    return light;
}

/// What a ray of rough light meets. lightHere: mean radiance where it started.
vec3 bounceRadiance(vec3 hitWorld, vec3 direction, vec3 lightHere) {
    if (!uBounce) return vec3(0.0);
    vec3 normal = faceNormal(hitWorld, direction);
    vec4 seen = radianceOnScreen(hitWorld, normal, 0.0);
    if (seen.a > 0.0) return seen.rgb;
    return unseenLight(hitWorld, normal, lightHere) * kBounceAlbedo;
}
