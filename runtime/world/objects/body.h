#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "runtime/core/handle.h"
#include "runtime/core/pose.h"

namespace rubble {

/// A rigid body: a frame that shapes are fixed to. Its origin is not its centre of mass.
struct Body {
    std::string name;
    Pose pose;                        ///< metres, world
    glm::dvec3 velocity{0.0};         ///< of the centre of mass, m/s
    glm::dvec3 angularVelocity{0.0};  ///< rad/s, world axes
    bool isStatic = true;
    bool asleep = false;
    bool waitsToWake = false;  ///< asleep until the budgets of physics have a place for it
    std::vector<ShapeHandle> shapes;
    std::vector<std::string> tags;
    bool settled = false;       ///< asleep for so long that only damage or motion near it wakes it
    bool broken = false;        ///< has lost voxels
    uint64_t createdStep = 0;   ///< 0: came with the level
    uint64_t restingSince = 0;  ///< step at which it fell asleep; 0 while awake
    double gravityScale = 1.0;  ///< multiple of the world's gravity that acts on it
    double linearDamping = 0.0, angularDamping = 0.0;  ///< 1/s: rates at which its velocities decay
};

/// A body's new state, as physics hands it over: world space, metres, m/s and rad/s.
struct BodyPose {
    BodyHandle body;
    Pose pose;
    glm::dvec3 velocity{0.0};
    glm::dvec3 angularVelocity{0.0};
    bool asleep = false;
    bool waitsToWake = false;  ///< see Body
};

}  // namespace rubble
