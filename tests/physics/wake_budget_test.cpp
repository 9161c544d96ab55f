#include <gtest/gtest.h>

#include "tests/physics/physics_scene.h"

namespace rubble {
namespace {

constexpr int kCubes = 100;

/// Cubes that sleep on a floor and do not touch each other.
void addSleepers(PhysicsScene& scene) {
    scene.addFloor();
    for (int i = 0; i < kCubes; ++i) scene.add(solidGrid({3, 3, 3}, 7), {i % 10 - 5.0, 0.0, i / 10 - 5.0}, false);
    scene.load(false);
    scene.world.applyEdits({});
}

/// Takes the floor away.
CarveEdit removeFloor(const PhysicsScene& scene) {
    const ShapeHandle floor = scene.body(0).shapes[0];
    return {.kind = BrushKind::Box, .position = {0, -0.5, 0}, .halfSize = {11, 0.6, 11}, .shape = floor};
}

TEST(WakeBudget, WhatWakesTogetherWakesInTurns) {
    PhysicsSettings settings;
    settings.wakesPerStep = 10;
    PhysicsScene scene(settings);
    addSleepers(scene);
    ASSERT_EQ(scene.physics.stats().awake, 0);
    scene.stepWith({removeFloor(scene)});
    int steps = 1;
    for (; scene.physics.stats().awake < kCubes && steps < 60; ++steps) {
        ASSERT_LE(scene.physics.stats().awake, 10 * (steps + 1)) << "ten by the edit, ten in each step";
        ASSERT_EQ(scene.physics.stats().awake + scene.physics.stats().waiting, kCubes);
        scene.step();
    }
    EXPECT_LT(steps, 25) << "half of the budget is for those that wait";
    EXPECT_EQ(scene.physics.stats().waiting, 0);
}

TEST(WakeBudget, NearItsEndFewWakePerStep) {
    PhysicsSettings settings;
    settings.awakeBodies = 20;
    PhysicsScene scene(settings);
    addSleepers(scene);
    scene.stepWith({});  // the next edit has the budget of a step with 20 places
    scene.stepWith({removeFloor(scene)});
    EXPECT_LT(scene.physics.stats().awake, kCubes);
    for (int i = 0; i < 25; ++i) scene.step();
    EXPECT_EQ(scene.physics.stats().awake, kCubes) << "the others follow: 4 a step, and 4 places are left for hits";
}

TEST(WakeBudget, FewWakeAtOnce) {
    PhysicsScene scene;
    addSleepers(scene);
    scene.stepWith({removeFloor(scene)});
    EXPECT_EQ(scene.physics.stats().awake, kCubes);
    EXPECT_EQ(scene.physics.stats().waiting, 0);
}

}  // namespace
}  // namespace rubble
