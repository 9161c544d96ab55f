#pragma once
#include <functional>
#include <map>
#include <memory>
#include <random>
#include <rubble/rubble.hpp>
#include <span>
#include <string>
#include <vector>

#include "samples/netplay/body_table.h"
#include "samples/netplay/edit_log.h"
#include "samples/netplay/interest.h"
#include "samples/netplay/player.h"
#include "samples/netplay/traffic.h"
#include "samples/netplay/transport.h"

namespace netplay {

struct ServerSettings {
    size_t players = 64;
    uint64_t seed = 1;                     ///< of the tokens of players: nobody else should know it
    size_t poseBytesPerSecond = 36'000;    ///< to each client
    uint64_t stepsToComeBack = 60 * 60;    ///< that a player who lost his connection is kept
    std::function<void(std::string)> log;  ///< gets a line for each player that comes or goes; may be empty
};

/// Runs the world. Clients ask, and follow what came of it. A client that sends what is no message, or a message where
/// it makes no sense, or too many, is dropped; nothing that it sends harms the others.
class Server {
public:
    /// The world is as the game begins; it must outlive the server.
    Server(rubble::World& world, std::unique_ptr<Transport> transport, ServerSettings settings);
    ~Server();

    /// One step of 1/60 s: reads what has come, steps the world, sends.
    void tick();
    /// How many clients take part.
    size_t playing() const;
    /// How many were dropped for what they sent.
    uint64_t dropped() const { return m_dropped; }
    /// What each player's client has got, by the player's number.
    const Traffic& trafficTo(uint32_t player) const;
    /// The world's step.
    uint64_t step() const { return m_step; }

private:
    struct Session;
    struct Client;

    void receive();
    void accept(Peer peer);
    void handle(Client& client, std::span<const uint8_t> bytes);
    bool handle(Client& client, const Join& join);
    bool handle(Client& client, const Input& input);
    bool handle(Client& client, const Ask& ask);
    Session* sessionFor(Client& client, const Join& join);
    void welcome(Client& client, const Join& join);
    void movePlayers();
    void sendEdits();
    void sendPoses(Client& client);
    void addPlayers(Poses& out, const Session& self) const;
    void send(Client& client, Delivery delivery, const Message& message);
    void sendEncoded(Client& client, Delivery delivery, const std::vector<uint8_t>& bytes);
    void disconnect(Client& client);
    void forgetAbsent();
    void say(const std::string& line) const;

    rubble::World& m_world;
    std::unique_ptr<Transport> m_transport;
    ServerSettings m_settings;
    std::mt19937_64 m_random;
    uint64_t m_game;
    uint64_t m_step = 0, m_dropped = 0;
    uint32_t m_players = 0;
    BodyTable m_bodies;
    EditLog m_log;
    std::map<Peer, std::unique_ptr<Client>> m_clients;
    std::map<uint64_t, std::unique_ptr<Session>> m_sessions;  ///< by token
};

}  // namespace netplay
