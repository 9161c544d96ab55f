#include "samples/netplay/server.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace netplay {
namespace {

constexpr int kMaxMessagesPerStep = 32;     // of one client, after a stall of half a second
constexpr uint64_t kStepsToJoin = 10 * 60;  // that a connection may say nothing
constexpr size_t kMaxWaiting = 64;          // connections that have not joined
constexpr size_t kHeaderBytes = 32;         // of a message with poses, and its bytes for a player
constexpr size_t kPlayerBytes = 9;

}  // namespace

/// A player, also while the connection is lost.
struct Server::Session {
    uint64_t token = 0;
    uint32_t number = 0;
    Player player;
    Interest interest;
    Traffic traffic;
    uint16_t sequence = 0;
    Client* client = nullptr;  ///< null: gone since `lostAt`
    uint64_t lostAt = 0;
};

/// A connection.
struct Server::Client {
    Peer peer = 0;
    uint64_t since = 0;
    int messages = 0;            ///< in this step
    Session* session = nullptr;  ///< null: has not joined
    bool isGone = false;
};

Server::Server(rubble::World& world, std::unique_ptr<Transport> transport, ServerSettings settings)
    : m_world(world),
      m_transport(std::move(transport)),
      m_settings(std::move(settings)),
      m_random(m_settings.seed),
      m_game(m_random() | 1),
      m_step(world.get_events().step),
      m_log(world, m_bodies) {}

Server::~Server() = default;

void Server::say(const std::string& line) const {
    if (m_settings.log) m_settings.log(line);
}

void Server::tick() {
    receive();
    movePlayers();
    m_world.step();
    ++m_step;
    m_bodies.follow(m_world);
    m_log.follow();
    for (auto& [token, session] : m_sessions) session->interest.follow(m_bodies);
    if (m_step % kStepsPerEdits == 0) sendEdits();
    for (auto& [peer, client] : m_clients)
        if (client->session && (m_step + client->session->number) % kStepsPerPoses == 0) sendPoses(*client);
    if (m_step % kStepsPerSecond == 0) {
        for (auto& [token, session] : m_sessions)
            if (session->client) session->traffic.endSecond();
        forgetAbsent();
    }
    m_transport->tick();
}

void Server::receive() {
    for (auto& [peer, client] : m_clients) client->messages = 0;
    Event event;
    while (m_transport->receive(event)) {
        if (event.kind == Event::Kind::Connected) {
            accept(event.peer);
            continue;
        }
        const auto found = m_clients.find(event.peer);
        if (found == m_clients.end()) continue;  // it was dropped
        if (event.kind == Event::Kind::Received)
            handle(*found->second, event.bytes);
        else
            disconnect(*found->second);
        if (found->second->isGone) m_clients.erase(found);
    }
    std::erase_if(m_clients, [&](const auto& entry) {
        const Client& client = *entry.second;
        const bool isSilent = !client.session && m_step - client.since > kStepsToJoin;
        if (isSilent) m_transport->drop(client.peer);
        return isSilent || client.isGone;
    });
}

/// Of those that have not joined, the oldest gives way.
void Server::accept(Peer peer) {
    auto& client = m_clients[peer] = std::make_unique<Client>();
    client->peer = peer, client->since = m_step;
    const auto waits = [](const auto& entry) { return !entry.second->session; };
    if (size_t(std::count_if(m_clients.begin(), m_clients.end(), waits)) <= kMaxWaiting) return;
    const auto oldest = std::find_if(m_clients.begin(), m_clients.end(), waits);
    m_transport->drop(oldest->first);
    m_clients.erase(oldest);
}

void Server::handle(Client& client, std::span<const uint8_t> bytes) {
    const std::optional<Message> message = decode(bytes, true);
    bool isGood = message && ++client.messages <= kMaxMessagesPerStep;
    if (isGood) {
        if (const auto* join = std::get_if<Join>(&*message)) isGood = handle(client, *join);
        if (const auto* input = std::get_if<Input>(&*message)) isGood = handle(client, *input);
        if (const auto* ask = std::get_if<Ask>(&*message)) isGood = handle(client, *ask);
    }
    if (isGood || client.isGone) return;
    ++m_dropped;
    say(fmt::format("connection {}: dropped for what it sent", client.peer));
    m_transport->drop(client.peer);
    disconnect(client);
}

/// Ends what a connection has begun; receive() erases it.
void Server::disconnect(Client& client) {
    client.isGone = true;
    if (!client.session) return;
    say(fmt::format("player {} has gone", client.session->number));
    client.session->client = nullptr;
    client.session->lostAt = m_step;
    client.session = nullptr;
}

