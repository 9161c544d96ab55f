#include "samples/netplay/memory_transport.h"

#include <deque>
#include <map>
#include <utility>

namespace netplay {

/// Number 0 is the server's end; a client's end has the number that the server calls it by.
struct MemoryNetwork::State {
    std::map<Peer, std::deque<Event>> inboxes;  ///< of the ends that there are
    Peer last = 0;

    void put(Peer to, Event event) {
        if (const auto inbox = inboxes.find(to); inbox != inboxes.end()) inbox->second.push_back(std::move(event));
    }
};

class MemoryNetwork::End final : public Transport {
public:
    End(std::shared_ptr<State> state, Peer self) : m_state(std::move(state)), m_self(self) { m_state->inboxes[self]; }
    ~End() override {
        drop(0);
        m_state->inboxes.erase(m_self);
    }
    bool receive(Event& event) override {
        auto& inbox = m_state->inboxes[m_self];
        if (inbox.empty()) return false;
        event = std::move(inbox.front());
        inbox.pop_front();
        if (event.kind == Event::Kind::Disconnected) m_isOpen = false;
        return true;
    }
    void send(Peer peer, Delivery, std::span<const uint8_t> bytes) override {
        if (!m_self || m_isOpen)
            m_state->put(m_self ? 0 : peer, {Event::Kind::Received, m_self, {bytes.begin(), bytes.end()}});
    }
    void drop(Peer peer) override {
        if (m_self && !std::exchange(m_isOpen, false)) return;
        const Peer client = m_self ? m_self : peer;
        m_state->put(0, {Event::Kind::Disconnected, client, {}});
        m_state->put(client, {Event::Kind::Disconnected, 0, {}});
    }
    void tick() override {}

private:
    std::shared_ptr<State> m_state;
    Peer m_self;
    bool m_isOpen = true;  ///< of a client
};

MemoryNetwork::MemoryNetwork() : m_state(std::make_shared<State>()) {}
MemoryNetwork::~MemoryNetwork() = default;

std::unique_ptr<Transport> MemoryNetwork::listen() {
    return std::make_unique<End>(m_state, 0);
}

std::unique_ptr<Transport> MemoryNetwork::connect() {
    const Peer self = ++m_state->last;
    auto end = std::make_unique<End>(m_state, self);
    m_state->put(self, {Event::Kind::Connected, 0, {}});
    m_state->put(0, {Event::Kind::Connected, self, {}});
    return end;
}

}  // namespace netplay
