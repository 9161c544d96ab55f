#include <gtest/gtest.h>

#include <map>

#include "runtime/assets/rubble_file.h"
#include "tests/runtime/world/worlds.h"

namespace rubble {
namespace {

/// Palette index, paint steps and paint colour of every voxel, by the position of its centre in tenths of a millimetre.
std::map<std::array<int64_t, 3>, std::array<int, 4>> voxelLooks(const World& world) {
    std::map<std::array<int64_t, 3>, std::array<int, 4>> out;
    world.shapes().forEach([&](ShapeHandle handle, const Shape& shape) {
        const Pose pose = shapeToWorld(world, handle);
        shape.grid.forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
            forEachVoxel(brick->occupancy, [&](int i) {
                const glm::dvec3 cell = glm::dvec3(position * kBrickSize + voxelInBrick(i)) + 0.5;
                const glm::dvec3 at = glm::round(pose.transformPoint(cell * double(shape.voxelSize)) * 1e4);
                const uint8_t paint = brick->paintAt(i);
                const Srgb color = paint ? shape.paintColors->colors[size_t(paintColor(paint) - 1)] : Srgb{};
                out[{int64_t(at.x), int64_t(at.y), int64_t(at.z)}] = {brick->at(i) | paintSteps(paint) << 8, color[0],
                                                                      color[1], color[2]};
            });
        });
    });
    return out;
}

TEST(PaintedPiece, KeepsItsPaintThroughSplitSaveAndLoad) {
    VoxelGrid grid({60, 20, 12});
    {
        GridWriter writer(grid);
        for (int i = 0; i < 60 * 20 * 12; ++i) writer.set({i % 60, i / 60 % 20, i / 60 / 20}, uint8_t(1 + i % 3));
    }
    const Pose turned{{3.0, 1.0, -2.0}, glm::angleAxis(0.7, glm::normalize(glm::dvec3(1, 2, 0.5)))};
    World world;
    world.load(test::oneShapeLevel(std::move(grid), false, turned));
    const auto at = [&](double x, double y, double z) { return turned.transformPoint({x, y, z}); };
    Edits paints;
    for (int i = 0; i < 20; ++i)
        paints.push_back(PaintEdit{.position = at(0.3 * i, 0.2 + 0.07 * i, 1.2),
                                   .radius = 0.8,
                                   .color = {uint8_t(12 * i), 40, uint8_t(250 - 9 * i)},
                                   .strength = uint8_t(30 + 11 * i),
                                   .probability = 90,
                                   .seed = uint32_t(i),
                                   .falloff = 70,
                                   .mode = PaintMode::Layer});
    const FrameChanges painted = world.applyEdits(paints);
    EXPECT_GT(painted.paintedVoxels, 500u);
    EXPECT_EQ(painted.paintMerges, 5u) << "a shape has 15 colours of paint: five of twenty are merged";
    const auto before = voxelLooks(world);

    const FrameChanges cut = world.applyEdits({CarveEdit{
        .kind = BrushKind::Box, .position = at(3.0, 1.0, 0.6), .halfSize = {0.15, 5, 5}, .rotation = turned.rotation}});
    ASSERT_EQ(cut.splits.size(), 1u);
    const auto after = voxelLooks(world);
    EXPECT_GT(after.size(), before.size() * 9 / 10);
    for (const auto& [position, look] : after) ASSERT_EQ(before.at(position), look) << "a piece keeps its paint";

    const std::vector<uint8_t> bytes = levelToRubble(toLevel(world));
    const Result<Level> back = levelFromRubble(bytes, "painted.rubble");
    ASSERT_TRUE(back) << back.error();
    World loaded;
    loaded.load(*back);
    EXPECT_EQ(voxelLooks(loaded), after);
}

}  // namespace
}  // namespace rubble
