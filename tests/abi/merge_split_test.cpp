#include <algorithm>
#include <string>
#include <vector>

#include "runtime/assets/assets.h"
#include "tests/abi/abi_fixture.h"
#include "tests/support/grids.h"
#include "tests/support/temp_folder.h"

namespace rubble {
namespace {

/// Worlds with a body of our own.
class AbiMergeSplit : public Abi {
protected:
    /// Replaces the level by a body of these shapes.
    void load(std::vector<LevelShape> shapes) {
        auto palette = std::make_shared<Palette>();
        (*palette)[1].material = defaultMaterials().find("brick");
        for (LevelShape& shape : shapes) shape.palette = palette;
        Level level;
        level.bodies.push_back({.name = "body", .shapes = std::move(shapes)});
        const TempFolder folder;
        const std::string path = folder / "level.rubble";
        ASSERT_TRUE(writeRubble(path, level));
        ASSERT_EQ(api()->load_level(m_world, path.c_str(), nullptr), RUBBLE_OK) << api()->get_last_error();
        step();
    }
    /// A column of 4 x 8 x 4 voxels, and another one, 4 cells beside it on the same body.
    void loadTwoColumns() {
        load({{.name = "left", .grid = solidGrid({4, 8, 4})},
              {.name = "right", .local = {{0.4, 0.0, 0.0}}, .grid = solidGrid({4, 8, 4})}});
    }
};

TEST_F(AbiMergeSplit, PartsOfAShapeBecomeShapesOfItsBody) {
    load({{.name = "two", .grid = gridOf({12, 4, 4}, [](glm::ivec3 cell) { return cell.x < 5 || cell.x > 7; })}});
    const rubble_shape_state whole = shapes().at(0);
    ASSERT_EQ(api()->split_shape(m_world, whole.shape), RUBBLE_OK) << api()->get_last_error();
    step();
    const std::vector<rubble_shape_state> parts = shapes();
    ASSERT_EQ(parts.size(), 2u);
    EXPECT_EQ(parts[0].voxel_count + parts[1].voxel_count, whole.voxel_count);
    for (const rubble_shape_state& part : parts) EXPECT_EQ(part.body, whole.body);
    auto events = sized<rubble_events>();
    ASSERT_EQ(api()->get_events(m_world, &events), RUBBLE_OK);
    ASSERT_EQ(events.split_count, 1u);
    EXPECT_EQ(events.splits[0].parent, whole.shape);
    EXPECT_EQ(events.splits[0].piece, parts[1].shape);
    EXPECT_EQ(events.splits[0].parent_offset[0], 8) << "the larger part stays";
}

TEST_F(AbiMergeSplit, AShapeIsAddedToTheOneThatItTouches) {
    for (const bool isNamed : {true, false}) {
        loadTwoColumns();
        const std::vector<rubble_shape_state> before = shapes();
        ASSERT_EQ(before.size(), 2u);
        ASSERT_EQ(api()->merge_shape(m_world, before[1].shape, isNamed ? before[0].shape : 0), RUBBLE_OK);
        step();
        const std::vector<rubble_shape_state> after = shapes();
        ASSERT_EQ(after.size(), 1u);
        EXPECT_EQ(after[0].shape, before[0].shape);
        EXPECT_EQ(after[0].voxel_count, 256u);
        EXPECT_EQ(after[0].size[0], 8);
    }
}

TEST_F(AbiMergeSplit, MergeAndSplitAreUndone) {
    loadTwoColumns();
    ASSERT_EQ(api()->set_undo_limit(m_world, 2), RUBBLE_OK);
    step();
    const std::vector<rubble_shape_state> before = shapes();
    uint64_t hashes[2] = {};
    ASSERT_EQ(api()->add_undo_mark(m_world), RUBBLE_OK);
    ASSERT_EQ(api()->merge_shape(m_world, before[1].shape, 0), RUBBLE_OK);
    step();
    ASSERT_EQ(api()->get_state_hash(m_world, &hashes[0]), RUBBLE_OK);
    ASSERT_EQ(api()->undo(m_world), RUBBLE_OK);
    step();
    const std::vector<rubble_shape_state> back = shapes();
    ASSERT_EQ(back.size(), 2u);
    for (size_t i = 0; i < 2; ++i) EXPECT_EQ(back[i].shape, before[i].shape) << "the same handles";
    ASSERT_EQ(api()->get_state_hash(m_world, &hashes[1]), RUBBLE_OK);
    EXPECT_NE(hashes[0], hashes[1]);
}

TEST_F(AbiMergeSplit, ARopeIsFreedFromAShapeAndGoneWhenNothingHoldsIt) {
    loadTwoColumns();
    const rubble_shape shape = shapes().at(0).shape;
    auto rope = sized<rubble_joint_settings>();
    rope.kind = RUBBLE_JOINT_ROPE;
    rope.shapes[0] = shape;
    rope.position[0] = rope.position[2] = 0.2, rope.position[1] = 0.75;
    rope.rope_end[1] = 4.0;
    ASSERT_EQ(api()->add_joint(m_world, &rope), RUBBLE_OK) << api()->get_last_error();
    rope.shapes[1] = shapes().at(1).shape;
    rope.rope_end[0] = 0.6, rope.rope_end[1] = 0.75, rope.rope_end[2] = 0.2;
    ASSERT_EQ(api()->add_joint(m_world, &rope), RUBBLE_OK) << api()->get_last_error();
    step();
    rubble_joint_state joints[2] = {};
    uint32_t count = 0;
    ASSERT_EQ(api()->get_joint_states(m_world, joints, 2, &count), RUBBLE_OK);
    ASSERT_EQ(count, 2u);
    for (const rubble_joint_state& joint : joints)
        ASSERT_EQ(api()->detach_joint(m_world, joint.joint, shape), RUBBLE_OK) << api()->get_last_error();
    step();
    ASSERT_EQ(api()->get_joint_states(m_world, joints, 2, &count), RUBBLE_OK);
    ASSERT_EQ(count, 2u) << "the other ends hold them";
    for (const rubble_joint_state& joint : joints) EXPECT_EQ(joint.shapes[0], 0u);
    ASSERT_EQ(api()->detach_joint(m_world, joints[1].joint, rope.shapes[1]), RUBBLE_OK);
    step();
    ASSERT_EQ(api()->get_joint_states(m_world, joints, 2, &count), RUBBLE_OK);
    EXPECT_EQ(count, 1u) << "nothing holds it";
}

}  // namespace
}  // namespace rubble
