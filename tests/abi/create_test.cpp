#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/abi/create_fixture.h"
#include "tests/support/temp_folder.h"

namespace rubble {
namespace {

TEST_F(AbiCreate, AChainOfCallsNeedsNoWaiting) {
    const rubble_body crate = make(bodyAt(5.0, 20.0, 0));
    const rubble_shape shape = make(shapeOn(crate, RUBBLE_SHAPE_EMPTY, 10));
    const rubble_voxel_box box = wholeOf(shape, 10);
    const std::vector<uint8_t> cells(1000, 3);
    ASSERT_EQ(api()->write_voxels(m_world, &box, cells.data(), cells.size()), RUBBLE_OK) << api()->get_last_error();
    auto change = sized<rubble_body_change>();
    change.body = crate, change.fields = RUBBLE_SET_POSE | RUBBLE_SET_VELOCITY;
    change.position[1] = 30.0, change.velocity[0] = 6.0;
    ASSERT_EQ(api()->set_body(m_world, &change), RUBBLE_OK) << api()->get_last_error();
    rubble_body_state before = {};
    expectRefused(api()->get_body_state(m_world, crate, &before), RUBBLE_ERROR_STALE, "before the next step");
    step();
    EXPECT_TRUE(refusals().empty());
    EXPECT_EQ(state(shape).body, crate);
    EXPECT_EQ(state(shape).voxel_count, 1000u);
    EXPECT_EQ(read(box), cells);
    EXPECT_NEAR(bodyState(crate).position[1], 30.0, 0.01);
    EXPECT_NEAR(bodyState(crate).velocity[0], 6.0, 1e-9);
    auto events = sized<rubble_events>();
    ASSERT_EQ(api()->get_events(m_world, &events), RUBBLE_OK);
    ASSERT_EQ(events.bodies_created_count, 1u);
    EXPECT_EQ(events.bodies_created[0], crate);
    step(20);
    EXPECT_LT(bodyState(crate).position[1], 29.9) << "it is simulated";
}

TEST_F(AbiCreate, TheVelocityIsThatOfTheWholeBody) {
    auto settings = bodyAt(0.0, 50.0, 0);
    settings.velocity[0] = 2.0, settings.angular_velocity[1] = 3.0;
    const rubble_body body = make(settings);
    for (int i = 0; i < 3; ++i) {
        auto shape = shapeOn(body, RUBBLE_SHAPE_BOX, 4);
        shape.position[0] = 1.5 * i;
        make(shape);
    }
    step();
    EXPECT_NEAR(bodyState(body).velocity[0], 2.0, 1e-6);
    EXPECT_NEAR(bodyState(body).velocity[2], 0.0, 1e-6);
    EXPECT_EQ(bodyState(body).shape_count, 3u);
}

TEST_F(AbiCreate, VoxelsComeFromBoxesBallsIndicesRunsAndShapes) {
    const rubble_body body = make(bodyAt(10.0, 0.0, RUBBLE_BODY_STATIC));
    const auto at = [&](double x, uint32_t source, int32_t side) {
        auto out = shapeOn(body, source, side);
        out.position[0] = x;
        return out;
    };
    auto boxed = at(0.0, RUBBLE_SHAPE_BOX, 40);
    boxed.index = 7;
    const rubble_shape box = make(boxed), ball = make(at(5.0, RUBBLE_SHAPE_SPHERE, 21));
    std::vector<uint8_t> cells(1000);
    for (size_t i = 0; i < cells.size(); ++i) cells[i] = uint8_t(i % 7);
    auto dense = at(8.0, RUBBLE_SHAPE_INDICES, 10);
    dense.indices = cells.data(), dense.count = cells.size(), dense.voxel_size = 0.05;
    const rubble_shape raw = make(dense);
    std::vector<rubble_voxel_run> runs;
    for (const uint8_t cell : cells) runs.push_back({1, cell});
    auto packed = at(9.0, RUBBLE_SHAPE_RUNS, 10);
    packed.runs = runs.data(), packed.count = runs.size();
    const rubble_shape run = make(packed);
    auto copied = at(11.0, RUBBLE_SHAPE_COPY, 0);
    copied.copied = raw;
    const rubble_shape copy = make(copied);
    step();
    ASSERT_TRUE(refusals().empty()) << refusals()[0].reason;
    EXPECT_EQ(read(wholeOf(box, 40)), std::vector<uint8_t>(64000, 7));
    EXPECT_EQ(read(wholeOf(raw, 10)), cells);
    EXPECT_EQ(read(wholeOf(run, 10)), cells);
    EXPECT_EQ(read(wholeOf(copy, 10)), cells);
    EXPECT_NEAR(state(copy).voxel_size, 0.05, 1e-6);
    const std::vector<uint8_t> round = read(wholeOf(ball, 21));
    uint64_t solid = 0;
    for (int z = 0; z < 21; ++z)
        for (int y = 0; y < 21; ++y)
            for (int x = 0; x < 21; ++x) {
                const int dx = x - 10, dy = y - 10, dz = z - 10;
                const bool isIn = 4 * (dx * dx + dy * dy + dz * dz) <= 21 * 21;
                ASSERT_EQ(round[size_t((z * 21 + y) * 21 + x)], isIn ? 6 : 0) << x << " " << y << " " << z;
                solid += isIn;
            }
    EXPECT_EQ(state(ball).voxel_count, solid);
}

TEST_F(AbiCreate, RefusalsNameTheArgument) {
    rubble_body body = 9;
    auto settings = bodyAt(0.0, 0.0, 4);
    expectRefused(api()->create_body(m_world, &settings, &body), RUBBLE_ERROR_ARGUMENT, "flags");
    EXPECT_EQ(body, 0u);
    settings.flags = RUBBLE_BODY_STATIC, settings.velocity[1] = 1.0;
    expectRefused(api()->create_body(m_world, &settings, &body), RUBBLE_ERROR_ARGUMENT, "velocity");
    settings.velocity[1] = 0.0, settings.position[2] = 1e10;
    expectRefused(api()->create_body(m_world, &settings, &body), RUBBLE_ERROR_ARGUMENT, "position[2]");
    expectRefused(api()->create_body(m_world, &settings, nullptr), RUBBLE_ERROR_NULL, "out");
    expectRefused(api()->create_body(m_world, nullptr, &body), RUBBLE_ERROR_NULL, "settings");
    const rubble_body table = bodies(m_world)[0].body;
    rubble_shape shape = 0;
    const auto refused = [&](const rubble_shape_settings& wrong, rubble_result code, const char* word) {
        expectRefused(api()->create_shape(m_world, &wrong, &shape), code, word);
    };
    refused(shapeOn(0, RUBBLE_SHAPE_BOX, 1), RUBBLE_ERROR_STALE, "body is 0");
    refused(shapeOn(table, RUBBLE_SHAPE_COPY + 1, 1), RUBBLE_ERROR_ARGUMENT, "source is 6");
    refused(shapeOn(table, RUBBLE_SHAPE_COPY, 1), RUBBLE_ERROR_STALE, "copied is 0");
    refused(shapeOn(table, RUBBLE_SHAPE_EMPTY, 5000), RUBBLE_ERROR_ARGUMENT, "size[0] is 5000");
    refused(shapeOn(table, RUBBLE_SHAPE_BOX, 4096), RUBBLE_ERROR_ARGUMENT, "size[0] * size[1] * size[2]");
    refused(shapeOn(table, RUBBLE_SHAPE_INDICES, 4), RUBBLE_ERROR_NULL, "indices");
    refused(shapeOn(table, RUBBLE_SHAPE_RUNS, 4), RUBBLE_ERROR_NULL, "runs");
    auto wrong = shapeOn(table, RUBBLE_SHAPE_INDICES, 4);
    const uint8_t cells[64] = {};
    wrong.indices = cells, wrong.count = 63;
    refused(wrong, RUBBLE_ERROR_ARGUMENT, "count is 63, expected 64");
    wrong = shapeOn(table, RUBBLE_SHAPE_RUNS, 2);
    const rubble_voxel_run runs[2] = {{8, 1}, {1, 0}};
    wrong.runs = runs, wrong.count = 2;
    refused(wrong, RUBBLE_ERROR_ARGUMENT, "runs[1] ends after 9 cells");
    wrong = shapeOn(table, RUBBLE_SHAPE_BOX, 2);
    wrong.index = 256;
    refused(wrong, RUBBLE_ERROR_ARGUMENT, "index is 256");
    wrong.index = 6, wrong.voxel_size = 1e-9;
    refused(wrong, RUBBLE_ERROR_ARGUMENT, "voxel_size");
    wrong.voxel_size = 0.0, wrong.palette_of = table;
    refused(wrong, RUBBLE_ERROR_STALE, "palette_of");
}

TEST_F(AbiCreate, WhatTheStepCannotMakeIsDeadAndSaysWhy) {
    const rubble_body doomed = make(bodyAt(0.0, 9.0, 0)), empty = make(bodyAt(3.0, 9.0, 0));
    ASSERT_EQ(api()->destroy_body(m_world, doomed), RUBBLE_OK) << api()->get_last_error();
    const rubble_shape late = make(shapeOn(doomed, RUBBLE_SHAPE_BOX, 4));
    const rubble_shape bare = make(shapeOn(empty, RUBBLE_SHAPE_EMPTY, 4));
    step();
    const std::vector<rubble_refusal> rows = refusals();
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0].handle, late);
    EXPECT_EQ(rows[0].reason, std::string("create_shape: the handle of its body is stale"));
    EXPECT_EQ(rows[1].handle, bare);
    EXPECT_NE(std::string(rows[1].reason).find("has no voxels"), std::string::npos) << rows[1].reason;
    for (const uint64_t handle : {doomed, late, bare}) EXPECT_TRUE(isStale(handle));
    EXPECT_EQ(bodyState(empty).shape_count, 0u) << "a body may wait for its shapes";
    const rubble_shape now = make(shapeOn(empty, RUBBLE_SHAPE_BOX, 4));
    EXPECT_NE(now, bare);
    step(30);
    EXPECT_TRUE(refusals().empty());
    EXPECT_LT(bodyState(empty).position[1], 9.0);
}

