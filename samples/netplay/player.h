#pragma once
#include <rubble/rubble.hpp>

#include "samples/netplay/protocol.h"

namespace netplay {

inline constexpr double kPlayerSpeed = 12.0;  ///< m/s, the fastest
inline constexpr double kReach = 60.0;        ///< metres that tools reach

/// A player as the server has it: it flies where its client wants to go, no faster than it may, and uses tools no more
/// often than it may. Where it is follows from wishes alone: no client says where it is.
class Player {
public:
    /// Begins at a place of its own around the yard.
    explicit Player(uint32_t number);
    /// Takes a wish: how fast to go along each axis.
    void want(const Input& input);
    /// Flies for a step of 1/60 s.
    void step();
    /// Whether it may use a tool now; then the time until the next begins.
    bool mayUse(uint64_t step);
    /// Where it is, metres.
    const Vec3& position() const { return m_position; }

private:
    Vec3 m_position{};
    Vec3 m_velocity{};
    uint64_t m_nextUse = 0;  ///< the step from which it may use a tool
};

/// Uses a tool from a place in a direction: an edit at what lies ahead. Nothing, if that is nothing.
void useTool(rubble::World& world, const Vec3& from, const Ask& ask);

}  // namespace netplay
