#pragma once
#include "runtime/world/objects/lights.h"

namespace rubble {

/// Another sky, sun, air, camera exposure or gravity, from this step on.
struct SetEnvironmentEdit {
    Environment environment;
};

/// Makes a light, on a shape or free in the world: FrameChanges::lightsAdded has its handle. One of a group that is out
/// stays dark.
struct AddLightEdit {
    Light light;
};

/// Makes a light another one under the same handle: change a copy of what it is. One of a group that is out stays dark.
struct SetLightEdit {
    LightHandle light;
    Light values;
};

/// Its handle is stale from here on.
struct RemoveLightEdit {
    LightHandle light;
};

}  // namespace rubble
