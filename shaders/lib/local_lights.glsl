// Local lights: which of them are near a pixel (lists made by render/scene/light_grid.cpp), how one is chosen, and what
// it sends. runtime/world/objects/lights.h describes the kinds.
//
// Direct light is a sum over lights of integrals over directions: E / pi = sum_i integral L_i cos / pi. One ray a pixel
// must do for any number of lights, so one light and one direction to it are drawn:
//   1. Each candidate i gets the weight w_i = an estimate of its unshadowed irradiance (unshadowedIrradiance()).
//   2. A reservoir keeps one candidate with the probability w_i / sum w, in one pass (Chao 1982; resampled importance
//      sampling: Talbot, Cline, Egbert 2005). Where there are more than 24, the first 12 are always candidates and 12
//      of the others are taken at a stride, each standing for `stride` of them.
//   3. A direction to that light is drawn with density p over solid angle, uniform over the cone of a sphere, or over a
//      rectangle: by solid angle where that is large, else by area, which loses fewer digits.
// The estimate L cos / (pi p) * (sum w / w_i) has the right mean if w_i > 0 wherever light i sends anything. Its noise
// is small where w_i is nearly proportional to the light's true contribution. Needs lib/frame, lib/sampling.
#include "lib/constants.glsl"
#include "lib/color.glsl"
#include "lib/texels.glsl"
#include "lib/rectangle_sampling.glsl"

uniform texels4f uLights;       // kTexelsPerLight a light: see readLight()
uniform texels2 uLightCells;    // a cell of the grid: first entry in the list, number of lights
uniform texels1 uLightList;     // light numbers; the first kAlwaysWeighed of a cell are its strongest
uniform texels4f uLightImages;  // texels of screens, linear colour
uniform ivec3 uLightGrid;       // tiles across and up, slices of depth; one more slice lists lights of all depths

const int kOthersWeighed = 12;  // beside the kAlwaysWeighed first ones of a cell
const float kWideAngle = 0.3;   // solid angle from which on a rectangle is sampled by solid angle, sr

struct LocalLight {
    vec3 position;
    float extent;  // radius around the position that holds all of it
    vec3 color;    // radiant intensity
    float reach;   // metres beyond which it sends nothing
    vec3 axis;     // its direction
    int kind;      // kSphere, kCapsule, kArea or kScreen
    vec2 cone;     // cosine of the outer half angle (below -1 without a cone); 1 / (inner cosine - outer cosine)
    float radius;  // metres: of the sphere or capsule
    vec3 right;
    vec2 halfSize;  // metres along right and up; of a capsule: half its length
    bool twoSided;
    ivec3 image;  // of a screen: first texel, columns, rows
};

/// Whether it is a rectangle. NO_AREA_LIGHTS: see ShaderLibrary::setRareFeatures().
bool isRectangle(LocalLight light) {
#ifdef NO_AREA_LIGHTS
    return false;
#else
    return light.kind >= kArea;
#endif
}

LocalLight readLight(int i) {
    i *= kTexelsPerLight;
    vec4 a = fetch4f(uLights, i), c = fetch4f(uLights, i + 2), d = fetch4f(uLights, i + 3), e = fetch4f(uLights, i + 4),
         f = fetch4f(uLights, i + 5), g = fetch4f(uLights, i + 6);
    return LocalLight(a.xyz, a.w, d.rgb, c.y, e.xyz, int(d.w), vec2(e.w, g.x), c.z, f.xyz, vec2(f.w, c.w), g.w > 0.0,
                      ivec3(int(g.y), int(g.z) & 255, int(g.z) >> 8));
}

/// The lights that may reach a pixel: x first entry in the list, y number. A negative depth stands for any depth.
ivec2 lightsAt(ivec2 pixel, float depth) {
    int slice = depth < 0.0 ? uLightGrid.z : clamp(int(floor(2.0 * log2(max(depth, 1.0)))), 0, uLightGrid.z - 1);
    ivec2 tile = min(pixel / kTilePixels, uLightGrid.xy - 1);
    return ivec2(fetch2(uLightCells, tile.x + uLightGrid.x * (tile.y + uLightGrid.y * slice)));
}

/// How many of `count` lights become candidates.
int candidateCount(int count) { return min(count, kAlwaysWeighed + kOthersWeighed); }

