#include "samples/sandbox/shell/input.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace sandbox {
namespace {

/// What keys are for, where nothing was bound.
constexpr std::pair<const char*, const char*> kActions[] = {
    {"up", "w"},         {"down", "s"},       {"left", "a"},          {"right", "d"},
    {"jump", "space"},   {"crouch", "ctrl"},  {"usetool", "lmb"},     {"grab", "rmb"},
    {"interact", "e"},   {"flashlight", "f"}, {"handbrake", "space"}, {"pause", "esc"},
    {"sprint", "shift"},
};

/// "ctrl+z" without its last key; "" of a single key.
std::string heldOf(const std::string& key) {
    const size_t at = key.rfind('+');
    return at == std::string::npos || at == 0 ? "" : key.substr(0, at);
}

/// The last key of "ctrl+z".
std::string lastOf(const std::string& key) {
    const std::string held = heldOf(key);
    return held.empty() ? key : key.substr(held.size() + 1);
}

}  // namespace

void Input::beginFrame() {
    for (auto& [name, key] : m_keys) key.isPressed = key.isReleased = false;
    m_values.clear();
    for (const auto& [name, isDown] : std::exchange(m_askedKeys, {})) set(name, isDown);
    for (const auto& [name, amount] : std::exchange(m_askedMotion, {})) add(name, amount);
}

void Input::bind(const std::string& action, std::vector<std::string> keys) {
    m_bindings[action] = std::move(keys);
}

std::string Input::keyOf(const std::string& name) const {
    if (const auto bound = m_bindings.find(name); bound != m_bindings.end())
        return bound->second.empty() ? name : lastOf(bound->second.front());
    for (const auto& [action, key] : kActions)
        if (name == action) return key;
    return name;
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

const Input::Key* Input::find(const std::string& key) const {
    const auto found = m_keys.find(key);
    return found == m_keys.end() ? nullptr : &found->second;
}

/// Whether that holds for one of the keys of an action, or for a key.
template <class Holds>
bool Input::any(const std::string& name, Holds&& holds) const {
    const auto isOne = [&](const std::string& text) {
        const std::string held = heldOf(text);
        const Key* with = held.empty() ? nullptr : find(held);
        if (!held.empty() && !(with && with->isDown)) return false;
        const Key* key = find(lastOf(text));
        return key && holds(*key);
    };
    const auto bound = m_bindings.find(name);
    if (bound == m_bindings.end()) return isOne(keyOf(name));
    return std::any_of(bound->second.begin(), bound->second.end(), isOne);
}

bool Input::isDown(const std::string& name) const {
    return any(name, [](const Key& key) { return key.isDown; });
}

bool Input::isPressed(const std::string& name) const {
    return any(name, [](const Key& key) { return key.isPressed; });
}

bool Input::isReleased(const std::string& name) const {
    return any(name, [](const Key& key) { return key.isReleased; });
}

double Input::value(const std::string& name) const {
    if (name == "mousex") return m_x;
    if (name == "mousey") return m_y;
    const auto bound = m_bindings.find(name);
    if (bound == m_bindings.end()) {
        const auto found = m_values.find(name);
        return found == m_values.end() ? (isDown(name) ? 1.0 : 0.0) : found->second;
    }
    double most = 0.0;
    for (const std::string& text : bound->second) {
        const auto found = m_values.find(text);  // a stick or a trigger says how far
        const Key* key = found == m_values.end() ? find(lastOf(text)) : nullptr;
        most = std::max(most, key ? double(key->isDown) : found == m_values.end() ? 0.0 : found->second);
    }
    return most;
}

std::string Input::lastPressed() const {
    for (const auto& [name, key] : m_keys)
        if (key.isPressed) return name;
    return "";
}

}  // namespace sandbox
