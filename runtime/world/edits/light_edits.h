#pragma once
#include "runtime/world/objects/lights.h"

namespace rubble {

/// Replaces sky, sun, air, camera exposure and gravity from this step on.
struct SetEnvironmentEdit {
    Environment environment;
};

/// Adds a light on a shape or in the world; FrameChanges::lightsAdded gets its handle. A light of a group that is out
/// stays dark.
struct AddLightEdit {
    Light light;
};

/// Replaces all values of a light; begin with a copy of them. A light of a group that is out stays dark.
struct SetLightEdit {
    LightHandle light;
    Light values;
};

/// Erases a light.
struct RemoveLightEdit {
    LightHandle light;
};

/// Makes a light group, which palette entries and lights may name from now on. It goes out when its share of the voxels
/// that then came to it is lost.
struct CreateLightGroupEdit {
    LightGroup group;  ///< its name, threshold and flicker steps are read
};

/// Switches a light group, says when it goes out, or feeds it by wire. One that is out stays dark.
struct SetLightGroupEdit {
    LightGroupHandle group;
    bool switches = false;  ///< else `on` is not read, and so on
    bool on = true;
    bool setsThreshold = false;
    float threshold = 0.4f;  ///< see LightGroup
    bool setsSupply = false;
    ShapeHandle supply;        ///< empty: it needs no supply
    glm::ivec3 supplyCell{0};  ///< where the wire begins; the group fails if none leads from there to its voxels
};

}  // namespace rubble
