#include <gtest/gtest.h>

#include <algorithm>

#include "runtime/world/state/fire_state.h"
#include "runtime/world/state/fires.h"
#include "tests/runtime/world/worlds.h"
#include "tests/support/allocation_count.h"
#include "tests/support/grids.h"

namespace rubble {
namespace {

constexpr uint8_t kWood = 1, kBrick = 2;

PaletteRef houseEntries() {
    auto palette = std::make_shared<Palette>();
    (*palette)[kWood] = {.red = 150, .green = 100, .blue = 60, .material = defaultMaterials().find("wood")};
    (*palette)[kBrick] = {.red = 170, .green = 80, .blue = 60, .material = defaultMaterials().find("brick")};
    return palette;
}

LevelBody bodyOf(VoxelGrid grid, glm::dvec3 position) {
    LevelBody body{.name = "body", .pose = {position}};
    LevelShape shape{.name = "shape", .grid = std::move(grid)};
    shape.palette = houseEntries();
    body.shapes.push_back(std::move(shape));
    return body;
}

VoxelGrid wall(glm::ivec3 size, uint8_t entry = kWood) {
    return solidGrid(size, entry);
}

/// Sums of what happened in some steps without edits.
struct Happened {
    uint64_t lit = 0, out = 0, removed = 0, refused = 0, maxSteps = 0;
};
Happened run(World& world, int steps, const Edits& first = {}) {
    Happened out;
    for (int i = 0; i < steps; ++i) {
        const FrameChanges changes = world.applyEdits(i == 0 ? first : Edits{});
        out.lit += changes.firesLit.size();
        out.out += changes.firesOut.size();
        out.refused += changes.firesRefused;
        for (const RemovedVoxels& each : changes.removed) out.removed += each.count;
        out.maxSteps = std::max<uint64_t>(out.maxSteps, findFires(world).size());
        if (!findFires(world).empty() || !changes.firesOut.empty()) {
            EXPECT_TRUE(changes.firesChanged);
        }
    }
    EXPECT_TRUE(voxelAccounting(world).balances());
    return out;
}

TEST(Fire, AWoodenWallBurnsDownAndABrickOneDoesNot) {
    for (const uint8_t entry : {kWood, kBrick}) {
        Level level;
        level.bodies.push_back(bodyOf(wall({32, 24, 3}, entry), {}));
        World world;
        world.load(level);
        const Happened burned = run(world, 60 * 150, {spawnFire({1.6, 0.2, 0.15})});
        if (entry == kBrick) {
            EXPECT_EQ(burned.lit, 0u);
            EXPECT_EQ(burned.removed, 0u);
            continue;
        }
        EXPECT_GE(burned.lit, 9u) << "of twelve bricks; parts that come off may not burn";
        EXPECT_GT(burned.removed, 32u * 24 * 3 * 2 / 3);
        EXPECT_EQ(voxelAccounting(world).removed, burned.removed);
        EXPECT_FALSE(world.data().fire.isActive()) << "nothing is left to be hot";
    }
}

TEST(Fire, ClimbsFasterThanItSpreadsSideways) {
    Level level;
    level.bodies.push_back(bodyOf(wall({104, 104, 3}), {}));
    World world;
    world.load(level);
    const Happened burned = run(world, 60 * 12, {spawnFire({5.2, 5.2, 0.15})});
    ASSERT_GT(burned.lit, 5u);
    glm::dvec3 low(1e9), high(-1e9);
    for (const Fire& fire : findFires(world)) low = glm::min(low, fire.position), high = glm::max(high, fire.position);
    EXPECT_GT(high.y - 5.2, 1.3 * (high.x - 5.2)) << "up against aside";
    EXPECT_GT(high.x - 5.2, 0.7);
    EXPECT_GT(high.y - 5.2, 2.0 * (5.2 - low.y)) << "up against down";
}

TEST(Fire, CharsBeforeItConsumesVoxels) {
    for (const PaintMode mode : {PaintMode::Blend, PaintMode::Layer}) {
        Level level;
        level.bodies.push_back(bodyOf(wall({16, 16, 8}), {}));
        World world;
        world.load(level);
        WorldSettings settings = world.settings();
        settings.paint.mode = mode;
        world.setSettings(settings);
        const Happened burned = run(world, 60 * 3, {spawnFire({0.8, 0.8, 0.8}, 0.4)});
        EXPECT_EQ(burned.removed, 0u);
        const Shape& shape = world.shapes().at(test::firstShape(world));
        int dark = 0, painted = 0;
        shape.grid.forEachBrick([&](glm::ivec3, const BrickRef& brick) {
            forEachVoxel(brick->occupancy, [&](int i) {
                dark += (*shape.palette)[brick->at(i)].red < 120;
                painted += paintSteps(brick->paintAt(i)) > 4;
            });
        });
        EXPECT_GT(mode == PaintMode::Layer ? painted : dark, 50);
        EXPECT_EQ(mode == PaintMode::Layer ? dark : painted, 0);
        EXPECT_LT(remainingStrength(world, test::firstShape(world), {0, 0, 0}), 0.9) << "char is weak";
    }
}

TEST(Fire, SpreadsToNearShapesOnly) {
    Level level;
    level.bodies.push_back(bodyOf(wall({24, 24, 3}), {}));
    level.bodies.push_back(bodyOf(wall({24, 24, 3}), {0, 0, 0.7}));
    level.bodies.push_back(bodyOf(wall({24, 24, 3}), {0, 0, 6.0}));
    World world;
    world.load(level);
    bool nearIsHot = false;
    for (int second = 0; second < 40; ++second) {
        run(world, 60, second ? Edits{} : Edits{spawnFire({1.2, 0.2, 0.15})});
        for (const Fire& fire : findFires(world)) {
            nearIsHot |= fire.position.z > 0.6;
            EXPECT_LT(fire.position.z, 2.0);
        }
    }
    EXPECT_TRUE(nearIsHot);
}

TEST(Fire, WaterStopsAndPreventsFire) {
    Level level;
    level.bodies.push_back(bodyOf(wall({32, 24, 3}), {}));
    World world;
    world.load(level);
    run(world, 120, {spawnFire({1.6, 0.2, 0.15})});
    ASSERT_FALSE(findFires(world).empty());
    const Happened after = run(world, 60, {pourWater({1.6, 1.2, 0.15}, 3.0)});
    EXPECT_GT(after.out, 0u);
    EXPECT_TRUE(findFires(world).empty());
    EXPECT_EQ(run(world, 60, {spawnFire({1.6, 0.2, 0.15})}).lit, 0u) << "it is wet";
    run(world, 60 * 20);
    EXPECT_FALSE(world.data().fire.isActive()) << "dry again";
    EXPECT_GT(run(world, 60, {spawnFire({1.6, 0.2, 0.15})}).lit, 0u);
    EXPECT_GT(run(world, 60, {RemoveFiresEdit{{-1, -1, -1}, {9, 9, 9}}}).out, 0u);
    EXPECT_TRUE(findFires(world).empty());
}

TEST(Fire, FollowsItsPiece) {
    Level level;
    level.bodies.push_back(bodyOf(wall({16, 48, 8}), {}));
    World world;
    world.load(level);
    run(world, 300, {spawnFire({0.8, 4.6, 0.8}, 0.4)});
    ASSERT_FALSE(findFires(world).empty());
    CarveEdit cut{.kind = BrushKind::Box, .position = {0.8, 2.0, 0.4}, .halfSize = {2, 0.1, 2}};
    const FrameChanges changes = world.applyEdits({cut});
    ASSERT_EQ(changes.splits.size(), 1u);
    const std::vector<Fire> fires = findFires(world);
    ASSERT_FALSE(fires.empty());
    for (const Fire& fire : fires) {
        EXPECT_EQ(fire.shape, changes.splits[0].children[0]) << "the upper part burns";
        EXPECT_GT(fire.position.y, 3.5) << "where it did";
    }
    EXPECT_GT(run(world, 60 * 60).removed, 500u) << "and goes on burning";
}

TEST(Fire, BudgetsHold) {
    Level level;
    level.bodies.push_back(bodyOf(wall({64, 64, 3}), {}));
    World world;
    world.load(level);
    WorldSettings settings;
    settings.fire.maxFires = 5;
    settings.fire.maxHot = 20;
    world.setSettings(settings);
    const Happened burned = run(world, 60 * 40, {spawnFire({3.2, 3.2, 0.15}, 2.0)});
    EXPECT_EQ(burned.maxSteps, 5u);
    EXPECT_GT(burned.refused, 0u);
    EXPECT_LE(world.data().fire.hotBricks, 20u);
    EXPECT_LE(fireLights(findFires(world), world.step(), 2).size(), 2u);
}

TEST(Fire, IsTheSameEveryTimeAndGoesOnFromItsState) {
    Level level;
    level.bodies.push_back(bodyOf(wall({32, 32, 3}), {}));
    level.bodies.push_back(bodyOf(wall({32, 8, 16}), {0.3, 3.3, -0.6}));
    World a, b, c;
    a.load(level), b.load(level);
    const Edits first = {spawnFire({1.6, 0.2, 0.15}),
                         HeatEdit{.position = {0.3, 3.4, 0.0}, .radius = 0.5, .joules = 2e5}};
    for (int step = 0; step < 600; ++step) {
        a.applyEdits(step ? Edits{} : first), b.applyEdits(step ? Edits{} : first);
        ASSERT_EQ(a.hash(), b.hash()) << step;
        if (step == 50) {
            WorldState state = b.state();
            state.fire = a.data().fire;
            b.setState(std::move(state));
            ASSERT_EQ(a.hash(), b.hash());
        }
    }
    World cold;
    cold.load(level);
    cold.applyEdits({});
    const uint64_t before = cold.hash();
    WorldState state = cold.state();
    state.fire = a.data().fire;
    for (HeatField& field : state.fire.fields) field.shape = test::firstShape(cold);
    state.fire.fields.resize(1);
    cold.setState(std::move(state));
    EXPECT_NE(cold.hash(), before) << "heat is part of the state";
}

TEST(Fire, InvalidInputIsRefused) {
    Level level;
    level.bodies.push_back(bodyOf(wall({16, 16, 3}), {}));
    World world;
    world.load(level);
    const double nan = std::nan("");
    world.applyEdits({HeatEdit{.position = {nan, 0, 0}, .joules = 1e6}, HeatEdit{.position = {0, 0, 0}, .joules = 1e30},
                      HeatEdit{.position = {0, 0, 0}, .radius = 1e30, .joules = 5},
                      ExtinguishEdit{.position = {0, nan, 0}},
                      ExtinguishEdit{.position = {0, 0, 0}, .radius = 1, .wetSeconds = -4},
                      RemoveFiresEdit{{nan, 0, 0}, {1, 1, 1}}});
    EXPECT_FALSE(world.data().fire.isActive());
}

TEST(Fire, NoncombustiblesCostNothing) {
    Level level;
    level.bodies.push_back(bodyOf(wall({64, 64, 3}), {}));
    World world;
    world.load(level);
    world.applyEdits({});
    const Edits none;
    const uint64_t before = allocationCount();
    for (int i = 0; i < 100; ++i) world.applyEdits(none);
    EXPECT_EQ(allocationCount(), before);
    EXPECT_EQ(world.data().fire.fields.capacity(), 0u);
}

TEST(Fire, GoesOutWithAShapeThatIsMergedIntoAnother) {
    for (const bool enabled : {true, false}) {
        Level level;
        level.bodies.push_back(bodyOf(wall({16, 16, 8}), {}));
        level.bodies[0].shapes.push_back(level.bodies[0].shapes[0]);
        level.bodies[0].shapes[1].name = "second";
        level.bodies[0].shapes[1].local.position = {1.6, 0.0, 0.0};
        World world;
        world.load(level);
        const ShapeHandle first = world.shapes().handleAt(0), second = world.shapes().handleAt(1);
        run(world, 60, {HeatEdit{.position = {2.4, 0.8, 0.4}, .ignite = true, .shape = second}});
        ASSERT_FALSE(findFires(world).empty());
        WorldSettings settings = world.settings();
        settings.fire.enabled = enabled;
        const FrameChanges changes = world.applyEdits({SettingsEdit{settings}, MergeShapeEdit{second, first}});
        EXPECT_TRUE(changes.firesChanged);
        for (const Fire& fire : findFires(world)) EXPECT_EQ(fire.shape, first);
        for (const HeatField& field : world.data().fire.fields) EXPECT_TRUE(world.shapes().find(field.shape));
        run(world, 60);
    }
}

/// A brick of a piece gets the heat of all those that its cells came from. With more, a save would be refused.
TEST(Fire, HeatOfPiecesStaysWithinItsLimit) {
    Level level;
    level.bodies.push_back(bodyOf(wall({21, 8, 8}, kBrick), {}));
    {
        GridWriter writer(level.bodies[0].shapes[0].grid);
        for (int i = 0; i < 64; ++i) writer.set({12, i % 8, i / 8}, 0);
    }
    World world;
    world.load(level);
    const ShapeHandle first = test::firstShape(world);
    world.applyEdits({HeatEdit{.position = {1.0, 0.4, 0.4}, .radius = 3.0, .joules = 1e15}});
    EXPECT_EQ(world.data().fire.hotBricks, 3u);
    world.applyEdits({SplitShapeEdit{first}});
    ASSERT_EQ(world.shapes().size(), 2u);
    int64_t most = 0;
    for (const HeatField& field : world.data().fire.fields)
        for (const HotBrick& hot : field.bricks) most = std::max(most, hot.heat);
    EXPECT_EQ(most, kMaxHeat);
}

TEST(Fire, TheHeatOfFragmentsStaysWhereItWas) {
    Level level;
    level.bodies.push_back(bodyOf(wall({40, 40, 8}), {}));
    World world;
    world.load(level);
    const glm::ivec3 brick(2, 2, 0);
    world.applyEdits({HeatEdit{.position = {2.0, 2.0, 0.0}, .radius = 0.15, .joules = 1e6}});
    ASSERT_EQ(world.data().fire.hotBricks, 1u);
    ASSERT_TRUE(world.data().fire.find(test::firstShape(world), brick));
    const FrameChanges changes = world.applyEdits(
        {BreakEdit{.position = {2.0, 2.0, 0.4}, .radii = {0.9, 0.9, 0.9}, .tool = Tool::Explosive, .seed = 3}});
    ASSERT_FALSE(changes.splits.empty());
    const glm::dvec3 low = glm::dvec3(brick * kBrickSize) * 0.1, high = low + 0.8;
    size_t hotPieces = 0;
    world.shapes().forEach([&](ShapeHandle handle, const Shape& shape) {
        shape.grid.forEachBrick([&](glm::ivec3 at, const BrickRef& content) {
            bool wasHot = false;
            forEachVoxel(content->occupancy, [&](int i) {
                const glm::dvec3 place =
                    shapeToWorld(world, handle)
                        .transformPoint((glm::dvec3(at * kBrickSize + voxelInBrick(i)) + 0.5) * 0.1);
                wasHot = wasHot || WorldBox{low, high}.contains({place, place});
            });
            EXPECT_EQ(world.data().fire.find(handle, at) != nullptr, wasHot) << handle.slot();
            hotPieces += wasHot;
        });
    });
    EXPECT_GT(hotPieces, 2u);
    for (const HeatField& field : world.data().fire.fields) EXPECT_TRUE(world.shapes().find(field.shape));
}

}  // namespace
}  // namespace rubble
