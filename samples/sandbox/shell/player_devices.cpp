// Keyboard and mouse of a window, by the names that scripts know.
#include "samples/sandbox/shell/player_devices.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <string>

#include "samples/support/window.h"

namespace sandbox {
namespace {

constexpr double kCanvasHeight = 1080.0;

struct KeyName {
    int key;
    const char* name;
};
constexpr KeyName kKeys[] = {
    {GLFW_KEY_SPACE, "space"},       {GLFW_KEY_ESCAPE, "esc"},          {GLFW_KEY_TAB, "tab"},
    {GLFW_KEY_ENTER, "return"},      {GLFW_KEY_BACKSPACE, "backspace"}, {GLFW_KEY_LEFT_SHIFT, "shift"},
    {GLFW_KEY_LEFT_CONTROL, "ctrl"}, {GLFW_KEY_LEFT_ALT, "alt"},        {GLFW_KEY_UP, "uparrow"},
    {GLFW_KEY_DOWN, "downarrow"},    {GLFW_KEY_LEFT, "leftarrow"},      {GLFW_KEY_RIGHT, "rightarrow"},
};

void readKeys(const rubble::Window& window, Input& input) {
    for (const KeyName& row : kKeys) input.set(row.name, window.held(row.key));
    for (int key = GLFW_KEY_A; key <= GLFW_KEY_Z; ++key)
        input.set(std::string(1, char('a' + key - GLFW_KEY_A)), window.held(key));
    for (int key = GLFW_KEY_0; key <= GLFW_KEY_9; ++key)
        input.set(std::string(1, char('0' + key - GLFW_KEY_0)), window.held(key));
    for (int i = 1; i <= 12; ++i) input.set("f" + std::to_string(i), window.held(GLFW_KEY_F1 + i - 1));
}

}  // namespace

bool readDevices(rubble::Display& display, Input& input) {
    rubble::Window* const window = display.window();
    if (!window) return true;
    const bool isOpen = window->poll();
    readKeys(*window, input);
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
