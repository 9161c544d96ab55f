#pragma once
#include <deque>
#include <memory>
#include <rubble/rubble.hpp>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "samples/netplay/playout_clock.h"
#include "samples/netplay/pose_track.h"
#include "samples/netplay/protocol.h"
#include "samples/netplay/transport.h"

namespace netplay {

/// Follows a server's world: carries out what edits came to, moves bodies between the poses that it gets, and asks. It
/// runs no edits and no physics of its own. A server that sends what is no message, or what cannot be true, is left,
/// and what it said forgotten; memory for bodies and steps that are not there yet is bounded.
class Client {
public:
    enum class State : uint8_t { Disconnected, Joining, Playing, Refused };

    /// The world, made with RUBBLE_WORLD_HOST_PHYSICS, becomes the server's. It must outlive the client.
    explicit Client(rubble::World& world) : m_world(world) {}

    /// Begins to join over a new connection. A client that has lost one goes on where it was, if the server can. It
    /// disconnects by itself where its world has become another one: connect it again.
    void connect(std::unique_ptr<Transport> transport);
    /// Ends the connection, without a word to the server.
    void disconnect();
    /// One step of 1/60 s: reads what has come, follows, sends.
    void tick();
    /// Follows to so much of a step behind the last tick(): for hosts that draw between two, before each frame.
    void show(double partOfStep);
    /// Where between the last two steps of the world the shown time is, for rubble_view.alpha.
    double alpha() const { return m_alpha; }
    /// Wants to fly, m/s along each axis; the server decides.
    void move(const Vec3& velocity);
    /// Asks to use a tool in a direction, which has a length; the server decides.
    void ask(Tool tool, const Vec3& direction);

    /// How far it has got.
    State state() const { return m_state; }
    /// The number that the server calls it by.
    uint32_t player() const { return m_player; }
    /// Where the server has it, metres.
    Vec3 position() const { return m_players.empty() ? Vec3{} : m_players.front().position; }
    /// It, and those near it.
    const std::vector<Poses::Player>& players() const { return m_players; }
    /// The last step whose edits it has carried out.
    uint64_t appliedStep() const { return m_applied; }
    /// How far bodies jumped when a pose arrived that was not as foreseen: how many by so many millimetres; the last:
    /// more.
    const std::vector<uint64_t>& corrections() const { return m_corrections; }
    /// How many bodies may not yet be where they come to rest.
    size_t moving() const { return m_moving.size(); }
    /// How many bodies it has poses of, with those that are not there yet.
    size_t tracked() const { return m_bodies.size(); }
    /// Bytes of the steps that wait until they are shown.
    size_t waitingBytes() const { return m_waitingBytes; }
    /// How many messages of servers have come.
    uint64_t heard() const { return m_heard; }
    /// How often it has taken a snapshot.
    int snapshots() const { return m_snapshots; }

private:
    /// A step that waits until it is shown.
    struct Step {
        uint64_t step = 0;
        std::vector<uint8_t> delta;
        std::vector<BodyName> names;  ///< of bodies that first moved in it
        /// About, with what holds it.
        size_t bytes() const { return delta.size() + names.size() * sizeof(BodyName) + sizeof(Step); }
    };
    /// A body that moves.
    struct Tracked {
        rubble_body body = 0;  ///< 0: not there yet
        PoseTrack track;
    };

    void receive();
    void handle(const Message& message);
    void take(const Snapshot& snapshot);
    void take(EditSteps steps);
    void take(const Poses& poses);
    void noteSequence(uint16_t sequence);
    void name(const BodyName& name);
    void forget();
    void moveBodies(uint64_t step);
    void apply(const Step& step);
    void forgetDestroyed();
    void send();
    void rejoin();

    rubble::World& m_world;
    std::unique_ptr<Transport> m_transport;
    Peer m_server = 0;
    State m_state = State::Disconnected;
    uint64_t m_token = 0, m_game = 0;
    uint32_t m_player = 0;
    PlayoutClock m_clock;
    double m_alpha = 1.0;
    uint64_t m_ticks = 0, m_applied = 0, m_received = 0;  ///< the last step that was carried out; that has come
    std::deque<Step> m_steps;
    size_t m_waitingBytes = 0;  ///< of them
    std::unordered_map<uint32_t, Tracked> m_bodies;
    std::unordered_map<rubble_body, uint32_t> m_ids;  ///< of those that are there
    std::unordered_set<uint32_t> m_moving;
    std::vector<Poses::Player> m_players;
    bool m_hasSequence = false;
    Input m_input;
    std::vector<Ask> m_asks;
    std::vector<uint64_t> m_corrections = std::vector<uint64_t>(1001);
    uint64_t m_heard = 0;
    int m_snapshots = 0;
};

}  // namespace netplay
