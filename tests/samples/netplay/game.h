#pragma once
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "samples/netplay/bot.h"
#include "samples/netplay/link_conditioner.h"
#include "samples/netplay/server.h"

namespace netplay {

/// Where the server's bodies were after a step.
struct PastStep {
    uint64_t step = 0;
    std::map<rubble_body, Vec3> positions;  ///< of those that it moved
};

/// A client with its world and a bot.
struct Seat {
    rubble::World world;
    Client client{world};
    Bot bot;
    uint32_t seed;
    bool isPlaying = true;  ///< the bot acts
    /// seed: of the bot, and of the link.
    Seat(const rubble_world_settings& settings, uint32_t seed, int rows, int stepsBetweenAsks);
};

struct GameSettings {
    int rows = 2;
    int stepsBetweenAsks = 90;
    LinkSettings link;  ///< of each end
    size_t players = 8;
    rubble_world_settings world{.flags = RUBBLE_WORLD_NO_RENDERER | RUBBLE_WORLD_HOST_PHYSICS};  ///< of each client
};

/// A server and clients over ENet on the loopback, each end behind a LinkConditioner, in one thread and by one clock of
/// steps: a loaded machine makes it slower and changes nothing else.
class Game {
public:
    /// A yard with a server and no client.
    explicit Game(const GameSettings& settings);

    /// Adds a client that joins.
    Seat& add();
    /// Connects a client, again.
    void connect(Seat& seat);
    /// Runs so many steps of all.
    void run(int steps);
    /// Lets the bots rest until nothing moves and all clients have all; false: ten minutes did not do.
    bool settle();

    /// The server.
    Server& server() { return *m_server; }
    /// The world that the server runs.
    rubble::World& world() { return m_world; }
    /// The clients, in the order in which they came.
    std::vector<std::unique_ptr<Seat>>& seats() { return m_seats; }
    /// How far shown bodies were from where the server had them at that time, in millimetres: how many by distance.
    const std::vector<uint64_t>& errors() const { return m_errors; }

private:
    void tick();
    void remember();
    void compare(Seat& seat);

    GameSettings m_settings;
    rubble::World m_world;
    std::unique_ptr<Server> m_server;
    uint16_t m_port = 0;
    std::vector<std::unique_ptr<Seat>> m_seats;
    std::deque<PastStep> m_past;
    std::vector<uint64_t> m_errors = std::vector<uint64_t>(1001);
};

/// The value below which a part of all lies, in millimetres.
int percentile(const std::vector<uint64_t>& histogram, double part);

/// Says where two worlds differ in a voxel, its paint or a palette; empty: nowhere.
std::string difference(const rubble::World& server, const rubble::World& client);

/// The farthest that a body is from where the server has it, metres.
double farthestApart(const rubble::World& server, const rubble::World& client);

}  // namespace netplay
