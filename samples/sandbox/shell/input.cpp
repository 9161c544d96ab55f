#include "samples/sandbox/shell/input.h"

#include <utility>

namespace sandbox {
namespace {

/// What keys are for.
constexpr std::pair<const char*, const char*> kActions[] = {
    {"up", "w"},         {"down", "s"},       {"left", "a"},          {"right", "d"},
    {"jump", "space"},   {"crouch", "ctrl"},  {"usetool", "lmb"},     {"grab", "rmb"},
    {"interact", "e"},   {"flashlight", "f"}, {"handbrake", "space"}, {"pause", "esc"},
    {"sprint", "shift"},
};

const std::string keyOf(const std::string& name) {
    for (const auto& [action, key] : kActions)
        if (name == action) return key;
    return name;
}

}  // namespace

void Input::beginFrame() {
    for (auto& [name, key] : m_keys) key.isPressed = key.isReleased = false;
    m_values.clear();
    for (const auto& [name, isDown] : std::exchange(m_askedKeys, {})) set(name, isDown);
    for (const auto& [name, amount] : std::exchange(m_askedMotion, {})) add(name, amount);
}

void Input::set(const std::string& name, bool isDown) {
    Key& key = m_keys[keyOf(name)];
    key.isPressed = key.isPressed || (isDown && !key.isDown);
    key.isReleased = key.isReleased || (!isDown && key.isDown);
    key.isDown = isDown;
}

void Input::add(const std::string& name, double amount) {
    m_values[name] += amount;
}

void Input::place(double x, double y) {
    m_x = x;
    m_y = y;
}

const Input::Key* Input::find(const std::string& name) const {
    const auto found = m_keys.find(keyOf(name));
    return found == m_keys.end() ? nullptr : &found->second;
}

bool Input::isDown(const std::string& name) const {
    const Key* key = find(name);
    return key && key->isDown;
}

bool Input::isPressed(const std::string& name) const {
    const Key* key = find(name);
    return key && key->isPressed;
}

bool Input::isReleased(const std::string& name) const {
    const Key* key = find(name);
    return key && key->isReleased;
}

double Input::value(const std::string& name) const {
    if (name == "mousex") return m_x;
    if (name == "mousey") return m_y;
    const auto found = m_values.find(name);
    return found == m_values.end() ? (isDown(name) ? 1.0 : 0.0) : found->second;
}

}  // namespace sandbox
