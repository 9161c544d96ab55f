#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "runtime/core/handle.h"
#include "runtime/core/pose.h"

namespace rubble {

/// Capsule and Area are data that fitting leaves (see LightFit); they are drawn as spheres of their radius.
enum class LightKind : uint8_t { Sphere, Cone, Capsule, Area };

/// A light that rides on a shape. Its cone looks along -z of `local`.
struct Light {
    std::string name;
    LightKind kind = LightKind::Sphere;
    ShapeHandle shape;       ///< whose frame `local` is in; empty: the world's
    Pose local;              ///< metres
    glm::vec3 color{1.0f};   ///< linear radiant intensity (W/sr, in the renderer's units)
    float radius = 0.1f;     ///< of the glowing sphere, metres: it makes the penumbra
    float reach = 12.0f;     ///< metres beyond which it lights nothing
    float coneInner = 0.5f;  ///< half angles, radians
    float coneOuter = 0.8f;
    LightGroupHandle group;  ///< that puts it out; empty: none
    bool enabled = true;
};

/// Emissive voxels that live and die together with their lights. Voxels belong to a group by their palette entry. A group
/// with a supply also dies when no path of wire (voxels of the material "wire") leads from there to one of its voxels.
struct LightGroup {
    std::string name;
    float threshold = 0.4f;  ///< share of its voxels that must be destroyed to put it out
    uint64_t initialVoxels = 0;
    uint64_t removedVoxels = 0;
    bool out = false;
    std::string supplyShape;    ///< "" = needs none
    glm::ivec3 supplyCell{0};   ///< of that shape: where the wire begins
    uint32_t flickerSteps = 0;  ///< how long it flickers before it is out
    uint64_t dyingSince = 0;    ///< step; 0: it is not
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
    float exposure = 1.0f;
    float wetness = 0.0f;  ///< of what lies open to the sky: 0 dry, 0.5 dark and smooth, 1 with puddles
    glm::vec3 gravity{0.0f, -9.81f, 0.0f};

    friend bool operator==(const Environment&, const Environment&) = default;
};

}  // namespace rubble
