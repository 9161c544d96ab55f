#include <gtest/gtest.h>

#include "runtime/world/history/world_baseline.h"
#include "runtime/world/queries/query.h"
#include "tests/runtime/world/worlds.h"
#include "tests/support/grids.h"

namespace rubble {
namespace {

/// A static slab of 4 m and a free cube of 27 voxels above it.
Level slabAndCube() {
    Level level = test::oneShapeLevel(solidGrid({40, 4, 40}), true);
    LevelBody cube{.name = "cube", .pose = {{2.0, 3.0, 2.0}}, .isStatic = false};
    cube.shapes.push_back(test::levelShape("cube", solidGrid({3, 3, 3})));
    level.bodies.push_back(std::move(cube));
    return level;
}

struct BoundsWorld : World {
    BoundsWorld() {
        load(slabAndCube());
        bodies().forEach([&](BodyHandle handle, const Body& body) {
            if (!body.isStatic) cube = handle;
        });
        applyEdits({});
    }
    void move(glm::dvec3 to) {
        BodyPose pose{cube, {to}};
        setPoses({&pose, 1});
    }
    BodyHandle cube;
};

TEST(Bounds, AreTheLevelsShapesAndAMargin) {
    const BoundsWorld world;
    const WorldBox box = world.data().boundsInUse();
    EXPECT_NEAR(box.low.y, -128.0, 1e-6);
    EXPECT_NEAR(box.high.x, 4.0 + 128.0, 1e-6);
    EXPECT_NEAR(box.high.y, 3.3 + 128.0, 1e-6);
}

TEST(Bounds, WhatLeavesThemBecomesDustInTheNextStepAndIsAccountedFor) {
    BoundsWorld world;
    world.move({2.0, -128.2, 2.0});
    EXPECT_TRUE(world.applyEdits({}).bodiesDestroyed.empty()) << "a part of it is still inside";
    world.move({2.0, -129.0, 2.0});
    const FrameChanges changes = world.applyEdits({});
    EXPECT_EQ(changes.bodiesDestroyed, std::vector<BodyHandle>{world.cube});
    ASSERT_EQ(changes.dust.size(), 1u);
    EXPECT_EQ(changes.dust[0].count, 27u);
    const VoxelAccounting voxels = voxelAccounting(world.data());
    EXPECT_EQ(voxels.removed, 27u);
    EXPECT_EQ(voxels.imported, voxels.standing + voxels.inPieces + voxels.removed);
    EXPECT_TRUE(world.applyEdits({}).empty());
}

TEST(Bounds, KeepLetsBodiesGo) {
    BoundsWorld world;
    world.applyEdits({SetBoundsEdit{{.rule = BoundsRule::Keep}}});
    world.move({2.0, -1e6, 2.0});
    world.applyEdits({});
    EXPECT_TRUE(world.bodies().find(world.cube));
    const FrameChanges changes = world.applyEdits({SetBoundsEdit{}});
    EXPECT_EQ(changes.bodiesDestroyed.size(), 1u) << "the rule holds for what is out there already";
}

TEST(Bounds, ASettingReplacesTheLevelsBox) {
    BoundsWorld world;
    SetBoundsEdit edit;
    edit.bounds.low = {-1.0, -1.0, -1.0};
    edit.bounds.high = {5.0, 2.0, 5.0};
    EXPECT_EQ(world.applyEdits({edit}).bodiesDestroyed.size(), 1u);
    EXPECT_EQ(world.bodies().size(), 1u) << "static bodies stay, wherever they are";
}

TEST(Bounds, UndoBringsBackWhatLeft) {
    BoundsWorld world;
    WorldSettings settings = world.settings();
    settings.undoMarks = 4;
    world.setSettings(settings);
    world.applyEdits({HistoryEdit{HistoryAction::Mark}});
    const uint64_t before = world.data().removed;
    world.move({900.0, 0.0, 0.0});
    EXPECT_EQ(world.applyEdits({}).bodiesDestroyed.size(), 1u);
    world.applyEdits({HistoryEdit{HistoryAction::Undo}});
    EXPECT_EQ(world.data().removed, before);
    EXPECT_EQ(world.bodies().size(), 2u);
    world.applyEdits({});
    EXPECT_EQ(world.bodies().size(), 2u) << "it is inside again";
}

TEST(Bounds, OfALevelStayWithIt) {
    Level level = slabAndCube();
    level.bounds = {{-10.0, -10.0, -10.0}, {10.0, 20.0, 10.0}};
    World world;
    world.load(level);
    EXPECT_EQ(world.data().boundsInUse().low, level.bounds.low);
    EXPECT_EQ(toLevel(world.data()).bounds.high, level.bounds.high);
    World other;
    other.setState(world.state());
    EXPECT_EQ(other.data().boundsInUse().high, level.bounds.high);
}

TEST(Bounds, CastsFindTheGroundWhereItIsSolid) {
    BoundsWorld world;
    const auto ray = [&](glm::dvec3 origin, glm::dvec3 direction, const QueryFilter& filter = {}) {
        return castRay(world, {origin, direction}, filter);
    };
    const glm::dvec3 beside(20.0, 5.0, 2.0), down(0.0, -1.0, 0.0);
    EXPECT_FALSE(ray(beside, down).hit) << "bodies fall through";
    world.applyEdits({SetBoundsEdit{{.rule = BoundsRule::Ground}}});
    const WorldHit hit = ray(beside, down);
    ASSERT_TRUE(hit.hit);
    EXPECT_FALSE(hit.shape);
    EXPECT_NEAR(hit.distance, 5.0 - kFieldsHeight, 1e-9);
    EXPECT_EQ(hit.normal, -down);
    EXPECT_NEAR(hit.position.y, kFieldsHeight, 1e-9);
    EXPECT_TRUE(ray({2.0, 2.0, 2.0}, down).shape) << "the level is nearer";
    EXPECT_FALSE(ray({20.0, 0.1, 2.0}, {1.0, 0.0, 0.0}).hit) << "above it";
    EXPECT_EQ(ray({20.0, -0.2, 2.0}, down).distance, 0.0) << "begins in it";
    EXPECT_FALSE(ray(beside, down, {.rejectStatic = true}).hit);
    EXPECT_FALSE(ray(beside, down, {.layerMask = 2}).hit);
    EXPECT_NEAR(castRay(world, {beside, down, 100.0, 0.5}).distance, 4.5 - kFieldsHeight, 1e-6) << "a sphere";
    const QueryShape box{.kind = QueryShapeKind::Box, .position = beside, .halfSize = {1.0, 2.0, 1.0}};
    const WorldHit cast = castShape(world, {box, down, 100.0});
    EXPECT_NEAR(cast.distance, 3.0 - kFieldsHeight, 1e-6);
    EXPECT_FALSE(cast.shape);
    const WorldHit closest = closestPoint(world, beside, 100.0);
    EXPECT_NEAR(closest.distance, 5.0 - kFieldsHeight, 1e-9);
    EXPECT_EQ(closest.normal, -down);
    EXPECT_TRUE(overlappingShapes(world, {.position = {20.0, 0.0, 2.0}}).empty());
}

}  // namespace
}  // namespace rubble
