#include "samples/netplay/enet_transport.h"

#include <enet/enet.h>

#include <algorithm>
#include <cerrno>
#include <map>
#include <span>
#include <stdexcept>

namespace netplay {
namespace {

enum Channel : uint8_t { kReliable, kUnreliable, kChannels };
constexpr uint64_t kUdpHeader = 28;  // with that of IP
constexpr int kMaxReads = 1024;      // of the socket in a tick: more empty datagrams than its buffer holds
constexpr size_t kPending = 256;     // connects that the other end has not confirmed yet

void startEnet() {
    static const int result = enet_initialize();
    if (result != 0) throw std::runtime_error("ENet could not start");
}

bool isConnect(const ENetHost& host) {
    constexpr unsigned kNoPeer = 0xfff;
    return host.receivedDataLength >= 2 && ((host.receivedData[0] << 8 | host.receivedData[1]) & kNoPeer) == kNoPeer;
}

/// When something was last sent to a peer; at the very end, if nothing was yet.
enet_uint32 lastSent(const ENetPeer* peer) {
    return peer->lastSendTime - 1;
}

/// Whether a peer is no connection yet, or no longer.
bool isLoose(const ENetPeer& peer) {
    return peer.state == ENET_PEER_STATE_ACKNOWLEDGING_CONNECT || peer.state == ENET_PEER_STATE_DISCONNECTING ||
           peer.state == ENET_PEER_STATE_DISCONNECT_LATER;
}

/// Called for each datagram. A connect that finds all peers in use takes the place of one that is loose: the oldest of
/// the address that has most of these, so that no address keeps others out.
int makeRoom(ENetHost* host, ENetEvent*) {
    const std::span<ENetPeer> peers(host->peers, host->peerCount);
    const auto isFree = [](const ENetPeer& peer) { return peer.state == ENET_PEER_STATE_DISCONNECTED; };
    if (!isConnect(*host) || std::any_of(peers.begin(), peers.end(), isFree)) return 0;
    std::map<enet_uint32, std::vector<ENetPeer*>> pending;  // by address
    for (ENetPeer& peer : peers)
        if (isLoose(peer)) pending[peer.address.host].push_back(&peer);
    const auto most = std::max_element(pending.begin(), pending.end(),
                                       [](const auto& a, const auto& b) { return a.second.size() < b.second.size(); });
    if (most != pending.end()) enet_peer_reset(*std::ranges::min_element(most->second, {}, lastSent));
    return 0;
}

std::string whyNoPort() {
    return errno == EACCES ? "expected one from 1024 on: this user may not take lower ones" : "expected a free one";
}

class EnetTransport final : public Transport {
public:
    EnetTransport(const ENetAddress* address, size_t peers, bool patient) : m_patient(patient) {
        m_host.reset(enet_host_create(address, peers, kChannels, 0, 0));
        if (!m_host)
            throw std::runtime_error(address ? "UDP port " + std::to_string(address->port) + ": " + whyNoPort()
                                             : "ENet could not make a host");
        m_host->intercept = makeRoom;
    }
    ~EnetTransport() override {
        for (auto& [number, peer] : m_peers) enet_peer_disconnect_now(peer, 0);
        enet_host_flush(m_host.get());
    }

    void connect(const ENetAddress& address) {
        if (!enet_host_connect(m_host.get(), &address, kChannels, 0)) throw std::runtime_error("ENet has no peer left");
    }

    bool receive(Event& event) override {
        if (!m_dropped.empty()) {
            event = {Event::Kind::Disconnected, m_dropped.back(), {}};
            m_dropped.pop_back();
            return true;
        }
        ENetEvent got;
        while (hasNext(got)) {
            if (got.type == ENET_EVENT_TYPE_CONNECT) return open(got.peer, event);
            const Peer peer = numberOf(got.peer);
            if (got.type == ENET_EVENT_TYPE_DISCONNECT) {
                got.peer->data = nullptr;
                if (peer && !m_peers.erase(peer)) continue;
                event = {Event::Kind::Disconnected, peer, {}};
                return true;
            }
            event = {Event::Kind::Received, peer, {got.packet->data, got.packet->data + got.packet->dataLength}};
            enet_packet_destroy(got.packet);
            if (m_peers.contains(peer)) return true;
        }
        return false;
    }

