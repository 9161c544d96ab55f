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

}  // namespace rubble
