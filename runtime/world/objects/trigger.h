#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "runtime/core/handle.h"
#include "runtime/core/pose.h"
#include "runtime/core/world_box.h"
#include "runtime/world/objects/ground_polygon.h"

namespace rubble {

enum class TriggerKind : uint8_t { Sphere, Box, Polygon };

/// A region that reports which bodies enter and leave it. Nothing collides with it. Static bodies do not count.
struct Trigger {
    std::string name;
    TriggerKind kind = TriggerKind::Box;
    Pose pose;                 ///< world; sphere and box: of their centre; polygon: its origin, without rotation
    double radius = 1.0;       ///< sphere, metres
    glm::dvec3 halfSize{1.0};  ///< box, metres
    GroundPolygon outline;     ///< polygon: relative to the pose's position
    double height = 1.0;       ///< polygon: upward from the pose's position, metres
    uint8_t layerMask = 255;   ///< only shapes with a collision layer in this mask count
    std::vector<std::string> tags;
    std::vector<BodyHandle> inside;  ///< bodies with a voxel in it, in slot order; empty in a level

    /// The smallest world box around it.
    WorldBox bounds() const;
    /// A hash of all that decides what happens; name and tags are not in it.
    uint64_t hash() const;
};

/// A body that has entered a trigger, or left it.
struct TriggerEvent {
    Handle<HandleType::Trigger> trigger;
    BodyHandle body;
    bool entered = false;
};

}  // namespace rubble