TEST_F(AbiCreate, ALevelLoadedInBetweenLeavesDeadHandles) {
    const rubble_body waiting = make(bodyAt(0.0, 9.0, 0));
    const rubble_shape shape = make(shapeOn(waiting, RUBBLE_SHAPE_BOX, 4));
    ASSERT_EQ(api()->load_level(m_world, s_level.c_str(), nullptr), RUBBLE_OK);
    step();
    for (int i = 0; i < 5; ++i) {
        const rubble_body other = make(bodyAt(2.0 * i, 20.0, 0));
        make(shapeOn(other, RUBBLE_SHAPE_BOX, 2));
        step();
        EXPECT_NE(other, waiting);
        EXPECT_TRUE(isStale(waiting));
        EXPECT_TRUE(isStale(shape));
    }
}

TEST_F(AbiCreate, UndoInTheSameStepMayTakeThePlace) {
    ASSERT_EQ(api()->set_undo_limit(m_world, 4), RUBBLE_OK);
    step();
    ASSERT_EQ(api()->add_undo_mark(m_world), RUBBLE_OK);
    const rubble_body table = bodies(m_world)[0].body;
    ASSERT_EQ(api()->destroy_body(m_world, table), RUBBLE_OK);
    step();
    const rubble_body made = make(bodyAt(0.0, 9.0, 0));
    const rubble_shape shape = make(shapeOn(made, RUBBLE_SHAPE_BOX, 4));
    EXPECT_EQ(made & 0xffffff, table & 0xffffff) << "this test is about a slot that undo needs";
    ASSERT_EQ(api()->undo(m_world), RUBBLE_OK);
    step();
    ASSERT_EQ(refusals().size(), 2u);
    EXPECT_EQ(refusals()[0].handle, made);
    EXPECT_TRUE(isStale(made));
    EXPECT_TRUE(isStale(shape));
    EXPECT_EQ(bodies(m_world).size(), 1u);
    EXPECT_EQ(bodies(m_world)[0].body, table);
}

