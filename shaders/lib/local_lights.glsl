// Local lights: which are near a pixel (filled by render/scene/light_grid.cpp), what they send there, and random points of
// them. runtime/world/objects/lights.h says what each kind is. Needs lib/frame, lib/sampling.
#include "lib/color.glsl"
#include "shared/constants.h"

uniform samplerBuffer uLights;          // kTexelsPerLight a light: see readLight()
uniform usamplerBuffer uLightCells;     // of the grid: first place in the list, number of lights
uniform usamplerBuffer uLightList;      // the first kAlwaysWeighed of a cell are those that may matter most there
uniform samplerBuffer uLightImages;   // linear
uniform ivec3 uLightGrid;               // tiles across and up, slices of depth; after the last slice one for all depths

const int kOthersWeighed = 12;
const int kSphere = 0, kCapsule = 1, kArea = 2, kScreen = 3;

struct LocalLight {
    vec3 position;
    float extent;     // all of it lies within this of its place
    vec3 color;
    float reach;
    vec3 axis;        // where it looks
    int kind;
    vec2 cone;        // cosine of the outer half angle; 1 / (cosine of the inner - cosine of the outer). Lies beyond all directions without one
    float radius;
    vec3 right;
    vec2 halfSize;    // along right and up
    bool twoSided;
    ivec3 image;    // first texel, columns, rows
};

LocalLight readLight(int i) {
    i *= kTexelsPerLight;
    vec4 a = texelFetch(uLights, i), c = texelFetch(uLights, i + 2), d = texelFetch(uLights, i + 3), e = texelFetch(uLights, i + 4),
         f = texelFetch(uLights, i + 5), g = texelFetch(uLights, i + 6);
    return LocalLight(a.xyz, a.w, d.rgb, c.y, e.xyz, int(d.w), vec2(e.w, g.x), c.z, f.xyz, vec2(f.w, c.w), g.w > 0.0,
                      ivec3(int(g.y), int(g.z) & 255, int(g.z) >> 8));
}

/// The lights that may reach a pixel: x first place in the list, y number. Depth below 0: at any depth.
ivec2 lightsAt(ivec2 pixel, float depth) {
    int slice = depth < 0.0 ? uLightGrid.z : clamp(int(floor(2.0 * log2(max(depth, 1.0)))), 0, uLightGrid.z - 1);
    ivec2 tile = min(pixel / kTilePixels, uLightGrid.xy - 1);
    return ivec2(texelFetch(uLightCells, tile.x + uLightGrid.x * (tile.y + uLightGrid.y * slice)).xy);
}

/// Where to look for the i-th of those that a pixel weighs: the first ones always, of the stride every so many from a random one on,
/// so that hundreds cost no more than some. x: the light, y: for how many it multiplicity.
int candidateCount(int count) { return min(count, kAlwaysWeighed + kOthersWeighed); }
vec2 candidateLight(ivec2 cell, int i, float random) {
    float stride = float(cell.y - kAlwaysWeighed) / float(kOthersWeighed);
    bool counted = stride <= 1.0 || i < kAlwaysWeighed;
    int place = counted ? i : kAlwaysWeighed + int((float(i - kAlwaysWeighed) + random) * stride);
    return vec2(texelFetch(uLightList, cell.x + min(place, cell.y - 1)).x, counted ? 1.0 : stride);
}

float lightWindow(float distanceMetres, float reach) {
    float x = distanceMetres / reach;
    float w = clamp(1.0 - x * x * x * x, 0.0, 1.0);
    return w * w;
}

float coneAttenuation(LocalLight light, float cosine) {
    float e = clamp((cosine - light.cone.x) * light.cone.y, 0.0, 1.0);
    return e * e;
}

/// Luminance of about what a light sends to a surface without shadows: never 0 where it may send some.
float unshadowedIrradiance(int i, vec3 position, vec3 normal) {
    i *= kTexelsPerLight;
    vec4 a = texelFetch(uLights, i), b = texelFetch(uLights, i + 1), c = texelFetch(uLights, i + 2);
    vec3 toCentre = a.xyz - position;
    float range2 = dot(toCentre, toCentre), extent = a.w, inverse = inversesqrt(max(range2, extent * extent)), wide = extent * inverse;
    float facing = clamp(dot(normal, toCentre) * inverse + wide, 0.0, 1.0);
    float edge = clamp(b.w - dot(toCentre, b.xyz) * inverse + wide, 0.0, 1.0);
    float far = max(sqrt(range2) - extent, 0.0) / c.y, far2 = far * far, window = max(1.0 - far2 * far2, 0.0);
    return c.x * facing * edge * edge * window * window * inverse * inverse;
}

/// Keeps one of the lights that are offered one after the other, each in proportion to its weight.
struct Reservoir {
    int light;      // -1: none
    float weight;   // about what it sends
    float weightSum;    // of all that were offered
    float random;   // serves again and again: what is left of it after a draw is as random
};
void updateReservoir(inout Reservoir reservoir, int light, float weight, float multiplicity) {
    float share = weight * multiplicity;
    reservoir.weightSum += share;
    float place = reservoir.random * reservoir.weightSum;
    bool accepted = place < share;
    // A light that sends nothing is no draw.
    reservoir.random = share > 0.0 ? (accepted ? place : place - share) / max(accepted ? share : reservoir.weightSum - share, 1e-20) : reservoir.random;
    reservoir.light = accepted ? light : reservoir.light;
    reservoir.weight = accepted ? weight : reservoir.weight;
}