/// The player that comes back, or a new one; null if there is no place.
Server::Session* Server::sessionFor(Client& client, const Join& join) {
    const auto known = m_sessions.find(join.token);
    if (known != m_sessions.end()) {
        Session& session = *known->second;
        if (Client* old = session.client) {  // the old connection has not yet been noticed to be lost
            m_transport->drop(old->peer);
            old->session = nullptr;
            old->isGone = true;
        }
        session.client = &client;
        return &session;
    }
    if (playing() >= m_settings.players) return nullptr;
    const uint64_t token = m_random() | 1;
    const uint32_t number = ++m_players;
    auto& session = m_sessions[token] = std::unique_ptr<Session>(new Session{token, number, Player(number)});
    session->client = &client;
    return session.get();
}

bool Server::handle(Client& client, const Join& join) {
    if (client.session) return false;
    sendEdits();  // to the others: the log is complete then
    const bool isKnownVersion = join.version == kVersion;
    client.session = isKnownVersion ? sessionFor(client, join) : nullptr;
    if (client.session) {
        welcome(client, join);
        return true;
    }
    send(client, Delivery::Reliable, Refused{isKnownVersion ? Refusal::Full : Refusal::Version});
    m_transport->drop(client.peer);
    client.isGone = true;
    return true;
}

void Server::welcome(Client& client, const Join& join) {
    Session& session = *client.session;
    const bool isResumed = join.game == m_game && m_log.has(join.step);
    const SharedBytes snapshot = isResumed ? nullptr : m_log.snapshot();
    send(client, Delivery::Reliable, Welcome{session.token, m_game, session.number, isResumed});
    if (snapshot) sendEncoded(client, Delivery::Reliable, *snapshot);
    for (const SharedBytes& message : isResumed ? m_log.since(join.step) : m_log.sinceSnapshot())
        sendEncoded(client, Delivery::Reliable, *message);
    session.interest.restart(m_bodies);
    say(fmt::format("player {} {}", session.number, isResumed ? "is back" : "has joined"));
}

bool Server::handle(Client& client, const Input& input) {
    if (!client.session) return false;
    client.session->player.want(input);
    client.session->interest.acknowledge(m_bodies, input.newest, input.older);
    return true;
}

bool Server::handle(Client& client, const Ask& ask) {
    if (!client.session) return false;
    if (!client.session->player.mayUse(m_step)) return true;  // asking is free
    try {
        useTool(m_world, client.session->player.position(), ask);
    } catch (const rubble::Error& error) {
        say(fmt::format("player {}: {}", client.session->number, error.what()));
    }
    return true;
}

void Server::movePlayers() {
    for (auto& [token, session] : m_sessions)
        if (session->client) session->player.step();
}

void Server::sendEdits() {
    const SharedBytes message = m_log.closeMessage();
    if (!message) return;
    for (auto& [peer, client] : m_clients)
        if (client->session) sendEncoded(*client, Delivery::Reliable, *message);
}

void Server::addPlayers(Poses& out, const Session& self) const {
    const Vec3 from = self.player.position();
    std::vector<std::pair<double, const Session*>> near;
    for (const auto& [token, session] : m_sessions) {
        const Vec3& at = session->player.position();
        if (session->client)
            near.emplace_back(
                session.get() == &self ? -1.0 : std::hypot(at[0] - from[0], at[1] - from[1], at[2] - from[2]),
                session.get());
    }
    const size_t count = std::min(near.size(), kMaxPlayersInPoses);
    std::partial_sort(near.begin(), near.begin() + std::ptrdiff_t(count), near.end());
    for (size_t i = 0; i < count; ++i)
        out.players.push_back({near[i].second->number, near[i].second->player.position()});
}

void Server::sendPoses(Client& client) {
    Session& session = *client.session;
    Poses message;
    message.sequence = ++session.sequence;
    message.step = m_step;
    addPlayers(message, session);
    const size_t perMessage = m_settings.poseBytesPerSecond * kStepsPerPoses / kStepsPerSecond;
    const size_t room = std::min(perMessage, kPosePacketBytes) - kHeaderBytes - message.players.size() * kPlayerBytes;
    message.bodies = session.interest.choose(m_bodies, session.player.position(), room / kPoseBytes, message.sequence);
    send(client, Delivery::Unreliable, message);
}

void Server::send(Client& client, Delivery delivery, const Message& message) {
    sendEncoded(client, delivery, encode(message));
}

void Server::sendEncoded(Client& client, Delivery delivery, const std::vector<uint8_t>& bytes) {
    if (client.session) client.session->traffic.add(bytes[0], bytes.size());
    m_transport->send(client.peer, delivery, bytes);
}

void Server::forgetAbsent() {
    std::erase_if(m_sessions, [&](const auto& entry) {
        return !entry.second->client && m_step - entry.second->lostAt > m_settings.stepsToComeBack;
    });
}

size_t Server::playing() const {
    return size_t(std::count_if(m_sessions.begin(), m_sessions.end(),
                                [](const auto& entry) { return entry.second->client != nullptr; }));
}

const Traffic& Server::trafficTo(uint32_t player) const {
    for (const auto& [token, session] : m_sessions)
        if (session->number == player) return session->traffic;
    throw std::out_of_range(fmt::format("player {}: there is none", player));
}

}  // namespace netplay
