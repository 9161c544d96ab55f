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

/// The eyes of the sandbox: fly freely, or are those of a character that walks, jumps, crouches and swims.
class Player {
public:
    void place(const Pose& eye);
    /// Turns and flies the camera, or puts it where the character is. Returns what is to be done to the character.
    Edits move(const PlayerInput& input, const World& world, double seconds);
    void toggleWalk() { m_walks = !m_walks; }
    void toggleTorch() { m_hasTorch = !m_hasTorch; }
    /// Makes, carries or removes the torch: once before each step.
    Edits carryTorch(const World& world) const;
    bool walks() const { return m_walks; }
    const Camera& camera() const { return m_camera; }

private:
    Edits walk(const PlayerInput& input, const World& world, double seconds);
    void follow(const Character& character, double seconds);

    Camera m_camera;
    bool m_walks = false, m_hasTorch = false;
    bool m_isSpawning = false;  ///< the character has been asked for
};

}  // namespace rubble
