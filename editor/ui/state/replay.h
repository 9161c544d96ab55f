#pragma once
#include <cstdint>
#include <memory>
#include <rubble/rubble.hpp>
#include <string>
#include <vector>

namespace editor {

/// The last play, step by step: a second world follows what the steps of the first one changed, to any of them. It
/// costs the level's world nothing but the bytes of these changes, and stays after play has ended.
class Replay {
public:
    /// Forgets what it has, and begins with a world that begins to play.
    void begin(rubble::World& world);
    /// Adds a step that the world has taken since, as its deltas; of more than a minute the first.
    void add(const std::vector<uint8_t>& step);
    /// Forgets all but the first steps: the world has gone back to them, and goes on from there.
    void rewind(rubble::World& world, size_t steps);
    /// Ends it; what was added stays.
    void end() { m_isRunning = false; }
    /// Whether it goes on.
    bool isRunning() const { return m_isRunning; }

    /// How many steps it has.
    size_t size() const { return m_steps.size(); }
    /// Shows what became of so many steps, 1 or more: from the first one on where it has shown more. Throws
    /// rubble::Error.
    void seek(size_t place);
    /// How many steps are shown.
    size_t place() const { return m_place; }
    /// The world that shows it; null: there is none yet.
    rubble::World* world() { return m_world.get(); }
    /// Grows with every change of what is shown.
    uint64_t version() const { return m_version; }
    /// Bytes that it holds.
    size_t bytes() const { return m_bytes; }

private:
    /// A saved game, and after how many steps it was saved.
    struct Start {
        size_t step;
        std::vector<uint8_t> game;
    };
    std::vector<Start> m_starts;
    std::vector<std::vector<uint8_t>> m_steps;
    std::unique_ptr<rubble::World> m_world;
    size_t m_place = 0, m_bytes = 0;
    uint64_t m_version = 1;
    bool m_isRunning = false, m_isLoaded = false;
};

}  // namespace editor
