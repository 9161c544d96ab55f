// The netplay sample: connections that send messages of clients, most of them changed, to a server; a client whose
// server's messages are changed on the way; and an honest client, whose world must stay the server's.
#include <cstdio>
#include <cstdlib>

#include "samples/netplay/client.h"
#include "samples/netplay/memory_transport.h"
#include "samples/netplay/server.h"
#include "tests/fuzz/mutate_bytes.h"
#include "tests/fuzz/stages.h"

namespace netplay {
namespace {

using rubble::Decisions;
using rubble::reached;

[[noreturn]] void fail(const char* what) {
    std::fprintf(stderr, "%s\n", what);
    std::abort();
}

rubble_world_settings settingsOf(uint32_t flags) {
    rubble_world_settings out{};
    out.flags = RUBBLE_WORLD_NO_RENDERER | flags;
    out.assertion_failed = [](void*, const char* message) { fail(message); };
    return out;
}

void buildWall(rubble::World& world) {
    rubble_body_settings body{};
    body.flags = RUBBLE_BODY_STATIC;
    rubble_shape_settings wall{};
    wall.source = RUBBLE_SHAPE_BOX, wall.body = world.create_body(body);
    wall.size[0] = wall.size[1] = 30, wall.size[2] = 4, wall.index = 7;
    world.create_shape(wall);
    rubble_bounds bounds{};
    bounds.low[0] = bounds.low[1] = bounds.low[2] = -20.0;
    bounds.high[0] = bounds.high[1] = bounds.high[2] = 20.0;
    world.set_bounds(bounds);
    world.step();
}

/// Changes a step or a number in one of the ways that a server must not.
uint64_t wrong(Decisions& decisions, uint64_t value) {
    const uint32_t kind = decisions.below(4);
    return kind == 0 ? decisions.bits() : kind == 1 ? value + decisions.below(1u << 20) : value + kind - 2;
}

void lie(Decisions& decisions, std::vector<BodyName>& names) {
    if (!names.empty() && decisions.oneIn(2)) names.push_back(names[decisions.below(uint32_t(names.size()))]);
    for (BodyName& name : names) {
        if (decisions.oneIn(4)) name.id = uint32_t(wrong(decisions, name.id));
        if (decisions.oneIn(4)) name.handle = wrong(decisions, name.handle);
        if (decisions.oneIn(4)) name.step = wrong(decisions, name.step);
    }
}
void lie(Decisions& decisions, Welcome& welcome) {
    welcome.isResumed = !welcome.isResumed;
    welcome.game = wrong(decisions, welcome.game);
}
void lie(Decisions& decisions, Snapshot& snapshot) {
    if (decisions.oneIn(2)) snapshot.step = wrong(decisions, snapshot.step);
    lie(decisions, snapshot.names);
    if (decisions.oneIn(2)) mutateBytes(decisions, snapshot.game);
}
void lie(Decisions& decisions, EditSteps& steps) {
    if (decisions.oneIn(4)) steps.last = wrong(decisions, steps.last);
    lie(decisions, steps.names);
    for (auto& delta : steps.deltas)
        if (decisions.oneIn(4)) mutateBytes(decisions, delta);
    if (decisions.oneIn(8)) steps.deltas.resize(decisions.below(70));
}
/// Of thousands of bodies that there are not.
void lie(Decisions& decisions, Poses& poses) {
    if (decisions.oneIn(4)) poses.step = wrong(decisions, poses.step);
    if (decisions.oneIn(4)) poses.sequence = uint16_t(decisions.bits());
    const uint32_t first = poses.bodies.empty() ? 0 : poses.bodies.back().id + 1 + decisions.below(1u << 20);
    for (uint32_t i = 0, count = decisions.below(3000); i < count; ++i) {
        BodyPose& pose = poses.bodies.emplace_back();
        pose.id = first + i;
        for (double& part : pose.position) part = 2e9 * (decisions.unit() - 0.5);
    }
}
template <class T>
void lie(Decisions&, T&) {}

/// The bytes of a message that is well-formed and says something else; the same where it is none.
void lie(Decisions& decisions, std::vector<uint8_t>& bytes) {
    std::optional<Message> message = decode(bytes, false);
    if (!message) return;
    std::visit([&](auto& kind) { lie(decisions, kind); }, *message);
    bytes = encode(*message);
    reached("lies of a server");
}

/// Changes one in eight of the messages that arrive: their bytes, or what they say.
class Garbled final : public Transport {
public:
    Garbled(std::unique_ptr<Transport> inner, Decisions& decisions)
        : m_inner(std::move(inner)), m_decisions(decisions) {}
    bool receive(Event& event) override {
        if (!m_inner->receive(event)) return false;
        if (event.kind == Event::Kind::Received && m_decisions.oneIn(8))
            m_decisions.oneIn(2) ? lie(m_decisions, event.bytes) : mutateBytes(m_decisions, event.bytes);
        return true;
    }
    void send(Peer peer, Delivery delivery, std::span<const uint8_t> bytes) override {
        m_inner->send(peer, delivery, bytes);
    }
    void drop(Peer peer) override { m_inner->drop(peer); }
    void tick() override { m_inner->tick(); }

private:
    std::unique_ptr<Transport> m_inner;
    Decisions& m_decisions;
};

/// A connection that sends what it should not, and knows when the server must end it.
class Attacker {
public:
    Attacker(MemoryNetwork& network, Decisions& decisions)
        : m_transport(network.connect()), m_decisions(decisions), m_isWild(!decisions.oneIn(4)) {}

