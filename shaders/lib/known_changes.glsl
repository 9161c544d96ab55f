// What the engine knows to have changed since the previous frame, and how much history is left where it has: a share of
// uMaxHistory frames, 1 where nothing has. (Set by render/passes/known_changes.cpp.) For the few passes that must ask
// at places of their own; the others read what passes/history_left.frag has found (lib/history_left.glsl).
//
// Let r be a change of light, relative to the light that a place had. n frames of old history then have an error of r,
// and n frames of samples with the deviation s one of s / sqrt(n). They are equal at n = (s / r)^2: that many are kept.
// Needs lib/frame, lib/color.
#include "lib/constants.glsl"

uniform int uDirtyCornerCount;
// Boxes in which voxels have changed, world: low corner, w square metres of the change as it is seen; high corner.
uniform vec4 uDirtyCorners[2 * kMaxDirtyRegions];
uniform int uChangedLightTexels;
uniform int uNewLightTexels;  // the first of them: changes since the previous frame; behind them older ones
// The share of a change of lights that stays in a history which was made that of the lights of now
// (passes/accumulate.frag): x of those since the previous frame, y in the frame before.
uniform vec2 uUnknownShare;
// Before and after by turns, each in three: xyz position, w reach; rgb intensity, w extent; angular falloff.
uniform vec4 uChangedLights[6 * kMaxLightChanges];
uniform int uShadowedLightTexels;
// Lights that changed voxels may have shadowed or let through, each in three as above.
uniform vec4 uShadowedLights[3 * kMaxLightChanges];
uniform int uLookCornerCount;
// Boxes in which shapes look different, world: low corner, w share of this frame in the mean of colours, at the least;
// high corner, w relative change since the previous frame, or less than 0: that of the frame before.
uniform vec4 uLookCorners[2 * kMaxLookChanges];
uniform float uLookEverywhere;      // the share in all places: sky and air look different
uniform float uSkylightChange;      // of light from sun and sky since the previous frame, relative
uniform float uLateSkylightChange;  // the largest of that and of frames before it that count
uniform float uMaxHistory;          // frames

const float kSampleDeviation = 0.25;  // s: of a sample of light after the spatial filter
const float kResetDistance = 1.2;     // metres around changed voxels within which all history is dropped, at most
const float kCompact = 0.3;           // share of a box that has changed, from which on it counts as changed as a whole
const float kReflected = 0.4;         // share of the light of a place that may come from one shape beside it
const float kMinFalloff = 0.1;        // share of a light's intensity that reaches places beside its beam, by bounces

float historyLeftAfter(float relativeChange) {
    float ratio = kSampleDeviation / max(relativeChange, 1e-4);
    return min(ratio * ratio / uMaxHistory, 1.0);
}

/// The share of a box that has changed, as it is seen from outside. halfDiagonal2: squared.
float changedShare(float area, float halfDiagonal2) {
    return min(area / halfDiagonal2, 1.0);
}

/// Around voxels that have changed: by the share of directions in which they are seen, squared, as little has changed
/// in most of a small box. Where pieces fly about in a large box, nobody knows which place in it is near one.
float historyNearVoxels(vec3 position) {
    float share = 0.0;
    int i = loopBegin();
    do {
        if (uDirtyCornerCount == 0) break;
        vec3 low = uDirtyCorners[i].xyz, high = uDirtyCorners[i + 1].xyz;
        vec3 outside = max(max(low - position, position - high), vec3(0.0)), away = 0.5 * (low + high) - position,
             halfSize = 0.5 * (high - low);
        float box2 = dot(halfSize, halfSize), changed = changedShare(uDirtyCorners[i].w, box2), area = changed * box2;
        if (changed > kCompact && dot(outside, outside) < min(area, kResetDistance * kResetDistance)) return 0.0;
        share += area / (max(dot(away, away), (1.0 - changed) * box2) + area);
    } while ((i += 2) < uDirtyCornerCount);
    return historyLeftAfter(share * share);
}