/// Candidate i of a list. x: the light, y: for how many lights it stands. random: where the strided ones begin.
vec2 candidateLight(ivec2 cell, int i, float random) {
    float stride = float(cell.y - kAlwaysWeighed) / float(kOthersWeighed);
    bool counted = stride <= 1.0 || i < kAlwaysWeighed;
    int place = counted ? i : kAlwaysWeighed + int((float(i - kAlwaysWeighed) + random) * stride);
    return vec2(fetch1(uLightList, cell.x + min(place, cell.y - 1)), counted ? 1.0 : stride);
}

/// Falls smoothly to 0 at a light's reach (Karis 2013, "Real Shading in Unreal Engine 4", inverse-square falloff).
float lightWindow(float distanceMetres, float reach) {
    float x = distanceMetres / reach;
    float w = clamp(1.0 - x * x * x * x, 0.0, 1.0);
    return w * w;
}

/// cosine: between a light's axis and the direction from it.
float coneAttenuation(LocalLight light, float cosine) {
    float e = clamp((cosine - light.cone.x) * light.cone.y, 0.0, 1.0);
    return e * e;
}

/// The weight w of a candidate: about the luminance of a light's irradiance on a surface without shadows. It is above 0
/// wherever the light may send anything, as `wide` adds the angle that the light's extent takes.
float unshadowedIrradiance(int i, vec3 position, vec3 normal) {
    i *= kTexelsPerLight;
    vec4 a = fetch4f(uLights, i), b = fetch4f(uLights, i + 1), c = fetch4f(uLights, i + 2);
    vec3 toCentre = a.xyz - position;
    float range2 = dot(toCentre, toCentre), extent = a.w, inverse = inversesqrt(max(range2, extent * extent)),
          wide = extent * inverse;
    float facing = clamp(dot(normal, toCentre) * inverse + wide, 0.0, 1.0);
    float edge = clamp(b.w - dot(toCentre, b.xyz) * inverse + wide, 0.0, 1.0);
    float far = max(sqrt(range2) - extent, 0.0) / c.y, far2 = far * far, window = max(1.0 - far2 * far2, 0.0);
    return c.x * facing * edge * edge * window * window * inverse * inverse;
}

/// Weighted reservoir sampling of one light (Chao 1982).
struct Reservoir {
    int light;        // -1: none
    float weight;     // w of that light
    float weightSum;  // of all candidates so far
    float random;     // reused: its remainder after a decision is uniform in [0, 1) again
};
void updateReservoir(inout Reservoir reservoir, int light, float weight, float multiplicity) {
    float share = weight * multiplicity;
    reservoir.weightSum += share;
    float place = reservoir.random * reservoir.weightSum;
    bool accepted = place < share;
    // A light of weight 0 decides nothing, and the random number stays.
    reservoir.random =
        share > 0.0 ? (accepted ? place : place - share) / max(accepted ? share : reservoir.weightSum - share, 1e-20)
                    : reservoir.random;
    reservoir.light = accepted ? light : reservoir.light;
    reservoir.weight = accepted ? weight : reservoir.weight;
}

/// One light of a list as lightsAt() gives it.
Reservoir chooseLight(ivec2 cell, vec3 position, vec3 normal, vec2 random) {
    int candidates = candidateCount(cell.y);
    Reservoir reservoir = Reservoir(-1, 1.0, 0.0, random.x);
    int i = 0;
    do {
        if (candidates == 0) break;
        vec2 next = candidateLight(cell, i, random.y);
        updateReservoir(reservoir, int(next.x), unshadowedIrradiance(int(next.x), position, normal), next.y);
    } while (++i < candidates);
    return reservoir;
}

/// Colour of a screen at a place of its face, -1 to 1 along right and up. A viewer has the light's right on the left.
vec3 screenImageAt(LocalLight light, vec2 place) {
    if (light.image.y == 0) return vec3(1.0);
    ivec2 texel = clamp(ivec2((0.5 - 0.5 * place) * vec2(light.image.yz)), ivec2(0), light.image.yz - 1);
    return fetch4f(uLightImages, light.image.x + texel.x + texel.y * light.image.y).rgb;
}

/// From a position to a light's centre; of a capsule, to a random one of the spheres on its axis.
vec3 toLight(LocalLight light, vec3 position, float u) {
    return light.position + light.right * (light.kind == kCapsule ? light.halfSize.x * (2.0 * u - 1.0) : 0.0) -
           position;
}

/// Solid angle of a sphere / 2 pi, which is 1 - cosine of its half angle. Written as sine^2 / (1 + cosine), which loses
/// no digits for small spheres.
float hemisphereFraction(float radius, float range2) {
    float sine2 = min(radius * radius / range2, 1.0);
    return sine2 / (1.0 + sqrt(1.0 - sine2));
}

