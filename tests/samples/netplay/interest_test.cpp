#include "samples/netplay/interest.h"

#include <gtest/gtest.h>

namespace netplay {
namespace {

/// A world with boxes that fall: near ones and far ones.
class InterestTest : public testing::Test {
protected:
    void SetUp() override {
        for (int i = 0; i < 40; ++i) drop(i < 20 ? 1.0 * i : 500.0 + i);
        step();
    }
    void drop(double x) {
        rubble_body_settings body{};
        body.position[0] = x, body.position[1] = 300.0;
        rubble_shape_settings box{};
        box.source = RUBBLE_SHAPE_BOX, box.body = m_world.create_body(body);
        box.size[0] = box.size[1] = box.size[2] = 4;
        m_bodies.push_back(box.body);
        m_world.create_shape(box);
    }
    void step() {
        m_world.step();
        m_table.follow(m_world);
        m_interest.follow(m_table);
    }

    static rubble_world_settings settings() {
        rubble_world_settings out{};
        out.flags = RUBBLE_WORLD_NO_RENDERER;
        return out;
    }
    rubble::World m_world{settings()};
    std::vector<rubble_body> m_bodies;
    BodyTable m_table;
    Interest m_interest;
};

TEST_F(InterestTest, NearBodiesComeOftenerAndFarOnesAreNotForgotten) {
    std::map<uint32_t, int> times;
    for (uint16_t message = 1; message <= 200; ++message) {
        step();
        for (const BodyPose& pose : m_interest.choose(m_table, {0.0, 300.0, 0.0}, 10, message)) ++times[pose.id];
    }
    ASSERT_EQ(times.size(), 40u) << "all have been heard of";
    EXPECT_GT(times[0], 3 * times[39]);
    EXPECT_GT(times[39], 2);
}

TEST_F(InterestTest, ABodyThatRestsIsSentUntilItHasArrived) {
    for (const rubble_body body : m_bodies) {
        rubble_body_change sleep{};
        sleep.body = body, sleep.fields = RUBBLE_SET_ASLEEP;
        m_world.set_body(sleep);
    }
    step();
    step();
    ASSERT_TRUE(m_table.moved().empty());
    EXPECT_EQ(m_interest.choose(m_table, {}, 100, 1).size(), 40u);
    EXPECT_EQ(m_interest.choose(m_table, {}, 100, 2).size(), 40u) << "nothing has been heard of the first message";
    m_interest.acknowledge(m_table, 3, 0);
    EXPECT_EQ(m_interest.pending(), 40u) << "no such message was sent";
    m_interest.acknowledge(m_table, 3, 1);
    EXPECT_EQ(m_interest.pending(), 0u);
    m_interest.restart(m_table);
    EXPECT_EQ(m_interest.pending(), 40u) << "who joins hears of all";
    m_world.destroy_body(m_bodies[0]);
    step();
    EXPECT_EQ(m_interest.choose(m_table, {}, 100, 4).size(), 39u);
}

}  // namespace
}  // namespace netplay
