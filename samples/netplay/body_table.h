#pragma once
#include <rubble/rubble.hpp>
#include <unordered_map>
#include <vector>

#include "samples/netplay/protocol.h"

namespace netplay {

/// A body of the server's world that has moved since the server started.
struct TrackedBody {
    BodyPose pose;  ///< after the step in which it moved last
    uint64_t handle = 0;
    uint64_t movedStep = 0, firstStep = 0;  ///< in which it moved last, and first
    double speed = 0.0;                     ///< m/s
};

/// The bodies that have moved, each with a number that is shorter than its handle and never used again. Costs what
/// moves.
class BodyTable {
public:
    /// Takes up what the last step of the world moved and destroyed. moved(): the bodies that it moved.
    void follow(const rubble::World& world);
    /// Those that the last step moved, by their numbers.
    const std::vector<uint32_t>& moved() const { return m_moved; }
    /// One of them; null if it is gone.
    const TrackedBody* find(uint32_t id) const;
    /// The numbers of all, in order.
    std::vector<uint32_t> all() const;
    /// The names of all, in order.
    std::vector<BodyName> names() const;
    /// Those that are new since the last call, in order.
    std::vector<BodyName> takeNewNames();

private:
    std::unordered_map<uint64_t, uint32_t> m_ids;  ///< by handle
    std::unordered_map<uint32_t, TrackedBody> m_bodies;
    std::vector<uint32_t> m_moved;
    std::vector<BodyName> m_newNames;
    uint32_t m_next = 0;
};

}  // namespace netplay
