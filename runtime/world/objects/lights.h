#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "runtime/core/handle.h"
#include "runtime/core/pose.h"

namespace rubble {

/// Emitters of constant radiance, cut off smoothly at a distance: the window (1 - (d / reach)^4)^2 of the distance d
/// from the lit place to the point of the light multiplies it. Exact otherwise (tests/golden/local_lights_test.cpp):
/// * Sphere: a sphere of radiance color / (pi radius^2).
/// * Cone: a Sphere times e^2; e goes from 0 at the outer half angle to 1 at the inner one, by the cosine to -z at the
///   sphere's centre.
/// * Capsule: a Sphere spread evenly over a line of `width` metres along x.
/// * Area: a rectangle of `width` by `height` metres along x and y, of radiance color / (width height).
/// * Screen: an Area times its image.
/// Voxels within max(radius, 0.12) metres of the light cast no shadow: a light sits among its own glowing voxels.
enum class LightKind : uint8_t { Sphere, Cone, Capsule, Area, Screen };

inline constexpr uint32_t kMaxLightImageSide = 64;  ///< texels
inline constexpr size_t kMaxLights = 1u << 16;      ///< that edits can fill a World up to; a level may bring more

/// What a screen shows: rows from the top, as a viewer in front of it sees them.
struct LightImage {
    uint32_t width = 0;
    std::vector<uint32_t> texels;  ///< sRGB 0xRRGGBB

    /// Rows; 0 without texels.
    uint32_t height() const { return width ? uint32_t(texels.size()) / width : 0; }
    /// Whether it has whole rows, and no side above kMaxLightImageSide.
    bool isWhole() const {
        return width <= kMaxLightImageSide && height() <= kMaxLightImageSide &&
               texels.size() == size_t(width) * height();
    }
    friend bool operator==(const LightImage&, const LightImage&) = default;
};

/// A light on a shape, which it moves with, or in the world. Cones, areas and screens shine along -z of `local`.
struct Light {
    std::string name;
    LightKind kind = LightKind::Sphere;
    ShapeHandle shape;       ///< whose frame `local` is in; empty: the world
    Pose local;              ///< metres
    glm::vec3 color{1.0f};   ///< linear radiant intensity (W/sr, in the renderer's units); of areas: along -z
    float radius = 0.1f;     ///< of the glowing sphere, metres: the larger, the softer the shadows
    float reach = 12.0f;     ///< metres beyond which it lights nothing
    float coneInner = 0.5f;  ///< half angles, radians
    float coneOuter = 0.8f;
    float width = 0.0f;      ///< metres along x of `local`
    float height = 0.0f;     ///< along y
    bool twoSided = false;   ///< an area shines along +z too
    LightImage image;        ///< of a screen; none: white
    LightGroupHandle group;  ///< the light goes out with it; empty: none
    bool enabled = true;

    /// A hash of all that is seen; handles count by their slots.
    uint64_t hash() const;
};
/// Says which number of a light is out of its range, what was expected and what was found; empty: none is. Handles are
/// not checked.
std::string lightError(const Light& light);
/// Moves the numbers of a light that are out of their ranges to the nearest in them, for lights that are computed.
void clampToRanges(Light& light);

/// Emissive voxels and lights that go out together. Voxels belong to a group by their palette entry. A group with a
/// power supply also goes out when no path of wire (voxels of the material "wire") leads from there to one of its
/// voxels.
struct LightGroup {
    std::string name;
    float threshold = 0.4f;  ///< share of its voxels whose loss puts it out
    uint64_t initialVoxels = 0;
    uint64_t removedVoxels = 0;
    bool out = false;
    bool off = false;           ///< switched off: dark until it is switched on
    std::string supplyShape;    ///< "" = needs none
    glm::ivec3 supplyCell{0};   ///< cell of that shape at which the wire begins
    uint32_t flickerSteps = 0;  ///< how long it flickers before it goes out
    uint64_t failingSince = 0;  ///< step at which it began to flicker; 0: it does not
    bool dark = false;          ///< in this step of its flickering
    ShapeHandle supply;         ///< handle of supplyShape in a World; empty: needs none, or the level lacks that shape
};

/// Sky, sun, air and camera exposure of a level.
struct Environment {
    glm::vec3 sunDirection{-0.6f, 0.36f, 0.5f};  ///< unit vector to the sun; a level may bring any length
    glm::vec3 sunColor{9.0f, 7.6f, 5.8f};        ///< irradiance on a surface that faces it
    float sunAngle = 0.0047f;                    ///< angular radius, radians; larger: softer shadows
    glm::vec3 skyColor{0.55f, 0.70f, 1.00f};     ///< radiance overhead
    glm::vec3 horizonColor{0.85f, 0.80f, 0.75f};
    glm::vec3 groundColor{0.25f, 0.22f, 0.20f};  ///< radiance from below the horizon
    glm::vec3 fogColor{0.62f, 0.66f, 0.72f};
    float fogDistance = 150.0f;  ///< metres after which haze has absorbed half of the light
    float fogDensity = 0.0f;     ///< extinction per metre at fogBase of the fog that shows light shafts; 0: none, at
                                 ///< no cost
    float fogBase = 0.0f;        ///< height, metres
    float fogHeight = 12.0f;     ///< metres above fogBase at which its density is 1/e of that at fogBase
    float fogForward = 0.45f;    ///< mean cosine of its scattering, -0.9 to 0.9; above 0: forward
    glm::vec3 fogTint{1.0f};     ///< scattering albedo: share of the extinction that is scattered
    float clouds = 0.5f;         ///< cover: 0 is a clear sky, 1 overcast
    float stars = 0.0f;          ///< brightness of the stars
    float exposure = 1.0f;
    float wetness = 0.0f;                   ///< of surfaces open to the sky: 0 dry, 0.5 dark and smooth, 1 with puddles
    glm::vec3 gravity{0.0f, -9.81f, 0.0f};  ///< m/s2

    /// A hash of all fields.
    uint64_t hash() const;
    friend bool operator==(const Environment&, const Environment&) = default;
};
/// The same as lightError() for an environment. The sun's direction may have any length but 0.
std::string environmentError(const Environment& environment);

}  // namespace rubble