/// A light's rectangle as seen from a point. A sample needs it twice: for its direction and for its density.
SphericalRectangle rectangleOf(LocalLight light, vec3 toCentre) {
    vec3 centre =
        vec3(dot(toCentre, light.right), dot(toCentre, cross(light.right, light.axis)), dot(toCentre, light.axis));
    return sphericalRectangle(centre, max(light.halfSize, vec2(1e-3)));
}

/// A direction to a random point of a light: of a sphere uniform over its cone, of a rectangle uniform over its solid
/// angle or area.
vec3 sampleLightDirection(LocalLight light, vec3 toCentre, SphericalRectangle face, vec2 u) {
    float range2 = max(dot(toCentre, toCentre), 1e-6);
    float fall = u.y * hemisphereFraction(light.radius, range2);
    float angle = isRectangle(light) ? rectangleAngle(face, u.x) : 2.0 * kPi * u.x;
    vec2 turn = vec2(cos(angle), sin(angle));
    vec3 local = vec3(sqrt(fall * (2.0 - fall)) * turn, 1.0 - fall);
    vec3 ball = orthonormalBasis(toCentre * inversesqrt(range2)) * local;
    if (!isRectangle(light)) return ball;
    vec3 up = cross(light.right, light.axis);
    vec2 place = (2.0 * u - 1.0) * light.halfSize;
    if (face.solidAngle > kWideAngle)
        place = sampleRectangle(face, turn, u.y) - vec2(dot(toCentre, light.right), dot(toCentre, up));
    return normalize(toCentre + light.right * place.x + up * place.y);
}

/// What a light sends to a position along a direction.
struct LightSample {
    float range;      // metres to the light's surface
    float clearance;  // the last metres of a shadow ray, which the light's own voxels may fill
    vec3 radiance;
    float pdf;  // of sampleLightDirection(), over solid angle
};

/// A sphere of even radiance intensity / (pi radius^2). isHit: the direction meets it by construction, whatever
/// rounding says.
LightSample evaluateSphere(LocalLight light, vec3 toCentre, vec3 direction, bool isHit) {
    float along = dot(direction, toCentre), range2 = max(dot(toCentre, toCentre), 1e-6),
          radius2 = light.radius * light.radius;
    vec3 aside = toCentre - direction * along;
    float chord2 = radius2 - dot(aside, aside), range = max(along - sqrt(max(chord2, 0.0)), 0.0);
    float edge = coneAttenuation(light, -dot(toCentre, light.axis) * inversesqrt(range2));
    float strength =
        isHit || (chord2 >= 0.0 && along > 0.0) ? edge * lightWindow(range, light.reach) / (kPi * radius2) : 0.0;
    return LightSample(range, max(light.radius, 0.12), light.color * strength,
                       1.0 / (2.0 * kPi * hemisphereFraction(light.radius, range2)));
}

/// A rectangle of radiance intensity / area. Density by area becomes one over solid angle: range^2 / (cosine area).
LightSample evaluateArea(LocalLight light, vec3 toCentre, float solidAngle, vec3 direction, bool isHit) {
    float turned = -dot(direction, light.axis), cosine = max(light.twoSided ? abs(turned) : turned, 1e-5);
    float range = -dot(toCentre, light.axis) / (turned < 0.0 ? -cosine : cosine);
    vec3 onFace = direction * range - toCentre;
    vec2 halfSize = max(light.halfSize, vec2(1e-3));
    vec2 place = vec2(dot(onFace, light.right), dot(onFace, cross(light.right, light.axis))) / halfSize;
    float area = 4.0 * halfSize.x * halfSize.y;
    bool isVisible = cosine > 1e-5 && range > 0.0 && (isHit || max(abs(place.x), abs(place.y)) <= 1.0);
    vec3 color = light.kind == kScreen ? light.color * screenImageAt(light, place) : light.color;
    return LightSample(range, max(light.radius, 0.12) / max(cosine, 0.1),
                       isVisible ? color * (lightWindow(range, light.reach) / area) : vec3(0.0),
                       solidAngle > kWideAngle ? 1.0 / solidAngle : max(range * range, 1e-4) / (cosine * area));
}

LightSample evaluateLight(LocalLight light, vec3 toCentre, SphericalRectangle face, vec3 direction, bool isHit) {
    // WebGL has no ?: for structs.
    if (isRectangle(light)) return evaluateArea(light, toCentre, face.solidAngle, direction, isHit);
    return evaluateSphere(light, toCentre, direction, isHit);
}
