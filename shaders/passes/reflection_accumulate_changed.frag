// Temporal accumulation of mirror rays (lib/reflection_history.glsl) where something is known to have changed. History
// is shortened where a mirror shows a place whose light has changed, and dropped where it shows one through voxels that
// have changed.
#include "lib/reflection_history.glsl"
#include "lib/known_changes.glsl"

float framesLeft(Mirror m, vec3 seen, float lum) {
    if (meetsChange(m.position, seen - m.position, ggxAlpha(m.roughness))) return 0.0;
    return historyLeftAt(seen, lum) * uMaxHistory;
}

/// Whether its ray, or one within a pixel beside it, passes through changed voxels.
bool isImageChanged(Mirror m, float metres) {
    float range = isOrthographic() ? 0.0 : length(m.position - frame.cameraPosition.xyz);
    float pixels = 2.0 * pixelMetres(1.0) * (range + metres) / max(metres, 1e-3);
    return meetsChange(m.position, reflect(-m.view, m.normal) * metres, max(ggxAlpha(m.roughness), pixels));
}
