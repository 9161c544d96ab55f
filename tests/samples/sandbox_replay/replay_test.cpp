// The last seconds of a game, shown by another world.
#include "samples/sandbox/shell/replay.h"

#include <gtest/gtest.h>

#include "generated/paths.h"

namespace sandbox {
namespace {

constexpr uint32_t kFlags = RUBBLE_WORLD_NO_RENDERER | RUBBLE_WORLD_PARTICLES;

/// A car on the ground, and the same without a replay.
class ReplayTest : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_EQ(rubble_get_api(RUBBLE_VERSION, &m_api), RUBBLE_OK);
        for (rubble_world* world : {&m_game, &m_plain}) *world = makeWorld();
        m_replay.emplace(*m_api, kFlags, [](rubble_world, rubble_renderer&) { return ""; });
        m_scriptApi = m_replay->notingApi();
    }
    void TearDown() override {
        m_replay.reset();
        m_api->destroy_world(m_game);
        m_api->destroy_world(m_plain);
    }
    rubble_world makeWorld() {
        rubble_world_settings settings = {};
        settings.struct_size = sizeof settings;
        settings.flags = kFlags;
        rubble_world world = 0;
        EXPECT_EQ(m_api->create_world(&settings, &world), RUBBLE_OK);
        EXPECT_EQ(m_api->load_level(world, RUBBLE_SOURCE_DIR "/samples/lua/mods/car.vox", ""), RUBBLE_OK);
        m_api->set_undo_limit(world, 4);
        return world;
    }
    /// What a player does in a step.
    void play(rubble_world world, int step) {
        rubble_explosion edit = {};
        edit.struct_size = sizeof edit;
        edit.position[0] = 0.3 * (step % 5), edit.position[1] = 0.6;
        edit.size = 0.7;
        if (step % 50 == 10) m_api->add_undo_mark(world);
        if (step % 50 == 20) m_api->explode(world, &edit);
        if (step == 145) m_api->undo(world);
        rubble_environment air = {};
        air.struct_size = sizeof air;
        m_api->get_environment(world, &air);
        air.exposure = 1.0 + step;
        if (step % 70 == 30) {
            EXPECT_EQ(m_api->set_environment(world, &air), RUBBLE_OK);
            EXPECT_EQ(m_api->apply_edits(world), RUBBLE_OK);
        }
    }
    /// Plays on to a step, in both worlds.
    void playTo(int step) {
        for (; m_step < step; ++m_step) {
            for (const rubble_world world : {m_game, m_plain}) play(world, m_step);
            EXPECT_EQ(m_replay->beforeStep(m_game), "");
            if (m_step % 10 == 0) spawn();
            for (const rubble_world world : {m_game, m_plain}) EXPECT_EQ(m_api->step(world), RUBBLE_OK);
            EXPECT_EQ(m_replay->afterStep(m_game), "");
            m_hashes.push_back(resolvedHash(m_game));
        }
    }
    void spawn() {
        rubble_particle_burst burst = {};
        burst.struct_size = sizeof burst;
        burst.position[1] = 5.0;
        m_scriptApi.spawn_particles(m_game, &burst);
    }
    uint64_t resolvedHash(rubble_world world) {
        uint64_t hash = 0;
        EXPECT_EQ(m_api->get_resolved_hash(world, &hash), RUBBLE_OK);
        return hash;
    }
    uint64_t stateHash(rubble_world world) {
        uint64_t hash = 0;
        EXPECT_EQ(m_api->get_state_hash(world, &hash), RUBBLE_OK);
        return hash;
    }
    /// Whether the world of so many steps ago is shown as it was.
    void expectStep(int ago) {
        ASSERT_EQ(m_replay->show(ago / 60.0, "viewmodel"), "") << ago;
        EXPECT_EQ(resolvedHash(m_replay->world()), m_hashes[size_t(m_step - 1 - ago)]) << ago << " steps ago";
    }

    const rubble_api* m_api = nullptr;
    rubble_api m_scriptApi = {};
    rubble_world m_game = 0, m_plain = 0;
    std::optional<Replay> m_replay;
    std::vector<uint64_t> m_hashes;  ///< after each step
    int m_step = 0;
};

