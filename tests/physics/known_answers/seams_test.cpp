#include <gtest/gtest.h>

#include <cmath>

#include "physics/shapes/round_surface.h"
#include "runtime/core/constants.h"
#include "tests/physics/scenes/known_scenes.h"

namespace rubble {
namespace {

/// How the shapes of a floor are held.
enum class Tiles { Slab, Shapes, Bodies, TurnedBodies, DynamicShapes };
constexpr int kTile = 8, kTiles = 16;  ///< voxels of a tile, and tiles of the floor on a side

LevelShape tileShape(const PhysicsScene& scene, const std::string& name, uint8_t entry, const Pose& pose) {
    LevelShape shape;
    shape.name = name;
    shape.grid = solidGrid({kTile, 4, kTile}, entry);
    shape.palette = scene.palette;
    shape.local = pose;
    return shape;
}

/// Adds a floor of 12.8 m from the origin along x and z, whose top is at y = 0. turn: of the floor about the origin.
void addTiledFloor(PhysicsScene& scene, Tiles tiles, uint8_t entry, const glm::dquat& turn) {
    const double size = 0.1 * kTile;
    if (tiles == Tiles::Slab) {
        scene.add(solidGrid({kTile * kTiles, 4, kTile * kTiles}, entry), turn * glm::dvec3(0, -0.4, 0), true, turn);
        return;
    }
    const bool isOneBody = tiles == Tiles::Shapes || tiles == Tiles::DynamicShapes;
    LevelBody body;
    body.name = "tiles";
    body.isStatic = tiles == Tiles::Shapes;
    body.pose = {glm::dvec3(0.0), turn};
    for (int x = 0; x < kTiles; ++x)
        for (int z = 0; z < kTiles; ++z) {
            Pose pose{{x * size, -0.4, z * size}, {1, 0, 0, 0}};
            if (tiles == Tiles::TurnedBodies) {
                const glm::dquat quarter = glm::angleAxis(0.5 * kPi * ((x + 2 * z) % 4), glm::dvec3(0, 1, 0));
                const glm::dvec3 half(0.5 * size, 0.0, 0.5 * size);
                pose = {pose.position + half - quarter * half, quarter};
            }
            const std::string name = "tile " + std::to_string(x) + " " + std::to_string(z);
            if (isOneBody)
                body.shapes.push_back(tileShape(scene, name, entry, pose));
            else
                scene.add(solidGrid({kTile, 4, kTile}, entry), turn * pose.position, true, turn * pose.rotation);
        }
    if (isOneBody) scene.level.bodies.push_back(body);
}

struct Rider {
    VoxelGrid grid;
    double speed = 5.0, friction = 0.3, yaw = 0.0;  ///< m/s; radians from the way that it goes
    CollisionShape shape = CollisionShape::Voxels;  ///< what is round rolls
};
struct Ride {
    double distance = 0.0, aside = 0.0, highest = 0.0;  ///< metres
    double turned = 0.0;                                ///< radians about the floor's normal
};

/// What lies on the tiles and goes along them, aslant by 0.2 radians, for 10 m at most. turn: of all.
Ride rideOver(Tiles tiles, const Rider& rider, const glm::dquat& turn) {
    PhysicsScene scene(known::sleepless({}));
    const uint8_t entry = known::setMaterial(scene, 7, float(rider.friction), 0.0f),
                  heavy = known::setMaterial(scene, 8, float(rider.friction), 0.0f, 20000);
    const glm::dvec3 up = turn * glm::dvec3(0, 1, 0), along = turn * glm::dvec3(std::cos(0.2), 0, std::sin(0.2)),
                     across = glm::cross(along, up);
    scene.level.environment.gravity = glm::vec3(up * -9.81);
    addTiledFloor(scene, tiles, tiles == Tiles::DynamicShapes ? heavy : entry, turn);
    if (tiles == Tiles::DynamicShapes)
        scene.add(solidGrid({200, 10, 200}, entry), turn * glm::dvec3(-3, -1.4, -3), true, turn);
    const bool rolls = rider.shape != CollisionShape::Voxels;
    const glm::dvec3 half = glm::dvec3(rider.grid.size()) * 0.05;
    const CellBox cells{glm::ivec3(0), rider.grid.size()};
    const double height = rolls ? 0.1 * double(fitRoundSurface(rider.grid, cells, rider.shape)->radius) : half.y;
    const glm::dquat rotation = turn * glm::angleAxis(rider.yaw - 0.2, glm::dvec3(0, 1, 0));
    LevelBody& body = scene.add(rider.grid, turn * glm::dvec3(0.9, height, 4.1) - rotation * half, false, rotation);
    body.shapes[0].collisionShape = rider.shape;
    body.velocity = glm::vec3(along * rider.speed);
    if (rolls) body.angularVelocity = glm::vec3(across * (-rider.speed / height));
    scene.load();
    const int number = int(scene.level.bodies.size()) - 1;
    const glm::dvec3 start = scene.center(number), side = rotation * glm::dvec3(0, 0, 1);
    Ride ride;
    for (int i = 0; i < scene.stepsIn(10.0 / rider.speed); ++i) {
        scene.step();
        ride.highest = std::max(ride.highest, glm::dot(scene.center(number) - start, up));
    }
    const glm::dvec3 way = scene.center(number) - start;
    ride.distance = glm::dot(way, along), ride.aside = glm::dot(way, across);
    ride.turned = std::asin(glm::dot(glm::cross(side, scene.body(number).pose.rotation * glm::dvec3(0, 0, 1)), up));
    return ride;
}

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
        PhysicsScene scene(known::sleepless({}));
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
