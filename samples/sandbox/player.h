#pragma once
#include "runtime/world/world.h"
#include "samples/support/camera.h"

namespace rubble {

/// Which way the player wants to go, each in [-1, 1].
struct PlayerInput {
    double forward = 0.0, right = 0.0, up = 0.0;
    double turnRight = 0.0, turnUp = 0.0;  ///< radians since the last call
    bool fast = false;
};

/// The eyes of the sandbox: flies freely, or walks at eye height on whatever stands below.
class Player {
public:
    void place(const Pose& eye);
    void move(const PlayerInput& input, const World& world, double seconds);
    void toggleWalk() { m_walks = !m_walks; }
    bool walks() const { return m_walks; }
    const Camera& camera() const { return m_camera; }

private:
    void walk(glm::dvec3 step, bool jump, const World& world, double seconds);

    Camera m_camera;
    double m_fallSpeed = 0.0;
    bool m_walks = false;
};

}  // namespace rubble
