#include <gtest/gtest.h>
#include <rubble/rubble.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "tests/abi/test_level.h"
#include "tests/support/temp_folder.h"

namespace rubble {
namespace {

const rubble_api* api() {
    static const rubble_api* table = [] {
        const rubble_api* found = nullptr;
        EXPECT_EQ(rubble_get_api(RUBBLE_VERSION, &found), RUBBLE_OK);
        return found;
    }();
    return table;
}

template <class T>
T sized() {
    T value = {};
    value.struct_size = sizeof(T);
    return value;
}

/// A world with the test level in it, one step old, and no renderer.
class Abi : public testing::Test {
protected:
    static void SetUpTestSuite() { s_level = writeTestLevel(); }
    static void TearDownTestSuite() { std::filesystem::remove(s_level); }
    void SetUp() override { m_world = makeWorld(); }
    void TearDown() override { api()->world_destroy(m_world); }

    static rubble_world makeWorld() {
        auto settings = sized<rubble_world_settings>();
        settings.flags = RUBBLE_WORLD_NO_RENDERER;
        rubble_world world = 0;
        EXPECT_EQ(api()->world_create(&settings, &world), RUBBLE_OK) << api()->last_error();
        EXPECT_EQ(api()->load_level(world, s_level.c_str(), nullptr), RUBBLE_OK) << api()->last_error();
        EXPECT_EQ(api()->step(world), RUBBLE_OK);
        return world;
    }
    /// Hits the middle of the table's top, so that its leg no longer holds it.
    static rubble_explosion blow() {
        auto explosion = sized<rubble_explosion>();
        explosion.position[0] = explosion.position[2] = 0.85;
        explosion.position[1] = 0.95;
        explosion.size = 0.5;
        return explosion;
    }
    static std::vector<rubble_body_state> bodies(rubble_world world) {
        uint32_t count = 0;
        EXPECT_EQ(api()->body_states(world, nullptr, 0, &count), RUBBLE_OK);
        std::vector<rubble_body_state> states(count);
        EXPECT_EQ(api()->body_states(world, states.data(), count, &count), RUBBLE_OK);
        return states;
    }
    /// The last call was refused with this code, and the reason names `word`.
    static void expectRefused(rubble_result result, rubble_result code, const std::string& word) {
        EXPECT_EQ(result, code) << api()->last_error();
        EXPECT_NE(std::string(api()->last_error()).find(word), std::string::npos) << api()->last_error();
    }

