#include <gtest/gtest.h>

#include "tests/runtime/world/worlds.h"

namespace rubble {
namespace {

World paintedWorld(PaintMode mode, size_t undoMarks = 0) {
    World world;
    world.load(test::oneShapeLevel(solidGrid({40, 24, 16}), true));
    WorldSettings settings;
    settings.paint.mode = mode;
    settings.undoMarks = undoMarks;
    world.setSettings(settings);
    return world;
}

PaintEdit spray(int i, PaintMode mode = PaintMode::Default) {
    PaintEdit edit{.position = {0.4 * (i % 9), 0.3 * (i % 7), 1.6},
                   .radius = 0.5,
                   .color = {uint8_t(20 * i), 9, 200},
                   .strength = 90};
    edit.mode = mode;
    edit.seed = uint32_t(i);
    return edit;
}

const Shape& onlyShape(const World& world) {
    return world.shapes().at(test::firstShape(world));
}

TEST(PaintEdit, TheEditCanOverrideThePaintMode) {
    World blend = paintedWorld(PaintMode::Blend), layer = paintedWorld(PaintMode::Layer);
    const PaletteRef entries = onlyShape(blend).palette;
    EXPECT_EQ(blend.applyEdits({spray(1)}).palettes.size(), 1u);
    EXPECT_EQ(layer.applyEdits({spray(1)}).palettes.size(), 1u);
    EXPECT_NE(*onlyShape(blend).palette, *entries);
    EXPECT_FALSE(onlyShape(blend).paintColors);
    EXPECT_EQ(*onlyShape(layer).palette, *entries);
    ASSERT_TRUE(onlyShape(layer).paintColors);
    blend.applyEdits({spray(2, PaintMode::Layer)});
    EXPECT_TRUE(onlyShape(blend).paintColors) << "both at once: one edit says so";
}

TEST(PaintEdit, UndoIsExactInBothModes) {
    for (const PaintMode mode : {PaintMode::Blend, PaintMode::Layer}) {
        World world = paintedWorld(mode, 100);
        std::vector<uint64_t> grids, colors;
        for (int i = 0; i < 30; ++i) {
            grids.push_back(onlyShape(world).grid.contentHash());
            colors.push_back(hashPalette(*onlyShape(world).palette) +
                             (onlyShape(world).paintColors ? onlyShape(world).paintColors->count : 0u));
            world.applyEdits({HistoryEdit{HistoryAction::Mark}, spray(i)});
        }
        for (int i = 29; i >= 0; --i) {
            world.applyEdits({HistoryEdit{HistoryAction::Undo}});
            ASSERT_EQ(onlyShape(world).grid.contentHash(), grids[size_t(i)]) << i;
            ASSERT_EQ(hashPalette(*onlyShape(world).palette) +
                          (onlyShape(world).paintColors ? onlyShape(world).paintColors->count : 0u),
                      colors[size_t(i)]);
        }
        onlyShape(world).grid.forEachBrick([](glm::ivec3, const BrickRef& brick) { EXPECT_EQ(brick->paint, nullptr); });
    }
}

TEST(PaintEdit, CapsulesPaintStrokes) {
    World world = paintedWorld(PaintMode::Layer);
    PaintEdit skid{.position = {0.5, 2.4, 0.3},
                   .radius = 0.15,
                   .color = {15, 15, 15},
                   .strength = 200,
                   .kind = BrushKind::Capsule,
                   .end = {3.5, 2.4, 1.2}};
    const FrameChanges changes = world.applyEdits({skid});
    EXPECT_NEAR(double(changes.paintedVoxels), std::sqrt(30.0 * 30 + 9 * 9) * 3 + 7, 20);
    for (const double x : {0.5, 2.0, 3.4}) {
        const glm::ivec3 cell(int(x * 10), 23, int((0.3 + (x - 0.5) * 0.3) * 10));
        EXPECT_NE(onlyShape(world).grid.brickAt(brickOfCell(cell))->paintAt(voxelIndex(cellInBrick(cell))), 0) << x;
    }
}

/// Soot takes palette entries that the shape no longer uses; fragments of the same explosion may still use them.
TEST(PaintEdit, FragmentsKeepTheirMaterialsWhenTheirPaletteIsFull) {
    Level level = test::oneShapeLevel(VoxelGrid({24, 24, 12}), true);
    level.materials = defaultMaterials();
    LevelShape& shape = level.bodies[0].shapes[0];
    auto palette = std::make_shared<Palette>();
    const std::array materials = {"concrete", "wood", "brick", "dirt", "plaster"};
    for (int i = 1; i < 256; ++i) {
        PaletteEntry& entry = (*palette)[size_t(i)];
        entry.red = uint8_t(i), entry.green = uint8_t(i * 7), entry.blue = uint8_t(i * 13);
        entry.material = defaultMaterials().find(materials[size_t(i) % materials.size()]);
    }
    shape.palette = palette;
    {
        GridWriter writer(shape.grid);
        for (int z = 0; z < 12; ++z)
            for (int y = 0; y < 24; ++y)
                for (int x = 0; x < 24; ++x) writer.set({x, y, z}, uint8_t(1 + (x / 3 + y / 3 * 8 + z / 3 * 64) % 255));
        writer.flush();
    }
    const auto check = [](const World& world) {
        world.shapes().forEach([&](ShapeHandle, const Shape& each) {
            EXPECT_EQ(each.moments, gridMoments(each.grid, *each.palette, world.materials()));
        });
    };
    World world;
    world.load(level);
    check(world);
    const FrameChanges changes = world.applyEdits(
        {ExplodeEdit{.position = {2.4, 1.2, 1.2}, .size = 0.9}, ExplodeEdit{.position = {0.0, 1.2, 1.2}, .size = 0.9}});
    EXPECT_FALSE(changes.splits.empty());
    EXPECT_GT(changes.paintedVoxels, 0u);
    check(world);
}

}  // namespace
}  // namespace rubble
