// How much history is left to each pixel of the previous frame, where something is known to have changed since then
// (lib/known_changes.glsl). Drawn only where there is such a change: the passes that read it (lib/history_left.glsl)
// then pay one fetch, in place of loops over the changes. Sky rays and mirror rays ask at their hits, as far as the
// previous frame shows them.
#include "lib/frame.glsl"
#include "lib/color.glsl"
#include "lib/known_changes.glsl"
#include "lib/change_rays.glsl"

uniform sampler2D uSurfaceHistory;          // lib/surface_history.glsl
uniform sampler2D uLightHistory;            // accumulated light
uniform sampler2D uRadianceHistory;         // the previous frame before post-processing
uniform sampler2D uDiffuseFractionHistory;  // passes/composite.frag

in vec2 uv;
/// x after the changes since the previous frame, for the history as it is; y after those and after lights that changed
/// in the frame before, for the history that passes/accumulate.frag makes that of the lights of now; z share by which
/// the radiance counts as radiance of this frame; w flags / 3: 1 the sun may be seen through changed voxels, 2
/// kRaysAfterChange rays are to be sent.
out vec4 historyLeft;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 surface = texelFetch(uSurfaceHistory, pixel, 0);
    historyLeft = vec4(1.0, 1.0, 1.0, 0.0);
    if (surface.x >= kSkyDepth) return;
    vec3 position = previousWorldFromDepth(uv, surface.x);
    float light = luminance(texelFetch(uLightHistory, pixel, 0).rgb), voxels = historyNearVoxels(position);
    float known = min(voxels, min(historyNearLooks(position, 0), historyLeftAfter(uSkylightChange)));
    float knownLately = min(voxels, min(historyNearLooks(position, 1), historyLeftAfter(uLateSkylightChange)));
    float radiance = luminance(halfRange(texelFetch(uRadianceHistory, pixel, 0).rgb)) *
                     texelFetch(uDiffuseFractionHistory, pixel, 0).x;
    vec3 shadows = changeByShadows(position), now = changeByLights(position, 0, uNewLightTexels),
         before = changeByLights(position, uNewLightTexels, uChangedLightTexels);
    historyLeft.x = min(known, historyLeftAfter(shadows + now, light));
    vec3 unknown = uUnknownShare.x * now + uUnknownShare.y * before;
    historyLeft.y = min(knownLately, historyLeftAfter(shadows + unknown, light));
    historyLeft.z = countsOfPreviousFrame(min(known, historyLeftAfter(shadows + now, radiance)) * uMaxHistory);
    float leftLately = min(knownLately, historyLeftAfter(shadows + now + before, light));
    bool hasMoreRays = raysAt(floor(surface.z), historyLeft.x, leftLately, uv) > 1;
    historyLeft.w = (hasMoreRays ? 2.0 / 3.0 : 0.0) + (isSunSeenThroughChange(position) ? 1.0 / 3.0 : 0.0);
}
