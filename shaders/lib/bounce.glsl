// What a ray sees where it meets the world: the lit colour if the last picture shows that place, else an estimate.
// Needs lib/frame, gbuffer, sky, shadow_trace.
uniform sampler2D uLastRadiance;  // last frame's picture before post-processing
uniform sampler2D uLastSurface;   // x linear depth
uniform bool uLastValid;
uniform bool uSunUp;

const float kBounceAlbedo = 0.32;
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

bool radianceOnScreen(vec3 hitWorld, out vec3 radiance) {
    radiance = vec3(0.0);
    if (!uLastValid) return false;
    vec4 clip = frame.previousViewProjection * vec4(hitWorld, 1.0);
    if (clip.w < 0.1 || any(greaterThan(abs(clip.xy), vec2(clip.w)))) return false;
    ivec2 pixel = ivec2((clip.xy / clip.w * 0.5 + 0.5) * frame.targetSize.xy);
    float depth = texelFetch(uLastSurface, pixel, 0).x;
    if (abs(depth - clip.w) > 0.12 + 0.01 * clip.w) return false;
    radiance = min(texelFetch(uLastRadiance, pixel, 0).rgb, vec3(6.0));
    return true;
}

vec3 bounceRadiance(vec3 hitWorld, vec3 direction) {
    vec3 radiance;
    if (radianceOnScreen(hitWorld, radiance)) return radiance;
    vec3 normal = faceNormal(hitWorld, direction);
    // The sky is seen by half of what a hit's hemisphere holds, at best; inside houses by far less. A small share keeps shade readable.
    vec3 irradiance = 0.10 * mix(frame.groundColor.rgb, frame.skyColor.rgb, 0.5 + 0.5 * normal.y);
    float facing = dot(normal, frame.sunDirection.xyz);
    float t;
    if (uSunUp && facing > 0.0 && !shadowTrace(shadowOrigin(hitWorld, normal), frame.sunDirection.xyz, 64.0, t))
        irradiance += frame.sunColor.rgb * (facing / 3.14159265);
    return irradiance * kBounceAlbedo;
}
