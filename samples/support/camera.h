#pragma once
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>

#include "samples/support/player_input.h"

namespace rubble {

struct View;

/// A camera by position, yaw and pitch (radians). Yaw 0 looks along -z; positive pitch looks up.
struct Camera {
    glm::dvec3 position{0.0, 1.7, 0.0};
    double yaw = 0.0, pitch = 0.0;
    float verticalFov = 1.0f;  ///< radians

    /// Rotation from camera space (x right, y up, -z forward) to world space.
    glm::dquat rotation() const {
        return glm::angleAxis(yaw, glm::dvec3(0, 1, 0)) * glm::angleAxis(pitch, glm::dvec3(1, 0, 0));
    }
    /// Direction of view, of length 1.
    glm::dvec3 forward() const { return rotation() * glm::dvec3(0, 0, -1); }

    /// Turns to a point that is not the camera's own position.
    void lookAt(glm::dvec3 target) {
        const glm::dvec3 d = glm::normalize(target - position);
        yaw = std::atan2(-d.x, -d.z);
        pitch = std::asin(d.y);
    }
    /// Turns as the player asks for.
    void turn(const PlayerInput& input);
    /// Where the player asks to fly, seen from here: world, of length 1 along one axis of the input.
    glm::dvec3 flight(const PlayerInput& input) const;
    /// The renderer's view from here into a framebuffer of `size` pixels; 0 is the window's.
    View view(glm::ivec2 size, unsigned framebuffer) const;
};

}  // namespace rubble
