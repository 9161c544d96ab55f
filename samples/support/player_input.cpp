#include "samples/support/player_input.h"

#include <GLFW/glfw3.h>

#include "samples/support/window.h"

namespace rubble {

constexpr double kMouseRadiansPerPixel = 0.0025;

PlayerInput readPlayerInput(Window& window) {
    PlayerInput input;
    input.forward = window.held(GLFW_KEY_W) - window.held(GLFW_KEY_S);
    input.right = window.held(GLFW_KEY_D) - window.held(GLFW_KEY_A);
    input.up = window.held(GLFW_KEY_SPACE) - window.held(GLFW_KEY_LEFT_SHIFT);
    input.fast = window.held(GLFW_KEY_LEFT_CONTROL);
    const glm::dvec2 mouse = window.takeMouseMotion();
    input.turnRight = mouse.x * kMouseRadiansPerPixel;
    input.turnUp = -mouse.y * kMouseRadiansPerPixel;
    return input;
}

}  // namespace rubble