    void send(Peer peer, Delivery delivery, std::span<const uint8_t> bytes) override {
        const auto found = m_peers.find(peer);
        if (found == m_peers.end()) return;
        const bool isReliable = delivery == Delivery::Reliable;
        ENetPacket* packet = enet_packet_create(bytes.data(), bytes.size(),
                                                isReliable ? ENET_PACKET_FLAG_RELIABLE : ENET_PACKET_FLAG_UNSEQUENCED);
        if (!packet) throw std::bad_alloc();
        if (enet_peer_send(found->second, isReliable ? kReliable : kUnreliable, packet) != 0)
            enet_packet_destroy(packet);
    }

    void drop(Peer peer) override {
        const auto found = m_peers.find(peer);
        if (found == m_peers.end()) return;
        enet_peer_disconnect_later(found->second, 0);
        m_peers.erase(found);
        m_dropped.push_back(peer);
    }

    void tick() override {
        m_reads = 0;
        enet_host_flush(m_host.get());
    }

    uint16_t port() const { return m_host->address.port; }
    uint64_t bytes() const {
        return m_host->totalSentData + m_host->totalReceivedData +
               kUdpHeader * (uint64_t(m_host->totalSentPackets) + m_host->totalReceivedPackets);
    }

private:
    /// ENet stops reading at a datagram that is empty or too long, whatever lies behind it.
    bool hasNext(ENetEvent& event) {
        for (;;) {
            if (enet_host_service(m_host.get(), &event, 0) > 0) return true;
            enet_uint32 ready = ENET_SOCKET_WAIT_RECEIVE;
            if (++m_reads > kMaxReads || enet_socket_wait(m_host->socket, &ready, 0) != 0) return false;
            if (!(ready & ENET_SOCKET_WAIT_RECEIVE)) return false;
        }
    }
    bool open(ENetPeer* peer, Event& event) {
        const Peer number = ++m_last;
        peer->data = reinterpret_cast<void*>(uintptr_t(number));
        m_peers[number] = peer;
        if (m_patient) {
            constexpr enet_uint32 kHour = 3600 * 1000;
            enet_peer_timeout(peer, 1u << 20, kHour, kHour);
            enet_peer_throttle_configure(peer, 5000, ENET_PEER_PACKET_THROTTLE_SCALE, 0);  // drops none by itself
        }
        event = {Event::Kind::Connected, number, {}};
        return true;
    }
    static Peer numberOf(const ENetPeer* peer) { return Peer(reinterpret_cast<uintptr_t>(peer->data)); }

    struct Destroy {
        void operator()(ENetHost* host) const { enet_host_destroy(host); }
    };
    std::unique_ptr<ENetHost, Destroy> m_host;
    std::map<Peer, ENetPeer*> m_peers;
    std::vector<Peer> m_dropped;  ///< not yet told to have ended
    Peer m_last = 0;
    int m_reads = 0;  ///< in this tick that gave no event
    bool m_patient;
};

}  // namespace

std::unique_ptr<Transport> listenWithEnet(uint16_t port, size_t peers, bool patient) {
    startEnet();
    const ENetAddress address{ENET_HOST_ANY, port};
    return std::make_unique<EnetTransport>(&address, peers + kPending, patient);
}

std::unique_ptr<Transport> connectWithEnet(const std::string& host, uint16_t port, bool patient) {
    startEnet();
    ENetAddress address{0, port};
    if (enet_address_set_host(&address, host.c_str()) != 0)
        throw std::runtime_error(host + ": expected the name or address of a host");
    auto transport = std::make_unique<EnetTransport>(nullptr, 1, patient);
    transport->connect(address);
    return transport;
}

uint16_t portOf(const Transport& listening) {
    return dynamic_cast<const EnetTransport&>(listening).port();
}

uint64_t bytesOnWire(const Transport& transport) {
    return dynamic_cast<const EnetTransport&>(transport).bytes();
}

}  // namespace netplay
