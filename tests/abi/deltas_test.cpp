#include <array>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "tests/abi/deltas_fixture.h"
#include "tests/support/temp_folder.h"

namespace rubble {
namespace {

/// Steps in which something is made and gone again, in a world that ends around what edits have made.
class AbiMadeAndGone : public AbiDeltas {
protected:
    using Work = std::function<void()>;

    void SetUp() override {
        AbiDeltas::SetUp();
        api()->destroy_world(m_world);
        auto settings = sized<rubble_world_settings>();
        settings.flags = RUBBLE_WORLD_NO_RENDERER;
        ASSERT_EQ(api()->create_world(&settings, &m_world), RUBBLE_OK) << api()->get_last_error();
        make(shapeOn(make(bodyAt(0.0, 0.0, RUBBLE_BODY_STATIC)), RUBBLE_SHAPE_BOX, 20));
        step();
    }

    /// Each is outside of all that was made before.
    rubble_shape freeBox() {
        m_height += 30.0;
        return make(shapeOn(make(bodyAt(3.0, m_height, 0)), RUBBLE_SHAPE_BOX, 3));
    }
    static void expectDone(rubble_result result) { EXPECT_EQ(result, RUBBLE_OK) << api()->get_last_error(); }
    std::vector<std::pair<const char*, Work>> shapesMadeAndGone() {
        return {
            {"body and box, body destroyed",
             [&] {
                 const rubble_body body = make(bodyAt(30.0, 5.0, 0));
                 make(shapeOn(body, RUBBLE_SHAPE_BOX, 3));
                 expectDone(api()->destroy_body(m_world, body));
             }},
            {"box destroyed", [&] { expectDone(api()->destroy_shape(m_world, freeBox())); }},
            {"box carved away",
             [&] {
                 freeBox();
                 auto carve = sized<rubble_carve>();
                 carve.position[0] = 3.0, carve.position[1] = m_height;
                 std::fill_n(carve.radii, 3, 3.0);
                 expectDone(api()->carve(m_world, &carve));
             }},
            {"voxels taken",
             [&] {
                 const std::vector<uint8_t> none(27);
                 const rubble_voxel_box all = wholeOf(freeBox(), 3);
                 expectDone(api()->write_voxels(m_world, &all, none.data(), none.size()));
             }},
            {"shape without voxels", [&] { make(shapeOn(make(bodyAt(300.0, 5.0, 0)), RUBBLE_SHAPE_EMPTY, 4)); }},
            {"shape without voxels on an old body",
             [&] { make(shapeOn(bodies(m_world).at(0).body, RUBBLE_SHAPE_EMPTY, 99)); }},
        };
    }
    std::vector<std::pair<const char*, Work>> othersMadeAndGone() {
        return {
            {"body", [&] { expectDone(api()->destroy_body(m_world, make(bodyAt(3.0, 5.0, 0)))); }},
            {"light",
             [&] {
                 auto light = sized<rubble_light_settings>();
                 light.reach = 5.0;
                 madeAndGone(api()->create_light, light, api()->remove_light);
             }},
            {"water",
             [&] {
                 const double corners[8] = {-1, -1, 1, -1, 1, 1, -1, 1};
                 auto water = sized<rubble_water_settings>();
                 water.outline = corners, water.outline_count = 4;
                 madeAndGone(api()->create_water, water, api()->remove_water);
             }},
            {"trigger",
             [&] { madeAndGone(api()->create_trigger, sized<rubble_trigger_settings>(), api()->remove_trigger); }},
            {"character",
             [&] {
                 madeAndGone(api()->create_character, sized<rubble_character_settings>(), api()->remove_character);
             }},
            {"joint and rope",
             [&] {
                 auto joint = sized<rubble_joint_settings>();
                 joint.shapes[0] = shapes().at(0).shape;
                 std::fill_n(joint.position, 3, 0.85);
                 madeAndGone(api()->create_joint, joint, api()->remove_joint);
                 joint.kind = RUBBLE_JOINT_ROPE, joint.rope_end[1] = 4.0;
                 madeAndGone(api()->create_joint, joint, api()->remove_joint);
             }},
        };
    }
    template <class Create, class Settings, class Remove>
    void madeAndGone(Create create, const Settings& settings, Remove remove) {
        uint64_t handle = 0;
        expectDone(create(m_world, &settings, &handle));
        expectDone(remove(m_world, handle));
    }
    void expectFollowed(const char* what) {
        for (int i = 0; i < 2; ++i) {
            step();
            ASSERT_EQ(apply(take()), RUBBLE_OK) << what << ", " << i << ": " << api()->get_last_error();
            EXPECT_EQ(resolved(m_world), resolved(m_other)) << what;
            EXPECT_EQ(accounting(m_world), accounting(m_other)) << what;
        }
    }
    static std::array<uint64_t, 4> accounting(rubble_world world) {
        auto out = sized<rubble_voxel_accounting>();
        EXPECT_EQ(api()->get_voxel_accounting(world, &out), RUBBLE_OK) << api()->get_last_error();
        return {out.imported, out.standing, out.in_pieces, out.removed};
    }

