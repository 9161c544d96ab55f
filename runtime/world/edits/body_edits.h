#pragma once
#include <glm/vec3.hpp>

#include "runtime/core/handle.h"
#include "runtime/core/pose.h"

namespace rubble {

/// Changes where a body is and how it moves. What it touches does not hold it back: it is there in this step.
struct SetBodyEdit {
    BodyHandle body;
    bool setsPose = false;  ///< else `pose` is not read, and so on
    Pose pose;              ///< metres, world
    bool setsVelocity = false;
    glm::dvec3 velocity{0.0};         ///< of the centre of mass, m/s; a static body takes none
    glm::dvec3 angularVelocity{0.0};  ///< rad/s, world axes
    bool setsSleep = false;
    bool setsKind = false;  ///< before all else
    bool isStatic = false;  ///< true: it stands still, and its shapes are held to the world; false: it is free
    bool asleep = false;    ///< true: it stops and sleeps; false: it wakes
    bool setsGravityScale = false;
    double gravityScale = 1.0;  ///< see Body, as for what follows
    bool setsDamping = false;
    double linearDamping = 0.0, angularDamping = 0.0;
};

/// Erases a body with its shapes and all that is in them, without dust or pieces.
struct DestroyBodyEdit {
    BodyHandle body;
};

}  // namespace rubble