TEST_F(ReplayTest, ShowsEachStepAsItWasAndLeavesTheGameAsItIs) {
    m_replay->keep(2.0);
    playTo(90);
    EXPECT_EQ(m_replay->length(), 1.5);
    for (const int ago : {89, 80, 30, 1, 0, 60, 89}) expectStep(ago);
    m_replay->hide();
    playTo(275);
    EXPECT_EQ(m_replay->length(), 2.0);
    for (const int ago : {119, 118, 60, 61, 7, 0, 100, 0}) expectStep(ago);
    playTo(281);
    for (const int ago : {119, 0}) expectStep(ago);
    playTo(500);
    expectStep(119);
    EXPECT_EQ(stateHash(m_game), stateHash(m_plain));
    EXPECT_LT(m_replay->bytes(), size_t(4) << 20);
}

TEST_F(ReplayTest, GoesBackByWayOfSavedGames) {
    m_replay->keep(12.0);
    playTo(1000);
    for (const int ago : {0, 500, 0, 400, 399, 10, 719, 101, 100}) expectStep(ago);
    playTo(1010);
    for (const int ago : {719, 0, 1}) expectStep(ago);
}

TEST_F(ReplayTest, HasTheParticlesOfScripts) {
    m_replay->keep(1.0);
    playTo(19);
    ASSERT_EQ(m_replay->show(0.0, "viewmodel"), "");
    uint32_t count = 0;
    EXPECT_EQ(m_api->get_particles(m_replay->world(), nullptr, 0, &count), RUBBLE_OK);
    EXPECT_EQ(count, 2u);
}

TEST_F(ReplayTest, BeginsAgainWithAnotherGame) {
    m_replay->keep(1.0);
    playTo(30);
    expectStep(10);
    const char* const level = RUBBLE_SOURCE_DIR "/samples/lua/mods/car.vox";
    for (const rubble_world world : {m_game, m_plain}) ASSERT_EQ(m_api->load_level(world, level, ""), RUBBLE_OK);
    m_replay->forget();
    EXPECT_EQ(m_replay->length(), 0.0);
    EXPECT_EQ(m_replay->world(), 0u) << "nothing is shown";
    playTo(55);
    EXPECT_EQ(m_replay->length(), 25.0 / 60.0);
    for (const int ago : {24, 0, 12}) expectStep(ago);
    EXPECT_EQ(stateHash(m_game), stateHash(m_plain));
}

TEST_F(ReplayTest, StopsWhereTheGameWasReplacedAndNobodySaysSo) {
    m_replay->keep(1.0);
    playTo(30);
    ASSERT_EQ(m_api->load_level(m_game, RUBBLE_SOURCE_DIR "/samples/lua/mods/car.vox", ""), RUBBLE_OK);
    EXPECT_EQ(m_api->step(m_game), RUBBLE_OK);
    EXPECT_NE(m_replay->afterStep(m_game), "");
    EXPECT_EQ(m_replay->length(), 0.0);
    EXPECT_EQ(m_replay->beforeStep(m_game), "") << "it does not try on";
}

TEST_F(ReplayTest, OffItKeepsNothing) {
    playTo(3);
    uint64_t count = 0;
    EXPECT_EQ(m_replay->length(), 0.0);
    EXPECT_EQ(m_api->take_deltas(m_game, nullptr, 0, &count), RUBBLE_ERROR_ARGUMENT) << "no deltas are kept";
    EXPECT_NE(m_replay->show(0.0, "viewmodel").find("expected steps that are kept"), std::string::npos);
    m_replay->keep(1.0);
    playTo(6);
    EXPECT_EQ(m_replay->length(), 0.05);
    m_replay->keep(0.0);
    EXPECT_EQ(m_replay->bytes(), 0u);
    EXPECT_EQ(m_api->take_deltas(m_game, nullptr, 0, &count), RUBBLE_ERROR_ARGUMENT);
}

}  // namespace
}  // namespace sandbox
