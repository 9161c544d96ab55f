#include <string>
#include <vector>

#include "tests/abi/create_fixture.h"

namespace rubble {
namespace {

/// A world and another one that was equal when the first began to keep deltas.
class AbiDeltas : public AbiCreate {
protected:
    void SetUp() override {
        AbiCreate::SetUp();
        m_other = makeWorld();
        copyTo(m_other);
    }
    void TearDown() override {
        api()->destroy_world(m_other);
        AbiCreate::TearDown();
    }
    void copyTo(rubble_world other) {
        uint64_t size = 0;
        ASSERT_EQ(api()->keep_deltas(m_world, 1), RUBBLE_OK) << api()->get_last_error();
        ASSERT_EQ(api()->save_game_data(m_world, nullptr, 0, &size), RUBBLE_OK);
        std::vector<uint8_t> data(size);
        ASSERT_EQ(api()->save_game_data(m_world, data.data(), size, &size), RUBBLE_OK);
        ASSERT_EQ(api()->load_game_data(other, data.data(), size), RUBBLE_OK) << api()->get_last_error();
    }
    std::vector<uint8_t> take() {
        uint64_t size = 0;
        EXPECT_EQ(api()->take_deltas(m_world, nullptr, 0, &size), RUBBLE_OK) << api()->get_last_error();
        std::vector<uint8_t> out(size);
        EXPECT_EQ(api()->take_deltas(m_world, out.data(), size, &size), RUBBLE_OK) << api()->get_last_error();
        return out;
    }
    rubble_result apply(const std::vector<uint8_t>& data) {
        return api()->apply_deltas(m_other, data.data(), data.size());
    }
    static uint64_t resolved(rubble_world world) {
        uint64_t out = 0;
        EXPECT_EQ(api()->get_resolved_hash(world, &out), RUBBLE_OK) << api()->get_last_error();
        return out;
    }
    void breakTable() {
        const rubble_explosion explosion = tableExplosion();
        ASSERT_EQ(api()->explode(m_world, &explosion), RUBBLE_OK);
    }

    rubble_world m_other = 0;
};

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

/// A follower reads palettes anew; only other colours make meshes stale.
TEST_F(AbiDeltas, MeshesOfAWorldThatFollowsAreUpdatedByBricks) {
    const rubble_shape wall = make(shapeOn(make(bodyAt(10.0, 0.0, RUBBLE_BODY_STATIC)), RUBBLE_SHAPE_BOX, 40));
    step();
    copyTo(m_other);
    uint64_t version = 0;
    std::vector<rubble_brick> bricks(1000);
    const auto list = [&](uint32_t& count) {
        auto changes = sized<rubble_brick_changes>();
        changes.shape = wall, changes.what = RUBBLE_BRICKS_MESHES, changes.since = version;
        return api()->get_changed_bricks(m_other, &changes, &version, bricks.data(), uint32_t(bricks.size()), &count);
    };
    uint32_t whole = 0, changed = 0;
    ASSERT_EQ(list(whole), RUBBLE_OK);
    auto carve = sized<rubble_carve>();
    carve.position[0] = 10.0, carve.radii[0] = carve.radii[1] = carve.radii[2] = 0.35, carve.shape = wall;
    ASSERT_EQ(api()->carve(m_world, &carve), RUBBLE_OK);
    step();
    ASSERT_EQ(apply(take()), RUBBLE_OK) << api()->get_last_error();
    ASSERT_EQ(list(changed), RUBBLE_OK) << api()->get_last_error();
    EXPECT_GT(changed, 0u);
    EXPECT_LT(changed, whole / 4);
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
    rubble_body_state state = {};
    ASSERT_EQ(api()->get_body_state(m_world, body, &state), RUBBLE_OK);
    ASSERT_TRUE(state.flags & RUBBLE_BODY_ASLEEP);
    (void)take();
    ASSERT_EQ(api()->destroy_shape(m_world, make(shapeOn(body, RUBBLE_SHAPE_BOX, 5))), RUBBLE_OK);
    step();
    ASSERT_EQ(api()->get_body_state(m_world, body, &state), RUBBLE_OK);
    EXPECT_FALSE(state.flags & RUBBLE_BODY_ASLEEP);
    ASSERT_EQ(apply(take()), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(resolved(m_world), resolved(m_other));
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

TEST_F(AbiDeltas, WrongBytesAreRefused) {
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
    expectRefused(api()->keep_deltas(m_world, 2), RUBBLE_ERROR_ARGUMENT, "on is 2");
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
