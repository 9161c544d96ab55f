#include "runtime/frame/particles.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "runtime/frame/snapshots.h"
#include "samples/scenes/test_scenes.h"
#include "tests/support/allocation_count.h"

namespace rubble {
namespace {

/// A floor at y = 0 and something broken two metres above it.
class ParticlesTest : public testing::Test {
protected:
    void SetUp() override { world.load(makeSingleCube(2, 0.5)); }
    FrameChanges breaks(const char* material, uint64_t voxels) const {
        FrameChanges changes;
        changes.dust.push_back(
            {{4.0, 2.0, 4.0}, 0.5, glm::vec3(0.0f), {150, 140, 120}, world.materials().find(material), voxels});
        return changes;
    }
    static size_t count(const Particles& particles, ParticleKind kind) {
        const auto all = particles.snapshot();
        return size_t(std::count_if(all.begin(), all.end(), [&](const SnapshotParticle& p) { return p.kind == kind; }));
    }
    World world;
};

TEST_F(ParticlesTest, WhatBreaksRaisesDustThatSettles) {
    Particles particles({});
    particles.step(breaks("concrete", 900), {}, {}, world);
    EXPECT_GT(count(particles, ParticleKind::Dust), 3u);
    EXPECT_GT(count(particles, ParticleKind::Crumb), 10u);
    for (int step = 0; step < 400; ++step) {
        particles.step({}, {}, {}, world);
        for (const SnapshotParticle& p : particles.snapshot()) ASSERT_GT(p.position.y, -0.01) << "through the floor";
    }
    EXPECT_TRUE(particles.empty()) << "every particle ends";
}

TEST_F(ParticlesTest, MaterialsEmitTheirOwnParticles) {
    Particles glass({}), metal({});
    glass.step(breaks("glass", 200), {}, {}, world);
    metal.step(breaks("metal", 200), {}, {}, world);
    EXPECT_GT(count(glass, ParticleKind::Glint), 5u);
    EXPECT_EQ(count(glass, ParticleKind::Spark), 0u);
    EXPECT_GT(count(metal, ParticleKind::Spark), 5u);
}

TEST_F(ParticlesTest, AnUndoClearsTheAir) {
    Particles particles({});
    particles.step(breaks("brick", 900), {}, {}, world);
    ASSERT_FALSE(particles.empty());
    FrameChanges restored;
    restored.isRestored = true;
    particles.step(restored, {}, {}, world);
    EXPECT_TRUE(particles.empty());
}

TEST_F(ParticlesTest, BudgetHoldsAndLateEventsStillShow) {
    Particles particles({.maxAlive = 300});
    for (int i = 0; i < 60; ++i) {
        particles.step(breaks("brick", 5000), {}, {}, world);
        ASSERT_LE(particles.snapshot().size(), 300u);
    }
    EXPECT_GT(particles.snapshot().back().opacity, 0.0f);
}

TEST_F(ParticlesTest, FiresSmokeForAsLongAsTheyBurn) {
    const Fire fire{.position = {4.0, 1.0, 4.0}, .radius = 0.4, .intensity = 1.0f, .seed = 7};
    Particles particles({});
    for (int i = 0; i < 120; ++i) particles.step({}, {}, {&fire, 1}, world);
    EXPECT_GT(count(particles, ParticleKind::Flame), 10u);
    EXPECT_GT(count(particles, ParticleKind::Smoke), 10u);
    for (int i = 0; i < 600; ++i) particles.step({}, {}, {}, world);
    EXPECT_TRUE(particles.empty());
}

TEST_F(ParticlesTest, AnExplosionLightsItsSurroundingsAndGoesDark) {
    Particles particles({});
    FrameChanges changes;
    changes.blasts.push_back({.position = {4.0, 2.0, 4.0}, .size = 1.5});
    particles.step(changes, {}, {}, world);
    std::vector<SnapshotLight> lights = particles.lights();
    ASSERT_FALSE(lights.empty());
    EXPECT_LE(lights.size(), ParticleSettings().maxLights);
    EXPECT_GT(lights[0].color.r, 10.0f);
    EXPECT_GT(lights[0].color.r, 2.0f * lights[0].color.g) << "fire is orange";
    EXPECT_LT(glm::distance(lights[0].position, glm::dvec3(4.0, 2.0, 4.0)), 2.0);
    float last = 1e9f;
    for (int step = 0; step < 90; ++step) {
        particles.step({}, {}, {}, world);
        float sum = 0.0f;
        for (const SnapshotLight& light : particles.lights()) sum += light.color.r;
        EXPECT_LE(sum, last * 1.01f);
        last = std::max(sum, 1e-3f);
    }
    EXPECT_TRUE(particles.lights().empty());
}

TEST_F(ParticlesTest, SparksLightAndDustDoesNot) {
    Particles metal({}), stone({});
    metal.step(breaks("metal", 400), {}, {}, world);
    stone.step(breaks("concrete", 400), {}, {}, world);
    EXPECT_FALSE(metal.lights().empty());
    EXPECT_TRUE(stone.lights().empty());
}

TEST_F(ParticlesTest, SnapshotsListTheLightOfAnExplosionUntilItHasGone) {
    Snapshots snapshots{ParticleSettings{}};
    snapshots.publishWithoutShadow(world.applyEdits({}), {}, world);
    snapshots.take();
    FrameChanges changes;
    changes.step = world.step();
    changes.blasts.push_back({.position = {4.0, 2.0, 4.0}, .size = 1.5});
    snapshots.publishWithoutShadow(changes, {}, world);
    auto taken = snapshots.take();
    ASSERT_TRUE(taken && taken->lightsChanged);
    EXPECT_FALSE(taken->lights.empty());
    bool isDark = false;
    for (int step = 0; step < 120; ++step) {
        snapshots.publishWithoutShadow({}, {}, world);
        taken = snapshots.take();
        if (!taken || !taken->lightsChanged) continue;
        EXPECT_FALSE(isDark) << "a list of lights without a change";
        isDark = taken->lights.empty();
    }
    EXPECT_TRUE(isDark);
}

TEST_F(ParticlesTest, TheSameStepsGiveTheSameParticles) {
    Particles a({}), b({});
    for (Particles* each : {&a, &b}) {
        each->step(breaks("wood", 400), {}, {}, world);
        for (int i = 0; i < 30; ++i) each->step({}, {}, {}, world);
    }
    const auto one = a.snapshot(), two = b.snapshot();
    ASSERT_EQ(one.size(), two.size());
    for (size_t i = 0; i < one.size(); ++i) EXPECT_EQ(one[i].position, two[i].position);
}

TEST_F(ParticlesTest, CostsNothingWithoutParticles) {
    Particles particles({}), off({.maxAlive = 0});
    const FrameChanges nothing, much = breaks("concrete", 900);
    const size_t before = allocationCount();
    for (int i = 0; i < 100; ++i) {
        particles.step(nothing, {}, {}, world);
        off.step(much, {}, {}, world);
    }
    EXPECT_EQ(allocationCount(), before);
    EXPECT_TRUE(off.empty());
}

TEST_F(ParticlesTest, SnapshotsCarryParticlesUntilTheLastHasGone) {
    Snapshots snapshots{ParticleSettings{}};
    snapshots.publishWithoutShadow(world.applyEdits({}), {}, world);
    EXPECT_FALSE(snapshots.take()->particlesChanged);
    snapshots.publishWithoutShadow(world.applyEdits({ExplodeEdit{{4.0, 0.0, 4.0}, 1.0}}), {}, world);
    EXPECT_GT(snapshots.take()->particles.size(), 10u);
    bool emptied = false;
    for (int i = 0; i < 800; ++i) {
        snapshots.publishWithoutShadow(world.applyEdits({}), {}, world);
        if (const auto snapshot = snapshots.take()) emptied = snapshot->particlesChanged && snapshot->particles.empty();
    }
    EXPECT_TRUE(emptied) << "no snapshot said that all particles are gone";
}

}  // namespace
}  // namespace rubble