TEST_F(AbiCreate, IsUndoneAndRedone) {
    ASSERT_EQ(api()->set_undo_limit(m_world, 4), RUBBLE_OK);
    step();
    ASSERT_EQ(api()->add_undo_mark(m_world), RUBBLE_OK);
    const rubble_body body = make(bodyAt(6.0, 0.0, RUBBLE_BODY_STATIC));
    const rubble_shape shape = make(shapeOn(body, RUBBLE_SHAPE_SPHERE, 9));
    step();
    const rubble_shape_state made = state(shape);
    ASSERT_EQ(api()->undo(m_world), RUBBLE_OK);
    step();
    EXPECT_TRUE(isStale(body));
    EXPECT_TRUE(isStale(shape));
    EXPECT_EQ(shapes().size(), 1u);
    ASSERT_EQ(api()->redo(m_world), RUBBLE_OK);
    step();
    EXPECT_EQ(state(shape).voxel_count, made.voxel_count);
    EXPECT_EQ(bodyState(body).position[0], 6.0);
}

TEST_F(AbiCreate, IsRecordedAndSavedWithWhatWaits) {
    const TempFolder folder;
    const std::string log = folder / "game.rubblelog", save = folder / "game.rubble";
    std::vector<uint8_t> cells(512, 2);
    cells[5] = 0;
    const auto makeSome = [&](double x) {
        const rubble_body body = make(bodyAt(x, 12.0, 0));
        make(shapeOn(body, RUBBLE_SHAPE_SPHERE, 12));
        auto raw = shapeOn(body, RUBBLE_SHAPE_INDICES, 8);
        raw.position[1] = 1.2, raw.indices = cells.data(), raw.count = cells.size();
        return make(raw);
    };
    makeSome(3.0);
    ASSERT_EQ(api()->start_recording(m_world, log.c_str()), RUBBLE_OK) << api()->get_last_error();
    makeSome(5.0);
    const rubble_explosion explosion = tableExplosion();
    ASSERT_EQ(api()->explode(m_world, &explosion), RUBBLE_OK);
    step(2);
    make(shapeOn(make(bodyAt(9.0, 3.0, 0)), RUBBLE_SHAPE_EMPTY, 3));  // is refused
    const rubble_shape late = makeSome(7.0);
    step(5);
    ASSERT_EQ(api()->stop_recording(m_world), RUBBLE_OK);
    const uint64_t end = hash();
    uint64_t steps = 0;
    ASSERT_EQ(api()->play_recording(m_world, log.c_str(), &steps), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(steps, 7u);
    EXPECT_EQ(hash(), end);
    EXPECT_EQ(state(late).voxel_count, 511u);

    const rubble_shape waiting = makeSome(15.0);
    ASSERT_EQ(api()->save_game(m_world, save.c_str()), RUBBLE_OK) << api()->get_last_error();
    const rubble_shape after = makeSome(17.0);
    step(3);
    const uint64_t live = hash();
    EXPECT_EQ(state(waiting).voxel_count, 511u);
    ASSERT_EQ(api()->load_game(m_world, save.c_str()), RUBBLE_OK) << api()->get_last_error();
    uint64_t translated = 0;
    EXPECT_EQ(api()->translate_handle(m_world, waiting, &translated), RUBBLE_OK);
    EXPECT_EQ(translated, waiting);
    EXPECT_EQ(makeSome(17.0), after) << "what waits in the save has its handle";
    step(3);
    EXPECT_EQ(hash(), live);
    EXPECT_EQ(state(waiting).voxel_count, 511u);
}

TEST_F(AbiCreate, AddsToABodyThatMoves) {
    auto settings = bodyAt(0.0, 60.0, 0);
    settings.angular_velocity[1] = 2.0;
    const rubble_body body = make(settings);
    make(shapeOn(body, RUBBLE_SHAPE_BOX, 4));
    step();
    auto arm = shapeOn(body, RUBBLE_SHAPE_BOX, 4);
    arm.position[0] = 2.0;
    make(arm);
    step();
    EXPECT_NEAR(bodyState(body).velocity[2], -2.0, 0.05) << "the centre of mass moves as that point of the body did";
    EXPECT_NEAR(bodyState(body).angular_velocity[1], 2.0, 0.05);
}

TEST_F(AbiCreate, AStaticShapeIsHeldByItsLowestLayerAndBreaks) {
    const rubble_body body = make(bodyAt(10.0, 0.0, RUBBLE_BODY_STATIC));
    make(shapeOn(body, RUBBLE_SHAPE_BOX, 20));
    step();
    auto cut = sized<rubble_carve>();
    cut.brush = RUBBLE_BRUSH_BOX;
    cut.position[0] = 11.0, cut.position[1] = 1.0, cut.position[2] = 1.0;
    cut.half_size[0] = cut.half_size[2] = 2.0, cut.half_size[1] = 0.1;
    ASSERT_EQ(api()->carve(m_world, &cut), RUBBLE_OK);
    step();
    auto events = sized<rubble_events>();
    ASSERT_EQ(api()->get_events(m_world, &events), RUBBLE_OK);
    EXPECT_EQ(events.split_count, 1u) << "the upper part comes off";
    EXPECT_TRUE(bodyState(body).flags & RUBBLE_BODY_STATIC);
}

TEST_F(AbiCreate, TheLowestLayerIsThatWhichIsLowestInTheWorld) {
    const double half = std::sqrt(0.5), root = std::sin(0.125 * std::acos(-1.0));
    struct Case {
        double rotation[4];
        rubble_cell_box anchor;
    };
    // A box of 4 x 20 x 6 cells, turned; at 45 degrees two sides are equal.
    const Case cases[] = {{{0, 0, 0, 1}, {{0, 0, 0}, {4, 1, 6}}},
                          {{0, 0, 1, 0}, {{0, 19, 0}, {4, 1, 6}}},
                          {{0, 0, half, half}, {{0, 0, 0}, {1, 20, 6}}},
                          {{0, 0, -half, half}, {{3, 0, 0}, {1, 20, 6}}},
                          {{-half, 0, 0, half}, {{0, 0, 0}, {4, 20, 1}}},
                          {{half, 0, 0, half}, {{0, 0, 5}, {4, 20, 1}}},
                          {{0, 0, root, std::sqrt(1 - root * root)}, {{0, 0, 0}, {4, 1, 6}}}};
    for (const Case& each : cases) {
        auto fixedBody = bodyAt(10.0, 20.0, RUBBLE_BODY_STATIC), freeBody = bodyAt(30.0, 20.0, 0);
        const auto box = [&](rubble_body body) {
            auto settings = shapeOn(body, RUBBLE_SHAPE_BOX, 4);
            settings.size[1] = 20, settings.size[2] = 6;
            return settings;
        };
        auto ownTurn = box(make(fixedBody));
        std::copy_n(each.rotation, 4, ownTurn.rotation);
        std::copy_n(each.rotation, 4, fixedBody.rotation);
        fixedBody.position[0] = 20.0;
        const rubble_shape onTurned = make(box(make(fixedBody)));
        const rubble_body body = make(freeBody);
        const rubble_shape turned = make(ownTurn), tumbled = make(box(body));
        step();
        auto change = sized<rubble_body_change>();
        change.body = body, change.fields = RUBBLE_SET_STATIC | RUBBLE_SET_POSE;
        std::copy_n(freeBody.position, 3, change.position);
        std::copy_n(each.rotation, 4, change.rotation);
        ASSERT_EQ(api()->set_body(m_world, &change), RUBBLE_OK) << api()->get_last_error();
        step();
        for (const rubble_shape shape : {turned, onTurned, tumbled}) {
            rubble_cell_box anchor = {};
            uint32_t count = 0;
            ASSERT_EQ(api()->get_anchors(m_world, shape, &anchor, 1, &count), RUBBLE_OK) << api()->get_last_error();
            for (int a = 0; a < 3; ++a) {
                EXPECT_EQ(anchor.low[a], each.anchor.low[a]) << each.rotation[2] << ' ' << each.rotation[3];
                EXPECT_EQ(anchor.size[a], each.anchor.size[a]) << each.rotation[2] << ' ' << each.rotation[3];
            }
            ASSERT_EQ(api()->destroy_shape(m_world, shape), RUBBLE_OK);
        }
    }
}

TEST_F(AbiCreate, AnEmptyWorldNeedsNoLevel) {
    auto settings = sized<rubble_world_settings>();
    settings.flags = RUBBLE_WORLD_NO_RENDERER;
    const rubble_world before = m_world;
    ASSERT_EQ(api()->create_world(&settings, &m_world), RUBBLE_OK);
    auto floor = shapeOn(make(bodyAt(-5.0, -0.4, RUBBLE_BODY_STATIC)), RUBBLE_SHAPE_BOX, 100);
    floor.size[1] = 4, floor.position[2] = -5.0;
    make(floor);
    const rubble_body crate = make(bodyAt(0.0, 1.0, 0));
    make(shapeOn(crate, RUBBLE_SHAPE_BOX, 8));
    step(120);
    EXPECT_NEAR(bodyState(crate).position[1], 0.0, 0.02) << "it has come to rest on the floor";
    EXPECT_EQ(api()->destroy_world(m_world), RUBBLE_OK);
    m_world = before;
}

}  // namespace
}  // namespace rubble
