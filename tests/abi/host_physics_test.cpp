#include <algorithm>
#include <limits>
#include <string>

#include "tests/abi/create_fixture.h"
#include "tests/support/temp_folder.h"

namespace rubble {
namespace {

/// A world whose bodies the host moves, with the table of the test level in it.
class HostPhysics : public AbiCreate {
protected:
    void SetUp() override {
        m_world = makeHostWorld();
        ASSERT_EQ(api()->load_level(m_world, s_level.c_str(), nullptr), RUBBLE_OK) << api()->get_last_error();
    }
    static rubble_world makeHostWorld() {
        auto settings = sized<rubble_world_settings>();
        settings.flags = RUBBLE_WORLD_NO_RENDERER | RUBBLE_WORLD_HOST_PHYSICS;
        rubble_world world = 0;
        EXPECT_EQ(api()->create_world(&settings, &world), RUBBLE_OK) << api()->get_last_error();
        return world;
    }
    std::vector<rubble_rigid_body> rigids(uint32_t which = RUBBLE_BODIES_CHANGED) {
        uint32_t count = 0;
        EXPECT_EQ(api()->get_rigid_bodies(m_world, which, nullptr, 0, &count), RUBBLE_OK);
        std::vector<rubble_rigid_body> rows(count);
        EXPECT_EQ(api()->get_rigid_bodies(m_world, which, rows.data(), count, &count), RUBBLE_OK);
        return rows;
    }
    std::vector<rubble_body_box> boxes(rubble_body body) {
        uint32_t count = 0;
        EXPECT_EQ(api()->get_body_boxes(m_world, body, nullptr, 0, &count), RUBBLE_OK) << api()->get_last_error();
        std::vector<rubble_body_box> rows(count);
        EXPECT_EQ(api()->get_body_boxes(m_world, body, rows.data(), count, &count), RUBBLE_OK);
        return rows;
    }
    /// A cube of concrete of 0.8 m, which hangs in the air.
    rubble_body makeCube(double x, double y) {
        const rubble_body body = make(bodyAt(x, y, 0));
        make(shapeOn(body, RUBBLE_SHAPE_BOX, 8));
        return body;
    }
    rubble_result moveTo(rubble_body body, double x, double y, uint32_t flags = 0) {
        rubble_body_state state = {};
        state.body = body, state.position[0] = x, state.position[1] = y, state.flags = flags;
        return api()->set_body_states(m_world, &state, 1);
    }
    static rubble_impact hitOn(rubble_body body, double x, double y, double impulse) {
        rubble_impact out = {};
        out.body = body, out.position[0] = x, out.position[1] = y, out.position[2] = 0.4;
        out.normal[0] = 1.0, out.impulse = impulse, out.speed = 20.0;
        return out;
    }
};

TEST_F(HostPhysics, NothingMovesBodiesButTheHost) {
    const rubble_body cube = makeCube(5.0, 10.0);
    step(30);
    EXPECT_DOUBLE_EQ(bodyState(cube).position[1], 10.0) << "no gravity";
    ASSERT_EQ(moveTo(cube, 6.0, 9.0), RUBBLE_OK) << api()->get_last_error();
    EXPECT_DOUBLE_EQ(bodyState(cube).position[1], 9.0) << "at once";
    const double origin[3] = {6.4, 20.0, 0.4}, down[3] = {0.0, -1.0, 0.0};
    rubble_hit hit = {};
    ASSERT_EQ(api()->cast_ray(m_world, origin, down, 50.0, &hit), RUBBLE_OK);
    EXPECT_EQ(hit.body, cube);
    EXPECT_NEAR(hit.distance, 10.2, 1e-6);
    step();
    EXPECT_DOUBLE_EQ(bodyState(cube).position[0], 6.0);
}

TEST_F(HostPhysics, StatesThatAreSetAsTheyWereReadChangeNothing) {
    const rubble_body cube = makeCube(5.0, 10.0);
    step();
    rubble_body_state state = bodyState(cube);
    const double rotation[4] = {0.3, 0.2, 0.1, 0.927};
    std::copy_n(rotation, 4, state.rotation);
    ASSERT_EQ(api()->set_body_states(m_world, &state, 1), RUBBLE_OK) << api()->get_last_error();
    step();
    const uint64_t before = hash();
    state = bodyState(cube);
    ASSERT_EQ(api()->set_body_states(m_world, &state, 1), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(hash(), before);
}

TEST_F(HostPhysics, MassCentreInertiaAndBoxesAreThoseOfTheVoxels) {
    const rubble_body cube = makeCube(5.0, 10.0);
    step();
    const std::vector<rubble_rigid_body> all = rigids();
    ASSERT_EQ(all.size(), 2u) << "the level's table as well";
    const auto row = std::find_if(all.begin(), all.end(), [&](const auto& each) { return each.body == cube; });
    ASSERT_NE(row, all.end());
    EXPECT_EQ(row->changes, uint32_t(RUBBLE_RIGID_NEW));
    EXPECT_EQ(row->flags, 0u);
    const double density = row->mass / 0.512, side = 0.8;
    EXPECT_NEAR(density, 2400.0, 200.0);
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(row->center[i], 0.4, 1e-6);
        EXPECT_NEAR(row->inertia[i], row->mass * side * side / 6.0, 1e-3 * row->mass);
    }
    const std::vector<rubble_body_box> solid = boxes(cube);
    ASSERT_EQ(solid.size(), 1u);
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(solid[0].center[i], 0.4, 1e-6);
        EXPECT_NEAR(solid[0].half_size[i], 0.4, 1e-6);
    }
    EXPECT_EQ(solid[0].layer, 1u);
    EXPECT_EQ(solid[0].mask, 255u);
    double volume = 0.0;  // of the level's table: a top and a leg
    for (const auto& each : all)
        if (each.body != cube)
            for (const rubble_body_box& box : boxes(each.body))
                volume += 8.0 * box.half_size[0] * box.half_size[1] * box.half_size[2];
    EXPECT_NEAR(volume, 650 * 1e-3, 1e-5) << "650 voxels, each once";
    step();
    EXPECT_TRUE(rigids().empty()) << "nothing has changed";
    EXPECT_EQ(rigids(RUBBLE_BODIES_ALL).size(), 2u);
}

TEST_F(HostPhysics, ChangesAreListedWithTheirKinds) {
    const rubble_body cube = makeCube(5.0, 10.0);
    rubble_shape_settings second = shapeOn(cube, RUBBLE_SHAPE_BOX, 4);
    second.position[0] = 3.0;
    const rubble_shape shape = make(second);
    step();
    auto change = sized<rubble_body_change>();
    change.body = cube, change.fields = RUBBLE_SET_VELOCITY, change.velocity[0] = 3.0;
    ASSERT_EQ(api()->set_body(m_world, &change), RUBBLE_OK);
    step();
    ASSERT_EQ(rigids().size(), 1u);
    EXPECT_EQ(rigids()[0].changes, uint32_t(RUBBLE_RIGID_MOVED));
    EXPECT_EQ(rigids()[0].velocity[0], 3.0);
    auto carve = sized<rubble_carve>();
    carve.position[0] = 5.0, carve.position[1] = 10.0, carve.radii[0] = carve.radii[1] = carve.radii[2] = 0.3;
    ASSERT_EQ(api()->carve(m_world, &carve), RUBBLE_OK);
    step();
    ASSERT_EQ(rigids().size(), 1u);
    EXPECT_EQ(rigids()[0].changes, uint32_t(RUBBLE_RIGID_SOLID | RUBBLE_RIGID_MOVED)) << "its centre is another";
    EXPECT_GT(boxes(cube).size(), 2u);
    const double mass = rigids()[0].mass;
    ASSERT_EQ(api()->destroy_shape(m_world, shape), RUBBLE_OK);
    step();
    ASSERT_EQ(rigids().size(), 1u) << "a body that lost a shape";
    EXPECT_EQ(rigids()[0].changes, uint32_t(RUBBLE_RIGID_SOLID | RUBBLE_RIGID_MOVED));
    EXPECT_LT(rigids()[0].mass, mass);
    change.body = make(bodyAt(30.0, 0.0, RUBBLE_BODY_STATIC)), change.fields = RUBBLE_SET_POSE;
    second.body = change.body;
    const rubble_shape ground = make(second);
    step();
    change.position[0] = 31.0;
    ASSERT_EQ(api()->set_body(m_world, &change), RUBBLE_OK);
    step();
    ASSERT_EQ(rigids().size(), 1u) << "a static body that was moved";
    EXPECT_EQ(rigids()[0].changes, uint32_t(RUBBLE_RIGID_MOVED));
    auto denser = sized<rubble_shape_change>();
    denser.shape = ground, denser.fields = RUBBLE_SHAPE_DENSITY, denser.density = 2.0, change.position[0] = 32.0;
    ASSERT_EQ(api()->set_shape(m_world, &denser), RUBBLE_OK);
    ASSERT_EQ(api()->set_body(m_world, &change), RUBBLE_OK);
    step();
    ASSERT_EQ(rigids().size(), 1u) << "and weighs more";
    EXPECT_EQ(rigids()[0].changes, uint32_t(RUBBLE_RIGID_MOVED | RUBBLE_RIGID_SOLID));
}

TEST_F(HostPhysics, WhatAnEditWakesIsListed) {
    const rubble_body cube = makeCube(5.0, 10.0);
    step();
    rubble_body_state state = {};
    ASSERT_EQ(api()->get_body_state(m_world, cube, &state), RUBBLE_OK);
    state.flags |= RUBBLE_BODY_ASLEEP;
    ASSERT_EQ(api()->set_body_states(m_world, &state, 1), RUBBLE_OK);
    step();
    EXPECT_TRUE(rigids().empty()) << "the host knows what it said";
    auto push = sized<rubble_impulse>();
    push.body = cube;
    ASSERT_EQ(api()->apply_impulse(m_world, &push), RUBBLE_OK) << "one of length 0 wakes";
    step();
    ASSERT_EQ(rigids().size(), 1u);
    EXPECT_EQ(rigids()[0].changes, uint32_t(RUBBLE_RIGID_MOVED));
    EXPECT_FALSE(rigids()[0].flags & RUBBLE_BODY_ASLEEP);
}

/// What flies breaks where it is now, and its pieces fly on from there.
TEST_F(HostPhysics, AnImpactBreaksInTheNextStepWhereTheHostSaysThatTheBodyIs) {
    const rubble_body cube = makeCube(5.0, 10.0);
    step();
    rubble_body_state state = bodyState(cube);
    state.position[1] = 3.0, state.velocity[1] = -15.0;
    ASSERT_EQ(api()->set_body_states(m_world, &state, 1), RUBBLE_OK);
    rubble_impact hit = hitOn(cube, 5.4, 3.0, 2e4);
    hit.normal[0] = 0.0, hit.normal[1] = 1.0;
    ASSERT_EQ(api()->report_impacts(m_world, &hit, 1), RUBBLE_OK) << api()->get_last_error();
    step();
    auto events = sized<rubble_events>();
    ASSERT_EQ(api()->get_events(m_world, &events), RUBBLE_OK);
    EXPECT_GT(events.removed_count, 0u);
    ASSERT_GT(events.bodies_created_count, 0u);
    for (uint32_t i = 0; i < events.bodies_created_count; ++i) {
        const rubble_body_state piece = bodyState(events.bodies_created[i]);
        EXPECT_NEAR(piece.position[1], 3.4, 0.9);
        EXPECT_NEAR(piece.velocity[1], -15.0, 1e-6);
    }
}

TEST_F(HostPhysics, ApplyEditsLeavesImpactsToTheNextStep) {
    const rubble_body cube = makeCube(5.0, 10.0);
    step();
    const rubble_impact hit = hitOn(cube, 5.0, 10.4, 2e4);
    ASSERT_EQ(api()->report_impacts(m_world, &hit, 1), RUBBLE_OK) << api()->get_last_error();
    auto events = sized<rubble_events>();
    for (int i = 0; i < 2; ++i) {
        ASSERT_EQ(api()->apply_edits(m_world), RUBBLE_OK) << api()->get_last_error();
        ASSERT_EQ(api()->get_events(m_world, &events), RUBBLE_OK);
        EXPECT_EQ(events.removed_count + events.bodies_created_count, 0u);
    }
    step();
    ASSERT_EQ(api()->get_events(m_world, &events), RUBBLE_OK);
    EXPECT_GT(events.removed_count, 0u);
    EXPECT_EQ(events.bodies_broken_count, 1u);
}

TEST_F(HostPhysics, ImpulsesOfEditsAreForTheHost) {
    const rubble_body cube = makeCube(5.0, 10.0);
    step();
    auto push = sized<rubble_impulse>();
    push.body = cube, push.impulse[2] = 7.0, push.position[0] = 5.0;
    ASSERT_EQ(api()->apply_impulse(m_world, &push), RUBBLE_OK);
    step();
    rubble_body_impulse row = {};
    uint32_t count = 0;
    ASSERT_EQ(api()->get_body_impulses(m_world, &row, 1, &count), RUBBLE_OK) << api()->get_last_error();
    ASSERT_EQ(count, 1u);
    EXPECT_EQ(row.body, cube);
    EXPECT_EQ(row.impulse[2], 7.0);
    EXPECT_EQ(row.position[0], 5.0);
    EXPECT_EQ(bodyState(cube).velocity[2], 0.0);
}

TEST_F(HostPhysics, ASaveHasWhatTheHostSaidSinceTheLastStep) {
    const TempFolder folder;
    const std::string path = folder.path() / "game.rubble";
    const rubble_body cube = makeCube(5.0, 10.0);
    step();
    ASSERT_EQ(moveTo(cube, 5.0, 4.0), RUBBLE_OK);
    const rubble_impact hit = hitOn(cube, 5.0, 4.4, 2e4);
    ASSERT_EQ(api()->report_impacts(m_world, &hit, 1), RUBBLE_OK);
    ASSERT_EQ(api()->save_game(m_world, path.c_str()), RUBBLE_OK) << api()->get_last_error();
    step();
    const uint64_t playedOn = hash();
    ASSERT_EQ(api()->load_game(m_world, path.c_str()), RUBBLE_OK) << api()->get_last_error();
    step();
    EXPECT_EQ(hash(), playedOn);
    EXPECT_GT(rigids().size(), 1u) << "all bodies are new after a load";
}

TEST_F(HostPhysics, ARecordingPlaysInAWorldOfItsKindAlone) {
    const TempFolder folder;
    const std::string path = folder.path() / "game.rubblelog";
    const rubble_body cube = makeCube(5.0, 10.0);
    step();
    ASSERT_EQ(moveTo(cube, 5.0, 6.0), RUBBLE_OK);
    ASSERT_EQ(api()->start_recording(m_world, path.c_str()), RUBBLE_OK);
    for (int i = 0; i < 5; ++i) {
        ASSERT_EQ(moveTo(cube, 5.0 + i, 5.0 - i), RUBBLE_OK);
        const rubble_impact hit = hitOn(cube, 5.0 + i, 5.4 - i, 2e4);
        ASSERT_EQ(api()->report_impacts(m_world, &hit, i == 2), RUBBLE_OK);
        step();
    }
    const uint64_t expected = hash();
    ASSERT_EQ(api()->stop_recording(m_world), RUBBLE_OK);
    uint64_t steps = 0;
    EXPECT_EQ(api()->play_recording(m_world, path.c_str(), &steps), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(steps, 5u);
    EXPECT_EQ(hash(), expected);
    const rubble_world other = makeWorld();
    expectRefused(api()->play_recording(other, path.c_str(), &steps), RUBBLE_ERROR_ARGUMENT,
                  "expected a recording of a world with physics of its own");
    EXPECT_EQ(api()->destroy_world(other), RUBBLE_OK);
}

TEST_F(HostPhysics, ARecordingEndsWithWhatTheHostDidAfterTheLastStep) {
    const TempFolder folder;
    const std::string path = folder.path() / "game.rubblelog";
    const rubble_body cube = makeCube(5.0, 10.0);
    step();
    for (const bool steps : {true, false}) {
        ASSERT_EQ(moveTo(cube, 4.0, 9.0), RUBBLE_OK);
        ASSERT_EQ(api()->start_recording(m_world, path.c_str()), RUBBLE_OK);
        if (steps) step();
        ASSERT_EQ(moveTo(cube, 5.0, 6.0), RUBBLE_OK);
        const rubble_impact hit = hitOn(cube, 5.0, 6.4, 2e4);
        ASSERT_EQ(api()->report_impacts(m_world, &hit, 1), RUBBLE_OK);
        const uint64_t expected = hash();
        ASSERT_EQ(api()->stop_recording(m_world), RUBBLE_OK);
        const rubble_world replayed = makeHostWorld();
        uint64_t count = 0, found = 0;
        EXPECT_EQ(api()->play_recording(replayed, path.c_str(), &count), RUBBLE_OK) << api()->get_last_error();
        EXPECT_EQ(count, steps ? 1u : 0u);
        ASSERT_EQ(api()->get_state_hash(replayed, &found), RUBBLE_OK);
        EXPECT_EQ(found, expected);
        EXPECT_EQ(api()->step(replayed), RUBBLE_OK);
        EXPECT_EQ(api()->get_state_hash(replayed, &found), RUBBLE_OK);
        EXPECT_EQ(api()->destroy_world(replayed), RUBBLE_OK);
        step();
        EXPECT_EQ(found, hash()) << "the hit breaks the same in the next step";
    }
}

TEST_F(HostPhysics, ABlastPushesALargeBodyByItsNearestSide) {
    for (const auto& [side, expected] : {std::pair(4, 1000.0 * (1.0 - 1.4 / 2.5)), {40, 1000.0 * (1.0 - 1.5 / 2.5)}}) {
        const rubble_body cube = make(bodyAt(20.0, 10.0, 0));
        make(shapeOn(cube, RUBBLE_SHAPE_BOX, side));
        auto blast = sized<rubble_explosion>();
        blast.position[0] = 18.8, blast.position[1] = 10.0 + 0.05 * side, blast.position[2] = 0.05 * side;
        blast.size = 1.0, blast.impulse = 1000.0;
        ASSERT_EQ(api()->explode(m_world, &blast), RUBBLE_OK) << api()->get_last_error();
        step();
        rubble_body_impulse given = {};
        uint32_t count = 0;
        ASSERT_EQ(api()->get_body_impulses(m_world, &given, 1, &count), RUBBLE_OK) << api()->get_last_error();
        ASSERT_EQ(count, 1u);
        EXPECT_NEAR(given.impulse[0], expected, 1e-4) << side;
        ASSERT_EQ(api()->destroy_body(m_world, cube), RUBBLE_OK);
        step();
    }
}

TEST_F(HostPhysics, AnUndoTellsTheHostWhereBodiesAre) {
    const rubble_body cube = makeCube(5.0, 10.0);
    ASSERT_EQ(api()->set_undo_limit(m_world, 1), RUBBLE_OK);
    step();
    ASSERT_EQ(api()->add_undo_mark(m_world), RUBBLE_OK);
    step();
    ASSERT_EQ(moveTo(cube, 8.0, 2.0), RUBBLE_OK);
    step();
    EXPECT_TRUE(rigids().empty()) << "the host knows what it said";
    ASSERT_EQ(api()->undo(m_world), RUBBLE_OK);
    step();
    ASSERT_EQ(rigids().size(), 1u);
    EXPECT_EQ(rigids()[0].changes, uint32_t(RUBBLE_RIGID_MOVED));
    EXPECT_DOUBLE_EQ(rigids()[0].position[1], 10.0);
}

TEST_F(HostPhysics, WhatOnlyPhysicsDoesIsUnsupported) {
    const rubble_body cube = makeCube(5.0, 10.0);
    step();
    for (const uint32_t kind : {RUBBLE_REPORT_CONTACT_BEGUN, RUBBLE_REPORT_CONTACT_SLID, RUBBLE_REPORT_CONTACT_HIT,
                                RUBBLE_REPORT_WATER, RUBBLE_REPORT_FOOTSTEP}) {
        auto filter = sized<rubble_report_filter>();
        filter.kinds = kind | RUBBLE_REPORT_BREAK;
        expectRefused(api()->set_report_filter(m_world, &filter), RUBBLE_ERROR_UNSUPPORTED, "filter->kinds");
        filter.kinds = RUBBLE_REPORT_BREAK | RUBBLE_REPORT_JOINT | RUBBLE_REPORT_FIRE;
        EXPECT_EQ(api()->set_report_filter(m_world, &filter), RUBBLE_OK) << api()->get_last_error();
    }
    auto grab = sized<rubble_grab>();
    grab.body = cube;
    expectRefused(api()->grab_body(m_world, &grab), RUBBLE_ERROR_UNSUPPORTED, "grab_body: the world has RUBBLE_WORLD");
    auto drive = sized<rubble_drive>();
    drive.body = cube;
    expectRefused(api()->drive_wheels(m_world, &drive), RUBBLE_ERROR_UNSUPPORTED, "HOST_PHYSICS");
    auto character = sized<rubble_character_settings>();
    rubble_character made = 1;
    expectRefused(api()->create_character(m_world, &character, &made), RUBBLE_ERROR_UNSUPPORTED, "HOST_PHYSICS");
    EXPECT_EQ(made, 0u);
    expectRefused(api()->add_character(m_world, &character), RUBBLE_ERROR_UNSUPPORTED, "HOST_PHYSICS");
    const rubble_world other = makeWorld();
    rubble_body_state state = {};
    state.body = bodies(other)[0].body;
    expectRefused(api()->set_body_states(other, &state, 1), RUBBLE_ERROR_UNSUPPORTED, "physics of its own");
    const rubble_impact hit = hitOn(state.body, 0.0, 0.0, 1.0);
    expectRefused(api()->report_impacts(other, &hit, 1), RUBBLE_ERROR_UNSUPPORTED, "physics of its own");
    EXPECT_EQ(api()->destroy_world(other), RUBBLE_OK);
}

TEST_F(HostPhysics, WrongRowsAreRefusedAsAWhole) {
    const rubble_body cube = makeCube(5.0, 10.0);
    const rubble_body table = bodies(m_world)[0].body;
    step();
    const uint64_t before = hash();
    rubble_body_state rows[2] = {bodyState(cube), bodyState(cube)};
    rows[0].position[1] = 1.0;
    rows[1].velocity[2] = std::numeric_limits<double>::quiet_NaN();
    expectRefused(api()->set_body_states(m_world, rows, 2), RUBBLE_ERROR_ARGUMENT, "states[1].velocity[2] is nan");
    rows[1] = bodyState(table);
    rows[1].flags = 0;
    expectRefused(api()->set_body_states(m_world, rows, 2), RUBBLE_ERROR_ARGUMENT, "states[1].body is static");
    rows[1].body = m_world;
    expectRefused(api()->set_body_states(m_world, rows, 2), RUBBLE_ERROR_STALE, "states[1].body");
    expectRefused(api()->set_body_states(m_world, nullptr, 1), RUBBLE_ERROR_NULL, "states");
    EXPECT_EQ(api()->set_body_states(m_world, nullptr, 0), RUBBLE_OK);
    rubble_impact hit = hitOn(0, 0.0, 0.0, 1.0);
    expectRefused(api()->report_impacts(m_world, &hit, 1), RUBBLE_ERROR_STALE, "impacts[0].body and other are 0");
    hit.body = cube, hit.impulse = -1.0;
    expectRefused(api()->report_impacts(m_world, &hit, 1), RUBBLE_ERROR_ARGUMENT, "impacts[0].impulse is -1");
    hit.impulse = 1.0, hit.normal[0] = 0.0;
    expectRefused(api()->report_impacts(m_world, &hit, 1), RUBBLE_ERROR_ARGUMENT, "impacts[0].normal");
    uint32_t count = 0;
    expectRefused(api()->get_rigid_bodies(m_world, 2, nullptr, 0, &count), RUBBLE_ERROR_ARGUMENT, "which is 2");
    expectRefused(api()->get_body_boxes(m_world, 0, nullptr, 0, &count), RUBBLE_ERROR_STALE, "body is 0");
    expectRefused(api()->get_layers(nullptr), RUBBLE_ERROR_NULL, "layers");
    EXPECT_EQ(hash(), before);
}

TEST_F(HostPhysics, PaintChangesNoCollider) {
    const rubble_body cube = makeCube(5.0, 10.0);
    step();
    auto paint = sized<rubble_paint>();
    paint.position[0] = 5.0, paint.position[1] = 10.0;
    ASSERT_EQ(api()->paint(m_world, &paint), RUBBLE_OK);
    step();
    auto events = sized<rubble_events>();
    ASSERT_EQ(api()->get_events(m_world, &events), RUBBLE_OK);
    ASSERT_GT(events.painted_voxel_count, 0u);
    EXPECT_TRUE(rigids().empty());
    EXPECT_NE(cube, 0u);
}

}  // namespace
}  // namespace rubble
