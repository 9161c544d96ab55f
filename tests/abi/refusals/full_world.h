#pragma once
#include <rubble/rubble.h>

#include <map>
#include <string>

namespace rubble {

/// Handles of objects by their types, as "rubble_body".
using Handles = std::map<std::string, uint64_t>;

/// A world with an object of each kind.
class FullWorld {
public:
    /// Loads a level and makes what it lacks. flags: RUBBLE_WORLD_... more than those that reads need.
    explicit FullWorld(const std::string& level, uint32_t flags = RUBBLE_WORLD_NO_RENDERER);
    ~FullWorld();
    FullWorld(const FullWorld&) = delete;
    FullWorld& operator=(const FullWorld&) = delete;

    /// Makes its renderer, which lives. A GL context must be current, and the host's.
    void addRenderer();
    /// Steps once more.
    void step();
    /// Its state hash.
    uint64_t hash() const;
    /// Whether it still answers.
    bool isAlive() const;
    /// The world.
    rubble_world world() const { return m_world; }
    /// An object of each kind that lives.
    const Handles& live() const { return m_live; }
    /// An object of each kind that is gone; none of kinds that live as long as their world.
    const Handles& stale() const { return m_stale; }

private:
    /// Makes an object of each kind; they are there after a step.
    Handles makeAll(double x);
    bool m_hasPhysics;  ///< of its own, with a character
    rubble_world m_world = 0;
    Handles m_live, m_stale;
};

}  // namespace rubble
