#pragma once
#include <span>
#include <vector>

#include "runtime/world/state/fires.h"

namespace rubble {

/// Finds what was lit and what went out in a step: the difference of what burns, which therefore adds up to it, also
/// where a burning part comes off, burns down or is undone. Costs what is hot. [main-thread]
class FireReports {
public:
    /// What burns in this world is no news.
    void restart(const WorldState& world);
    /// Replaces the lists by what has changed since the last call.
    void step(const WorldState& world);

    /// In slot order.
    std::span<const Fire> lit() const { return m_lit; }
    /// The same, where they burned last; their shapes may be gone.
    std::span<const Fire> out() const { return m_out; }

private:
    std::vector<Fire> m_burning, m_lit, m_out;
};

}  // namespace rubble
