#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "runtime/core/handle.h"
#include "runtime/core/pose.h"

namespace rubble {

/// What shines, as an emitter of constant radiance that is seen through the window (1 - (d / reach)^4)^2 of the
/// distance d from the place lit to the point of the light; exact otherwise (tests/render/local_lights_test.cpp):
///   Sphere   a ball of radiance color / (pi radius^2)
///   Cone     the same times e^2: e goes from 0 at the outer half angle to 1 at the inner one, by the cosine to -z at
///   the ball's centre Capsule  such a ball that is anywhere on a line of `width` metres along x, evenly Area     a
///   rectangle of `width` by `height` metres along x and y, of radiance color / (width height) Screen   the same times
///   its picture
/// What a ray would meet within max(radius, 0.12) metres of the light does not count: a light sits among its own
/// glowing voxels.
enum class LightKind : uint8_t { Sphere, Cone, Capsule, Area, Screen };

inline constexpr uint32_t kMaxLightImageSide = 64;  ///< texels
inline constexpr size_t kMaxLights = 1u << 16;      ///< that edits fill a World up to; a level may bring more

/// What a screen shows: rows from the top, as seen by who looks at it.
struct LightImage {
    uint32_t width = 0;
    std::vector<uint32_t> texels;  ///< sRGB 0xRRGGBB

    uint32_t height() const { return width ? uint32_t(texels.size()) / width : 0; }
    /// Whole rows, and no side above kMaxLightImageSide.
    bool isWhole() const {
        return width <= kMaxLightImageSide && height() <= kMaxLightImageSide &&
               texels.size() == size_t(width) * height();
    }
    friend bool operator==(const LightImage&, const LightImage&) = default;
};

/// A light that rides on a shape. Cones, areas and screens look along -z of `local`.
struct Light {
    std::string name;
    LightKind kind = LightKind::Sphere;
    ShapeHandle shape;       ///< whose frame `local` is in; empty: the world's
    Pose local;              ///< metres
    glm::vec3 color{1.0f};   ///< linear radiant intensity (W/sr, in the renderer's units); of areas: straight ahead
    float radius = 0.1f;     ///< of the glowing ball, metres: it makes the penumbra
    float reach = 12.0f;     ///< metres beyond which it lights nothing
    float coneInner = 0.5f;  ///< half angles, radians
    float coneOuter = 0.8f;
    float width = 0.0f;      ///< metres along x of `local`
    float height = 0.0f;     ///< along y
    bool twoSided = false;   ///< an area shines along +z too
    LightImage image;        ///< of a screen; none: white
    LightGroupHandle group;  ///< that puts it out; empty: none
    bool enabled = true;

    uint64_t hash() const;
};
/// Which number of a light is out of its range, with what was expected and found; empty: none. Handles are not looked
/// at.
std::string lightError(const Light& light);

/// Emissive voxels that live and die together with their lights. Voxels belong to a group by their palette entry. A
/// group with a supply also dies when no path of wire (voxels of the material "wire") leads from there to one of its
/// voxels.
struct LightGroup {
    std::string name;
    float threshold = 0.4f;  ///< share of its voxels that must be destroyed to put it out
    uint64_t initialVoxels = 0;
    uint64_t removedVoxels = 0;
    bool out = false;
    std::string supplyShape;    ///< "" = needs none
    glm::ivec3 supplyCell{0};   ///< of that shape: where the wire begins
    uint32_t flickerSteps = 0;  ///< how long it flickers before it is out
    uint64_t failingSince = 0;  ///< step; 0: it is not
    bool dark = false;          ///< in this moment of its flickering
    ShapeHandle supply;         ///< a World's handle of supplyShape; empty: needs none, or was never connected
};

/// Sky, sun, air and camera exposure of a level.
struct Environment {
    glm::vec3 sunDirection{-0.6f, 0.36f, 0.5f};  ///< towards the sun; normalised on load
    glm::vec3 sunColor{9.0f, 7.6f, 5.8f};        ///< irradiance on a face turned to it
    float sunAngle = 0.0047f;                    ///< angular radius, radians
    glm::vec3 skyColor{0.55f, 0.70f, 1.00f};     ///< radiance overhead
    glm::vec3 horizonColor{0.85f, 0.80f, 0.75f};
    glm::vec3 groundColor{0.25f, 0.22f, 0.20f};  ///< light from below the horizon
    glm::vec3 fogColor{0.62f, 0.66f, 0.72f};
    float fogDistance = 150.0f;  ///< metres at which the haze takes half
    float fogDensity = 0.0f;   ///< of fog that lights throw shafts into: share of light it takes in a metre at fogBase.
                               ///< 0: none, and nothing is paid
    float fogBase = 0.0f;      ///< height, metres
    float fogHeight = 12.0f;   ///< metres over fogBase at which it is 1/e as thick
    float fogForward = 0.45f;  ///< how much it scatters forward: mean cosine, -0.9 to 0.9
    glm::vec3 fogTint{1.0f};   ///< share of what it takes that it scatters
    float clouds = 0.5f;       ///< 0: a clear sky, 1: overcast
    float stars = 0.0f;        ///< brightness of the stars
    float exposure = 1.0f;
    float wetness = 0.0f;  ///< of what lies open to the sky: 0 dry, 0.5 dark and smooth, 1 with puddles
    glm::vec3 gravity{0.0f, -9.81f, 0.0f};

    uint64_t hash() const;
    friend bool operator==(const Environment&, const Environment&) = default;
};
/// The same as lightError(). A sun's direction may have any length but 0.
std::string environmentError(const Environment& environment);

}  // namespace rubble