    void send() {
        for (uint32_t count = m_decisions.oneIn(50) ? 40 : m_decisions.below(16), i = 1; i <= count; ++i) {
            std::vector<uint8_t> bytes = encode(message());
            const std::vector<uint8_t> sent = bytes;
            if (m_isWild ? !m_decisions.oneIn(4) : m_decisions.oneIn(500)) mutateBytes(m_decisions, bytes);
            reached(bytes == sent ? "messages as they should be" : "changed messages");
            m_mustEnd = m_mustEnd || !isGood(bytes) || i > 32;
            m_transport->send(0, Delivery::Reliable, bytes);
        }
    }
    /// After a step of the server; false: the connection has ended, as it must.
    bool isOpen() {
        Event event;
        bool isOpen = true;
        while (m_transport->receive(event)) {
            isOpen = isOpen && event.kind != Event::Kind::Disconnected;
            if (event.kind != Event::Kind::Received) continue;
            const auto message = decode(event.bytes, false);
            if (!message) fail("the server has sent what is no message");
            if (const auto* poses = std::get_if<Poses>(&*message)) m_position = poses->players.at(0).position;
        }
        if (isOpen == m_mustEnd)
            fail(isOpen ? "the sender of wrong bytes was not dropped" : "an honest one was dropped");
        if (!isOpen) reached("senders dropped");
        return isOpen;
    }

private:
    Message message() {
        if (!m_hasJoined && !m_decisions.oneIn(8)) return Join{kVersion, 0, m_decisions.bits(), m_decisions.below(9)};
        const uint64_t bits = m_decisions.bits();
        if (bits % 64 == 0) return askAtWall();
        if (m_decisions.oneIn(3)) return Ask{Tool(bits % 4), {int16_t(bits >> 8), int16_t(bits >> 24), 1}};
        return Input{uint16_t(m_decisions.below(40)), uint32_t(bits), {int8_t(bits >> 32), int8_t(bits >> 40), 0}};
    }
    Ask askAtWall() {
        const Vec3 to = {3.0 * m_decisions.unit(), 3.0 * m_decisions.unit(), 0.2};
        Ask ask{Tool(m_decisions.below(4)), {0, 0, 1}};
        for (size_t i = 0; i < 3; ++i) ask.direction[i] = int16_t(1000.0 * (to[i] - m_position[i]));
        reached("messages that break or paint, if they arrive unchanged");
        return ask;
    }
    /// Whether the server has to take it.
    bool isGood(const std::vector<uint8_t>& bytes) {
        const auto message = decode(bytes, true);
        if (!message) return false;
        const auto* join = std::get_if<Join>(&*message);
        if (!join) return m_hasJoined;
        if (m_hasJoined || join->version != kVersion) return false;
        reached("players joined");
        return m_hasJoined = true;
    }

    std::unique_ptr<Transport> m_transport;
    Decisions& m_decisions;
    bool m_isWild;  ///< changes most of what it sends
    Vec3 m_position{};
    bool m_hasJoined = false, m_mustEnd = false;
};

/// The honest client has the server's world, whatever the others have sent.
void expectSameWorld(Server& server, Client& honest, const rubble::World& here, const rubble::World& there) {
    for (int i = 0; i < 40 || server.step() % kStepsPerEdits; ++i) server.tick(), honest.tick();
    if (honest.state() != Client::State::Playing) fail("the honest client no longer plays");
    if (honest.appliedStep() + 16 < server.step()) fail("the honest client does not follow");
    while (honest.appliedStep() < server.step()) honest.tick();  // it shows what was some steps before
    uint64_t hashes[2] = {};
    rubble::check(rubble::api().get_voxel_hash(here.handle(), &hashes[0]));
    rubble::check(rubble::api().get_voxel_hash(there.handle(), &hashes[1]));
    if (hashes[0] != hashes[1]) fail("the honest client has another world");
}

}  // namespace
}  // namespace netplay

void rubble::fuzz(Decisions& decisions) {
    using namespace netplay;
    World world(settingsOf(0)), honestWorld(settingsOf(RUBBLE_WORLD_HOST_PHYSICS)),
        garbledWorld(settingsOf(RUBBLE_WORLD_HOST_PHYSICS));
    buildWall(world);
    MemoryNetwork network;
    Server server(world, network.listen(), {});
    Client honest(honestWorld), garbled(garbledWorld);
    honest.connect(network.connect());
    std::vector<std::unique_ptr<Attacker>> attackers;
    for (int i = 0; i < 100; ++i) {
        while (attackers.size() < 4) attackers.push_back(std::make_unique<Attacker>(network, decisions));
        for (auto& attacker : attackers) attacker->send();
        if (garbled.state() == Client::State::Disconnected)
            garbled.connect(std::make_unique<Garbled>(network.connect(), decisions));
        server.tick(), honest.tick(), garbled.tick();
        if (garbled.tracked() > 20'000) fail("a client keeps poses of bodies that there are not");
        if (garbled.state() == Client::State::Disconnected) reached("servers left");
        std::erase_if(attackers, [](auto& attacker) { return !attacker->isOpen(); });
    }
    expectSameWorld(server, honest, world, honestWorld);
    reached("worlds equal at the end");
    if (world.get_body_states().size() > 1) reached("walls in pieces at the end");
}
