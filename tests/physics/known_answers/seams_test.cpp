#include <gtest/gtest.h>

#include <cmath>

#include "tests/physics/scenes/known_scenes.h"
#include "tests/physics/scenes/seam_scenes.h"

namespace rubble {
namespace {

using namespace known;

/// Expects what goes over flush tiles to go as over one slab.
void expectNoSeams(const Rider& rider, double maxAside, double maxTurn) {
    for (const glm::dquat& turn : {glm::dquat(1, 0, 0, 0), glm::normalize(glm::dquat(0.9, 0.2, 0.3, 0.1))}) {
        const Ride slab = rideOver(Tiles::Slab, rider, turn);
        for (const Tiles tiles : {Tiles::Shapes, Tiles::Bodies, Tiles::TurnedBodies, Tiles::DynamicShapes}) {
            const Ride ride = rideOver(tiles, rider, turn);
            const auto of = testing::Message() << "tiles " << int(tiles) << ", " << rider.speed << " m/s";
            EXPECT_NEAR(ride.distance / slab.distance, 1.0, 0.02) << of;
            EXPECT_LT(ride.highest, 0.001) << of;
            EXPECT_NEAR(ride.aside, slab.aside, maxAside) << of;
            EXPECT_NEAR(ride.turned, slab.turned, maxTurn) << of;
        }
    }
}

TEST(Seams, ACrateSlidesOverFlushTilesAsOverOneSlab) {
    for (const double yaw : {0.2, 0.0, 0.5}) expectNoSeams({solidGrid({6, 6, 6}, 7), 5.0, 0.3, yaw}, 0.15, 0.2);
    expectNoSeams({solidGrid({13, 2, 9}, 7), 5.0, 0.3, 0.7}, 0.15, 0.2);
}

TEST(Seams, WhatHasNoFrictionLosesNoSpeedOnFlushTiles) {
    for (const double speed : {1.0, 5.0, 20.0}) expectNoSeams({solidGrid({6, 6, 6}, 7), speed, 0.0, 0.5}, 0.01, 0.005);
}

TEST(Seams, WhatRollsOverFlushTilesDoesNotHop) {
    const auto disc = gridOf({8, 8, 3}, [](glm::ivec3 c) {
        const glm::ivec3 d = 2 * c - 7;
        return uint8_t(d.x * d.x + d.y * d.y <= 64 ? 7 : 0);
    });
    const auto ball = gridOf(glm::ivec3(8), [](glm::ivec3 c) {
        const glm::ivec3 d = 2 * c - 7;
        return uint8_t(d.x * d.x + d.y * d.y + d.z * d.z <= 64 ? 7 : 0);
    });
    for (const double speed : {1.0, 5.0, 20.0}) {
        expectNoSeams({disc, speed, 0.8, 0.0, CollisionShape::CylinderZ}, 0.03, 0.01);
        expectNoSeams({ball, speed, 0.8, 0.0, CollisionShape::Sphere}, 0.01, 0.01);
    }
}

/// A wall of two shapes stands on a floor of two: what slides along and against it is held by both, and by no seam.
TEST(Seams, FlushTilesHoldWhatFallsOnThemAndWhatIsPushedIntoTheirCorners) {
    for (const double speed : {5.0, 20.0, 60.0}) {
        PhysicsScene scene(sleepless({}));
        addTiledFloor(scene, Tiles::Bodies, 7, {1, 0, 0, 0});
        for (int x = 0; x < kTiles; ++x)
            for (int y = 0; y < 3; ++y) {
                scene.add(solidGrid({kTile, kTile, 1}, 7), {0.8 * x, 0.8 * y, -0.1}, true);
                scene.add(solidGrid({1, kTile, kTile}, 7), {-0.1, 0.8 * y, 0.8 * x}, true);
            }
        std::vector<int> crates;
        for (int i = 0; i < 8; ++i) {
            crates.push_back(int(scene.level.bodies.size()));
            scene.add(solidGrid({3, 3, 3}, 7), {1.3 + 0.8 * i, 0.6, 1.3 + 0.55 * i}, false).velocity =
                glm::vec3(glm::normalize(glm::dvec3(-1.0, -0.6, -0.7)) * speed);
        }
        scene.load();
        scene.seconds(3.0);
        for (const int crate : crates) {
            const glm::dvec3 at = scene.center(crate);
            EXPECT_GT(std::min({at.x, at.y, at.z}), 0.148) << speed << " m/s";
        }
    }
}

}  // namespace
}  // namespace rubble
