#include <gtest/gtest.h>

#include "tests/runtime/world/worlds.h"
#include "tests/support/grids.h"

namespace rubble {
namespace {

/// The edit that makes a shape under a handle that is reserved for it.
Edit makes(ShapeHandle handle, CreateShapeEdit edit) {
    Edit out{std::move(edit)};
    out.made = AnyHandle{handle.bits};
    return out;
}

TEST(CreateEdits, AShapeThatIsFilledAndBrokenInOneStepLeavesItsPieces) {
    World world;
    world.load(test::oneShapeLevel(solidGrid({8, 8, 8}), true));
    world.applyEdits({});
    const ShapeHandle wall = world.shapes().handleAt(0), made = reserveHandle(world, &WorldObjects::shapes);
    CreateShapeEdit create{.body = world.shapes().at(wall).body, .paletteOf = wall};
    create.shape.grid = VoxelGrid({24, 24, 24});
    create.shape.local.position = {5.0, 0.0, 0.0};
    const WriteVoxelsEdit fill{made, {glm::ivec3(0), glm::ivec3(24)}, std::vector<uint8_t>(24 * 24 * 24, 2)};
    const BreakEdit all{.position = {6.2, 1.2, 1.2}, .radii = {2.5, 2.5, 2.5}, .tool = Tool::Explosive, .shape = made};
    const FrameChanges changes = world.applyEdits({makes(made, create), fill, all});
    EXPECT_TRUE(changes.refused.empty()) << "it had voxels";
    EXPECT_FALSE(world.shapes().find(made)) << "it has none any more";
    EXPECT_GT(world.shapes().size(), 1u) << "pieces";
    EXPECT_TRUE(voxelAccounting(world).balances());
}

TEST(CreateEdits, PaintWithoutAColourIsNone) {
    World world;
    world.load(test::oneShapeLevel(solidGrid({8, 8, 8}), true));
    world.applyEdits({});
    CreateShapeEdit create{.body = world.bodies().handleAt(0), .source = ShapeSource::Box, .size = glm::ivec3(4)};
    create.shape.paintColors = std::make_shared<PaintColors>();
    const FrameChanges changes = world.applyEdits({create});
    ASSERT_EQ(changes.shapesCreated.size(), 1u);
    EXPECT_FALSE(world.shapes().at(changes.shapesCreated[0]).paintColors) << "as in a save of it";
}

}  // namespace
}  // namespace rubble
