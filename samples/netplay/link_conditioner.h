#pragma once
#include <deque>
#include <map>
#include <memory>
#include <random>
#include <span>
#include <vector>

#include "samples/netplay/transport.h"

namespace netplay {

/// A bad link: what is sent over it.
struct LinkSettings {
    int delay = 0;      ///< steps of 1/60 s that each datagram takes, in one direction
    double loss = 0.0;  ///< of datagrams: 0 to below 1
    uint32_t seed = 1;  ///< selects which are lost
};

/// A transport over a worse link than it has: delays and loses what it sends, by a clock of steps and a seeded
/// generator, so that the same messages meet the same fate on every machine. A lost message is gone; of a reliable one,
/// each lost datagram is sent again a round trip later, and those behind it wait.
class LinkConditioner final : public Transport {
public:
    /// What it is given to send goes over `inner`.
    LinkConditioner(std::unique_ptr<Transport> inner, const LinkSettings& settings);

    bool receive(Event& event) override;
    void send(Peer peer, Delivery delivery, std::span<const uint8_t> bytes) override;
    void drop(Peer peer) override;
    void tick() override;

    /// What it sends with.
    const Transport& inner() const { return *m_inner; }
    /// How many datagrams it has lost.
    uint64_t lost() const { return m_lost; }

private:
    struct Waiting {
        uint64_t due = 0;
        Delivery delivery = Delivery::Reliable;
        bool drops = false;  ///< the connection
        std::vector<uint8_t> bytes;
    };
    bool isLost();
    /// Steps until the last of the datagrams of a reliable message has come through.
    uint64_t delayOf(size_t bytes);
    void handOver(Peer peer, const Waiting& message);
    /// Hands over what is due.
    void release();

    std::unique_ptr<Transport> m_inner;
    LinkSettings m_settings;
    std::mt19937 m_random;
    uint64_t m_step = 0, m_lost = 0;
    std::map<Peer, std::deque<Waiting>> m_reliable, m_unreliable;
};

}  // namespace netplay
