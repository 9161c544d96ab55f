#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace netplay {

/// A connection, as its own end calls it.
using Peer = uint32_t;

/// Reliable messages all arrive, in their order. The others arrive or do not, in any order.
enum class Delivery : uint8_t { Reliable, Unreliable };

/// What happened to a connection.
struct Event {
    enum class Kind : uint8_t { Connected, Disconnected, Received };
    Kind kind = Kind::Received;
    Peer peer = 0;
    std::vector<uint8_t> bytes;  ///< of a message that was received
};

/// One end of connections: all that server and clients know of a network. Used by one thread.
class Transport {
public:
    virtual ~Transport() = default;
    /// Takes what has happened; false: nothing more.
    virtual bool receive(Event& event) = 0;
    /// Sends a message. Does nothing if the connection has ended.
    virtual void send(Peer peer, Delivery delivery, std::span<const uint8_t> bytes) = 0;
    /// Ends a connection, behind what was sent reliably; both ends hear of it by Event::Kind::Disconnected.
    virtual void drop(Peer peer) = 0;
    /// To be called once in each step of 1/60 s, after what was sent in it.
    virtual void tick() = 0;
};

}  // namespace netplay
