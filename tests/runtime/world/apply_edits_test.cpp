#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "runtime/core/log.h"
#include "tests/runtime/world/worlds.h"
#include "tests/support/allocation_count.h"
#include "tests/support/grids.h"

namespace rubble {
namespace {

using test::firstShape;
using test::oneShapeLevel;
using test::sphereCarve;

/// A mast of 4x40x4 on a foot of 16x4x16 cells of 0.1 m.
VoxelGrid mast() {
    return gridOf({16, 44, 16},
                  [](glm::ivec3 c) { return uint8_t(c.y < 4 || (c.x >= 6 && c.x < 10 && c.z >= 6 && c.z < 10)); });
}

TEST(ApplyEdits, AStepWithoutEditsAllocatesNothing) {
    World world;
    world.load(oneShapeLevel(mast(), true));
    EXPECT_TRUE(world.applyEdits({}).levelReplaced);
    const Edits none;
    const size_t before = allocationCount();
    const FrameChanges changes = world.applyEdits(none);
    const size_t after = allocationCount();
    EXPECT_EQ(after, before);
    EXPECT_TRUE(changes.empty());
    EXPECT_EQ(changes.step, 2u);
    EXPECT_EQ(world.step(), 2u);
}

TEST(ApplyEdits, AnEditOfWhatItsStepHasDestroyedBeforeItsTurnSaysNothing) {
    std::vector<std::string> lines;
    setLogSink([](void* user, LogLevel,
                  std::string_view line) { static_cast<std::vector<std::string>*>(user)->emplace_back(line); },
               &lines);
    World world;
    world.load(oneShapeLevel(solidGrid({4, 4, 4}, 1), false));
    world.applyEdits({});
    const ShapeHandle shape = firstShape(world);
    const BodyHandle body = world.shapes().at(shape).body;
    const Edits edits = {BreakEdit{.position = glm::dvec3(0.2), .radii = {0.2, 0.2, 0.2}, .shape = shape},
                         ImpulseEdit{.body = body}, ImpactLoadEdit{shape, glm::dvec3(0.2), glm::dvec3(1.0)}};
    Edits all = {ResizeShapeEdit{shape, {{8, 8, 8}, {9, 9, 9}}}};
    all.insert(all.end(), edits.begin(), edits.end());
    world.applyEdits(all);
    EXPECT_FALSE(world.bodies().find(body));
    EXPECT_TRUE(lines.empty()) << lines.front();
    world.applyEdits(edits);
    EXPECT_EQ(lines.size(), 3u);
    setLogSink(nullptr, nullptr);
}

TEST(ApplyEdits, DetachedPiecesBecomeBodies) {
    World world;
    world.load(oneShapeLevel(mast(), true, {{10.0, 0.0, -3.0}}));
    const ShapeHandle parent = test::firstShape(world);
    const uint64_t before = world.shapes().at(parent).grid.voxelCount();
    const FrameChanges changes = world.applyEdits({sphereCarve({10.8, 2.0, -2.2}, 0.4)});
    ASSERT_EQ(changes.splits.size(), 1u);
    ASSERT_EQ(changes.splits[0].children.size(), 1u);
    EXPECT_EQ(changes.splits[0].parent, parent);
    const ShapeHandle child = changes.splits[0].children[0];
    EXPECT_EQ(changes.shapesCreated, std::vector{child});
    EXPECT_EQ(changes.carved, std::vector{parent});
    const Shape& piece = world.shapes().at(child);
    EXPECT_TRUE(piece.isPiece);
    EXPECT_EQ(changes.bodiesCreated, std::vector{piece.body});
    EXPECT_FALSE(world.bodies().at(piece.body).isStatic);
    // The child's cells are where they were in the world.
    EXPECT_EQ(changes.splits[0].parentOffset[0] % 8, glm::ivec3(0));
    const glm::dvec3 corner = shapeToWorld(world, child).position - shapeToWorld(world, parent).position;
    EXPECT_LT(glm::length(corner - glm::dvec3(changes.splits[0].parentOffset[0]) * 0.1), 1e-6);
    uint64_t removed = 0;
    for (const RemovedVoxels& each : changes.removed) removed += each.count;
    EXPECT_EQ(before, world.shapes().at(parent).grid.voxelCount() + piece.grid.voxelCount() + removed);
    const VoxelAccounting accounting = voxelAccounting(world);
    EXPECT_TRUE(accounting.balances());
    EXPECT_EQ(accounting.inPieces, piece.grid.voxelCount());
    EXPECT_EQ(accounting.removed, removed);
}

TEST(ApplyEdits, TheJournalHoldsEveryChangedBrickOnce) {
    World world;
    world.load(oneShapeLevel(mast(), true));
    const ShapeHandle parent = test::firstShape(world);
    VoxelGrid replica = world.shapes().at(parent).grid;
    Random random(3);
    for (int step = 0; step < 20; ++step) {
        const float x = random.unit(), y = random.unit(), z = random.unit();
        PaintEdit paint{.position = {1.6 * x, 4.4 * y, 1.6 * z}, .radius = 0.3};
        const FrameChanges changes = world.applyEdits({sphereCarve({1.6 * z, 4.4 * x, 1.6 * y}, 0.3), paint});
        for (size_t i = 0; i < changes.bricks.size(); ++i) {
            EXPECT_EQ(changes.bricks[i].shape, parent);
            for (size_t j = 0; j < i; ++j) EXPECT_NE(changes.bricks[i].brick, changes.bricks[j].brick);
            replica.setBrick(changes.bricks[i].brick, changes.bricks[i].content);
        }
        ASSERT_EQ(replica.contentHash(), world.shapes().at(parent).grid.contentHash());
    }
}

TEST(ApplyEdits, AFreeShapeKeepsItsLargestPiece) {
    World world;
    world.load(oneShapeLevel(mast(), false));
    const ShapeHandle parent = test::firstShape(world);
    const FrameChanges changes = world.applyEdits({sphereCarve({0.8, 2.0, 0.8}, 0.4)});
    ASSERT_EQ(changes.splits.size(), 1u);
    EXPECT_GT(world.shapes().at(parent).grid.voxelCount(),
              world.shapes().at(changes.splits[0].children[0]).grid.voxelCount());
    EXPECT_TRUE(changes.unanchored.empty());
}

/// Two small cuts close to each other are tested together, in one step and over steps.
TEST(ApplyEdits, TwoHalfCutsSplitTogether) {
    VoxelGrid bar({60, 6, 6});
    {
        GridWriter writer(bar);
        for (int i = 0; i < 60 * 6 * 6; ++i) writer.set({i % 60, i / 60 % 6, i / 360}, 1);
    }
    const auto half = [](double y) {
        CarveEdit cut{.kind = BrushKind::Box, .position = {2.55, y, 0.3}, .halfSize = {0.06, 0.16, 0.4}};
        return cut;
    };
    for (const bool isOneStep : {true, false}) {
        World world;
        world.load(oneShapeLevel(bar, false));
        world.applyEdits({});
        EXPECT_TRUE(world.applyEdits({sphereCarve({5.0, 0.3, 0.3}, 0.1)})
                        .splits.empty());  // the first test looks at the whole shape
        if (!isOneStep) {
            EXPECT_TRUE(world.applyEdits({half(0.15)}).splits.empty());
        }
        const FrameChanges changes =
            isOneStep ? world.applyEdits({half(0.15), half(0.45)}) : world.applyEdits({half(0.45)});
        ASSERT_EQ(changes.splits.size(), 1u);
        EXPECT_EQ(world.shapes().size(), 2u);
    }
}

/// Voxels that break out as fragments count as lost in the connectivity test, as carved ones do.
TEST(ApplyEdits, ABreakThatDividesAShapeSplitsIt) {
    VoxelGrid bar({60, 6, 6});
    {
        GridWriter writer(bar);
        for (int i = 0; i < 60 * 6 * 6; ++i) writer.set({i % 60, i / 60 % 6, i / 360}, 1);
    }
    World world;
    world.load(oneShapeLevel(bar, false));
    world.applyEdits({sphereCarve({5.0, 0.3, 0.3}, 0.1)});  // a first cut looks at all of it
    BreakEdit blow{.position = {3.0, 0.3, 0.3}};
    blow.radii.fill(0.5);
    world.applyEdits({blow});
    EXPECT_GT(world.shapes().size(), 2u);
    world.shapes().forEach(
        [](ShapeHandle, const Shape& shape) { EXPECT_EQ(test::floodFill(test::PlainGrid(shape.grid)).size(), 1u); });
}

TEST(ApplyEdits, AStaticShapeWithoutAnchorsIsDetached) {
    World world;
    world.load(oneShapeLevel(mast(), true));
    const ShapeHandle shape = test::firstShape(world);
    const BodyHandle oldBody = world.shapes().at(shape).body;
    CarveEdit foot{.kind = BrushKind::Box, .position = {0.8, 0.3, 0.8}, .halfSize = {2.0, 0.3, 2.0}};
    const FrameChanges changes = world.applyEdits({foot});
    EXPECT_EQ(changes.unanchored, std::vector{shape});
    EXPECT_EQ(changes.bodiesDestroyed, std::vector{oldBody});
    ASSERT_EQ(changes.bodiesCreated.size(), 1u);
    EXPECT_EQ(world.shapes().at(shape).body, changes.bodiesCreated[0]);
    EXPECT_FALSE(world.bodies().at(changes.bodiesCreated[0]).isStatic);
    EXPECT_TRUE(voxelAccounting(world).balances());
    EXPECT_EQ(voxelAccounting(world).standing, 0u);
}

TEST(ApplyEdits, AShapeCarvedAwayWhollyIsDestroyed) {
    World world;
    Level level = oneShapeLevel(mast(), false);
    level.lights.push_back({.light = {.name = "light", .local = {{0.5, 0.5, 0.5}}}, .shapeName = "shape"});
    world.load(level);
    const ShapeHandle shape = test::firstShape(world);
    const FrameChanges changes = world.applyEdits({sphereCarve({0.8, 2.0, 0.8}, 20.0)});
    EXPECT_EQ(changes.shapesDestroyed, std::vector{shape});
    EXPECT_EQ(world.bodies().size(), 0u);
    EXPECT_EQ(world.shapes().find(shape), nullptr);
    EXPECT_TRUE(changes.bricks.empty());
    EXPECT_EQ(changes.lights.size(), 1u);
    world.lights().forEach([&](LightHandle, const Light& light) { EXPECT_FALSE(light.enabled); });
    EXPECT_TRUE(voxelAccounting(world).balances());
}

TEST(ApplyEdits, PiecesBelowMinPieceVoxelsAreRemoved) {
    World world;
    world.setSettings({.minPieceVoxels = 100000});
    world.load(oneShapeLevel(mast(), true));
    EXPECT_EQ(world.settings().minPieceVoxels, 100000u);
    const FrameChanges changes = world.applyEdits({sphereCarve({0.8, 2.0, 0.8}, 0.4)});
    EXPECT_TRUE(changes.splits.empty());
    EXPECT_EQ(world.shapes().size(), 1u);
    const VoxelAccounting accounting = voxelAccounting(world);
    EXPECT_TRUE(accounting.balances());
    EXPECT_EQ(accounting.inPieces, 0u);
    EXPECT_GT(accounting.removed, 350u);  // the mast above the cut is removed too
}

TEST(ApplyEdits, StaleHandlesChangeNothing) {
    World world;
    world.load(oneShapeLevel(mast(), false));
    const ShapeHandle shape = test::firstShape(world);
    const BodyHandle body = world.shapes().at(shape).body;
    world.applyEdits({sphereCarve({0.8, 2.0, 0.8}, 20.0)});
    CarveEdit carve = sphereCarve({0.8, 2.0, 0.8}, 1.0);
    carve.shape = shape;
    EXPECT_TRUE(world.applyEdits({carve, ImpulseEdit{body, {}, {1, 0, 0}}}).empty());
}

TEST(ApplyEdits, NotANumberChangesNothing) {
    World world;
    world.load(oneShapeLevel(mast(), true));
    world.applyEdits({});
    const double nan = std::nan("");
    const uint64_t voxels = voxelAccounting(world).standing;
    CarveEdit box{.kind = BrushKind::Box, .position = {0.8, nan, 0.8}, .halfSize = {1, 1, 1}};
    world.applyEdits({sphereCarve({nan, 0, 0}, 1.0), sphereCarve({0.8, 2.0, 0.8}, nan), box,
                      PaintEdit{.position = {nan, 0, 0}}, ExplodeEdit{{nan, 0, 0}, 1.0},
                      sphereCarve({1e300, 0, 0}, 1.0)});
    EXPECT_EQ(voxelAccounting(world).standing, voxels);
}

TEST(ApplyEdits, ExplosionsPushFragmentsAndPaintSoot) {
    World world;
    world.load(oneShapeLevel(mast(), true));
    const FrameChanges changes = world.applyEdits({ExplodeEdit{{0.8, 2.0, 0.8}, 0.9}});
    ASSERT_EQ(changes.splits.size(), 2u) << "what broke out, then what came loose";
    EXPECT_GT(changes.bodiesCreated.size(), 2u) << "fragments, and the top of the mast";
    EXPECT_EQ(changes.impulses.size(), changes.bodiesCreated.size());
    for (const ImpulseApplied& each : changes.impulses) {
        const Body& body = world.bodies().at(each.body);
        const glm::dvec3 center = body.pose.transformPoint(bodyMass(world, each.body).center);
        EXPECT_GT(glm::dot(each.impulse, center - glm::dvec3(0.8, 2.0, 0.8)), 0.0);
    }
    EXPECT_TRUE(voxelAccounting(world).balances());
    EXPECT_GT(changes.paintedVoxels, 0u);
}

/// A free cube of 1 m, 1.5 m from a blast, and between them a wall of which the blast breaks nothing, of a height.
double pushBehindWall(int wallVoxels, bool isStatic = true) {
    Level level = oneShapeLevel(solidGrid({10, 10, 10}, 1), false, {{1.0, 0.0, -0.5}});
    if (wallVoxels) {
        LevelBody wall{.name = "wall", .pose = {{0.8, 0.0, -1.5}}, .isStatic = isStatic};
        wall.shapes.push_back(test::levelShape("wall", solidGrid({1, wallVoxels, 30}, 1)));
        level.bodies.push_back(wall);
    }
    World world;
    world.load(level);
    const FrameChanges changes = world.applyEdits({ExplodeEdit{{0.0, 0.5, 0.0}, 0.7}});
    EXPECT_TRUE(changes.removed.empty());
    double push = 0.0;
    for (const ImpulseApplied& each : changes.impulses)
        if (each.body == world.bodies().handleAt(0)) push = glm::length(each.impulse);
    return push;
}

TEST(ApplyEdits, WhatStandsShelters) {
    const double open = pushBehindWall(0);
    EXPECT_GT(open, 10.0);
    EXPECT_EQ(pushBehindWall(20), 0.0);
    EXPECT_EQ(pushBehindWall(20, false), open) << "what is free is pushed itself";
    const double behindHalf = pushBehindWall(5) / open;
    EXPECT_GT(behindHalf, 0.3);
    EXPECT_LT(behindHalf, 0.7);
}

TEST(ApplyEdits, TheSameEditsGiveTheSameHash) {
    const auto run = [] {
        World world;
        world.load(oneShapeLevel(towerGrid({64, 60, 48}), true));
        std::vector<uint64_t> hashes;
        Random random(11);
        for (int step = 0; step < 30; ++step) {
            const double x = random.unit() * 6.4, y = random.unit() * 6.0, z = random.unit() * 4.8;
            if (step % 3 == 0) world.applyEdits({ExplodeEdit{{x, y, z}, 1.3}});
            if (step % 3 == 1)
                world.applyEdits(
                    {sphereCarve({x, y, z}, 0.8), PaintEdit{.position = {y, x, z}, .probability = 90, .seed = 5}});
            if (step % 3 == 2)
                world.applyEdits({CarveEdit{
                    .kind = BrushKind::Capsule, .position = {x, y, z}, .end = {z, x, y}, .radii = {0.2, 0.2, 0.2}}});
            hashes.push_back(world.hash());
        }
        EXPECT_TRUE(voxelAccounting(world).balances());
        EXPECT_GT(world.shapes().size(), 3u);
        return hashes;
    };
    EXPECT_EQ(run(), run());
}

TEST(ApplyEdits, AnAnchorAroundAllCellsHoldsAllParts) {
    const int far = std::numeric_limits<int>::max();
    for (const CellBox& anchor :
         {CellBox{glm::ivec3(-far - 1), glm::ivec3(far)}, CellBox{{-far - 1, 0, -far - 1}, {far, 1, far}},
          CellBox{{0, 0, 0}, glm::ivec3(far)}}) {
        Level level = oneShapeLevel(solidGrid({100, 40, 40}, 1), true);
        level.bodies[0].shapes[0].anchors = {anchor};
        World world;
        world.load(level);
        const ShapeHandle shape = firstShape(world);
        const auto cut = [](double x) {
            return CarveEdit{.kind = BrushKind::Box, .position = {x, 2.0, 2.0}, .halfSize = {0.2, 9.0, 9.0}};
        };
        EXPECT_TRUE(world.applyEdits({cut(3.0)}).splits.empty());
        EXPECT_TRUE(world.applyEdits({cut(7.0)}).splits.empty());
        EXPECT_TRUE(world.applyEdits({ResizeShapeEdit{shape, {{-9, -9, -9}, {109, 49, 49}}}, cut(9.0)}).splits.empty());
        World loaded;
        loaded.setState(world.state());
        EXPECT_TRUE(loaded.applyEdits({cut(5.0)}).splits.empty());
        EXPECT_EQ(loaded.shapes().size(), 1u);
    }
}

}  // namespace
}  // namespace rubble
