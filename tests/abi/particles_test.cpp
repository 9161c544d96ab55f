#include <algorithm>
#include <utility>
#include <vector>

#include "tests/abi/abi_fixture.h"

namespace rubble {
namespace {

/// A world without a renderer that moves particles.
class AbiParticles : public Abi {
protected:
    void SetUp() override {
        auto settings = sized<rubble_world_settings>();
        settings.flags = RUBBLE_WORLD_NO_RENDERER | RUBBLE_WORLD_PARTICLES;
        ASSERT_EQ(api()->create_world(&settings, &m_world), RUBBLE_OK) << api()->get_last_error();
        ASSERT_EQ(api()->load_level(m_world, s_level.c_str(), nullptr), RUBBLE_OK);
        step();
    }
    std::vector<rubble_particle> particles() {
        std::vector<rubble_particle> out(4096);
        uint32_t count = 0;
        EXPECT_EQ(api()->get_particles(m_world, out.data(), 4096, &count), RUBBLE_OK) << api()->get_last_error();
        out.resize(count);
        return out;
    }
    static rubble_particle_burst burst() {
        auto out = sized<rubble_particle_burst>();
        out.kind = RUBBLE_PARTICLE_CRUMB, out.count = 20;
        out.position[0] = 5.0, out.position[1] = 30.0, out.velocity[0] = 3.0, out.color[1] = 0.5;
        out.size = 0.02, out.life = 0.5;
        return out;
    }
};

TEST_F(AbiParticles, WhatAHostThrowsMovesFallsAndEnds) {
    const rubble_particle_burst given = burst();
    ASSERT_EQ(api()->spawn_particles(m_world, &given), RUBBLE_OK) << api()->get_last_error();
    const uint64_t before = hash();
    ASSERT_EQ(particles().size(), 20u) << "at once";
    EXPECT_EQ(particles()[0].position[0], 5.0);
    step(15);
    ASSERT_EQ(particles().size(), 20u);
    for (const rubble_particle& each : particles()) {
        EXPECT_EQ(each.kind, uint32_t(RUBBLE_PARTICLE_CRUMB));
        EXPECT_NEAR(each.position[0], 5.0 + 3.0 * 0.25, 0.1);
        EXPECT_LT(each.position[1], 29.9) << "it falls";
        EXPECT_NEAR(each.age, 0.5f, 0.01f);
        EXPECT_EQ(each.color[1], 0.5f);
        EXPECT_NEAR(each.radius, 0.02f, 1e-6f);
    }
    step(16);
    EXPECT_TRUE(particles().empty());
    EXPECT_NE(before, 0u);
}

TEST_F(AbiParticles, GravityAndDragComeOnTopOfThoseOfTheKind) {
    rubble_particle_burst rising = burst(), slowed = burst();
    rising.count = slowed.count = 1;
    rising.gravity = -2.0 * 9.81, slowed.drag = 100.0;
    ASSERT_EQ(api()->spawn_particles(m_world, &rising), RUBBLE_OK) << api()->get_last_error();
    ASSERT_EQ(api()->spawn_particles(m_world, &slowed), RUBBLE_OK) << api()->get_last_error();
    step(15);
    ASSERT_EQ(particles().size(), 2u);
    EXPECT_NEAR(particles()[0].position[1], 30.0 + 0.5 * 9.81 * 0.25 * 0.25, 0.05) << "as fast as it would fall";
    EXPECT_NEAR(particles()[1].position[0], 5.0, 0.05);
    rising.gravity = 101.0;
    expectRefused(api()->spawn_particles(m_world, &rising), RUBBLE_ERROR_ARGUMENT, "burst->gravity");
    rising.gravity = 0.0, rising.flags = 2;
    expectRefused(api()->spawn_particles(m_world, &rising), RUBBLE_ERROR_ARGUMENT, "burst->flags");
}

TEST_F(AbiParticles, OneThatPassesFallsThroughTheGround) {
    rubble_particle_burst lands = burst();
    lands.count = 1, lands.life = 10.0, lands.velocity[0] = 0.0;
    lands.position[0] = lands.position[2] = 0.85, lands.position[1] = 1.5;  // over the table
    rubble_particle_burst passes = lands;
    passes.flags = RUBBLE_PARTICLE_PASSES;
    ASSERT_EQ(api()->spawn_particles(m_world, &lands), RUBBLE_OK) << api()->get_last_error();
    ASSERT_EQ(api()->spawn_particles(m_world, &passes), RUBBLE_OK) << api()->get_last_error();
    step(120);
    ASSERT_EQ(particles().size(), 2u);
    EXPECT_GT(particles()[0].position[1], 0.5);
    EXPECT_LT(particles()[1].position[1], -3.0);
}

TEST_F(AbiParticles, TheyChangeNothingInTheWorld) {
    const rubble_world other = makeWorld();
    const rubble_particle_burst given = burst();
    ASSERT_EQ(api()->spawn_particles(m_world, &given), RUBBLE_OK);
    step(5);
    for (int i = 0; i < 5; ++i) ASSERT_EQ(api()->step(other), RUBBLE_OK);
    uint64_t there = 0;
    ASSERT_EQ(api()->get_state_hash(other, &there), RUBBLE_OK);
    EXPECT_EQ(hash(), there);
    uint32_t count = 0;
    expectRefused(api()->spawn_particles(other, &given), RUBBLE_ERROR_ARGUMENT, "RUBBLE_WORLD_PARTICLES");
    expectRefused(api()->get_particles(other, nullptr, 0, &count), RUBBLE_ERROR_ARGUMENT, "RUBBLE_WORLD_PARTICLES");
    EXPECT_EQ(api()->destroy_world(other), RUBBLE_OK);
}

TEST_F(AbiParticles, WhatBreaksIsSeenByAHostThatDrawsItself) {
    const rubble_explosion explosion = tableExplosion();
    ASSERT_EQ(api()->explode(m_world, &explosion), RUBBLE_OK);
    step();
    const std::vector<rubble_particle> all = particles();
    const auto isFlame = [](const rubble_particle& each) { return each.kind == RUBBLE_PARTICLE_FLAME; };
    EXPECT_TRUE(std::any_of(all.begin(), all.end(), isFlame));
}

TEST_F(AbiParticles, EditsWithoutTimeRaiseNoDustAndMoveNothing) {
    const rubble_particle_burst given = burst();
    const rubble_explosion explosion = tableExplosion();
    ASSERT_EQ(api()->spawn_particles(m_world, &given), RUBBLE_OK) << api()->get_last_error();
    const rubble_particle before = particles().at(0);
    for (int i = 0; i < 3; ++i) {
        ASSERT_EQ(api()->explode(m_world, &explosion), RUBBLE_OK);
        ASSERT_EQ(api()->apply_edits(m_world), RUBBLE_OK) << api()->get_last_error();
        auto events = sized<rubble_events>();
        ASSERT_EQ(api()->get_events(m_world, &events), RUBBLE_OK);
        EXPECT_TRUE(i || events.removed_count) << "it breaks the table";
        EXPECT_EQ(events.dust_cloud_count, 0u);
    }
    ASSERT_EQ(particles().size(), 20u);
    EXPECT_EQ(particles()[0].position[1], before.position[1]);
    EXPECT_EQ(particles()[0].age, before.age);
    step();
    EXPECT_EQ(particles().size(), 20u) << "nor does it rise later";
    EXPECT_LT(particles()[0].position[1], before.position[1]);
}

TEST_F(AbiParticles, AFollowerHasTheDustOfItsLeaderHoweverManyStepsItTakes) {
    const rubble_world leader = m_world;
    SetUp();
    const rubble_world follower = std::exchange(m_world, leader);
    const auto bytesOf = [&](auto read) {
        uint64_t size = 0;
        EXPECT_EQ(read(m_world, nullptr, 0, &size), RUBBLE_OK) << api()->get_last_error();
        std::vector<uint8_t> out(size);
        EXPECT_EQ(read(m_world, out.data(), size, &size), RUBBLE_OK) << api()->get_last_error();
        return out;
    };
    ASSERT_EQ(api()->set_undo_limit(m_world, 4), RUBBLE_OK);
    step();
    ASSERT_EQ(api()->keep_deltas(m_world, RUBBLE_DELTAS_ALL | RUBBLE_DELTAS_EVENTS), RUBBLE_OK);
    const std::vector<uint8_t> game = bytesOf(api()->save_game_data);
    ASSERT_EQ(api()->load_game_data(follower, game.data(), game.size()), RUBBLE_OK) << api()->get_last_error();
    auto carve = sized<rubble_carve>();
    carve.position[0] = carve.position[2] = 0.85, carve.position[1] = 0.95;
    carve.radii[0] = carve.radii[1] = carve.radii[2] = 0.15;
    for (const int steps : {1, 40, 600, 0}) {
        ASSERT_EQ(api()->add_undo_mark(m_world), RUBBLE_OK);
        ASSERT_EQ(api()->carve(m_world, &carve), RUBBLE_OK);
        carve.position[0] += 0.2;
        step(std::max(steps, 1));
        ASSERT_EQ(api()->carve(m_world, &carve), RUBBLE_OK);
        ASSERT_EQ(api()->apply_edits(m_world), RUBBLE_OK) << api()->get_last_error();
        if (steps == 0) {
            ASSERT_EQ(api()->undo(m_world), RUBBLE_OK);
            step();
        }
        const std::vector<uint8_t> taken = bytesOf(api()->take_deltas);
        ASSERT_EQ(api()->apply_deltas(follower, taken.data(), taken.size()), RUBBLE_OK) << api()->get_last_error();
        const std::vector<rubble_particle> here = particles();
        m_world = follower;
        const std::vector<rubble_particle> there = particles();
        m_world = leader;
        EXPECT_EQ(here.size(), there.size()) << steps;
        EXPECT_EQ(here.empty(), steps == 600 || steps == 0) << steps;
    }
    EXPECT_EQ(api()->destroy_world(follower), RUBBLE_OK);
}

TEST_F(AbiParticles, ALoadTakesThemAway) {
    const rubble_particle_burst given = burst();
    ASSERT_EQ(api()->spawn_particles(m_world, &given), RUBBLE_OK) << api()->get_last_error();
    ASSERT_FALSE(particles().empty());
    ASSERT_EQ(api()->load_level(m_world, s_level.c_str(), nullptr), RUBBLE_OK) << api()->get_last_error();
    EXPECT_TRUE(particles().empty()) << "they are of the world before";
}

TEST_F(AbiParticles, TheBudgetHoldsAndNumbersOutOfRangeAreRefused) {
    rubble_particle_burst given = burst();
    given.count = 4096;
    for (int i = 0; i < 3; ++i) ASSERT_EQ(api()->spawn_particles(m_world, &given), RUBBLE_OK);
    EXPECT_EQ(particles().size(), 4096u);
    given.count = 4097;
    expectRefused(api()->spawn_particles(m_world, &given), RUBBLE_ERROR_ARGUMENT, "burst->count is 4097");
    given.count = 1, given.kind = 7;
    expectRefused(api()->spawn_particles(m_world, &given), RUBBLE_ERROR_ARGUMENT, "burst->kind is 7");
    given.kind = 0, given.life = 1e9;
    expectRefused(api()->spawn_particles(m_world, &given), RUBBLE_ERROR_ARGUMENT, "burst->life");
    expectRefused(api()->spawn_particles(m_world, nullptr), RUBBLE_ERROR_NULL, "burst");
}

}  // namespace
}  // namespace rubble