    double m_height = 5.0;
};

TEST_F(AbiMadeAndGone, AFollowerIsEqualAfterTheStep) {
    for (const auto& list : {shapesMadeAndGone(), othersMadeAndGone()})
        for (const auto& [what, work] : list) {
            copyTo(m_other);
            work();
            expectFollowed(what);
        }
}

TEST_F(AbiMadeAndGone, AShapeThatIsRefusedChangesNothing) {
    const rubble_body body = make(bodyAt(3.0, 0.0, 0));
    make(shapeOn(body, RUBBLE_SHAPE_BOX, 5));
    step();
    auto sleep = sized<rubble_body_change>();
    sleep.body = body, sleep.fields = RUBBLE_SET_ASLEEP;
    expectDone(api()->set_body(m_world, &sleep));
    step(2);
    const uint64_t before = resolved(m_world);
    make(shapeOn(body, RUBBLE_SHAPE_EMPTY, 99));
    step();
    EXPECT_EQ(refusals().size(), 1u);
    EXPECT_EQ(resolved(m_world), before);
}

TEST_F(AbiDeltas, AWorldThatFollowsHasNoReports) {
    auto filter = sized<rubble_report_filter>();
    auto reports = sized<rubble_reports>();
    filter.kinds = RUBBLE_REPORT_BREAK;
    for (const rubble_world world : {m_world, m_other})
        ASSERT_EQ(api()->set_report_filter(world, &filter), RUBBLE_OK) << api()->get_last_error();
    breakTable();
    step();
    ASSERT_EQ(api()->get_reports(m_world, &reports), RUBBLE_OK);
    EXPECT_GT(reports.break_count, 0u);
    ASSERT_EQ(apply(take()), RUBBLE_OK) << api()->get_last_error();
    ASSERT_EQ(api()->get_reports(m_other, &reports), RUBBLE_OK);
    EXPECT_EQ(reports.kinds, 0u);
    EXPECT_EQ(reports.break_count, 0u);
}

TEST_F(AbiDeltas, AnotherWorldFollowsStepByStep) {
    ASSERT_EQ(resolved(m_world), resolved(m_other));
    breakTable();
    for (int i = 0; i < 60; ++i) {
        if (i == 20) make(shapeOn(make(bodyAt(3.0, 2.0, 0)), RUBBLE_SHAPE_BOX, 5));
        step();
        ASSERT_EQ(apply(take()), RUBBLE_OK) << i << ": " << api()->get_last_error();
        ASSERT_EQ(resolved(m_world), resolved(m_other)) << i;
    }
    uint64_t other = 0;
    ASSERT_EQ(api()->get_state_hash(m_other, &other), RUBBLE_OK);
    EXPECT_EQ(other, hash()) << "nothing is hot and no rope hangs";
    EXPECT_GT(bodies(m_other).size(), 2u);
}

TEST_F(AbiDeltas, AMergeThatAddsNoVoxelIsFollowed) {
    const rubble_body body = make(bodyAt(3.0, 0.0, RUBBLE_BODY_STATIC));
    const rubble_shape around = make(shapeOn(body, RUBBLE_SHAPE_BOX, 8));
    auto inside = shapeOn(body, RUBBLE_SHAPE_BOX, 3);
    inside.position[0] = inside.position[1] = inside.position[2] = 0.3;
    const rubble_shape merged = make(inside);
    step();
    ASSERT_EQ(api()->merge_shape(m_world, merged, around), RUBBLE_OK) << api()->get_last_error();
    step();
    EXPECT_TRUE(isStale(merged));
    ASSERT_EQ(apply(take()), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(resolved(m_world), resolved(m_other));
}

TEST_F(AbiDeltas, AnEditLeavesTheMeshesOfAFollowerAsTheyAreElsewhere) {
    auto settings = sized<rubble_settings>();
    ASSERT_EQ(api()->get_settings(m_world, &settings), RUBBLE_OK);
    settings.flags |= RUBBLE_SETTING_PAINT_LAYER;
    ASSERT_EQ(api()->set_settings(m_world, &settings), RUBBLE_OK) << api()->get_last_error();
    const rubble_shape wall = make(shapeOn(make(bodyAt(3.0, 0.0, RUBBLE_BODY_STATIC)), RUBBLE_SHAPE_BOX, 40));
    auto paint = sized<rubble_paint>();
    paint.position[0] = 3.0, paint.position[1] = 3.0, paint.radius = 0.5, paint.color[0] = 200;
    step();
    ASSERT_EQ(api()->paint(m_world, &paint), RUBBLE_OK) << api()->get_last_error();
    step();
    copyTo(m_other);
    uint64_t there = 0, versions[2] = {};
    ASSERT_EQ(api()->translate_handle(m_other, wall, &there), RUBBLE_OK);
    for (int i = 0; i < 4; ++i) {
        auto carve = sized<rubble_carve>();
        carve.position[0] = 3.0 + i, carve.position[1] = 1.0;
        carve.radii[0] = carve.radii[1] = carve.radii[2] = 0.15;
        ASSERT_EQ(api()->carve(m_world, &carve), RUBBLE_OK) << api()->get_last_error();
        step();
        ASSERT_EQ(apply(take()), RUBBLE_OK) << api()->get_last_error();
        uint32_t counts[2] = {};
        for (const int k : {0, 1}) {
            auto changes = sized<rubble_brick_changes>();
            changes.what = RUBBLE_BRICKS_MESHES, changes.shape = k ? there : wall, changes.since = versions[k];
            EXPECT_EQ(api()->get_changed_bricks(k ? m_other : m_world, &changes, &versions[k], nullptr, 0, &counts[k]),
                      RUBBLE_OK)
                << "step " << i << (k ? ", the follower: " : ": ") << api()->get_last_error();
        }
        EXPECT_EQ(counts[0], counts[1]);
        EXPECT_GT(counts[0], 0u);
    }
}

/// A shape that is made and destroyed in one step leaves nothing but a body that is awake.
TEST_F(AbiDeltas, AFollowerHearsOfBodiesThatEditsWake) {
    const rubble_body body = make(bodyAt(3.0, 0.0, 0));
    make(shapeOn(body, RUBBLE_SHAPE_BOX, 5));
    step();
    auto sleep = sized<rubble_body_change>();
    sleep.body = body, sleep.fields = RUBBLE_SET_ASLEEP;
    ASSERT_EQ(api()->set_body(m_world, &sleep), RUBBLE_OK) << api()->get_last_error();
    step();
    copyTo(m_other);
    ASSERT_TRUE(bodyState(body).flags & RUBBLE_BODY_ASLEEP);
    (void)take();
    ASSERT_EQ(api()->destroy_shape(m_world, make(shapeOn(body, RUBBLE_SHAPE_BOX, 5))), RUBBLE_OK);
    step();
    EXPECT_FALSE(bodyState(body).flags & RUBBLE_BODY_ASLEEP);
    ASSERT_EQ(apply(take()), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(resolved(m_world), resolved(m_other));
}

TEST_F(AbiDeltas, WithoutMotionVoxelsAreEqualAndTheHostMovesTheBodies) {
    followWithoutMotion();
    breakTable();
    for (int i = 0; i < 60; ++i) {
        if (i == 30) breakTable();
        step();
        ASSERT_EQ(apply(take()), RUBBLE_OK) << i << ": " << api()->get_last_error();
        ASSERT_EQ(voxels(m_world), voxels(m_other)) << i;
        const std::vector<rubble_body_state> moved = movedForOther();
        EXPECT_EQ(api()->set_body_states(m_other, moved.data(), uint32_t(moved.size())), RUBBLE_OK)
            << api()->get_last_error();
    }
    for (const rubble_body_state& here : bodies(m_world)) {
        rubble_body_state there = {};
        uint64_t handle = 0;
        ASSERT_EQ(api()->translate_handle(m_other, here.body, &handle), RUBBLE_OK);
        ASSERT_EQ(api()->get_body_state(m_other, handle, &there), RUBBLE_OK);
        for (int i = 0; i < 3; ++i) EXPECT_EQ(here.position[i], there.position[i]);
    }
    step(60);
    EXPECT_LT(take().size(), 200u) << "nothing breaks: a second costs as much as a step";
}

TEST_F(AbiDeltas, WithoutMotionATakeThatIsMissingIsNoticed) {
    followWithoutMotion();
    step();
    (void)take();
    breakTable();
    step();
    expectRefused(apply(take()), RUBBLE_ERROR_FILE, "expected the delta of step");
}

TEST_F(AbiDeltas, MovedBodiesAreThoseOfTheLastStep) {
    const rubble_body floor = make(bodyAt(3.0, 0.0, RUBBLE_BODY_STATIC));
    make(shapeOn(floor, RUBBLE_SHAPE_BOX, 5));
    step();
    EXPECT_TRUE(movedIn(m_world).empty()) << "nothing moves yet";
    const rubble_body body = make(bodyAt(3.0, 0.55, 0));
    make(shapeOn(body, RUBBLE_SHAPE_BOX, 5));
    step();
    ASSERT_EQ(movedIn(m_world).size(), 1u);
    EXPECT_EQ(movedIn(m_world)[0].body, body);
    auto change = sized<rubble_body_change>();
    change.body = body, change.fields = RUBBLE_SET_POSE;
    change.position[0] = 3.0, change.position[1] = 0.6;
    ASSERT_EQ(api()->set_body(m_world, &change), RUBBLE_OK) << api()->get_last_error();
    step();
    EXPECT_EQ(movedIn(m_world).size(), 1u) << "once, though an edit and physics have moved it";
    int steps = 0;
    while (!movedIn(m_world).empty() && ++steps < 600) {
        EXPECT_EQ(movedIn(m_world)[0].body, body);
        step();
    }
    EXPECT_TRUE(bodyState(body).flags & RUBBLE_BODY_ASLEEP);
    ASSERT_EQ(apply(take()), RUBBLE_OK) << api()->get_last_error();
    EXPECT_TRUE(movedIn(m_other).empty()) << "of the last step that it followed";
    change.body = floor;
    ASSERT_EQ(api()->set_body(m_world, &change), RUBBLE_OK) << api()->get_last_error();
    step();
    ASSERT_EQ(apply(take()), RUBBLE_OK) << api()->get_last_error();
    ASSERT_EQ(movedIn(m_other).size(), movedForOther().size());
    EXPECT_EQ(movedIn(m_other)[0].body, movedForOther()[0].body) << "what edits place, too";
    ASSERT_EQ(api()->load_level(m_world, s_level.c_str(), nullptr), RUBBLE_OK);
    EXPECT_TRUE(movedIn(m_world).empty());
}

TEST_F(AbiDeltas, ManyStepsAreOneTake) {
    breakTable();
    step(30);
    const std::vector<uint8_t> data = take();
    ASSERT_EQ(apply(data), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(resolved(m_world), resolved(m_other));
    EXPECT_LT(take().size(), data.size()) << "what was taken is no longer kept";
}

TEST_F(AbiDeltas, AFollowerTellsOfTheLastStepAndGoesOnByItself) {
    breakTable();
    step();
    ASSERT_EQ(apply(take()), RUBBLE_OK);
    auto events = sized<rubble_events>();
    ASSERT_EQ(api()->get_events(m_other, &events), RUBBLE_OK);
    EXPECT_GT(events.bodies_created_count, 0u);
    for (int i = 0; i < 30; ++i) ASSERT_EQ(api()->step(m_other), RUBBLE_OK) << api()->get_last_error();
    rubble_body_state state = {};
    ASSERT_EQ(api()->get_body_state(m_other, bodies(m_other).back().body, &state), RUBBLE_OK);
    EXPECT_NE(state.position[1], 0.0);
}

TEST_F(AbiDeltas, WithEventsAFollowerTellsWhatTheLeaderTells) {
    auto filter = sized<rubble_report_filter>();
    filter.kinds = RUBBLE_REPORT_BREAK;
    size_t seen[5] = {};
    for (const uint32_t kept : {RUBBLE_DELTAS_ALL, RUBBLE_DELTAS_EDITS}) {
        ASSERT_EQ(api()->load_level(m_world, s_level.c_str(), nullptr), RUBBLE_OK) << api()->get_last_error();
        step();
        if (kept == RUBBLE_DELTAS_EDITS) followWithoutMotion();
        copyTo(m_other, kept | RUBBLE_DELTAS_EVENTS);
        for (const rubble_world world : {m_world, m_other})
            ASSERT_EQ(api()->set_report_filter(world, &filter), RUBBLE_OK) << api()->get_last_error();
        for (int i = 0; i < 40; ++i) {
            if (i % 10 == 0) breakTable();
            step();
            ASSERT_EQ(apply(take()), RUBBLE_OK) << api()->get_last_error();
            const std::vector<std::vector<double>> here = toldBy(m_world), there = toldBy(m_other);
            ASSERT_EQ(here, there) << "step " << i;
            for (size_t kind = 0; kind < here.size(); ++kind) seen[kind] += here[kind].size();
        }
    }
    for (const size_t each : seen) EXPECT_GT(each, 0u);
}

TEST_F(AbiDeltas, EventsCostNothingUntilTheyAreAskedForAndSomethingHappens) {
    std::vector<size_t> sizes;
    for (const uint32_t kept : {RUBBLE_DELTAS_EDITS | 0, RUBBLE_DELTAS_EDITS | RUBBLE_DELTAS_EVENTS})
        for (const bool breaks : {false, true}) {
            ASSERT_EQ(api()->load_level(m_world, s_level.c_str(), nullptr), RUBBLE_OK) << api()->get_last_error();
            step();
            copyTo(m_other, kept);
            if (breaks) breakTable();
            step();
            sizes.push_back(take().size());
        }
    EXPECT_EQ(sizes[2], sizes[0]);
    EXPECT_GT(sizes[3], sizes[1]);
    expectRefused(api()->keep_deltas(m_world, RUBBLE_DELTAS_EVENTS), RUBBLE_ERROR_ARGUMENT,
                  "RUBBLE_DELTAS_EVENTS alone");
    expectRefused(api()->keep_deltas(m_world, RUBBLE_DELTAS_EVENTS | 3), RUBBLE_ERROR_ARGUMENT, "on is 3");
}

TEST_F(AbiDeltas, StepsThatAreMissingOrOfAnotherWorldAreRefused) {
    breakTable();
    step();
    const std::vector<uint8_t> first = take();
    step();
    const std::vector<uint8_t> second = take();
    const uint64_t before = resolved(m_other);
    expectRefused(apply(second), RUBBLE_ERROR_FILE, "found that of step");
    EXPECT_EQ(resolved(m_other), before);
    ASSERT_EQ(apply(first), RUBBLE_OK);
    expectRefused(apply(first), RUBBLE_ERROR_FILE, "expected the delta of step");
    ASSERT_EQ(apply(second), RUBBLE_OK);
    step();
    ASSERT_EQ(api()->step(m_other), RUBBLE_OK);
    expectRefused(apply(take()), RUBBLE_ERROR_FILE, "expected the delta of step");
}

TEST_F(AbiDeltas, ARefusedTakeLeavesRecordingDeltasAndReportsOfTheFollower) {
    const TempFolder folder;
    const std::string log = folder / "follower.rubblelog";
    breakTable();
    step();
    const std::vector<uint8_t> first = take();
    step();
    const std::vector<uint8_t> second = take();
    auto filter = sized<rubble_report_filter>();
    auto reports = sized<rubble_reports>();
    filter.kinds = RUBBLE_REPORT_BREAK;
    const rubble_explosion explosion = tableExplosion();
    ASSERT_EQ(api()->set_report_filter(m_other, &filter), RUBBLE_OK) << api()->get_last_error();
    ASSERT_EQ(api()->keep_deltas(m_other, RUBBLE_DELTAS_ALL), RUBBLE_OK);
    ASSERT_EQ(api()->start_recording(m_other, log.c_str()), RUBBLE_OK) << api()->get_last_error();
    expectRefused(apply(second), RUBBLE_ERROR_FILE, "found that of step");
    ASSERT_EQ(api()->explode(m_other, &explosion), RUBBLE_OK);
    for (int i = 0; i < 2; ++i) {
        ASSERT_EQ(api()->step(m_other), RUBBLE_OK) << api()->get_last_error();
        expectRefused(apply(first), RUBBLE_ERROR_FILE, "expected the delta of step");
        ASSERT_EQ(api()->get_reports(m_other, &reports), RUBBLE_OK);
        EXPECT_EQ(reports.break_count > 0, i == 0) << "those of the step";
    }
    uint64_t size = 0, steps = 0;
    EXPECT_EQ(api()->take_deltas(m_other, nullptr, 0, &size), RUBBLE_OK) << api()->get_last_error();
    ASSERT_EQ(api()->stop_recording(m_other), RUBBLE_OK) << api()->get_last_error();
    ASSERT_EQ(api()->play_recording(m_world, log.c_str(), &steps), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(steps, 2u);
}

/// The content of the first step is wrong, not the frame around it.
TEST_F(AbiDeltas, AStepThatIsRefusedLeavesDeltasOfTheFollower) {
    auto settings = sized<rubble_world_settings>();
    settings.flags = RUBBLE_WORLD_NO_RENDERER;
    rubble_world unrelated = 0;
    ASSERT_EQ(api()->create_world(&settings, &unrelated), RUBBLE_OK) << api()->get_last_error();
    ASSERT_EQ(api()->step(unrelated), RUBBLE_OK) << "as many as the other world has done";
    ASSERT_EQ(api()->keep_deltas(unrelated, RUBBLE_DELTAS_ALL), RUBBLE_OK);
    breakTable();
    step();
    const std::vector<uint8_t> data = take();
    expectRefused(api()->apply_deltas(unrelated, data.data(), data.size()), RUBBLE_ERROR_FILE,
                  "a shape that fits the world before the step");
    uint64_t size = 0;
    EXPECT_EQ(api()->take_deltas(unrelated, nullptr, 0, &size), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(api()->destroy_world(unrelated), RUBBLE_OK);
}

TEST_F(AbiDeltas, WrongBytesAreRefused) {
    copyTo(m_other, RUBBLE_DELTAS_ALL | RUBBLE_DELTAS_EVENTS);
    breakTable();
    step(3);
    const std::vector<uint8_t> good = take();
    const uint64_t before = resolved(m_other);
    for (size_t at = 0; at < good.size(); at += 1 + good.size() / 211) {
        std::vector<uint8_t> bad = good;
        bad[at] ^= 0x04;
        EXPECT_EQ(apply(bad), RUBBLE_ERROR_FILE) << at;
        bad = good;
        bad.resize(at);
        EXPECT_NE(api()->apply_deltas(m_other, bad.data(), bad.size()), RUBBLE_OK) << at;
    }
    EXPECT_EQ(resolved(m_other), before);
    expectRefused(api()->apply_deltas(m_other, nullptr, 5), RUBBLE_ERROR_NULL, "data");
    EXPECT_EQ(apply(good), RUBBLE_OK) << api()->get_last_error();
}

TEST_F(AbiDeltas, ThereAreNoneUnlessTheyAreKept) {
    uint64_t size = 0;
    ASSERT_EQ(api()->keep_deltas(m_world, 0), RUBBLE_OK);
    step();
    expectRefused(api()->take_deltas(m_world, nullptr, 0, &size), RUBBLE_ERROR_ARGUMENT, "keep_deltas()");
    expectRefused(api()->keep_deltas(m_world, 3), RUBBLE_ERROR_ARGUMENT, "on is 3");
    ASSERT_EQ(api()->keep_deltas(m_world, 1), RUBBLE_OK);
    std::vector<uint8_t> small(4);
    step();
    expectRefused(api()->take_deltas(m_world, small.data(), 4, &size), RUBBLE_ERROR_CAPACITY, "the array holds 4");
    EXPECT_GT(size, 4u);
    ASSERT_EQ(api()->load_level(m_world, s_level.c_str(), nullptr), RUBBLE_OK);
    expectRefused(api()->take_deltas(m_world, nullptr, 0, &size), RUBBLE_ERROR_ARGUMENT, "keep_deltas()");
}

}  // namespace
}  // namespace rubble
