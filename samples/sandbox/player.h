#pragma once
#include "runtime/world/world.h"
#include "samples/support/camera.h"
#include "samples/support/player_input.h"

namespace rubble {

/// The sandbox's camera: it flies freely, or follows a character that walks, jumps, crouches and swims.
class Player {
public:
    /// Puts the camera at a pose and looks along its -z.
    void place(const Pose& eye);
    /// Turns and flies the camera, or moves it to the character's eyes. Returns the edits that add, move or remove the
    /// character. `seconds`: since the last call.
    Edits move(const PlayerInput& input, const World& world, double seconds);
    /// Switches between flying and walking.
    void toggleWalk() { m_walks = !m_walks; }
    /// Switches the torch on or off.
    void toggleTorch() { m_hasTorch = !m_hasTorch; }
    /// The edits that add the torch, move it with the camera or remove it. Call once before each step.
    Edits carryTorch(const World& world) const;
    /// Where the player looks from.
    const Camera& camera() const { return m_camera; }

private:
    Edits walk(const PlayerInput& input, const World& world, double seconds);
    void follow(const Character& character, double seconds);

    Camera m_camera;
    bool m_walks = false, m_hasTorch = false;
    bool m_isSpawning = false;  ///< the edit that adds the character is on its way into the next step
};

}  // namespace rubble
