#include "physics/water/water.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "runtime/core/constants.h"
#include "runtime/core/random.h"
#include "runtime/world/state/fires.h"
#include "tests/physics/physics_scene.h"

namespace rubble {
namespace {

/// A lake without ground, its surface at y = 0, and a material of a chosen density as entry 1 of the palette.
struct Lake : PhysicsScene {
    explicit Lake(uint32_t density, double drag = 1.5) {
        level.materials.materials[1].density = density;
        level.waters.push_back({.name = "lake",
                                .outline = {{-50, -50}, {50, -50}, {50, 50}, {-50, 50}},
                                .depth = 40.0,
                                .linearDrag = drag,
                                .angularDrag = drag});
    }
    void load() {
        PhysicsScene::load();
        world.applyEdits({});  // takes out the change that loaded the level
    }
    double speed(int index) const { return glm::length(body(index).velocity); }
};

TEST(Water, TheDraughtOfACubeIsItsRelativeDensity) {
    for (const auto& [density, share] : {std::pair(500u, 0.5), std::pair(250u, 0.25), std::pair(900u, 0.9)}) {
        Lake scene(density);
        scene.add(solidGrid({10, 10, 10}, 1), {0.0, -0.4, 0.0}, false);
        scene.load();
        scene.seconds(20.0);
        const double under = 0.5 - scene.center(0).y;
        EXPECT_NEAR(under, share, 0.03) << density;  // it may fall asleep at any phase of its last oscillation
        EXPECT_TRUE(scene.body(0).asleep) << "a body in still water sleeps";
    }
}

TEST(Water, TheBuoyancyOfARotatedCubeUnderWaterIsThatOfItsVolume) {
    Lake scene(500);
    Random random(3);
    scene.add(solidGrid({7, 9, 5}, 1), {0.0, 0.0, 0.0}, false);
    scene.load();
    const Shape& shape = scene.world.shapes().at(scene.body(0).shapes[0]);
    const ColliderPart part(shape, Pose{}, scene.world.materials());
    for (int i = 0; i < 200; ++i) {
        const float a = random.unit();
        const float b = random.unit();
        const float c = random.unit();
        const float h = random.unit();
        const glm::dmat3 axes = glm::mat3_cast(glm::normalize(glm::dquat(a, b - 0.5, c - 0.5, 0.3)));
        const CellTransform lattice{axes * 0.1, {0.2, -0.7 + h, 0.1}};
        Submersion sum;
        addSubmersion(part, lattice, {}, scene.world.waters().at(scene.world.waters().handleAt(0)), sum);
        double volume = 0.0;  // by 4 x 4 x 4 samples in each voxel
        glm::dvec3 moment(0.0);
        const int n = 4;
        const double piece = 1e-3 / (n * n * n);
        for (int z = 0; z < 5 * n; ++z)
            for (int y = 0; y < 9 * n; ++y)
                for (int x = 0; x < 7 * n; ++x) {
                    const glm::dvec3 p = lattice.corner + lattice.axes * ((glm::dvec3(x, y, z) + 0.5) / double(n));
                    if (p.y < 0.0) volume += piece, moment += p * piece;
                }
        EXPECT_NEAR(sum.volume, volume, 0.003) << i;
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(sum.moment[k], moment[k], 0.0015) << i;
    }
}

Water poolBetween(double low, double high, double surface, double depth) {
    return {.outline = {{low, -3}, {high, -3}, {high, 3}, {low, 3}}, .surface = surface, .depth = depth};
}

/// By samples: a place in several waters counts once, for the first of them.
void expectUnionBears(const std::vector<Water>& waters) {
    Lake scene(500);
    std::vector<const Water*> all;
    for (const Water& water : waters) all.push_back(&water);
    const glm::ivec3 size(7, 9, 5);
    scene.add(solidGrid(size, 1), {0.0, 0.0, 0.0}, false);
    scene.load();
    const ColliderPart part(scene.world.shapes().at(scene.body(0).shapes[0]), Pose{}, scene.world.materials());
    Random random(5);
    for (int i = 0; i < 60; ++i) {
        const double a = random.unit(), b = random.unit(), c = random.unit(), h = random.unit();
        const glm::dmat3 axes = glm::mat3_cast(glm::normalize(glm::dquat(a, b - 0.5, c - 0.5, 0.3)));
        const CellTransform lattice{axes * 0.1, {-0.1, -0.7 + h, 0.1}};
        std::vector<double> expected(waters.size()), found;
        for (size_t k = 0; k < waters.size(); ++k) {
            Submersion sum;
            addSubmersion(part, lattice, {}, waters[k], sum, std::span(all).first(k));
            found.push_back(sum.volume);
        }
        const int n = 4;
        for (int z = 0; z < size.z * n; ++z)
            for (int y = 0; y < size.y * n; ++y)
                for (int x = 0; x < size.x * n; ++x) {
                    const glm::dvec3 p = lattice.corner + lattice.axes * ((glm::dvec3(x, y, z) + 0.5) / double(n));
                    const auto in = std::ranges::find_if(waters, [&](const Water& water) { return water.contains(p); });
                    if (in != waters.end()) expected[size_t(in - waters.begin())] += 1e-3 / (n * n * n);
                }
        for (size_t k = 0; k < waters.size(); ++k) EXPECT_NEAR(found[k], expected[k], 0.006) << i << ", water " << k;
    }
}

TEST(Water, WhereWatersOverlapTheirUnionBears) {
    expectUnionBears(
        {poolBetween(-3.0, 0.33, 0.0, 2.0), poolBetween(0.1, 3.0, 0.2, 0.5), poolBetween(-1.0, 1.0, 0.4, 0.2)});
    // All around the body: heights alone tell them apart.
    expectUnionBears({poolBetween(-3.0, 3.0, -0.2, 0.1), poolBetween(-3.0, 3.0, 0.1, 0.1),
                      poolBetween(-3.0, 3.0, 0.3, 0.9), poolBetween(-3.0, 3.0, 0.4, 2.0),
                      poolBetween(5.0, 8.0, 0.4, 2.0), poolBetween(-3.0, 3.0, 0.0, 0.3)});
}

TEST(Water, WhatFloatsInTwoWatersFloatsAsInOne) {
    for (const double size : {10.0, 1.0}) {  // what is small takes the mean along its way
        double alone = 0.0;
        for (const double edge : {-60.0, -50.0, 0.03}) {  // from which the second water begins
            Lake scene(500);
            Water second = scene.level.waters[0];
            second.name = "second";
            second.outline = {{edge, -50}, {50, -50}, {50, 50}, {edge, 50}};
            if (edge > -60.0) scene.level.waters.push_back(second);
            scene.add(solidGrid(glm::ivec3(int(size)), 1), {0.0, -0.04 * size, 0.0}, false).shapes[0].voxelSize =
                size > 1.0 ? 0.1f : 0.02f;
            scene.load();
            scene.seconds(8.0);
            if (edge == -60.0) alone = scene.center(0).y;
            EXPECT_NEAR(scene.center(0).y, alone, 1e-6 * size) << "second water from " << edge << ", size " << size;
        }
    }
}

TEST(Water, ACubeBobsWithThePeriodOfItsBuoyancy) {
    Lake scene(500, 0.02);
    scene.add(solidGrid({10, 10, 10}, 1), {0.0, -0.3, 0.0}, false);
    scene.load();
    std::vector<double> rises;  // times at which it passes its equilibrium upward
    double before = scene.center(0).y;
    for (int i = 0; i < 1200 && rises.size() < 6; ++i) {
        scene.step();
        const double now = scene.center(0).y;
        if (before < 0.0 && now >= 0.0) rises.push_back((i + 1 - now / (now - before)) / 60.0);
        before = now;
    }
    ASSERT_EQ(rises.size(), 6u);
    const double period = (rises.back() - rises.front()) / 5.0,
                 expected = 2.0 * kPi * std::sqrt(500.0 / (1000.0 * 9.81));
    EXPECT_NEAR(period, expected, 0.03 * expected);
}

TEST(Water, ABodyRisesNoHigherThanItFellFrom) {
    for (const double drag : {0.0, 0.1, 1.5, 1000.0}) {
        Lake scene(400, drag);
        scene.add(solidGrid({5, 5, 5}, 1), {0.0, 1.0, 0.0}, false);
        scene.load();
        double before = 1.25;
        for (int window = 0; window < 15; ++window) {
            double highest = -1e9;
            for (int i = 0; i < 120; ++i) {
                scene.step();
                if (window || i > 60) highest = std::max(highest, scene.center(0).y);
            }
            EXPECT_LE(highest, drag == 0.0 ? 1.27 : before + 0.004) << drag << " in window " << window;
            before = highest;
        }
    }
}

TEST(Water, AnUprightLogTipsOverAndFloatsFlat) {
    Lake scene(600);
    scene.add(solidGrid({4, 40, 4}, 1), {0.0, -3.0, 0.0}, false, glm::angleAxis(0.02, glm::dvec3(0, 0, 1)));
    scene.load();
    scene.seconds(25.0);
    const glm::dvec3 axis = scene.body(0).pose.rotation * glm::dvec3(0, 1, 0);
    EXPECT_LT(std::abs(axis.y), 0.05);
    EXPECT_NEAR(scene.center(0).y, 0.0, 0.15);
}

TEST(Water, ADenseBodySinksAtItsTerminalVelocity) {
    Lake scene(2000, 3.0);
    scene.add(solidGrid({6, 6, 6}, 1), {0.0, -2.0, 0.0}, false);
    scene.load();
    scene.seconds(4.0);
    // m g = rho V g + drag rho V v
    const double expected = (2000.0 / 1000.0 - 1.0) * 9.81 / 3.0;
    EXPECT_NEAR(-scene.body(0).velocity.y, expected, 0.01 * expected);
}

TEST(Water, AVeryLightBodyDoesNotJitter) {
    Lake scene(30);
    scene.add(solidGrid({8, 1, 8}, 1), {0.0, 0.3, 0.0}, false);
    scene.add(solidGrid({1, 1, 1}, 1), {5.0, 0.3, 0.0}, false);
    scene.load();
    scene.seconds(12.0);  // until it no longer bobs
    for (int i = 0; i < 120; ++i) {
        scene.step();
        EXPECT_LT(scene.speed(0), 0.05);
        EXPECT_LT(scene.speed(1), 0.05);
    }
}

TEST(Water, AFlowCarriesABodyAndLetsItFallAtItsEnd) {
    Lake scene(500);
    scene.level.waters[0].flow = {0.8, 0.0, 0.0};
    scene.level.waters[0].depth = 2.0;
    scene.add(solidGrid({5, 5, 5}, 1), {40.0, -0.25, 0.0}, false);
    scene.load();
    scene.seconds(5.0);
    EXPECT_NEAR(scene.body(0).velocity.x, 0.8, 0.05);
    scene.seconds(15.0);
    EXPECT_LT(scene.center(0).y, -2.0) << "beyond x = 50 there is neither water nor ground";
}

TEST(Water, AFloatingBodyFallsWhenTheWaterIsRemoved) {
    Lake scene(500);
    scene.add(solidGrid({5, 5, 5}, 1), {0.0, -0.25, 0.0}, false);
    scene.load();
    scene.seconds(10.0);
    ASSERT_TRUE(scene.body(0).asleep);
    scene.physics.apply(scene.world.applyEdits({RemoveWaterEdit{scene.world.waters().handleAt(0)}}), scene.world);
    scene.seconds(1.0);
    EXPECT_LT(scene.center(0).y, -2.0);
}

TEST(Water, FiresInWaterGoOut) {
    Lake scene(500);
    scene.addFloor(7, {0.0, -1.0, 0.0});
    scene.add(solidGrid({10, 10, 10}, 5), {0.0, -0.5, 0.0}, true);
    scene.load();
    scene.physics.apply(scene.world.applyEdits({spawnFire({0.5, 0.5, 0.5}, 1.0), spawnFire({0.5, -0.5, 0.5}, 1.0)}),
                        scene.world);
    for (int i = 0; i < 30; ++i) scene.world.applyEdits({});
    const std::vector<Fire> fires = findFires(scene.world);
    EXPECT_FALSE(fires.empty());
    for (const Fire& fire : fires) EXPECT_GT(fire.position.y, 0.0);
}

TEST(Water, ATorrentMovesBodiesNoFasterThanTheLimit) {
    Lake scene(500, 1e5);
    scene.level.waters[0].flow = {1e7, 0.0, 0.0};
    for (int i = 0; i < 8; ++i) scene.add(solidGrid({6, 6, 6}, 1), {0.7 * i, -2.0, 0.0}, false);
    scene.load();
    for (int i = 0; i < 5; ++i) {
        scene.step();
        for (int k = 0; k < 8; ++k) EXPECT_LE(scene.speed(k), limits::kMaxSpeed * 1.001);
    }
}

}  // namespace
}  // namespace rubble
