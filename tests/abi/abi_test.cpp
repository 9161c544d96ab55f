#include <array>
#include <cmath>
#include <cstring>
#include <string>

#include "tests/abi/abi_fixture.h"
#include "tests/support/temp_folder.h"

namespace rubble {
namespace {

TEST_F(Abi, AnExplosionIsReportedInTheEvents) {
    const rubble_explosion explosion = tableExplosion();
    ASSERT_EQ(api()->explode(m_world, &explosion), RUBBLE_OK) << api()->get_last_error();
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    auto events = sized<rubble_events>();
    ASSERT_EQ(api()->get_events(m_world, &events), RUBBLE_OK);
    EXPECT_EQ(events.step, 2u);
    ASSERT_EQ(events.removed_count, 1u);
    EXPECT_EQ(events.removed[0].color[0], 200);
    ASSERT_GE(events.split_count, 1u);
    ASSERT_GE(events.bodies_created_count, 1u);

    auto voxels = sized<rubble_voxel_accounting>();
    ASSERT_EQ(api()->get_voxel_accounting(m_world, &voxels), RUBBLE_OK);
    EXPECT_EQ(voxels.imported, 650u);
    EXPECT_EQ(voxels.removed, events.removed[0].count);
    EXPECT_GT(voxels.in_pieces, 0u);
    EXPECT_EQ(voxels.imported, voxels.standing + voxels.in_pieces + voxels.removed);

    const rubble_body piece = events.bodies_created[0];
    rubble_body_state before = {}, after = {};
    ASSERT_EQ(api()->get_body_state(m_world, piece, &before), RUBBLE_OK);
    for (int i = 0; i < 10; ++i) ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    ASSERT_EQ(api()->get_body_state(m_world, piece, &after), RUBBLE_OK);
    EXPECT_NE(before.position[1], after.position[1]) << "the piece does not fall";

    uint32_t count = 0;
    ASSERT_EQ(api()->get_shape_states(m_world, piece, nullptr, 0, &count), RUBBLE_OK);
    EXPECT_EQ(count, after.shape_count);
    rubble_shape_state listed = {}, alone = {};
    ASSERT_EQ(api()->get_shape_states(m_world, piece, &listed, 1, &count), RUBBLE_OK);
    ASSERT_EQ(api()->get_shape_state(m_world, listed.shape, &alone), RUBBLE_OK);
    EXPECT_EQ(std::memcmp(&listed, &alone, sizeof listed), 0) << "one shape is read as in the list";
    expectRefused(api()->get_shape_state(m_world, piece, &alone), RUBBLE_ERROR_STALE, "type");
}

TEST_F(Abi, EveryRemovedVoxelIsInADustCloud) {
    auto edit = sized<rubble_break>();
    edit.position[0] = 0.3, edit.position[1] = 0.9, edit.position[2] = 0.3;
    edit.radii[0] = edit.radii[1] = 0.6;
    edit.tool = RUBBLE_TOOL_SLEDGE;
    auto events = sized<rubble_events>();
    ASSERT_EQ(api()->break_voxels(m_world, &edit), RUBBLE_OK);
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    ASSERT_EQ(api()->get_events(m_world, &events), RUBBLE_OK);
    EXPECT_EQ(events.bodies_broken_count, 0u) << "a sledge does not break bricks";
    edit.tool = RUBBLE_TOOL_GUN;
    ASSERT_EQ(api()->break_voxels(m_world, &edit), RUBBLE_OK);
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    ASSERT_EQ(api()->get_events(m_world, &events), RUBBLE_OK);
    EXPECT_GT(events.split_count, 1u);
    EXPECT_EQ(events.bodies_broken_count, 1u);
    uint64_t dust = 0;
    for (uint32_t i = 0; i < events.dust_cloud_count; ++i) dust += events.dust_clouds[i].count;
    auto voxels = sized<rubble_voxel_accounting>();
    ASSERT_EQ(api()->get_voxel_accounting(m_world, &voxels), RUBBLE_OK);
    EXPECT_EQ(dust, voxels.removed);
    edit.tool = 5;
    EXPECT_EQ(api()->break_voxels(m_world, &edit), RUBBLE_ERROR_ARGUMENT);
}

TEST_F(Abi, EqualCommandsGiveEqualWorlds) {
    const rubble_world other = makeWorld();
    uint64_t hash = 0, otherHash = 1;
    for (int step = 0; step < 30; ++step) {
        const rubble_explosion explosion = tableExplosion();
        for (const rubble_world world : {m_world, other}) {
            if (step == 3) {
                ASSERT_EQ(api()->explode(world, &explosion), RUBBLE_OK);
            }
            ASSERT_EQ(api()->step(world), RUBBLE_OK);
        }
        ASSERT_EQ(api()->get_state_hash(m_world, &hash), RUBBLE_OK);
        ASSERT_EQ(api()->get_state_hash(other, &otherHash), RUBBLE_OK);
        ASSERT_EQ(hash, otherHash) << "at step " << step;
    }
    EXPECT_EQ(api()->destroy_world(other), RUBBLE_OK);
}

TEST_F(Abi, EveryKindOfEditChangesTheWorld) {
    auto carve = sized<rubble_carve>();
    carve.brush = RUBBLE_BRUSH_BOX;
    carve.position[1] = 0.95;  // a corner of the table's top
    for (double& half : carve.half_size) half = 0.11;
    auto paint = sized<rubble_paint>();
    paint.position[0] = paint.position[1] = 0.95;
    paint.color[2] = 255;
    ASSERT_EQ(api()->carve(m_world, &carve), RUBBLE_OK) << api()->get_last_error();
    ASSERT_EQ(api()->paint(m_world, &paint), RUBBLE_OK) << api()->get_last_error();
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    auto events = sized<rubble_events>();
    ASSERT_EQ(api()->get_events(m_world, &events), RUBBLE_OK);
    EXPECT_EQ(events.removed_count, 1u);
    EXPECT_GT(events.painted_voxel_count, 0u);

    const double origin[3] = {0.25, 5.0, 0.25}, down[3] = {0.0, -2.0, 0.0};
    rubble_hit hit = {};
    ASSERT_EQ(api()->cast_ray(m_world, origin, down, 10.0, &hit), RUBBLE_OK);
    ASSERT_EQ(hit.hit, 1u);
    EXPECT_NEAR(hit.distance, 4.0, 1e-6);
    EXPECT_EQ(hit.cell[1], 9);
    EXPECT_NEAR(hit.normal[1], 1.0, 1e-6);

    const rubble_explosion explosion = tableExplosion();
    ASSERT_EQ(api()->explode(m_world, &explosion), RUBBLE_OK);
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    ASSERT_EQ(api()->get_events(m_world, &events), RUBBLE_OK);
    ASSERT_GE(events.bodies_created_count, 1u);
    auto impulse = sized<rubble_impulse>();
    impulse.body = events.bodies_created[0];
    impulse.impulse[1] = 1000.0;
    rubble_body_state state = {};
    ASSERT_EQ(api()->get_body_state(m_world, impulse.body, &state), RUBBLE_OK);
    std::copy_n(state.position, 3, impulse.position);
    const std::array<double, 3> before = {state.velocity[0], state.velocity[1], state.velocity[2]};
    ASSERT_EQ(api()->apply_impulse(m_world, &impulse), RUBBLE_OK) << api()->get_last_error();
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    ASSERT_EQ(api()->get_body_state(m_world, impulse.body, &state), RUBBLE_OK);
    double change = 0.0;  // contacts may turn the impulse, so any change of velocity counts
    for (size_t i = 0; i < 3; ++i) change += std::abs(state.velocity[i] - before[i]);
    EXPECT_GT(change, 0.5);
}

TEST_F(Abi, SavesRecordsReplaysAndUndoes) {
    const TempFolder folder;
    const std::string save = folder / "game.rubble", log = folder / "game.rubblelog";
    const auto hash = [&] {
        uint64_t out = 0;
        EXPECT_EQ(api()->get_state_hash(m_world, &out), RUBBLE_OK);
        return out;
    };
    const auto standingVoxels = [&] {
        auto voxels = sized<rubble_voxel_accounting>();
        EXPECT_EQ(api()->get_voxel_accounting(m_world, &voxels), RUBBLE_OK);
        return voxels.standing;
    };
    ASSERT_EQ(api()->set_undo_limit(m_world, 4), RUBBLE_OK);
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    const uint64_t whole = standingVoxels();
    ASSERT_EQ(api()->start_recording(m_world, log.c_str()), RUBBLE_OK);
    ASSERT_EQ(api()->add_undo_mark(m_world), RUBBLE_OK);
    const rubble_explosion explosion = tableExplosion();
    ASSERT_EQ(api()->explode(m_world, &explosion), RUBBLE_OK);
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    EXPECT_LT(standingVoxels(), whole);
    ASSERT_EQ(api()->save_game(m_world, save.c_str()), RUBBLE_OK);
    for (int i = 0; i < 20; ++i) ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    const uint64_t end = hash();
    ASSERT_EQ(api()->stop_recording(m_world), RUBBLE_OK);
    ASSERT_EQ(api()->undo(m_world), RUBBLE_OK);
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    EXPECT_EQ(standingVoxels(), whole);
    ASSERT_EQ(api()->redo(m_world), RUBBLE_OK);
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    EXPECT_LT(standingVoxels(), whole);

    ASSERT_EQ(api()->load_game(m_world, save.c_str()), RUBBLE_OK) << api()->get_last_error();
    for (int i = 0; i < 20; ++i) ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    EXPECT_EQ(hash(), end);
    uint64_t steps = 0;
    ASSERT_EQ(api()->play_recording(m_world, log.c_str(), &steps), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(steps, 21u);
    EXPECT_EQ(hash(), end);

    expectRefused(api()->load_game(m_world, log.c_str()), RUBBLE_ERROR_FILE, "SAVE");
    expectRefused(api()->play_recording(m_world, save.c_str(), nullptr), RUBBLE_ERROR_FILE, "GAME");
    expectRefused(api()->save_game(m_world, "/no/such/folder/x"), RUBBLE_ERROR_FILE, "/no/such/folder");
    EXPECT_EQ(hash(), end);
}

TEST_F(Abi, TheHostReceivesLogMessages) {
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

TEST_F(Abi, BoundsAreSetAndReadAndCheckedOnTheWayIn) {
    auto bounds = sized<rubble_bounds>();
    ASSERT_EQ(api()->get_bounds(m_world, &bounds), RUBBLE_OK);
    EXPECT_LT(bounds.low[1], -100.0) << "a margin around the level";
    EXPECT_EQ(bounds.rule, uint32_t(RUBBLE_BOUNDS_DUST));
    bounds.rule = RUBBLE_BOUNDS_KEEP;
    for (int a = 0; a < 3; ++a) bounds.low[a] = -5.0, bounds.high[a] = 50.0;
    ASSERT_EQ(api()->set_bounds(m_world, &bounds), RUBBLE_OK);
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    auto now = sized<rubble_bounds>();
    ASSERT_EQ(api()->get_bounds(m_world, &now), RUBBLE_OK);
    EXPECT_EQ(now.rule, uint32_t(RUBBLE_BOUNDS_KEEP));
    EXPECT_EQ(now.high[2], 50.0);
    bounds.low[1] = 60.0;
    EXPECT_EQ(api()->set_bounds(m_world, &bounds), RUBBLE_ERROR_ARGUMENT);
    bounds.low[1] = -5.0;
    bounds.rule = RUBBLE_BOUNDS_GROUND;
    EXPECT_EQ(api()->set_bounds(m_world, &bounds), RUBBLE_OK);
    bounds.rule = 3;
    EXPECT_EQ(api()->set_bounds(m_world, &bounds), RUBBLE_ERROR_ARGUMENT);
}

}  // namespace
}  // namespace rubble