/// Around shapes that look different: what they reflect has changed. moments: 0 since the previous frame, 1 and in the
/// one before.
float historyNearLooks(vec3 position, int moments) {
    float left = 1.0;
    int i = loopBegin();
    do {
        if (uLookCornerCount == 0) break;
        vec3 low = uLookCorners[i].xyz, high = uLookCorners[i + 1].xyz;
        vec3 outside = max(max(low - position, position - high), vec3(0.0)), halfSize = 0.5 * (high - low);
        float radius2 = dot(halfSize, halfSize), share = radius2 / (dot(outside, outside) + radius2);
        float change = moments > 0 ? abs(uLookCorners[i + 1].w) : max(uLookCorners[i + 1].w, 0.0);
        left = min(left, historyLeftAfter(kReflected * share * share * change));
    } while ((i += 2) < uLookCornerCount);
    return left;
}

/// Share of this frame in the mean of colours, at the least, where a place is seen. through: also where boxes lie
/// before it, whose shapes may be of glass.
float newShareAt(vec3 position, bool through) {
    float share = uLookEverywhere;
    vec3 ray = isOrthographic() ? frame.viewMiddle.xyz * 1e4 : position - frame.cameraPosition.xyz;
    vec3 origin = through ? position - ray : position, inverse = 1.0 / (ray + vec3(equal(ray, vec3(0.0))) * 1e-6);
    float depth = viewDepth(position);
    int i = loopBegin();
    do {
        if (uLookCornerCount == 0) break;
        vec3 low = uLookCorners[i].xyz, high = uLookCorners[i + 1].xyz;
        // A pixel where the box is, which may lie far before the sky.
        float boxDepth = viewDepth(0.5 * (low + high)) + 0.5 * length(high - low);
        float margin = 0.02 + pixelMetres(clamp(boxDepth, 0.0, depth));
        vec3 a = (low - margin - origin) * inverse, b = (high + margin - origin) * inverse;
        vec3 enter = min(a, b), leave = max(a, b);
        float end = through ? 1.0 : 0.0;
        bool isMet = max(max(enter.x, enter.y), max(enter.z, 0.0)) <= min(min(leave.x, leave.y), min(leave.z, end));
        share = max(share, isMet ? uLookCorners[i].w : 0.0);
    } while ((i += 2) < uLookCornerCount);
    return share;
}

/// Whether a line from `origin` to origin + ray passes through changed voxels, or beside them within `margin`, the sine
/// of an angle.
bool meetsChange(vec3 origin, vec3 ray, float margin) {
    vec3 inverse = 1.0 / (ray + vec3(equal(ray, vec3(0.0))) * 1e-6);
    int i = loopBegin();
    do {
        if (uDirtyCornerCount == 0) break;
        vec3 low = uDirtyCorners[i].xyz - origin, high = uDirtyCorners[i + 1].xyz - origin;
        vec3 wider = vec3(margin * length(0.5 * (low + high)));
        vec3 a = (low - wider) * inverse, b = (high + wider) * inverse, enter = min(a, b), leave = max(a, b);
        if (max(max(enter.x, enter.y), max(enter.z, 0.0)) <= min(min(leave.x, leave.y), min(leave.z, 1.0))) return true;
    } while ((i += 2) < uDirtyCornerCount);
    return false;
}

/// About the irradiance that a light sends to a place, whichever way its surface faces. The light as in uChangedLights.
vec3 irradianceOf(vec4 place, vec4 color, vec4 falloff, vec3 position) {
    vec3 away = position - place.xyz;
    float range = max(length(away), max(color.w, 0.05)), far = range / place.w;
    float window = max(1.0 - far * far * far * far, 0.0);
    float beam = clamp(dot(away / range, falloff.xyz) + falloff.w, 0.0, 1.0);
    return color.rgb * (window * window * max(beam * beam, kMinFalloff) / (range * range));
}

