#pragma once
#include <array>
#include <unordered_map>
#include <vector>

#include "samples/netplay/body_table.h"

namespace netplay {

/// Chooses which bodies one client hears of next. Each body that it does not know the pose of gains priority in each
/// message, the more the nearer and the faster it is, until it is sent; so near bodies are sent often, and no far one
/// is forgotten. A body that rests is sent until the client has said that a message with that pose has arrived.
class Interest {
public:
    /// Everything that has moved so far is of interest: for a client that joins.
    void restart(const BodyTable& bodies);
    /// What the last step moved is of interest.
    void follow(const BodyTable& bodies);
    /// The poses of the most urgent bodies for the message `sequence`, at most `count`, by their numbers.
    std::vector<BodyPose> choose(const BodyTable& bodies, const Vec3& viewer, size_t count, uint16_t sequence);
    /// The client has got these messages: the newest, and those before it as bits.
    void acknowledge(const BodyTable& bodies, uint16_t newest, uint32_t older);
    /// How many bodies the client may have another pose of.
    size_t pending() const { return m_priorities.size(); }

private:
    struct Sent {
        uint32_t id = 0;
        uint64_t movedStep = 0;
    };
    struct Packet {
        uint16_t sequence = 0;
        std::vector<Sent> bodies;
    };
    void acknowledge(const BodyTable& bodies, uint16_t sequence);

    std::unordered_map<uint32_t, double> m_priorities;  ///< of bodies that the client may have another pose of
    std::array<Packet, 64> m_packets;                   ///< the last ones, by sequence
};

}  // namespace netplay
