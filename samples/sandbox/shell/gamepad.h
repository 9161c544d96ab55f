#pragma once
#include <array>

#include "samples/sandbox/shell/input.h"

namespace sandbox {

/// What a gamepad says, in the order of GLFW's standard layout.
struct GamepadState {
    /// A B X Y, shoulders, back, start, guide, sticks, cross: up right down left.
    static constexpr std::array<const char*, 15> kButtons = {
        "a", "b", "x", "y", "lb", "rb", "back", "start", "guide", "ls", "rs", "up", "right", "down", "left"};
    static constexpr std::array<const char*, 6> kAxes = {"lx", "ly", "rx", "ry", "lt", "rt"};
    std::array<bool, 15> buttons = {};
    /// Sticks left and right: x to the right, y downwards, -1 to 1; triggers -1 (free) to 1.
    std::array<double, 6> axes = {0, 0, 0, 0, -1, -1};
};

/// Sets the buttons "pada" ... and the values "padlx", "padly", "padrx", "padry" (-1 to 1, up is positive), of triggers
/// "padlt" and "padrt", and of each direction of a stick, as "padlup" (0 to 1). What is nearly at rest is at rest; far
/// out a trigger or a direction is down, as a button is.
void readGamepad(const GamepadState& state, Input& input);

}  // namespace sandbox
