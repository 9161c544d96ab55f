#pragma once

namespace rubble {

class Window;

/// What the player asks for. forward, right, up: in [-1, 1].
struct PlayerInput {
    double forward = 0.0, right = 0.0, up = 0.0;
    double turnRight = 0.0, turnUp = 0.0;  ///< radians since the last call
    bool fast = false;
};

/// WASD, Space and Shift move, Control makes it fast, the mouse turns. To be called once after each poll().
PlayerInput readPlayerInput(Window& window);

}  // namespace rubble
