#pragma once
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace sandbox {

/// What the player does, by names: keys ("w", "space", "f5"), buttons of the mouse ("lmb"), what they are for
/// ("usetool"), and values ("mousedx").
class Input {
public:
    /// Forgets what was pressed, released and moved, and takes over what scripts have asked for since: before a frame's
    /// events.
    void beginFrame();
    /// From the next frame on a key is down or up, or something has moved by an amount: for bots.
    void ask(const std::string& key, bool isDown) { m_askedKeys.emplace_back(key, isDown); }
    /// The same of a value.
    void ask(const std::string& name, double amount) { m_askedMotion.emplace_back(name, amount); }
    /// What an action is bound to: keys and buttons, or two held together, as "ctrl+z". Actions that nothing was bound
    /// to have the keys that they begin with.
    void bind(const std::string& action, std::vector<std::string> keys);
    /// A key or button is down or up; of an action its first key.
    void set(const std::string& key, bool isDown);
    /// Adds to a value that each frame begins at 0: "mousedx", "mousedy" (pixels), "mousewheel" or a stick.
    void add(const std::string& name, double amount);
    /// Where the cursor is, in units of a canvas that is 1080 high.
    void place(double x, double y);

    /// Whether it is down.
    bool isDown(const std::string& name) const;
    /// Whether it went down in this frame.
    bool isPressed(const std::string& name) const;
    /// Whether it went up in this frame.
    bool isReleased(const std::string& name) const;
    /// A value; 0 of what has none. Of an action the largest of what it is bound to.
    double value(const std::string& name) const;
    /// A key or button that went down in this frame; "" if none did.
    std::string lastPressed() const;

private:
    struct Key {
        bool isDown = false, isPressed = false, isReleased = false;
    };
    const Key* find(const std::string& key) const;
    template <class Holds>
    bool any(const std::string& name, Holds&& holds) const;
    std::string keyOf(const std::string& name) const;

    std::map<std::string, std::vector<std::string>> m_bindings;
    std::map<std::string, Key> m_keys;
    std::map<std::string, double> m_values;
    std::vector<std::pair<std::string, bool>> m_askedKeys;
    std::vector<std::pair<std::string, double>> m_askedMotion;
    double m_x = 0.0, m_y = 0.0;
};

}  // namespace sandbox