    static inline std::string s_level;
    rubble_world m_world = 0;
};

TEST_F(Abi, AWorldBreaksAndTellsOfIt) {
    const rubble_explosion explosion = blow();
    ASSERT_EQ(api()->explode(m_world, &explosion), RUBBLE_OK) << api()->last_error();
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    auto events = sized<rubble_events>();
    ASSERT_EQ(api()->events(m_world, &events), RUBBLE_OK);
    EXPECT_EQ(events.step, 2u);
    ASSERT_EQ(events.removed_count, 1u);
    EXPECT_EQ(events.removed[0].color[0], 200);
    ASSERT_GE(events.split_count, 1u);
    ASSERT_GE(events.bodies_created_count, 1u);

    auto ledger = sized<rubble_ledger>();
    ASSERT_EQ(api()->ledger(m_world, &ledger), RUBBLE_OK);
    EXPECT_EQ(ledger.imported, 650u);
    EXPECT_EQ(ledger.removed, events.removed[0].count);
    EXPECT_GT(ledger.in_pieces, 0u);
    EXPECT_EQ(ledger.imported, ledger.standing + ledger.in_pieces + ledger.removed);

    const rubble_body piece = events.bodies_created[0];
    rubble_body_state before = {}, after = {};
    ASSERT_EQ(api()->body_state(m_world, piece, &before), RUBBLE_OK);
    for (int i = 0; i < 10; ++i) ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    ASSERT_EQ(api()->body_state(m_world, piece, &after), RUBBLE_OK);
    EXPECT_NE(before.position[1], after.position[1]) << "the piece does not move";

    uint32_t count = 0;
    ASSERT_EQ(api()->shape_states(m_world, piece, nullptr, 0, &count), RUBBLE_OK);
    EXPECT_EQ(count, after.shape_count);
}

TEST_F(Abi, JointsAreMadeReadAndRemoved) {
    auto table = sized<rubble_joint_settings>();
    table.kind = RUBBLE_JOINT_ROPE;
    const rubble_body body = bodies(m_world).at(0).body;
    std::array<rubble_shape_state, 1> shape{};
    uint32_t count = 0;
    ASSERT_EQ(api()->shape_states(m_world, body, shape.data(), 1, &count), RUBBLE_OK);
    table.shapes[0] = shape[0].shape;
    table.position[0] = table.position[1] = table.position[2] = 0.85;
    table.rope_end[1] = 4.0;
    ASSERT_EQ(api()->add_joint(m_world, &table), RUBBLE_OK) << api()->last_error();
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    std::array<rubble_joint_state, 2> joints{};
    ASSERT_EQ(api()->joint_states(m_world, joints.data(), 2, &count), RUBBLE_OK);
    ASSERT_EQ(count, 1u);
    EXPECT_EQ(joints[0].shapes[0], shape[0].shape);
    ASSERT_GE(joints[0].rope_points, 3u);
    std::vector<double> points(3 * joints[0].rope_points);
    ASSERT_EQ(api()->rope_points(m_world, joints[0].joint, points.data(), uint32_t(points.size()), &count), RUBBLE_OK);
    EXPECT_EQ(count, points.size());
    EXPECT_NEAR(points[1], 0.85, 1e-6);
    auto motor = sized<rubble_joint_motor>();
    motor.joint = joints[0].joint;
    motor.motor = 3;
    EXPECT_EQ(api()->set_joint_motor(m_world, &motor), RUBBLE_ERROR_ARGUMENT);
    motor.motor = RUBBLE_MOTOR_SPEED;
    EXPECT_EQ(api()->set_joint_motor(m_world, &motor), RUBBLE_OK);
    auto grab = sized<rubble_grab>();
    EXPECT_EQ(api()->grab(m_world, &grab), RUBBLE_ERROR_STALE);
    auto release = sized<rubble_release>();
    EXPECT_EQ(api()->release(m_world, &release), RUBBLE_OK);
    ASSERT_EQ(api()->remove_joint(m_world, joints[0].joint), RUBBLE_OK);
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    EXPECT_EQ(api()->remove_joint(m_world, joints[0].joint), RUBBLE_ERROR_STALE);
    table.kind = 7;
    EXPECT_EQ(api()->add_joint(m_world, &table), RUBBLE_ERROR_ARGUMENT);
}

TEST_F(Abi, WheelsAreDriven) {
    const auto addWheel = [](rubble_world world, double steerAngle) {
        rubble_shape_state shape{};
        uint32_t count = 0;
        EXPECT_EQ(api()->shape_states(world, bodies(world).at(0).body, &shape, 1, &count), RUBBLE_OK);
        auto wheel = sized<rubble_joint_settings>();
        wheel.kind = RUBBLE_JOINT_WHEEL;
        wheel.shapes[0] = shape.shape;
        wheel.position[0] = wheel.position[1] = wheel.position[2] = 0.85;
        wheel.drive_torque = 1000.0;
        wheel.steer_angle = steerAngle;
        return api()->add_joint(world, &wheel);
    };
    const auto hashOf = [](rubble_world world) {
        uint64_t value = 0;
        EXPECT_EQ(api()->state_hash(world, &value), RUBBLE_OK);
        return value;
    };
    const auto stepBoth = [&](rubble_world other) {
        for (const rubble_world world : {m_world, other}) EXPECT_EQ(api()->step(world), RUBBLE_OK);
    };
    const rubble_world idle = makeWorld();  // the same, but for the drive
    EXPECT_EQ(addWheel(m_world, -1.0), RUBBLE_ERROR_ARGUMENT) << "either way is as far";
    for (const rubble_world world : {m_world, idle}) ASSERT_EQ(addWheel(world, 0.5), RUBBLE_OK) << api()->last_error();
    stepBoth(idle);
    EXPECT_EQ(hashOf(m_world), hashOf(idle));
    auto drive = sized<rubble_drive>();
    EXPECT_EQ(api()->drive(m_world, &drive), RUBBLE_ERROR_STALE);
    drive.body = bodies(m_world).at(0).body;
    drive.throttle = 1.5;
    EXPECT_EQ(api()->drive(m_world, &drive), RUBBLE_ERROR_ARGUMENT);
    drive.throttle = 0.5;
    ASSERT_EQ(api()->drive(m_world, &drive), RUBBLE_OK) << api()->last_error();
    stepBoth(idle);
    EXPECT_NE(hashOf(m_world), hashOf(idle));
    EXPECT_EQ(api()->world_destroy(idle), RUBBLE_OK);
}

TEST_F(Abi, BreaksArriveAndEveryLostVoxelIsDust) {
    auto edit = sized<rubble_break>();
    edit.position[0] = 0.3, edit.position[1] = 0.9, edit.position[2] = 0.3;
    edit.radii[0] = edit.radii[1] = 0.6;
    edit.tool = RUBBLE_TOOL_SLEDGE;
    auto events = sized<rubble_events>();
    ASSERT_EQ(api()->break_voxels(m_world, &edit), RUBBLE_OK);
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    ASSERT_EQ(api()->events(m_world, &events), RUBBLE_OK);
    EXPECT_EQ(events.bodies_broken_count, 0u) << "a sledge does not break bricks";
    edit.tool = RUBBLE_TOOL_GUN;
    ASSERT_EQ(api()->break_voxels(m_world, &edit), RUBBLE_OK);
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    ASSERT_EQ(api()->events(m_world, &events), RUBBLE_OK);
    EXPECT_GT(events.split_count, 1u);
    EXPECT_EQ(events.bodies_broken_count, 1u);
    uint64_t dust = 0;
    for (uint32_t i = 0; i < events.dust_count; ++i) dust += events.dust[i].count;
    auto ledger = sized<rubble_ledger>();
    ASSERT_EQ(api()->ledger(m_world, &ledger), RUBBLE_OK);
    EXPECT_EQ(dust, ledger.removed);
    edit.tool = 5;
    EXPECT_EQ(api()->break_voxels(m_world, &edit), RUBBLE_ERROR_ARGUMENT);
}

TEST_F(Abi, EqualCommandsGiveEqualWorlds) {
    const rubble_world other = makeWorld();
    uint64_t hash = 0, otherHash = 1;
    for (int step = 0; step < 30; ++step) {
        const rubble_explosion explosion = blow();
        for (const rubble_world world : {m_world, other}) {
            if (step == 3) {
                ASSERT_EQ(api()->explode(world, &explosion), RUBBLE_OK);
            }
            ASSERT_EQ(api()->step(world), RUBBLE_OK);
        }
        ASSERT_EQ(api()->state_hash(m_world, &hash), RUBBLE_OK);
        ASSERT_EQ(api()->state_hash(other, &otherHash), RUBBLE_OK);
        ASSERT_EQ(hash, otherHash) << "at step " << step;
    }
    EXPECT_EQ(api()->world_destroy(other), RUBBLE_OK);
}

TEST_F(Abi, EveryKindOfEditArrives) {
    auto carve = sized<rubble_carve>();
    carve.brush = RUBBLE_BRUSH_BOX;
    carve.position[1] = 0.95;  // a corner of the table's top
    for (double& half : carve.half_size) half = 0.11;
    auto paint = sized<rubble_paint>();
    paint.position[0] = paint.position[1] = 0.95;
    paint.color[2] = 255;
    ASSERT_EQ(api()->carve(m_world, &carve), RUBBLE_OK) << api()->last_error();
    ASSERT_EQ(api()->paint(m_world, &paint), RUBBLE_OK) << api()->last_error();
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    auto events = sized<rubble_events>();
    ASSERT_EQ(api()->events(m_world, &events), RUBBLE_OK);
    EXPECT_EQ(events.removed_count, 1u);
    EXPECT_GT(events.painted_voxels, 0u);

    const double origin[3] = {0.25, 5.0, 0.25}, down[3] = {0.0, -2.0, 0.0};
    auto hit = sized<rubble_hit>();
    ASSERT_EQ(api()->raycast(m_world, origin, down, 10.0, &hit), RUBBLE_OK);
    ASSERT_EQ(hit.hit, 1u);
    EXPECT_NEAR(hit.distance, 4.0, 1e-6);
    EXPECT_EQ(hit.cell[1], 9);
    EXPECT_NEAR(hit.normal[1], 1.0, 1e-6);

    const rubble_explosion explosion = blow();
    ASSERT_EQ(api()->explode(m_world, &explosion), RUBBLE_OK);
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    ASSERT_EQ(api()->events(m_world, &events), RUBBLE_OK);
    ASSERT_GE(events.bodies_created_count, 1u);
    auto impulse = sized<rubble_impulse>();
    impulse.body = events.bodies_created[0];
    impulse.impulse[1] = 1000.0;
    rubble_body_state state = {};
    ASSERT_EQ(api()->body_state(m_world, impulse.body, &state), RUBBLE_OK);
    std::copy_n(state.position, 3, impulse.position);
    const std::array<double, 3> before = {state.velocity[0], state.velocity[1], state.velocity[2]};
    ASSERT_EQ(api()->push(m_world, &impulse), RUBBLE_OK) << api()->last_error();
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    ASSERT_EQ(api()->body_state(m_world, impulse.body, &state), RUBBLE_OK);
    double change = 0.0;  // it may be caught between others: not where it is pushed to
    for (size_t i = 0; i < 3; ++i) change += std::abs(state.velocity[i] - before[i]);
    EXPECT_GT(change, 1.0);
}

TEST_F(Abi, WrongVersionsAreRefused) {
    const rubble_api* table = api();
    testing::internal::CaptureStderr();
    EXPECT_EQ(rubble_get_api(RUBBLE_VERSION + 1, &table), RUBBLE_ERROR_VERSION);
    EXPECT_NE(testing::internal::GetCapturedStderr().find("version 2 asked for"), std::string::npos);
    EXPECT_EQ(table, nullptr);
    EXPECT_EQ(rubble_get_api(RUBBLE_VERSION, nullptr), RUBBLE_ERROR_NULL);
    EXPECT_EQ(api()->struct_size, sizeof(rubble_api));
    EXPECT_EQ(api()->version, RUBBLE_VERSION);
}

TEST_F(Abi, NullPointersAreRefused) {
    const double axis[3] = {1, 0, 0};
    auto hit = sized<rubble_hit>();
    rubble_renderer renderer = 1;
    expectRefused(api()->world_create(nullptr, nullptr), RUBBLE_ERROR_NULL, "out");
    expectRefused(api()->load_level(m_world, nullptr, nullptr), RUBBLE_ERROR_NULL, "path");
    expectRefused(api()->carve(m_world, nullptr), RUBBLE_ERROR_NULL, "carve");
    expectRefused(api()->explode(m_world, nullptr), RUBBLE_ERROR_NULL, "explode");
    expectRefused(api()->paint(m_world, nullptr), RUBBLE_ERROR_NULL, "paint");
    expectRefused(api()->push(m_world, nullptr), RUBBLE_ERROR_NULL, "push");
    expectRefused(api()->events(m_world, nullptr), RUBBLE_ERROR_NULL, "out");
    expectRefused(api()->body_states(m_world, nullptr, 0, nullptr), RUBBLE_ERROR_NULL, "count");
    uint32_t count = 0;
    expectRefused(api()->body_states(m_world, nullptr, 5, &count), RUBBLE_ERROR_NULL, "out");
    expectRefused(api()->body_state(m_world, bodies(m_world)[0].body, nullptr), RUBBLE_ERROR_NULL, "out");
    expectRefused(api()->shape_states(m_world, 0, nullptr, 5, &count), RUBBLE_ERROR_NULL, "out");
    expectRefused(api()->raycast(m_world, nullptr, axis, 1, &hit), RUBBLE_ERROR_NULL, "origin");
    expectRefused(api()->raycast(m_world, axis, nullptr, 1, &hit), RUBBLE_ERROR_NULL, "direction");
    expectRefused(api()->raycast(m_world, axis, axis, 1, nullptr), RUBBLE_ERROR_NULL, "out");
    expectRefused(api()->state_hash(m_world, nullptr), RUBBLE_ERROR_NULL, "out");
    expectRefused(api()->ledger(m_world, nullptr), RUBBLE_ERROR_NULL, "out");
    expectRefused(api()->figures(m_world, nullptr), RUBBLE_ERROR_NULL, "out");
    expectRefused(api()->renderer_create(m_world, nullptr, &renderer), RUBBLE_ERROR_NULL, "settings");
    EXPECT_EQ(renderer, 0u);
}

TEST_F(Abi, WrongStructSizesAreRefused) {
    auto explosion = blow();
    for (const uint32_t size : {0u, 4u, uint32_t(sizeof explosion) - 1, 1u << 30}) {
        explosion.struct_size = size;
        expectRefused(api()->explode(m_world, &explosion), RUBBLE_ERROR_STRUCT_SIZE, "struct_size");
    }
    auto ledger = sized<rubble_ledger>();
    ledger.struct_size = 8;
    expectRefused(api()->ledger(m_world, &ledger), RUBBLE_ERROR_STRUCT_SIZE, "struct_size");
}

TEST_F(Abi, ANewerHostMayGrowAStructAsLongAsItAsksForNothingNew) {
    struct Grown {
        rubble_explosion known;
        uint64_t added;
    } grown = {blow(), 0};
    grown.known.struct_size = sizeof grown;
    EXPECT_EQ(api()->explode(m_world, &grown.known), RUBBLE_OK) << api()->last_error();
    grown.added = 1;
    expectRefused(api()->explode(m_world, &grown.known), RUBBLE_ERROR_STRUCT_SIZE, "does not know");
}

TEST_F(Abi, StaleHandlesAreReported) {
    const rubble_world gone = makeWorld();
    const rubble_body itsBody = bodies(gone)[0].body;
    rubble_body_state state = {};
    expectRefused(api()->body_state(m_world, itsBody, &state), RUBBLE_ERROR_STALE, "body");  // of another world
    EXPECT_EQ(api()->world_destroy(gone), RUBBLE_OK);
    expectRefused(api()->world_destroy(gone), RUBBLE_ERROR_STALE, "world");
    expectRefused(api()->step(gone), RUBBLE_ERROR_STALE, "world");
    expectRefused(api()->step(0), RUBBLE_ERROR_STALE, "world");
    expectRefused(api()->step(~0ull), RUBBLE_ERROR_STALE, "world");
    expectRefused(api()->step(itsBody), RUBBLE_ERROR_STALE, "type");
    expectRefused(api()->body_state(m_world, m_world, &state), RUBBLE_ERROR_STALE, "type");
    auto explosion = blow();
    expectRefused(api()->explode(gone, &explosion), RUBBLE_ERROR_STALE, "world");
    auto impulse = sized<rubble_impulse>();
    expectRefused(api()->push(m_world, &impulse), RUBBLE_ERROR_STALE, "body");
    auto carve = sized<rubble_carve>();
    carve.radii[0] = 1.0;
    carve.shape = bodies(m_world)[0].body;
    expectRefused(api()->carve(m_world, &carve), RUBBLE_ERROR_STALE, "type");
    expectRefused(api()->renderer_destroy(0), RUBBLE_ERROR_STALE, "renderer");

    const rubble_world next = makeWorld();  // in the slot of the one that is gone
    EXPECT_NE(next, gone);
    expectRefused(api()->step(gone), RUBBLE_ERROR_STALE, "world");
    EXPECT_EQ(api()->world_destroy(next), RUBBLE_OK);
}

TEST_F(Abi, ABodyThatALevelReplacedIsStale) {
    const rubble_body body = bodies(m_world)[0].body;
    ASSERT_EQ(api()->load_level(m_world, s_level.c_str(), nullptr), RUBBLE_OK);
    rubble_body_state state = {};
    expectRefused(api()->body_state(m_world, body, &state), RUBBLE_ERROR_STALE, "body");
}

TEST_F(Abi, NumbersThatAreNoneAreRefused) {
    auto explosion = blow();
    explosion.position[1] = std::numeric_limits<double>::quiet_NaN();
    expectRefused(api()->explode(m_world, &explosion), RUBBLE_ERROR_ARGUMENT, "position[1]");
    explosion = blow();
    explosion.size = 1e9;
    expectRefused(api()->explode(m_world, &explosion), RUBBLE_ERROR_ARGUMENT, "size");
    auto carve = sized<rubble_carve>();
    expectRefused(api()->carve(m_world, &carve), RUBBLE_ERROR_ARGUMENT, "radii");
    carve.radii[0] = 0.5, carve.radii[1] = 1.0;
    expectRefused(api()->carve(m_world, &carve), RUBBLE_ERROR_ARGUMENT, "radii");
    carve.brush = 7;
    expectRefused(api()->carve(m_world, &carve), RUBBLE_ERROR_ARGUMENT, "brush");
    const double origin[3] = {0, 0, 0}, nowhere[3] = {0, 0, 0};
    auto hit = sized<rubble_hit>();
    expectRefused(api()->raycast(m_world, origin, nowhere, 1, &hit), RUBBLE_ERROR_ARGUMENT, "direction");
    auto settings = sized<rubble_world_settings>();
    settings.flags = 1u << 31;
    rubble_world world = 0;
    expectRefused(api()->world_create(&settings, &world), RUBBLE_ERROR_ARGUMENT, "flags");
}

TEST_F(Abi, AShortArrayGetsWhatFits) {
    const rubble_explosion explosion = blow();
    ASSERT_EQ(api()->explode(m_world, &explosion), RUBBLE_OK);
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    ASSERT_GE(bodies(m_world).size(), 2u);
    rubble_body_state rows[2] = {};
    uint32_t count = 0;
    expectRefused(api()->body_states(m_world, rows, 1, &count), RUBBLE_ERROR_CAPACITY, "holds 1");
    EXPECT_EQ(count, bodies(m_world).size());
    EXPECT_NE(rows[0].body, 0u);
    EXPECT_EQ(rows[1].body, 0u);
}

TEST_F(Abi, ABadFileLeavesTheWorldAsItWas) {
    uint64_t before = 0, after = 1;
    ASSERT_EQ(api()->state_hash(m_world, &before), RUBBLE_OK);
    expectRefused(api()->load_level(m_world, "no/such/file.rubble", nullptr), RUBBLE_ERROR_FILE, "no/such/file.rubble");
    expectRefused(api()->load_level(m_world, RUBBLE_LIBRARY, nullptr), RUBBLE_ERROR_FILE, "librubble");
    ASSERT_EQ(api()->state_hash(m_world, &after), RUBBLE_OK);
    EXPECT_EQ(before, after);
}

TEST_F(Abi, SavesRecordsReplaysAndUndoes) {
    const TempFolder folder;
    const std::string save = folder / "game.rubble", log = folder / "game.rubblelog";
    const auto hash = [&] {
        uint64_t out = 0;
        EXPECT_EQ(api()->state_hash(m_world, &out), RUBBLE_OK);
        return out;
    };
    const auto voxels = [&] {
        auto ledger = sized<rubble_ledger>();
        EXPECT_EQ(api()->ledger(m_world, &ledger), RUBBLE_OK);
        return ledger.standing;
    };
    ASSERT_EQ(api()->undo_limit(m_world, 4), RUBBLE_OK);
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    const uint64_t whole = voxels();
    ASSERT_EQ(api()->record_start(m_world, log.c_str()), RUBBLE_OK);
    ASSERT_EQ(api()->undo_mark(m_world), RUBBLE_OK);
    const rubble_explosion explosion = blow();
    ASSERT_EQ(api()->explode(m_world, &explosion), RUBBLE_OK);
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    EXPECT_LT(voxels(), whole);
    ASSERT_EQ(api()->save(m_world, save.c_str()), RUBBLE_OK);
    for (int i = 0; i < 20; ++i) ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    const uint64_t end = hash();
    ASSERT_EQ(api()->record_stop(m_world), RUBBLE_OK);
    ASSERT_EQ(api()->undo(m_world), RUBBLE_OK);
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    EXPECT_EQ(voxels(), whole);
    ASSERT_EQ(api()->redo(m_world), RUBBLE_OK);
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    EXPECT_LT(voxels(), whole);

    ASSERT_EQ(api()->load_save(m_world, save.c_str()), RUBBLE_OK) << api()->last_error();
    for (int i = 0; i < 20; ++i) ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    EXPECT_EQ(hash(), end);
    uint64_t steps = 0;
    ASSERT_EQ(api()->replay(m_world, log.c_str(), &steps), RUBBLE_OK) << api()->last_error();
    EXPECT_EQ(steps, 21u);
    EXPECT_EQ(hash(), end);

    expectRefused(api()->load_save(m_world, log.c_str()), RUBBLE_ERROR_FILE, "SAVE");
    expectRefused(api()->replay(m_world, save.c_str(), nullptr), RUBBLE_ERROR_FILE, "GAME");
    expectRefused(api()->save(m_world, "/no/such/folder/x"), RUBBLE_ERROR_FILE, "/no/such/folder");
    EXPECT_EQ(hash(), end);
}

TEST_F(Abi, ARendererNeedsTheHostsGl) {
    rubble_world world = 0;
    ASSERT_EQ(api()->world_create(nullptr, &world), RUBBLE_OK);
    auto settings = sized<rubble_renderer_settings>();
    rubble_renderer renderer = 0;
    settings.shader_folder = RUBBLE_SOURCE_DIR "/shaders";
    expectRefused(api()->renderer_create(world, &settings, &renderer), RUBBLE_ERROR_GL, "gl_get_proc_address");
    settings.preset = "shiny";
    expectRefused(api()->renderer_create(world, &settings, &renderer), RUBBLE_ERROR_ARGUMENT, "shiny");
    EXPECT_EQ(api()->world_destroy(world), RUBBLE_OK);
}

TEST_F(Abi, QueriesAnswerManyAtOnce) {
    const std::array<rubble_ray, 3> rays = {rubble_ray{{0.85, 5.0, 0.85}, {0.0, -1.0, 0.0}, 10.0, 0.0},
                                            rubble_ray{{0.85, 5.0, 0.85}, {0.0, -1.0, 0.0}, 10.0, 0.2},
                                            rubble_ray{{5.0, 5.0, 5.0}, {0.0, -1.0, 0.0}, 10.0, 0.0}};
    std::array<rubble_touch, 3> touches = {};
    ASSERT_EQ(api()->cast_rays(m_world, rays.data(), 3, nullptr, touches.data()), RUBBLE_OK) << api()->last_error();
    EXPECT_EQ(touches[0].hit, 1u);
    EXPECT_NEAR(touches[0].distance, 4.0, 1e-6);  // a voxel is 0.1f metres
    EXPECT_NEAR(touches[1].distance, 3.8, 1e-6);
    EXPECT_EQ(touches[2].hit, 0u);
    auto filter = sized<rubble_filter>();
    filter.rejected_shape_count = 1;
    filter.rejected_shapes = &touches[0].shape;
    rubble_touch none = {};
    ASSERT_EQ(api()->cast_rays(m_world, rays.data(), 1, &filter, &none), RUBBLE_OK);
    EXPECT_EQ(none.hit, 0u);

    rubble_cast cast = {};
    cast.shape.kind = RUBBLE_REGION_BOX;
    cast.shape.position[0] = cast.shape.position[2] = 0.85, cast.shape.position[1] = 3.0;
    cast.shape.half_size[0] = cast.shape.half_size[1] = cast.shape.half_size[2] = 0.5;
    cast.direction[1] = -1.0;
    cast.max_distance = 10.0;
    ASSERT_EQ(api()->cast_shapes(m_world, &cast, 1, nullptr, &none), RUBBLE_OK) << api()->last_error();
    EXPECT_NEAR(none.distance, 1.5, 1e-6);
    uint32_t count = 0;
    uint64_t found = 0;
    cast.shape.position[1] = 1.2;
    ASSERT_EQ(api()->overlap_bodies(m_world, &cast.shape, nullptr, &found, 1, &count), RUBBLE_OK);
    EXPECT_EQ(count, 1u);
    EXPECT_EQ(found, touches[0].body);
    ASSERT_EQ(api()->overlap_shapes(m_world, &cast.shape, &filter, &found, 1, &count), RUBBLE_OK);
    EXPECT_EQ(count, 0u);
    const double above[3] = {0.85, 1.5, 0.85};
    ASSERT_EQ(api()->closest_point(m_world, above, 10.0, nullptr, &none), RUBBLE_OK);
    EXPECT_NEAR(none.distance, 0.5, 1e-6);
    cast.direction[1] = 0.0;
    expectRefused(api()->cast_shapes(m_world, &cast, 1, nullptr, &none), RUBBLE_ERROR_ARGUMENT, "direction");
    expectRefused(api()->cast_rays(m_world, nullptr, 1, nullptr, &none), RUBBLE_ERROR_NULL, "rays");
}

TEST_F(Abi, SomeoneWalksOverTheTableIntoATriggersWater) {
    auto person = sized<rubble_character_params>();
    person.position[0] = person.position[2] = 0.85, person.position[1] = 1.05;
    ASSERT_EQ(api()->add_character(m_world, &person), RUBBLE_OK) << api()->last_error();
    const double square[8] = {-5, -5, 5, -5, 5, 5, -5, 5};
    auto water = sized<rubble_water_params>();
    water.outline = square, water.outline_count = 4, water.surface = 0.5, water.depth = 30.0;
    ASSERT_EQ(api()->add_water(m_world, &water), RUBBLE_OK) << api()->last_error();
    auto trigger = sized<rubble_trigger_params>();
    trigger.kind = RUBBLE_TRIGGER_SPHERE, trigger.position[1] = 0.9, trigger.radius = 3.0;
    ASSERT_EQ(api()->add_trigger(m_world, &trigger), RUBBLE_OK) << api()->last_error();
    for (int i = 0; i < 30; ++i) ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    rubble_character_state state = {};
    uint32_t count = 0;
    ASSERT_EQ(api()->character_states(m_world, &state, 1, &count), RUBBLE_OK);
    ASSERT_EQ(count, 1u);
    EXPECT_TRUE(state.flags & RUBBLE_CHARACTER_GROUNDED);
    EXPECT_NEAR(state.position[1], 1.0, 0.03);
    auto move = sized<rubble_character_move>();
    move.character = state.character;
    move.wish[0] = 3.0;
    ASSERT_EQ(api()->move_character(m_world, &move), RUBBLE_OK) << api()->last_error();
    for (int i = 0; i < 90; ++i) ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    ASSERT_EQ(api()->character_states(m_world, &state, 1, &count), RUBBLE_OK);
    EXPECT_GT(state.position[0], 1.7);
    EXPECT_TRUE(state.flags & RUBBLE_CHARACTER_SWIMMING);

    const rubble_explosion explosion = blow();  // pieces of the table move inside the trigger
    ASSERT_EQ(api()->explode(m_world, &explosion), RUBBLE_OK);
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    ASSERT_EQ(api()->trigger_events(m_world, nullptr, 0, &count), RUBBLE_OK);
    EXPECT_GT(count, 0u);
    std::vector<rubble_trigger_event> events(count);
    ASSERT_EQ(api()->trigger_events(m_world, events.data(), count, &count), RUBBLE_OK);
    EXPECT_EQ(events[0].entered, 1u);
    uint32_t inside = 0;
    ASSERT_EQ(api()->trigger_bodies(m_world, events[0].trigger, nullptr, 0, &inside), RUBBLE_OK);
    EXPECT_EQ(inside, count);

    auto collision = sized<rubble_collision>();
    expectRefused(api()->set_collision(m_world, &collision), RUBBLE_ERROR_STALE, "shape");
    EXPECT_EQ(api()->remove_character(m_world, state.character), RUBBLE_OK);
    EXPECT_EQ(api()->remove_trigger(m_world, events[0].trigger), RUBBLE_OK);
    uint64_t lake = 0;
    ASSERT_EQ(api()->waters(m_world, &lake, 1, &count), RUBBLE_OK);
    EXPECT_EQ(api()->remove_water(m_world, lake), RUBBLE_OK);
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    ASSERT_EQ(api()->triggers(m_world, nullptr, 0, &count), RUBBLE_OK);
    EXPECT_EQ(count, 0u);
    expectRefused(api()->move_character(m_world, &move), RUBBLE_ERROR_STALE, "character");
}

TEST_F(Abi, TheHostReceivesMessages) {
    struct Heard {
        int count = 0;
        std::string last;
    } heard;
    auto host = sized<rubble_host>();
    host.user = &heard;
    host.log = [](void* user, int32_t, const char* message) {
        auto* into = static_cast<Heard*>(user);
        ++into->count;
        into->last = message;
    };
    ASSERT_EQ(api()->set_host(&host), RUBBLE_OK);
    const rubble_api* table = nullptr;
    EXPECT_EQ(rubble_get_api(99, &table), RUBBLE_ERROR_VERSION);
    EXPECT_EQ(heard.count, 1);
    EXPECT_NE(heard.last.find("99"), std::string::npos);
    ASSERT_EQ(api()->set_host(nullptr), RUBBLE_OK);
}

}  // namespace
}  // namespace rubble
