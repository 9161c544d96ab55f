#pragma once
#include "runtime/world/lights.h"

namespace rubble {

/// Another sky, sun, air, camera exposure or gravity, from this step on. Undo leaves it: weather is not taken back.
struct SetEnvironmentEdit {
    Environment environment;
};

/// Gives a light other properties. Its name, its kind, its group and the shape that it rides on stay as they are, and so does the
/// picture of a screen; one whose group is out stays dark.
struct SetLightEdit {
    LightHandle light;
    Pose local;  ///< in the frame of its shape, or of the world
    glm::vec3 color{1.0f};
    float radius = 0.1f, reach = 12.0f;
    float coneInner = 0.5f, coneOuter = 0.8f;
    float width = 0.0f, height = 0.0f;
    bool twoSided = false, enabled = true;

    SetLightEdit() = default;
    /// Of a light as it is: change some of it.
    SetLightEdit(LightHandle handle, const Light& now);
};

}  // namespace rubble