/// One of a list, as lightsAt() gives it.
Reservoir chooseLight(ivec2 cell, vec3 position, vec3 normal, vec2 random) {
    int candidates = candidateCount(cell.y);
    Reservoir reservoir = Reservoir(-1, 1.0, 0.0, random.x);
    for (int i = 0; i < candidates; ++i) {
        vec2 next = candidateLight(cell, i, random.y);
        updateReservoir(reservoir, int(next.x), unshadowedIrradiance(int(next.x), position, normal), next.y);
    }
    return reservoir;
}

vec3 screenImageAt(LocalLight light, vec2 place) {
    if (light.image.y == 0) return vec3(1.0);
    ivec2 texel = clamp(ivec2((0.5 - 0.5 * place) * vec2(light.image.yz)), ivec2(0), light.image.yz - 1);
    return texelFetch(uLightImages, light.image.x + texel.x + texel.y * light.image.y).rgb;
}

/// From a position to a light, to a random one of a capsule's balls.
vec3 toLight(LocalLight light, vec3 position, float u) {
    return light.position + light.right * (light.kind == kCapsule ? light.halfSize.x * (2.0 * u - 1.0) : 0.0) - position;
}

/// 1 - cosine of the angle that a ball takes from its middle to its edge: its solid angle / 2 pi.
float hemisphereFraction(float radius, float range2) {
    float sine2 = min(radius * radius / range2, 1.0);
    return sine2 / (1.0 + sqrt(1.0 - sine2));
}

/// To a random point of a light: of a ball by the solid angle that each takes, so that its light arrives as exactly as its shadow; of a
/// rectangle by area.
vec3 sampleLightDirection(LocalLight light, vec3 toCentre, vec2 u) {
    float range2 = max(dot(toCentre, toCentre), 1e-6);
    float fall = u.y * hemisphereFraction(light.radius, range2), angle = 2.0 * kPi * u.x;
    vec3 local = vec3(sqrt(fall * (2.0 - fall)) * vec2(cos(angle), sin(angle)), 1.0 - fall);
    vec3 ball = orthonormalBasis(toCentre * inversesqrt(range2)) * local;
    vec2 place = (2.0 * u - 1.0) * light.halfSize;
    vec3 area = normalize(toCentre + light.right * place.x + cross(light.right, light.axis) * place.y);
    return light.kind >= kArea ? area : ball;
}

/// What a light sends to a position along a direction.
struct LightSample {
    float range;     // metres to its point
    float clearance;       // of these, the last ones are the light's clearance
    vec3 radiance;
    float pdf;   // of sampleLightDirection(), by solid angle
};

/// isHit: the direction is known to meet it, but for rounding.
LightSample evaluateSphere(LocalLight light, vec3 toCentre, vec3 direction, bool isHit) {
    float along = dot(direction, toCentre), range2 = max(dot(toCentre, toCentre), 1e-6), radius2 = light.radius * light.radius;
    vec3 aside = toCentre - direction * along;
    float chord2 = radius2 - dot(aside, aside), range = max(along - sqrt(max(chord2, 0.0)), 0.0);
    float edge = coneAttenuation(light, -dot(toCentre, light.axis) * inversesqrt(range2));
    float strength = isHit || (chord2 >= 0.0 && along > 0.0) ? edge * lightWindow(range, light.reach) / (kPi * radius2) : 0.0;
    return LightSample(range, max(light.radius, 0.12), light.color * strength, 1.0 / (2.0 * kPi * hemisphereFraction(light.radius, range2)));
}

LightSample evaluateArea(LocalLight light, vec3 toCentre, vec3 direction, bool isHit) {
    float turned = -dot(direction, light.axis), cosine = max(light.twoSided ? abs(turned) : turned, 1e-5);
    float range = -dot(toCentre, light.axis) / (turned < 0.0 ? -cosine : cosine);
    vec3 onFace = direction * range - toCentre;
    vec2 halfSize = max(light.halfSize, vec2(1e-3));
    vec2 place = vec2(dot(onFace, light.right), dot(onFace, cross(light.right, light.axis))) / halfSize;
    float area = 4.0 * halfSize.x * halfSize.y;
    bool strength = cosine > 1e-5 && range > 0.0 && (isHit || max(abs(place.x), abs(place.y)) <= 1.0);
    vec3 color = light.kind == kScreen ? light.color * screenImageAt(light, place) : light.color;
    return LightSample(range, max(light.radius, 0.12) / max(cosine, 0.1), strength ? color * (lightWindow(range, light.reach) / area) : vec3(0.0),
                       max(range * range, 1e-4) / (cosine * area));
}

LightSample evaluateLight(LocalLight light, vec3 toCentre, vec3 direction, bool isHit) {
    LightSample ball = evaluateSphere(light, toCentre, direction, isHit);
    LightSample area = evaluateArea(light, toCentre, direction, isHit);
    return light.kind >= kArea ? area : ball;
}
