#include "tests/abi/layers/bullet_host.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "tests/support/temp_folder.h"

namespace rubble {
namespace {

/// A host with Bullet's stock world and the runtime alone: this program has none of Rubble's physics in it.
class BulletHostTest : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_EQ(rubble_get_api(RUBBLE_VERSION, &m_api), RUBBLE_OK);
        uint32_t layers = 9;
        ASSERT_EQ(m_api->get_layers(&layers), RUBBLE_OK);
        ASSERT_EQ(layers, 0u);
        m_world = makeWorld();
    }
    void TearDown() override { m_api->destroy_world(m_world); }

    rubble_world makeWorld() {
        rubble_world_settings settings = {};
        settings.struct_size = sizeof settings;
        settings.flags = RUBBLE_WORLD_HOST_PHYSICS;
        rubble_world world = 0;
        EXPECT_EQ(m_api->create_world(&settings, &world), RUBBLE_OK) << m_api->get_last_error();
        return world;
    }
    /// A box of one material, its low corner at a place.
    rubble_body makeBox(double x, double y, double z, int sx, int sy, int sz, uint32_t material, uint32_t flags) {
        rubble_body_settings frame = {};
        frame.struct_size = sizeof frame;
        frame.position[0] = x, frame.position[1] = y, frame.position[2] = z, frame.flags = flags;
        rubble_shape_settings box = {};
        box.struct_size = sizeof box;
        rubble_shape shape = 0;
        EXPECT_EQ(m_api->create_body(m_world, &frame, &box.body), RUBBLE_OK);
        box.source = RUBBLE_SHAPE_BOX, box.size[0] = sx, box.size[1] = sy, box.size[2] = sz, box.index = material;
        EXPECT_EQ(m_api->create_shape(m_world, &box, &shape), RUBBLE_OK);
        return box.body;
    }
    uint64_t removed() {
        rubble_voxel_accounting sums = {};
        sums.struct_size = sizeof sums;
        EXPECT_EQ(m_api->get_voxel_accounting(m_world, &sums), RUBBLE_OK);
        EXPECT_EQ(sums.imported, sums.standing + sums.in_pieces + sums.removed);
        return sums.removed;
    }
    uint64_t hash() {
        uint64_t out = 0;
        EXPECT_EQ(m_api->get_state_hash(m_world, &out), RUBBLE_OK);
        return out;
    }
    /// Frames until something is so; false: it never was.
    static bool playUntil(BulletHost& host, int frames, const std::function<bool()>& isSo) {
        for (int i = 0; i < frames; ++i) {
            host.frame();
            if (isSo()) return true;
        }
        return false;
    }

    static constexpr uint32_t kBrick = 7, kGlass = 1;
    const rubble_api* m_api = nullptr;
    rubble_world m_world = 0;
};

/// The wall is narrow: what is above the hole has nothing to stand on.
TEST_F(BulletHostTest, AWallIsShotAndWhatFallsBreaksAgainAndRests) {
    makeBox(-0.15, 0.0, 0.0, 3, 80, 3, kBrick, RUBBLE_BODY_STATIC);
    BulletHost host(*m_api, m_world);
    host.frame();
    EXPECT_EQ(host.dynamicBodies(), 0);
    host.shoot({0, btScalar(0.8), -4}, {0, 0, 35}, btScalar(0.3), 800);
    ASSERT_TRUE(playUntil(host, 60, [&] { return host.dynamicBodies() > 0; })) << "nothing came off";
    const uint64_t shot = removed();
    ASSERT_TRUE(playUntil(host, 300, [&] { return host.floorImpacts > 0; }))
        << "nothing fell on the floor: " << host.dynamicBodies() << " pieces, " << host.impacts << " impacts";
    EXPECT_GT(host.highestSpeed(), 0.5);
    EXPECT_TRUE(playUntil(host, 600, [&] { return removed() > shot; })) << "the fall broke nothing";
    EXPECT_TRUE(playUntil(host, 1200, [&] { return host.highestSpeed() == 0.0; }))
        << host.dynamicBodies() << " pieces, at " << host.highestSpeed() << " m/s";
    EXPECT_GT(host.dynamicBodies(), 1);
    EXPECT_GT(host.lowestPoint(), -0.05) << "pieces rest on the host's floor";
}

TEST_F(BulletHostTest, AFallingBodyBreaksOnTheHostsFloor) {
    makeBox(0.0, 12.0, 0.0, 16, 16, 16, kBrick, 0);
    BulletHost host(*m_api, m_world);
    ASSERT_TRUE(playUntil(host, 200, [&] { return host.floorImpacts > 0; })) << "it never fell on the floor";
    EXPECT_EQ(removed(), 0u) << "until the next step";
    host.frame();
    EXPECT_GT(removed(), 0u);
    EXPECT_GT(host.dynamicBodies(), 1) << "it is in pieces";
    EXPECT_TRUE(playUntil(host, 900, [&] { return host.highestSpeed() == 0.0; }));
    EXPECT_GT(host.lowestPoint(), -0.05);
}

TEST_F(BulletHostTest, AnExplosionPushesTheHostsBodies) {
    const rubble_body box = makeBox(0.0, 0.0, 0.0, 8, 8, 8, kBrick, 0);
    BulletHost host(*m_api, m_world);
    for (int i = 0; i < 10; ++i) host.frame();
    rubble_explosion explosion = {};
    explosion.struct_size = sizeof explosion;
    explosion.position[0] = -1.6, explosion.position[1] = 0.4, explosion.position[2] = 0.4;
    ASSERT_EQ(m_api->explode(m_world, &explosion), RUBBLE_OK);
    host.frame();
    rubble_body_state state = {};
    ASSERT_EQ(m_api->get_body_state(m_world, box, &state), RUBBLE_OK);
    EXPECT_GT(state.velocity[0], 0.1);
}

TEST_F(BulletHostTest, ARecordingPlaysWithoutTheHost) {
    const TempFolder folder;
    const std::string path = folder.path() / "game.rubblelog";
    makeBox(-2.0, 0.0, 0.0, 40, 30, 3, kBrick, RUBBLE_BODY_STATIC);
    BulletHost host(*m_api, m_world);
    host.frame();
    ASSERT_EQ(m_api->start_recording(m_world, path.c_str()), RUBBLE_OK) << m_api->get_last_error();
    host.shoot({0, btScalar(1.5), -4}, {0, 0, 40}, btScalar(0.3), 80);
    for (int i = 0; i < 120; ++i) host.frame();
    ASSERT_GT(removed(), 0u);
    ASSERT_EQ(m_api->step(m_world), RUBBLE_OK);  // with what the last frame handed back
    const uint64_t expected = hash();
    ASSERT_EQ(m_api->stop_recording(m_world), RUBBLE_OK) << m_api->get_last_error();
    const rubble_world first = std::exchange(m_world, makeWorld());
    uint64_t steps = 0;
    EXPECT_EQ(m_api->play_recording(m_world, path.c_str(), &steps), RUBBLE_OK) << m_api->get_last_error();
    EXPECT_EQ(steps, 121u);
    EXPECT_EQ(hash(), expected);
    EXPECT_EQ(m_api->destroy_world(first), RUBBLE_OK);
}

}  // namespace
}  // namespace rubble
