// Keyboard, mouse and gamepad of a window, by the names that scripts know.
#include "samples/sandbox/shell/player_devices.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <string>

#include "samples/sandbox/shell/gamepad.h"
#include "samples/support/window.h"

namespace sandbox {
namespace {

constexpr double kCanvasHeight = 1080.0;

struct KeyName {
    int key;
    const char* name;
};
constexpr KeyName kKeys[] = {
    {GLFW_KEY_SPACE, "space"},
    {GLFW_KEY_ESCAPE, "esc"},
    {GLFW_KEY_TAB, "tab"},
    {GLFW_KEY_ENTER, "return"},
    {GLFW_KEY_BACKSPACE, "backspace"},
    {GLFW_KEY_LEFT_SHIFT, "shift"},
    {GLFW_KEY_LEFT_CONTROL, "ctrl"},
    {GLFW_KEY_LEFT_ALT, "alt"},
    {GLFW_KEY_UP, "uparrow"},
    {GLFW_KEY_DOWN, "downarrow"},
    {GLFW_KEY_LEFT, "leftarrow"},
    {GLFW_KEY_RIGHT, "rightarrow"},
    {GLFW_KEY_RIGHT_SHIFT, "rshift"},
    {GLFW_KEY_RIGHT_CONTROL, "rctrl"},
    {GLFW_KEY_RIGHT_ALT, "ralt"},
    {GLFW_KEY_INSERT, "insert"},
    {GLFW_KEY_DELETE, "delete"},
    {GLFW_KEY_HOME, "home"},
    {GLFW_KEY_END, "end"},
    {GLFW_KEY_PAGE_UP, "pgup"},
    {GLFW_KEY_PAGE_DOWN, "pgdown"},
    {GLFW_KEY_CAPS_LOCK, "capslock"},
    {GLFW_KEY_COMMA, ","},
    {GLFW_KEY_PERIOD, "."},
    {GLFW_KEY_SLASH, "/"},
    {GLFW_KEY_SEMICOLON, ";"},
    {GLFW_KEY_APOSTROPHE, "'"},
    {GLFW_KEY_LEFT_BRACKET, "["},
    {GLFW_KEY_RIGHT_BRACKET, "]"},
    {GLFW_KEY_BACKSLASH, "\\"},
    {GLFW_KEY_MINUS, "-"},
    {GLFW_KEY_EQUAL, "="},
    {GLFW_KEY_GRAVE_ACCENT, "`"},
};

void readKeys(const rubble::Window& window, Input& input) {
    for (const KeyName& row : kKeys) input.set(row.name, window.held(row.key));
    for (int key = GLFW_KEY_A; key <= GLFW_KEY_Z; ++key)
        input.set(std::string(1, char('a' + key - GLFW_KEY_A)), window.held(key));
    for (int key = GLFW_KEY_0; key <= GLFW_KEY_9; ++key)
        input.set(std::string(1, char('0' + key - GLFW_KEY_0)), window.held(key));
    for (int i = 1; i <= 12; ++i) input.set("f" + std::to_string(i), window.held(GLFW_KEY_F1 + i - 1));
}

/// The first gamepad that GLFW knows; without one all is free, so that nothing stays down.
void readFirstGamepad(Input& input) {
    static bool wasThere = false;
    GamepadState state;
    GLFWgamepadstate raw;
    bool isThere = false;
    for (int id = GLFW_JOYSTICK_1; id <= GLFW_JOYSTICK_LAST && !isThere; ++id)
        isThere = glfwGetGamepadState(id, &raw) == GLFW_TRUE;
    for (size_t i = 0; isThere && i < state.buttons.size(); ++i) state.buttons[i] = raw.buttons[i] == GLFW_PRESS;
    for (size_t i = 0; isThere && i < state.axes.size(); ++i) state.axes[i] = double(raw.axes[i]);
    if (isThere || wasThere) readGamepad(state, input);
    wasThere = isThere;
}

}  // namespace

bool readDevices(rubble::Display& display, Input& input) {
    rubble::Window* const window = display.window();
    if (!window) return true;
    const bool isOpen = window->poll();
    readKeys(*window, input);
    readFirstGamepad(input);
    static constexpr const char* kButtons[] = {"lmb", "rmb", "mmb"};
    for (int i = 0; i < 3; ++i) input.set(kButtons[i], window->buttonHeld(i));
    const glm::dvec2 motion = window->takeMouseMotion();
    input.add("mousedx", motion.x);
    input.add("mousedy", motion.y);
    input.add("mousewheel", window->takeWheel());
    const glm::dvec2 at = window->cursor() * (kCanvasHeight / std::max(1, display.size().y));
    input.place(at.x, at.y);
    return isOpen;
}

}  // namespace sandbox
