// A server that lies is left, and what it has said does not stay.
#include <gtest/gtest.h>

#include "samples/netplay/client.h"
#include "samples/netplay/memory_transport.h"
#include "samples/netplay/server.h"

namespace netplay {
namespace {

rubble_world_settings settingsOf(uint32_t flags) {
    rubble_world_settings settings{};
    settings.flags = RUBBLE_WORLD_NO_RENDERER | flags;
    return settings;
}

/// A client of a server that the test speaks for, in a world with one box that can move.
class LyingServer : public testing::Test {
protected:
    void SetUp() override {
        rubble_shape_settings box{};
        box.source = RUBBLE_SHAPE_BOX, box.body = m_body = m_world.create_body({});
        box.size[0] = box.size[1] = box.size[2] = 4;
        m_world.create_shape(box);
        m_world.step();
        m_client.connect(m_network.connect());
        m_client.tick();
        for (Event event; m_server->receive(event);) m_peer = event.peer;
        Snapshot snapshot;
        snapshot.step = m_world.get_events().step;
        snapshot.game = m_world.save_game_data();
        m_step = snapshot.step;
        m_world.keep_deltas(RUBBLE_DELTAS_EDITS);
        send(Welcome{1, 1, 1, false});
        send(snapshot);
        ASSERT_TRUE(isFollowed());
    }
    void send(const Message& message) { m_server->send(m_peer, Delivery::Reliable, encode(message)); }
    /// Whether the client still follows after a tick.
    bool isFollowed() {
        m_client.tick();
        return m_client.state() == Client::State::Playing;
    }
    /// An honest step of the server, which names bodies.
    void sendStep(const std::vector<BodyName>& names) {
        m_world.step();
        EditSteps steps;
        steps.last = ++m_step, steps.names = names;
        steps.deltas.push_back(m_world.take_deltas());
        send(steps);
    }
    void sendPoses(uint64_t step, uint32_t first, uint32_t count) {
        Poses poses;
        poses.sequence = ++m_sequence, poses.step = step;
        for (uint32_t i = 0; i < count; ++i) poses.bodies.push_back({first + i, {0.0, 1.0, 0.0}});
        send(poses);
    }

    MemoryNetwork m_network;
    std::unique_ptr<Transport> m_server = m_network.listen();
    rubble::World m_world{settingsOf(0)}, m_there{settingsOf(RUBBLE_WORLD_HOST_PHYSICS)};
    Client m_client{m_there};
    rubble_body m_body = 0;
    Peer m_peer = 0;
    uint64_t m_step = 0;
    uint16_t m_sequence = 0;
};

TEST_F(LyingServer, ThatMovesBodiesWithoutEndIsLeft) {
    uint32_t id = 0;
    size_t most = 0;
    for (; m_client.state() == Client::State::Playing && id < 1'000'000; id += 1000) {
        sendPoses(m_step + 10, id, 1000);
        m_client.tick();
        most = std::max(most, m_client.tracked());
    }
    EXPECT_EQ(m_client.state(), Client::State::Disconnected);
    EXPECT_LT(most, 10'000u);
    EXPECT_EQ(m_client.tracked(), 0u) << "what it said is forgotten";
}

TEST_F(LyingServer, BodiesThatWereNeverMadeAreForgotten) {
    for (uint32_t i = 0; i < 200; ++i) {
        sendStep({});
        sendPoses(m_step, 1000 * i, 100);
        ASSERT_TRUE(isFollowed());
    }
    EXPECT_LT(m_client.tracked(), 5000u) << "those of some steps that are still to come";
}

TEST_F(LyingServer, ThatSendsStepsWithoutEndIsLeft) {
    size_t most = 0;
    for (int i = 0; m_client.state() == Client::State::Playing && i < 100; ++i) {
        EditSteps steps;
        steps.last = ++m_step;
        steps.deltas.emplace_back(4u << 20);
        send(steps);
        m_client.tick();
        most = std::max(most, m_client.waitingBytes());
    }
    EXPECT_EQ(m_client.state(), Client::State::Disconnected);
    EXPECT_LT(most, 140u << 20);
    EXPECT_EQ(m_client.waitingBytes(), 0u);
}

TEST_F(LyingServer, ThatSpeaksOfAnotherTimeIsLeft) {
    sendPoses(m_step + 3'000'000, 0, 1);
    EXPECT_FALSE(isFollowed());
}

TEST_F(LyingServer, ThatGivesABodyTwoNumbersIsLeft) {
    const uint64_t next = m_step + 1;
    sendStep({{1, m_body, next}, {2, m_body, next}});
    sendPoses(m_step + 10, 7, 1);  // so that the step is shown
    bool isLeft = false;
    for (int i = 0; i < 60 && !isLeft; ++i) isLeft = !isFollowed();
    EXPECT_TRUE(isLeft);
}

TEST_F(LyingServer, ThatSendsAHugeSnapshotIsLeft) {
    Snapshot huge;
    huge.step = m_step, huge.game = m_world.save_game_data();
    huge.game.resize((4u << 20) + 1);
    send(huge);
    EXPECT_FALSE(isFollowed());
    EXPECT_EQ(m_client.state(), Client::State::Disconnected);
}

TEST_F(LyingServer, ThatSendsNoMessageIsLeft) {
    const std::vector<uint8_t> bytes(3000, 0xff);
    m_server->send(m_peer, Delivery::Reliable, bytes);
    EXPECT_FALSE(isFollowed());
}

TEST(Protocol, AMessageOfManyEmptyStepsIsRefused) {
    EditSteps steps;
    steps.last = 1u << 16;
    steps.deltas.resize(1u << 16);
    const std::vector<uint8_t> bytes = encode(steps);
    EXPECT_LT(bytes.size(), 1000u) << "packed, it is short";
    EXPECT_FALSE(decode(bytes, false));
}

}  // namespace
}  // namespace netplay
