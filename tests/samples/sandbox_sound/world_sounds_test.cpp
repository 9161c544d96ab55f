// What the sound of the game hears of a world.
#include "samples/sandbox/sound/world_sounds.h"

#include <gtest/gtest.h>
#include <rubble/rubble.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "generated/paths.h"
#include "samples/sandbox/sound/acoustics.h"

namespace sandbox::sound {
namespace {

/// A car on the ground.
class WorldSoundsTest : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_EQ(rubble_get_api(RUBBLE_VERSION, &m_api), RUBBLE_OK);
        rubble_world_settings settings = {};
        settings.struct_size = sizeof settings;
        ASSERT_EQ(m_api->create_world(&settings, &m_world), RUBBLE_OK);
        ASSERT_EQ(m_api->load_level(m_world, RUBBLE_SOURCE_DIR "/samples/lua/mods/car.vox", ""), RUBBLE_OK);
        ASSERT_EQ(m_api->step(m_world), RUBBLE_OK);
        rubble_hit hit = {};
        const double above[3] = {0.0, 20.0, 0.0}, down[3] = {0.0, -1.0, 0.0};
        ASSERT_EQ(m_api->cast_ray(m_world, above, down, 40.0, &hit), RUBBLE_OK);
        ASSERT_TRUE(hit.shape) << "the car is not where the test looks for it";
        m_car = {hit.position[0], hit.position[1] - 0.3, hit.position[2]};
    }
    void TearDown() override { m_api->destroy_world(m_world); }
    void explode() {
        rubble_explosion edit = {};
        edit.struct_size = sizeof edit;
        for (int i = 0; i < 3; ++i) edit.position[i] = m_car[i];
        edit.size = 1.5;
        ASSERT_EQ(m_api->explode(m_world, &edit), RUBBLE_OK);
    }
    /// What it sounds like within two seconds.
    std::vector<Strike> listen() {
        WorldSounds sounds(*m_api, m_world);
        std::vector<Strike> strikes;
        for (int i = 0; i < 120; ++i) {
            EXPECT_EQ(m_api->step(m_world), RUBBLE_OK);
            sounds.read(strikes);
        }
        return strikes;
    }

    const rubble_api* m_api = nullptr;
    rubble_world m_world = 0;
    glm::dvec3 m_car{0.0};
};

TEST_F(WorldSoundsTest, AnExplosionBreaksAndThrowsPieces) {
    const rubble_report_filter filter = WorldSounds::filter();
    ASSERT_EQ(m_api->set_report_filter(m_world, &filter), RUBBLE_OK);
    explode();
    const std::vector<Strike> strikes = listen();
    double joules = 0.0;
    for (const Strike& strike : strikes) {
        ASSERT_LT(strike.material, acousticMaterials().size());
        EXPECT_GT(strike.contact, 0.0);
        EXPECT_LE(strike.size[2], strike.size[0]);
        EXPECT_LE(strike.size[0], 2.7);
        joules += strike.joules;
    }
    EXPECT_GT(strikes.size(), 20u);
    EXPECT_GT(joules, 50.0);
    EXPECT_TRUE(std::isfinite(joules));
}

TEST_F(WorldSoundsTest, WhoDoesNotListenHearsNothing) {
    explode();
    EXPECT_TRUE(listen().empty());
}

TEST_F(WorldSoundsTest, FiresAreLoops) {
    WorldSounds sounds(*m_api, m_world);
    std::vector<Loop> loops;
    sounds.readFires(m_car, loops);
    EXPECT_TRUE(loops.empty());
    rubble_heat heat = {};
    heat.struct_size = sizeof heat;
    heat.flags = RUBBLE_HEAT_IGNITE;
    for (int i = 0; i < 3; ++i) heat.position[i] = m_car[i];
    heat.radius = 3.0, heat.joules = 1e7;
    ASSERT_EQ(m_api->heat(m_world, &heat), RUBBLE_OK);
    for (int i = 0; i < 30; ++i) ASSERT_EQ(m_api->step(m_world), RUBBLE_OK);
    for (int i = 0; i < 6; ++i) loops.clear(), sounds.readFires(m_car, loops);
    ASSERT_FALSE(loops.empty());
    EXPECT_LE(loops.size(), 4u);
    EXPECT_EQ(loops[0].kind, findLoopKind("fire"));
    EXPECT_LT(glm::length(loops[0].position - m_car), 5.0);
}

TEST_F(WorldSoundsTest, TheCarIsBetween) {
    Acoustics acoustics(*m_api, m_world);
    const glm::dvec3 ear = m_car + glm::dvec3(-6.0, 0.0, 0.0);
    for (int i = 0; i < 12; ++i) acoustics.listen(ear);
    std::vector<double> openness;
    const glm::dvec3 places[] = {m_car + glm::dvec3(3.5, 0, 0), ear + glm::dvec3(0, 2, 6), ear};
    acoustics.findOpenness(places, openness);
    EXPECT_LT(openness[0], 0.5);
    EXPECT_EQ(openness[1], 1.0);
    EXPECT_EQ(openness[2], 1.0);
    const Room away = acoustics.room();
    for (int i = 0; i < 12; ++i) acoustics.listen(m_car + glm::dvec3(0.0, 1.2, 0.0));
    EXPECT_EQ(away.openness, 1.0);
    EXPECT_LT(acoustics.room().openness, away.openness - 0.05) << "right above the roof";
    EXPECT_LT(acoustics.room().freePath, 10.0);
}

}  // namespace
}  // namespace sandbox::sound
