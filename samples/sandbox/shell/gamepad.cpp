#include "samples/sandbox/shell/gamepad.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace sandbox {
namespace {

constexpr double kDeadStick = 0.16, kDeadTrigger = 0.06;
constexpr double kFar = 0.6, kNear = 0.45;  ///< where a stick becomes a button, and no button any more

/// One direction of a stick, or a trigger: how far, and whether it counts as a button.
void readHalf(Input& input, const std::string& name, double value) {
    input.set(name, value > (input.isDown(name) ? kNear : kFar));
    input.add(name, std::max(value, 0.0));
}

/// A stick by its letter. The dead zone is a disc, beyond which values grow from 0.
void readStick(Input& input, const std::string& name, double x, double y) {
    const double length = std::hypot(x, y);
    const double scale = length < kDeadStick ? 0.0 : std::min(1.0, (length - kDeadStick) / (1.0 - kDeadStick)) / length;
    x *= scale, y *= scale;
    input.add(name + "x", x);
    input.add(name + "y", y);
    readHalf(input, name + "right", x);
    readHalf(input, name + "left", -x);
    readHalf(input, name + "up", y);
    readHalf(input, name + "down", -y);
}

void readTrigger(Input& input, const std::string& name, double value) {
    const double share = std::clamp((0.5 * (value + 1.0) - kDeadTrigger) / (1.0 - kDeadTrigger), 0.0, 1.0);
    readHalf(input, name, share);
}

}  // namespace

void readGamepad(const GamepadState& state, Input& input) {
    for (size_t i = 0; i < state.buttons.size(); ++i)
        input.set(std::string("pad") + GamepadState::kButtons[i], state.buttons[i]);
    readStick(input, "padl", state.axes[0], -state.axes[1]);
    readStick(input, "padr", state.axes[2], -state.axes[3]);
    readTrigger(input, "padlt", state.axes[4]);
    readTrigger(input, "padrt", state.axes[5]);
}

}  // namespace sandbox