/// By how much the irradiance differs of the changed lights from texel `first` to `end`.
vec3 changeByLights(vec3 position, int first, int end) {
    vec3 change = vec3(0.0);
    int i = first + loopBegin();
    do {
        if (i >= end) break;
        change += abs(irradianceOf(uChangedLights[i + 3], uChangedLights[i + 4], uChangedLights[i + 5], position) -
                      irradianceOf(uChangedLights[i], uChangedLights[i + 1], uChangedLights[i + 2], position));
    } while ((i += 6) < end);
    return change;
}

/// The share of what has changed in the boxes through which a line passes, or beside which within `margin`: see
/// meetsChange().
float shareOfChange(vec3 origin, vec3 ray, float margin) {
    vec3 inverse = 1.0 / (ray + vec3(equal(ray, vec3(0.0))) * 1e-6);
    float share = 0.0;
    int i = loopBegin();
    do {
        if (uDirtyCornerCount == 0) break;
        vec3 low = uDirtyCorners[i].xyz - origin, high = uDirtyCorners[i + 1].xyz - origin;
        vec3 halfSize = 0.5 * (high - low);
        vec3 wider = vec3(margin * length(0.5 * (low + high)));
        vec3 a = (low - wider) * inverse, b = (high + wider) * inverse, enter = min(a, b), leave = max(a, b);
        bool isMet = max(max(enter.x, enter.y), max(enter.z, 0.0)) <= min(min(leave.x, leave.y), min(leave.z, 1.0));
        share += isMet ? changedShare(uDirtyCorners[i].w, dot(halfSize, halfSize)) : 0.0;
    } while ((i += 2) < uDirtyCornerCount);
    return min(share, 1.0);
}

/// Irradiance of the lights before which changed voxels lie.
vec3 changeByShadows(vec3 position) {
    vec3 change = vec3(0.0);
    int i = loopBegin();
    do {
        if (uShadowedLightTexels == 0) break;
        vec3 toLight = uShadowedLights[i].xyz - position;
        float share = shareOfChange(position, toLight, uShadowedLights[i + 1].w / max(length(toLight), 0.05));
        if (share > 0.0) {
            vec3 light = irradianceOf(uShadowedLights[i], uShadowedLights[i + 1], uShadowedLights[i + 2], position);
            change += share * light;
        }
    } while ((i += 3) < uShadowedLightTexels);
    return change;
}

/// After a change of irradiance. meanRadiance: luminance of the light that the place had.
float historyLeftAfter(vec3 change, float meanRadiance) {
    return historyLeftAfter(max(change.r, max(change.g, change.b)) / (kPi * max(meanRadiance, 1e-4)));
}

/// Share of the longest history that is left to a place.
float historyLeftAt(vec3 position, float meanRadiance) {
    vec3 change = changeByLights(position, 0, uChangedLightTexels) + changeByShadows(position);
    float looks = min(historyNearLooks(position, 1), historyLeftAfter(uLateSkylightChange));
    return min(min(historyNearVoxels(position), looks), historyLeftAfter(change, meanRadiance));
}

const float kBeyond = 1e4;  // metres: beyond all voxels

/// Whether the view of a place passes through changed voxels, or beside them within a pixel, for the one beside that
/// TAA takes in. An orthographic view counts as one from far away.
bool isSeenThroughChange(vec3 position) {
    vec3 ray = isOrthographic() ? frame.viewMiddle.xyz * kBeyond : position - frame.cameraPosition.xyz;
    return meetsChange(position - ray, ray, pixelMetres(1.0) / (isOrthographic() ? kBeyond : 1.0));
}

/// Whether voxels have changed that may hide a part of the sun from a place.
bool isSunSeenThroughChange(vec3 position) {
    return frame.sunDirection.y > 0.0 && meetsChange(position, frame.sunDirection.xyz * kBeyond, frame.sunDirection.w);
}
