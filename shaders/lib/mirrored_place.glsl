// What a mirror shows of a place: the lit colour if the last picture shows it, else its voxel's own colour in the light of sun and sky.
// Needs what lib/bounce needs, and that.
#include "lib/voxel_walk.glsl"
#include "lib/paint.glsl"
#include "lib/voxel_at.glsl"

/// Light that the voxel behind a face gives back and its own. glow: see lib/bounce.
vec3 unseenRadiance(vec3 hitWorld, vec3 normal, vec3 direction, vec3 lightHere, float glow) {
    vec3 light = unseenLight(hitWorld, normal, lightHere);
    // The cell that was met has its middle in the voxel. What moves is drawn between two steps and may be a little farther on.
    vec3 middle = (floor((hitWorld - normal * (0.5 * kShadowCellMetres)) / kShadowCellMetres) + 0.5) * kShadowCellMetres;
    Entry entry;
    bool found = voxelAt(middle, entry);
    if (!found) found = voxelAt(middle + direction * kShadowCellMetres, entry);
    if (!found) return light * kBounceAlbedo;
    vec3 albedo = srgbToLinear(entry.color);
    return albedo * light + min(albedo * entry.emission, vec3(3.0)) * (frame.counters.z > 0 ? glow : 1.0);
}

vec3 mirroredRadiance(vec3 hitWorld, vec3 direction, vec3 lightHere, float glow) {
    if (!uBounce) return vec3(0.0);
    vec3 normal = faceNormal(hitWorld, direction);
    vec4 seen = radianceOnScreen(hitWorld, normal, glow);
    if (seen.a == 1.0) return seen.rgb;
    return mix(unseenRadiance(hitWorld, normal, direction, lightHere, glow), seen.rgb, seen.a);
}
