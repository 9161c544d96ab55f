#include <algorithm>
#include <string>
#include <vector>

#include "tests/abi/abi_fixture.h"
#include "tests/support/temp_folder.h"

namespace rubble {
namespace {

class AbiChanges : public Abi {
protected:
    rubble_body_state body(rubble_body handle) {
        rubble_body_state state = {};
        EXPECT_EQ(api()->get_body_state(m_world, handle, &state), RUBBLE_OK) << api()->get_last_error();
        return state;
    }
    rubble_voxel_accounting accounting() {
        auto out = sized<rubble_voxel_accounting>();
        EXPECT_EQ(api()->get_voxel_accounting(m_world, &out), RUBBLE_OK);
        EXPECT_EQ(out.imported, out.standing + out.in_pieces + out.removed);
        return out;
    }
    /// Knocks the table's top off its leg, and gives the largest piece.
    rubble_body makePiece() {
        const rubble_explosion explosion = tableExplosion();
        EXPECT_EQ(api()->explode(m_world, &explosion), RUBBLE_OK);
        step();
        rubble_body best = 0;
        uint64_t most = 0;
        for (const rubble_shape_state& shape : shapes())
            if (!(body(shape.body).flags & RUBBLE_BODY_STATIC) && shape.voxel_count > most)
                best = shape.body, most = shape.voxel_count;
        EXPECT_NE(best, 0u);
        return best;
    }
    static rubble_body_change change(rubble_body body, uint32_t fields) {
        auto out = sized<rubble_body_change>();
        out.body = body;
        out.fields = fields;
        return out;
    }
    void set(const rubble_body_change& edit) {
        ASSERT_EQ(api()->set_body(m_world, &edit), RUBBLE_OK) << api()->get_last_error();
    }
    /// The voxel that a ray down through the table's top meets.
    rubble_hit hitFrom(double x, double z) {
        const double origin[3] = {x, 30.0, z}, down[3] = {0.0, -1.0, 0.0};
        rubble_hit hit = {};
        EXPECT_EQ(api()->cast_ray(m_world, origin, down, 100.0, &hit), RUBBLE_OK);
        return hit;
    }
    rubble_voxel_box wholeOf(const rubble_shape_state& shape) {
        auto box = sized<rubble_voxel_box>();
        box.shape = shape.shape;
        std::copy_n(shape.size, 3, box.size);
        return box;
    }
    std::vector<uint8_t> read(const rubble_voxel_box& box) {
        std::vector<uint8_t> out(size_t(box.size[0] * box.size[1] * box.size[2]));
        uint64_t count = 0;
        EXPECT_EQ(api()->read_voxels(m_world, &box, out.data(), out.size(), &count), RUBBLE_OK);
        return out;
    }
};

TEST_F(AbiChanges, ABodyIsWhereAndAsFastAsItIsSet) {
    const rubble_body piece = makePiece();
    auto edit = change(piece, RUBBLE_SET_POSE | RUBBLE_SET_VELOCITY);
    edit.position[0] = 7.0, edit.position[1] = 50.0;
    edit.velocity[0] = 3.0;
    set(edit);
    step();
    EXPECT_NEAR(body(piece).velocity[0], 3.0, 0.02);
    EXPECT_NEAR(body(piece).position[0], 7.05, 0.01);
    EXPECT_NEAR(body(piece).position[1], 50.0, 0.01);
    set(change(piece, RUBBLE_SET_ASLEEP));
    step();
    const rubble_body_state asleep = body(piece);
    EXPECT_TRUE(asleep.flags & RUBBLE_BODY_ASLEEP);
    step(20);
    EXPECT_EQ(body(piece).position[1], asleep.position[1]) << "it hangs in the air until something wakes it";
    set(change(piece, RUBBLE_SET_AWAKE));
    step(20);
    EXPECT_LT(body(piece).position[1], asleep.position[1]);
    auto wrong = change(piece, RUBBLE_SET_POSE);
    wrong.position[2] = 1e10;
    expectRefused(api()->set_body(m_world, &wrong), RUBBLE_ERROR_ARGUMENT, "position[2] is 1e+10");
    wrong = change(piece, 0);
    expectRefused(api()->set_body(m_world, &wrong), RUBBLE_ERROR_ARGUMENT, "fields is 0");
    wrong = change(piece, RUBBLE_SET_ASLEEP | RUBBLE_SET_AWAKE);
    expectRefused(api()->set_body(m_world, &wrong), RUBBLE_ERROR_ARGUMENT, "expected one of them");
    wrong = change(0, RUBBLE_SET_POSE);
    expectRefused(api()->set_body(m_world, &wrong), RUBBLE_ERROR_STALE, "body is 0");
}

TEST_F(AbiChanges, AStaticBodyIsMovedAndBearsWhatStandsOnItThere) {
    const rubble_shape_state table = shapes().at(0);
    auto edit = change(table.body, RUBBLE_SET_POSE);
    edit.position[0] = 20.0, edit.position[1] = 5.0;
    set(edit);
    step();
    EXPECT_EQ(hitFrom(0.3, 0.3).hit, 0u) << "where it was";
    const rubble_hit hit = hitFrom(20.3, 0.3);
    EXPECT_EQ(hit.shape, table.shape);
    EXPECT_NEAR(hit.position[1], 6.0, 1e-6);
    step(10);
    EXPECT_EQ(body(table.body).position[1], 5.0);
    edit.fields = RUBBLE_SET_VELOCITY;
    expectRefused(api()->set_body(m_world, &edit), RUBBLE_ERROR_ARGUMENT, "the body is static");
}

TEST_F(AbiChanges, AreTheSameInAWorldThatIsDrawn) {
    auto settings = sized<rubble_world_settings>();
    settings.flags = RUBBLE_WORLD_SHADOW_INLINE;
    const rubble_world undrawn = m_world;
    rubble_world drawn = 0;
    ASSERT_EQ(api()->create_world(&settings, &drawn), RUBBLE_OK);
    std::vector<uint64_t> hashes;
    for (const rubble_world world : {drawn, undrawn}) {
        m_world = world;
        ASSERT_EQ(api()->load_level(world, s_level.c_str(), nullptr), RUBBLE_OK);
        ASSERT_EQ(api()->set_undo_limit(world, 1), RUBBLE_OK);
        step();
        ASSERT_EQ(api()->add_undo_mark(world), RUBBLE_OK);
        const rubble_shape_state table = shapes().at(0);
        auto edit = change(table.body, RUBBLE_SET_POSE);
        edit.position[0] = 3.0;
        set(edit);
        step(2);
        const uint8_t none[4] = {};
        auto corner = sized<rubble_voxel_box>();
        corner.shape = table.shape;
        corner.low[1] = 8, corner.size[0] = corner.size[1] = 2, corner.size[2] = 1;
        ASSERT_EQ(api()->write_voxels(world, &corner, none, 4), RUBBLE_OK);
        set(edit);
        step(2);
        hashes.push_back(hash());
        ASSERT_EQ(api()->undo(world), RUBBLE_OK);
        step(2);
        ASSERT_EQ(api()->destroy_shape(world, table.shape), RUBBLE_OK);
        step(2);
    }
    EXPECT_EQ(hashes[0], hashes[1]);
    EXPECT_EQ(api()->destroy_world(drawn), RUBBLE_OK);
}

TEST_F(AbiChanges, WhatIsDestroyedLeavesNoDust) {
    const rubble_body piece = makePiece();
    const rubble_voxel_accounting before = accounting();
    ASSERT_EQ(api()->destroy_body(m_world, piece), RUBBLE_OK);
    step();
    auto events = sized<rubble_events>();
    ASSERT_EQ(api()->get_events(m_world, &events), RUBBLE_OK);
    EXPECT_EQ(events.dust_cloud_count, 0u);
    EXPECT_EQ(events.bodies_destroyed_count, 1u);
    EXPECT_EQ(api()->destroy_body(m_world, piece), RUBBLE_ERROR_STALE);
    EXPECT_EQ(accounting().removed, before.removed);
    EXPECT_LT(accounting().imported, before.imported);
    for (const rubble_shape_state& shape : shapes())
        ASSERT_EQ(api()->destroy_shape(m_world, shape.shape), RUBBLE_OK) << api()->get_last_error();
    step();
    EXPECT_TRUE(shapes().empty());
    EXPECT_TRUE(bodies(m_world).empty());
    EXPECT_EQ(accounting().imported, before.removed);
}

TEST_F(AbiChanges, WrittenVoxelsAreReadBack) {
    const rubble_shape_state table = shapes().at(0);
    const rubble_voxel_box box = wholeOf(table);
    std::vector<uint8_t> cells = read(box);
    for (size_t i = 0; i < cells.size(); ++i)
        if (i / 17 % 10 >= 8) cells[i] = uint8_t(i % 3 == 0 ? 2 : 1);  // the top, which stays in one part
    ASSERT_EQ(api()->write_voxels(m_world, &box, cells.data(), cells.size()), RUBBLE_OK) << api()->get_last_error();
    step();
    EXPECT_EQ(read(box), cells);
    EXPECT_EQ(accounting().imported, 650u);
    const uint8_t none[4] = {};
    auto corner = sized<rubble_voxel_box>();
    corner.shape = table.shape;
    corner.low[1] = 8, corner.size[0] = corner.size[1] = 2, corner.size[2] = 1;
    ASSERT_EQ(api()->write_voxels(m_world, &corner, none, 4), RUBBLE_OK) << api()->get_last_error();
    step();
    EXPECT_EQ(shapes().at(0).voxel_count, 646u);
    EXPECT_EQ(accounting().imported, 646u);
    expectRefused(api()->write_voxels(m_world, &corner, none, 3), RUBBLE_ERROR_ARGUMENT, "size is 3, expected 4");
    corner.low[0] = 16;
    expectRefused(api()->write_voxels(m_world, &corner, none, 4), RUBBLE_ERROR_ARGUMENT, "cells 16 to 17 of axis 0");
    corner.low[0] = 0, corner.what = RUBBLE_VOXEL_PAINT;
    expectRefused(api()->write_voxels(m_world, &corner, none, 4), RUBBLE_ERROR_ARGUMENT, "box->what is 1");
}

TEST_F(AbiChanges, AMaskWritesTheCellsThatItNames) {
    const rubble_shape_state table = shapes().at(0);
    rubble_voxel_box box = wholeOf(table);
    std::vector<uint8_t> cells = read(box), mask(cells.size());
    const size_t drawn = 9 * 17 + 16, hole = 9 * 17 + 1;  // of the top, at z 0
    cells[drawn] = 2, mask[drawn] = 1;
    auto carve = sized<rubble_carve>();
    carve.brush = RUBBLE_BRUSH_BOX, carve.shape = table.shape;
    const double corner[3] = {0.15, 0.95, 0.05};  // the cell of the hole
    for (int a = 0; a < 3; ++a) carve.position[a] = corner[a], carve.half_size[a] = 0.04;
    carve.rotation[3] = 1.0;
    ASSERT_EQ(api()->carve(m_world, &carve), RUBBLE_OK) << api()->get_last_error();
    box.mask = mask.data();
    ASSERT_EQ(api()->write_voxels(m_world, &box, cells.data(), cells.size()), RUBBLE_OK) << api()->get_last_error();
    std::fill(mask.begin(), mask.end(), uint8_t(1));  // copied by the call
    step();
    const std::vector<uint8_t> after = read(box);
    EXPECT_EQ(after[drawn], 2);
    EXPECT_EQ(after[hole], 0) << "the carve of the same step stays";
    EXPECT_EQ(accounting().removed, 1u);
    cells[hole] = 0;
    EXPECT_EQ(after, cells);
}

TEST_F(AbiChanges, WrittenVoxelsThatTouchNothingComeOff) {
    const rubble_shape_state table = shapes().at(0);
    auto box = sized<rubble_voxel_box>();
    box.shape = table.shape;
    box.size[0] = box.size[1] = box.size[2] = 4;  // beside the leg, below the top
    const std::vector<uint8_t> cube(64, 1);
    ASSERT_EQ(api()->write_voxels(m_world, &box, cube.data(), cube.size()), RUBBLE_OK) << api()->get_last_error();
    box.low[1] = 5, box.size[1] = 1;
    ASSERT_EQ(api()->write_voxels(m_world, &box, cube.data(), 16), RUBBLE_OK) << api()->get_last_error();
    step();
    const std::vector<rubble_shape_state> after = shapes();
    ASSERT_EQ(after.size(), 2u) << "the cube stands on the ground, where the table is held";
    EXPECT_EQ(after[0].voxel_count, 650u + 64u);
    EXPECT_EQ(after[1].voxel_count, 16u);
    EXPECT_EQ(accounting().imported, 650u + 64u + 16u);
}

TEST_F(AbiChanges, AreRecordedAndUndone) {
    const TempFolder folder;
    const std::string log = folder / "game.rubblelog";
    ASSERT_EQ(api()->set_undo_limit(m_world, 2), RUBBLE_OK);
    const rubble_body piece = makePiece();
    ASSERT_EQ(api()->start_recording(m_world, log.c_str()), RUBBLE_OK);
    ASSERT_EQ(api()->add_undo_mark(m_world), RUBBLE_OK);
    const rubble_shape_state table = shapes().at(0);
    const size_t before = shapes().size();
    auto edit = change(piece, RUBBLE_SET_POSE | RUBBLE_SET_ASLEEP);
    edit.position[1] = 12.0;
    set(edit);
    edit = change(table.body, RUBBLE_SET_POSE);
    edit.position[2] = -4.0;
    set(edit);
    const rubble_voxel_box box = wholeOf(table);
    std::vector<uint8_t> cells = read(box);
    cells[0] = 1;
    ASSERT_EQ(api()->write_voxels(m_world, &box, cells.data(), cells.size()), RUBBLE_OK);
    step(3);
    ASSERT_EQ(api()->destroy_body(m_world, piece), RUBBLE_OK);
    step(3);
    const uint64_t end = hash();
    ASSERT_EQ(api()->stop_recording(m_world), RUBBLE_OK);
    ASSERT_EQ(api()->undo(m_world), RUBBLE_OK);
    step();
    EXPECT_EQ(shapes().size(), before);
    EXPECT_EQ(body(table.body).position[2], 0.0);
    const double beside[3] = {-5.0, 0.2, 0.85}, along[3] = {1.0, 0.0, 0.0};
    rubble_hit leg = {};
    ASSERT_EQ(api()->cast_ray(m_world, beside, along, 10.0, &leg), RUBBLE_OK);
    EXPECT_EQ(leg.shape, table.shape) << "the table is back";
    uint64_t steps = 0;
    ASSERT_EQ(api()->play_recording(m_world, log.c_str(), &steps), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(steps, 6u);
    EXPECT_EQ(hash(), end);
}

}  // namespace
}  // namespace rubble
