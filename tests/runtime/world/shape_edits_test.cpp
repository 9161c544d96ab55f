#include <gtest/gtest.h>

#include <map>

#include "runtime/destruction/detachment.h"
#include "runtime/world/history/world_baseline.h"
#include "runtime/world/state/load_level.h"
#include "tests/runtime/world/worlds.h"
#include "tests/support/grids.h"

namespace rubble {
namespace {

/// Every solid cell of a world by its position in whole cells; shapes are not rotated here.
std::map<std::array<int, 3>, uint8_t> worldCells(const World& world) {
    std::map<std::array<int, 3>, uint8_t> out;
    world.shapes().forEach([&](ShapeHandle handle, const Shape& shape) {
        const glm::dvec3 corner = glm::round(shapeToWorld(world, handle).position / double(shape.voxelSize));
        shape.grid.forEachBrick([&](glm::ivec3 brick, const BrickRef& content) {
            forEachVoxel(content->occupancy, [&](int i) {
                const glm::ivec3 c = glm::ivec3(corner) + brick * kBrickSize + voxelInBrick(i);
                EXPECT_FALSE(out.contains({c.x, c.y, c.z})) << "two voxels in one place";
                out[{c.x, c.y, c.z}] = content->at(i);
            });
        });
        EXPECT_EQ(shape.moments, gridMoments(shape.grid, *shape.palette, world.materials()));
    });
    return out;
}

VoxelGrid twoBlocks() {
    VoxelGrid grid({45, 20, 30});
    GridWriter writer(grid);
    for (int i = 0; i < 10 * 10 * 10; ++i) {
        const glm::ivec3 c(i % 10, i / 10 % 10, i / 100);
        writer.set(c + glm::ivec3(3, 5, 9), 1);
        if (c.x < 9) writer.set(c + glm::ivec3(21, 5, 9), 2);
    }
    writer.set({40, 0, 0}, 3);
    writer.flush();
    return grid;
}

/// A body with a frame of `length` x 16 x 16 cells, and a peg inside it whose upper part is loose if `isCracked`.
Level frameAndPeg(bool isStatic, bool isCracked = false, int length = 24) {
    const auto isFrame = [](glm::ivec3 c) { return uint8_t(c.y < 4 || c.x < 4 ? 1 : 0); };
    Level level = test::oneShapeLevel(gridOf({length, 16, 16}, isFrame), isStatic);
    LevelShape peg = test::levelShape(
        "peg", gridOf({8, 10, 8}, [=](glm::ivec3 c) { return uint8_t(isCracked && c.y == 5 ? 0 : 6); }));
    auto palette = std::make_shared<Palette>(*peg.palette);
    (*palette)[6] = {.red = 7, .material = 2};
    peg.palette = palette;
    peg.local.position = glm::dvec3(8, 4, 4) * 0.1;
    level.bodies[0].shapes.push_back(peg);
    return level;
}

World worldOf(VoxelGrid grid, bool isStatic) {
    World world;
    world.load(test::oneShapeLevel(std::move(grid), isStatic));
    world.applyEdits({});
    return world;
}

TEST(ShapeEdits, SplitKeepsEveryVoxelInItsPlaceAndOnTheBody) {
    for (const bool isStatic : {true, false}) {
        World world = worldOf(twoBlocks(), isStatic);
        const auto before = worldCells(world);
        const ShapeHandle shape = test::firstShape(world);
        const FrameChanges changes = world.applyEdits({SplitShapeEdit{shape}});
        ASSERT_EQ(changes.splits.size(), 1u);
        EXPECT_EQ(changes.splits[0].children.size(), 2u);
        EXPECT_EQ(world.bodies().size(), 1u);
        EXPECT_EQ(worldCells(world), before);
        EXPECT_TRUE(voxelAccounting(world).balances());
    }
}

TEST(ShapeEdits, SplitRemovesTheResidual) {
    World world = worldOf(twoBlocks(), false);
    world.applyEdits({SplitShapeEdit{test::firstShape(world), true}});
    EXPECT_EQ(world.shapes().size(), 2u);
    EXPECT_EQ(voxelAccounting(world).removed, 1u);
    EXPECT_TRUE(voxelAccounting(world).balances());
}

TEST(ShapeEdits, TrimAndResizeLeaveVoxelsWhereTheyAre) {
    World world = worldOf(twoBlocks(), false);
    const ShapeHandle shape = test::firstShape(world);
    const auto before = worldCells(world);
    const FrameChanges changes = world.applyEdits({ResizeShapeEdit{shape, {{-13, 0, -8}, {64, 50, 30}}}});
    EXPECT_EQ(changes.shapesDestroyed, std::vector{shape});
    EXPECT_EQ(changes.shapesCreated, std::vector{shape});
    EXPECT_EQ(world.shapes().at(shape).grid.size(), glm::ivec3(77, 50, 38));
    EXPECT_EQ(worldCells(world), before);
    world.applyEdits({TrimShapeEdit{shape}});
    EXPECT_EQ(world.shapes().at(shape).grid.size(), glm::ivec3(38, 15, 19));
    EXPECT_EQ(worldCells(world), before);
}

TEST(ShapeEdits, ResizingRemovesVoxelsAndSplitsTheRest) {
    VoxelGrid grid({30, 10, 10});
    {
        GridWriter writer(grid);
        for (int x = 0; x < 30; ++x) writer.set({x, 0, 0}, 1);
        for (int y = 0; y < 6; ++y) writer.set({4, y, 0}, 1), writer.set({20, y, 0}, 1);
    }
    World world = worldOf(grid, false);
    const ShapeHandle shape = test::firstShape(world);
    world.applyEdits({ResizeShapeEdit{shape, {{0, 1, 0}, {30, 10, 10}}}});
    EXPECT_EQ(world.shapes().size(), 2u);
    EXPECT_EQ(voxelAccounting(world).removed, 30u);
    EXPECT_TRUE(voxelAccounting(world).balances());
}

TEST(ShapeEdits, MergeUndoesASplit) {
    VoxelGrid grid = twoBlocks();
    GridWriter(grid).set({13, 8, 12}, 1);
    World world = worldOf(grid, false);
    const ShapeHandle shape = test::firstShape(world);
    // A second shape on the same body, which touches the first one at x = 14.
    Level level = toLevel(world);
    VoxelGrid peg({9, 3, 3});
    {
        GridWriter writer(peg);
        for (int x = 0; x < 7; ++x) writer.set({x, 1, 1}, 2, 0x25);
    }
    LevelShape second = test::levelShape("peg", peg);
    second.local.position = glm::dvec3(14, 7, 11) * 0.1;
    level.bodies[0].shapes.push_back(second);
    world.load(level);
    const auto before = worldCells(world);
    const BodyHandle body = world.shapes().at(test::firstShape(world)).body;
    const ShapeHandle first = world.bodies().at(body).shapes[0], pegShape = world.bodies().at(body).shapes[1];
    world.applyEdits({MergeShapeEdit{pegShape, {}}});
    EXPECT_EQ(world.shapes().size(), 1u);
    EXPECT_FALSE(world.shapes().find(pegShape));
    EXPECT_EQ(worldCells(world), before);
    EXPECT_TRUE(voxelAccounting(world).balances());
    EXPECT_FALSE(world.shapes().find(shape)) << "its handle is from before the load";
    world.applyEdits({MergeShapeEdit{first, {}}});  // nothing left to merge with: refused
    EXPECT_EQ(worldCells(world), before);
}

TEST(ShapeEdits, InvalidInputIsRefused) {
    World world = worldOf(twoBlocks(), false);
    const ShapeHandle shape = test::firstShape(world);
    const uint64_t hash = voxelHash(world);
    world.applyEdits({ResizeShapeEdit{shape, {{0, 0, 0}, {0, 5, 5}}},
                      ResizeShapeEdit{shape, {{0, 0, 0}, {1 << 30, 5, 5}}},
                      ResizeShapeEdit{shape, {{INT32_MIN, 0, 0}, {INT32_MAX, 5, 5}}}, TrimShapeEdit{{}},
                      SplitShapeEdit{{}}, MergeShapeEdit{shape, shape}});
    EXPECT_EQ(voxelHash(world), hash);
}

TEST(SlicedSplits, ConserveVoxelsAndEndLikeImmediateSplits) {
    const auto run = [](size_t partsPerStep, int* hanging) {
        World world = worldOf(towerGrid({100, 120, 90}, 3, 12), true);
        WorldSettings settings = world.settings();
        settings.split.partsPerStep = partsPerStep;
        world.setSettings(settings);
        world.applyEdits({test::sphereCarve({0.2, 0.2, 0.2}, 0.1)});
        Random random(3);
        const auto count = [&] { return world.shapes().size(); };
        size_t last = count();
        for (int step = 0; step < 200; ++step) {
            Edits edits;
            if (step < 40 && step % 4 == 0)
                for (int i = 0; i < 3; ++i) {
                    const double x = random.unit(), y = random.unit(), z = random.unit();
                    edits.push_back(test::sphereCarve({10.0 * x, 12.0 * y, 9.0 * z}, 1.2));
                    edits.push_back(test::sphereCarve({10.0 * z, 12.0 * x, 9.0 * y}, 1.2));
                }
            const uint64_t before = world.hash();
            world.applyEdits(edits);
            EXPECT_TRUE(voxelAccounting(world).balances());
            EXPECT_NE(world.hash(), before);
            if (hanging && edits.empty() && count() != last) ++*hanging;
            last = count();
        }
        return world;
    };
    int hanging = 0;
    const World immediate = run(0, nullptr), sliced = run(2, &hanging), again = run(2, nullptr);
    EXPECT_GT(hanging, 0) << "some piece came off in a later step than its cut";
    EXPECT_EQ(sliced.hash(), again.hash());
    EXPECT_EQ(voxelAccounting(sliced).removed + voxelAccounting(sliced).standing + voxelAccounting(sliced).inPieces,
              voxelAccounting(immediate).imported);
    sliced.shapes().forEach([&](ShapeHandle, const Shape& shape) {
        if (shape.isPiece) {
            EXPECT_EQ(findComponents(shape.grid).size(), 1u);
        } else {
            EXPECT_TRUE(findDetached(shape.grid, shape.anchors, true).pieces.empty()) << "a loose piece was forgotten";
        }
    });
}

TEST(ShapeEdits, AMergeInsideTheFrameOfTheOtherIsInTheJournal) {
    for (const bool isStatic : {true, false}) {
        World world;
        world.load(frameAndPeg(isStatic));
        WorldSettings settings;
        settings.undoMarks = 5;
        world.setSettings(settings);
        world.applyEdits({});
        const ShapeHandle into = world.shapes().handleAt(0), peg = world.shapes().handleAt(1);
        const auto before = worldCells(world);
        const uint64_t hash = resolvedHash(world);
        WorldBaseline baseline(world);
        FrameChanges changes = world.applyEdits({HistoryEdit{}, MergeShapeEdit{peg, into}});
        EXPECT_EQ(worldCells(world), before);
        EXPECT_EQ(world.shapes().at(into).grid.size(), glm::ivec3(24, 16, 16)) << "not resized";
        EXPECT_EQ(std::count(changes.shapesCreated.begin(), changes.shapesCreated.end(), into), 0)
            << "the cost is that of the peg";
        EXPECT_EQ(changes.bricks.size(), 4u) << "each brick once";
        EXPECT_EQ(changes.carved, std::vector{into});
        EXPECT_EQ(changes.palettes, std::vector{into});
        EXPECT_TRUE(changes.broken.empty()) << "nothing was lost";
        baseline.update(world, changes);
        EXPECT_EQ(resolvedHash(World(world)), resolvedHash(baseline.last()));
        baseline.update(world, world.applyEdits({HistoryEdit{HistoryAction::Undo}}));
        EXPECT_EQ(resolvedHash(world), hash);
        EXPECT_EQ(worldCells(world), before) << "each voxel once";
        EXPECT_EQ(resolvedHash(world), resolvedHash(baseline.last()));
        EXPECT_TRUE(voxelAccounting(world).balances());
    }
}

TEST(ShapeEdits, ALoosePartOfAMergedShapeComesOffWithTheNextCut) {
    for (const bool cutsInTheSameStep : {false, true}) {
        World world;
        world.load(frameAndPeg(true, !cutsInTheSameStep));
        const ShapeHandle into = world.shapes().handleAt(0), peg = world.shapes().handleAt(1);
        world.applyEdits({test::sphereCarve({0.0, 1.6, 0.0}, 0.2)});  // the frame is known to be connected
        CarveEdit crack{
            .kind = BrushKind::Box, .position = {1.2, 0.95, 0.8}, .halfSize = {0.6, 0.05, 0.6}, .shape = peg};
        if (cutsInTheSameStep) {
            world.applyEdits({crack, MergeShapeEdit{peg, into}});
        } else {
            world.applyEdits({MergeShapeEdit{peg, into}});
            world.applyEdits({test::sphereCarve({0.0, 1.6, 1.6}, 0.2)});
        }
        ASSERT_EQ(world.shapes().size(), 2u);
        EXPECT_EQ(world.shapes().at(world.shapes().handleAt(1)).grid.voxelCount(), 8u * 4 * 8);
        EXPECT_TRUE(voxelAccounting(world).balances());
    }
}

TEST(ShapeEdits, AMergedShapeThatWaitsForItsSplitIsStillSplit) {
    World world;
    Level level = frameAndPeg(true, false, 400);
    level.bodies[0].shapes[0].anchors = {{{0, 0, 0}, {1, 16, 16}}};
    world.load(level);
    WorldSettings settings;
    settings.split.partsPerStep = 1;
    world.setSettings(settings);
    const ShapeHandle into = world.shapes().handleAt(0), peg = world.shapes().handleAt(1);
    CarveEdit crack{.kind = BrushKind::Box, .position = {1.2, 0.95, 0.8}, .halfSize = {0.6, 0.05, 0.6}, .shape = peg};
    CarveEdit slit{.kind = BrushKind::Box, .position = {20.0, 0.2, 0.2}, .halfSize = {0.1, 0.4, 2.0}, .shape = into};
    world.applyEdits({test::sphereCarve({0.0, 1.6, 0.0}, 0.2)});
    world.applyEdits({slit, crack});
    ASSERT_EQ(world.data().pendingSplits.size(), 2u);
    world.applyEdits({MergeShapeEdit{peg, into}});
    for (int i = 0; i < 99; ++i) world.applyEdits({});
    ASSERT_EQ(world.shapes().size(), 3u) << "the far half, and the upper part of the peg";
    uint64_t smallest = 1u << 30;
    world.shapes().forEach(
        [&](ShapeHandle, const Shape& shape) { smallest = std::min(smallest, shape.grid.voxelCount()); });
    EXPECT_EQ(smallest, 8u * 4 * 8);
}

TEST(ShapeEdits, AMergeTakesNoEntryThatVoxelsHave) {
    Level level = frameAndPeg(false);
    auto palette = std::make_shared<Palette>(*level.bodies[0].shapes[0].palette);
    for (size_t i = 1; i < 8; ++i) (*palette)[i] = {.red = uint8_t(i), .material = uint8_t(i == 1)};
    level.bodies[0].shapes[0].palette = palette;
    fillBox(level.bodies[0].shapes[0].grid, {{0, 0, 0}, {3, 3, 3}}, 2);  // without a material
    World world;
    world.load(level);
    const ShapeHandle into = world.shapes().handleAt(0);
    world.applyEdits({MergeShapeEdit{world.shapes().handleAt(1), into}});
    const Shape& merged = world.shapes().at(into);
    EXPECT_EQ(merged.grid.at({0, 0, 0}), 2);
    EXPECT_EQ((*merged.palette)[2], (*palette)[2]);
    EXPECT_EQ((*merged.palette)[merged.grid.at({9, 5, 5})].red, 7);
    EXPECT_EQ(merged.moments, gridMoments(merged.grid, *merged.palette, world.materials()));
}

TEST(ShapeEdits, AMergeTakesEntriesThatNoVoxelHasIfAllHaveMaterials) {
    Level level = frameAndPeg(false);
    World world;
    auto full = std::make_shared<Palette>(*materialPalette(world.materials()));
    level.bodies[0].shapes[0].palette = full;
    auto red = std::make_shared<Palette>(*full);
    for (PaletteEntry& entry : *red) entry.red = 7;
    level.bodies[0].shapes[1].palette = red;
    world.load(level);
    const ShapeHandle into = world.shapes().handleAt(0);
    world.applyEdits({MergeShapeEdit{world.shapes().handleAt(1), into}});
    ASSERT_EQ(world.shapes().size(), 1u);
    const Shape& merged = world.shapes().at(into);
    EXPECT_EQ((*merged.palette)[merged.grid.at({9, 5, 5})].red, 7);
    size_t others = 0;
    for (size_t i = 1; i < 256; ++i) others += (*merged.palette)[i] != (*full)[i];
    EXPECT_EQ(others, 1u);
    for (size_t i = 1; i + 1 < world.materials().materials.size(); ++i) EXPECT_EQ((*merged.palette)[i], (*full)[i]);
}

TEST(SlicedSplits, AShapeThatLostAllItsVoxelsDoesNotWait) {
    Level level = test::oneShapeLevel(solidGrid({400, 8, 8}), true);
    level.bodies[0].shapes[0].anchors = {{{0, 0, 0}, {1, 8, 8}}};
    level.bodies.push_back(test::oneShapeLevel(solidGrid({4, 4, 4}), false, {{0.0, 5.0, 0.0}}).bodies[0]);
    World world;
    world.load(level);
    WorldSettings settings;
    settings.split.partsPerStep = 1;
    world.setSettings(settings);
    world.applyEdits({test::sphereCarve({0.5, 0.8, 0.8}, 0.2)});
    const CarveEdit slit{.kind = BrushKind::Box, .position = {20.0, 0.4, 0.4}, .halfSize = {0.2, 1.0, 1.0}};
    const FrameChanges changes = world.applyEdits({slit, test::sphereCarve({0.2, 5.2, 0.2}, 1.0)});
    EXPECT_EQ(world.data().pendingSplits.size(), 1u) << "the slit";
    EXPECT_EQ(world.shapes().size(), 1u);
    EXPECT_EQ(changes.bodiesDestroyed.size(), 1u);
}

}  // namespace
}  // namespace rubble
