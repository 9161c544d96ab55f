// Who sleeps: beside other edits of a step, and after an undo.
#include <functional>

#include "tests/abi/create_fixture.h"

namespace rubble {
namespace {

/// A body that hangs asleep in the air, and what may wake it.
class AbiSleep : public AbiCreate {
protected:
    struct Edit {
        const char* what;
        std::function<rubble_result()> apply;
    };
    rubble_body hang(uint32_t flags) {
        m_body = make(bodyAt(20.0, 10.0, flags));
        m_shape = make(shapeOn(m_body, RUBBLE_SHAPE_BOX, 8));
        return m_body;
    }
    rubble_body_state state() {
        rubble_body_state out = {};
        EXPECT_EQ(api()->get_body_state(m_world, m_body, &out), RUBBLE_OK);
        return out;
    }
    bool isAsleep() { return state().flags & RUBBLE_BODY_ASLEEP; }
    std::vector<Edit> edits() {
        return {{"collision filter",
                 [&] {
                     auto filter = sized<rubble_collision_filter>();
                     filter.shape = m_shape, filter.layer = 2;
                     return api()->set_collision_filter(m_world, &filter);
                 }},
                {"collision shape",
                 [&] {
                     auto kind = sized<rubble_collision_shape>();
                     kind.shape = m_shape, kind.kind = 1;
                     return api()->set_collision_shape(m_world, &kind);
                 }},
                {"density",
                 [&] {
                     auto change = sized<rubble_shape_change>();
                     change.shape = m_shape, change.fields = RUBBLE_SHAPE_DENSITY, change.density = 2.0;
                     return api()->set_shape(m_world, &change);
                 }},
                {"gravity scale and damping",
                 [&] {
                     auto change = sized<rubble_body_change>();
                     change.body = m_body, change.fields = RUBBLE_SET_GRAVITY_SCALE | RUBBLE_SET_DAMPING;
                     change.gravity_scale = 0.5, change.linear_damping = 0.1;
                     return api()->set_body(m_world, &change);
                 }},
                {"water around it",
                 [&] {
                     static constexpr double kOutline[8] = {15, -5, 25, -5, 25, 5, 15, 5};
                     auto water = sized<rubble_water_settings>();
                     water.outline = kOutline, water.outline_count = 4, water.surface_height = 12, water.depth = 12;
                     return api()->add_water(m_world, &water);
                 }},
                {"hand", [&] {
                     auto grab = sized<rubble_grab>();
                     grab.body = m_body, grab.point[0] = 20.4, grab.point[1] = 10.4, grab.point[2] = 0.4;
                     grab.target[0] = 20.0, grab.target[1] = 12.0;
                     return api()->grab_body(m_world, &grab);
                 }}};
    }
    rubble_body m_body = 0;
    rubble_shape m_shape = 0;
};

TEST_F(AbiSleep, AnUndoLeavesAsleepWhoSleptAtTheMark) {
    hang(RUBBLE_BODY_ASLEEP);
    step(20);
    ASSERT_TRUE(isAsleep());
    ASSERT_EQ(api()->set_undo_limit(m_world, 5), RUBBLE_OK);
    step();
    for (const Edit& edit : edits()) {
        ASSERT_EQ(api()->add_undo_mark(m_world), RUBBLE_OK);
        step();
        ASSERT_EQ(edit.apply(), RUBBLE_OK) << edit.what << ": " << api()->get_last_error();
        step(10);
        ASSERT_EQ(api()->undo(m_world), RUBBLE_OK);
        step(30);
        EXPECT_TRUE(isAsleep()) << edit.what;
        EXPECT_EQ(state().position[1], 10.0) << edit.what;
    }
}

TEST_F(AbiSleep, WhatIsPutToSleepSleepsBesideOtherEditsOfItsStep) {
    for (const bool isMade : {true, false}) {
        for (const Edit& edit : edits()) {
            if (std::string(edit.what) == "hand") continue;  // it pulls
            hang(isMade ? uint32_t(RUBBLE_BODY_ASLEEP) : 0u);
            if (!isMade) step();
            ASSERT_EQ(edit.apply(), RUBBLE_OK) << edit.what << ": " << api()->get_last_error();
            if (!isMade) {
                auto change = sized<rubble_body_change>();
                change.body = m_body, change.fields = RUBBLE_SET_ASLEEP;
                ASSERT_EQ(api()->set_body(m_world, &change), RUBBLE_OK);
            }
            step(30);
            EXPECT_TRUE(isAsleep()) << edit.what << (isMade ? ", made asleep" : ", put to sleep");
            ASSERT_EQ(api()->destroy_body(m_world, m_body), RUBBLE_OK);
            step();
        }
    }
}

TEST_F(AbiSleep, WhatIsPutToSleepOnAJointWithSomethingAwakeFallsWithIt) {
    for (const Edit& edit : edits()) {
        if (std::string(edit.what) == "hand" || std::string(edit.what) == "water around it") continue;  // they hold
        const rubble_body other = make(bodyAt(21.0, 10.0, 0));
        auto ball = sized<rubble_joint_settings>();
        ball.kind = RUBBLE_JOINT_BALL;
        ball.shapes[1] = make(shapeOn(other, RUBBLE_SHAPE_BOX, 8));
        hang(0);
        ball.shapes[0] = m_shape;
        ball.position[0] = 20.9, ball.position[1] = 10.4, ball.position[2] = 0.4;
        ASSERT_EQ(api()->add_joint(m_world, &ball), RUBBLE_OK) << api()->get_last_error();
        step();
        ASSERT_EQ(edit.apply(), RUBBLE_OK) << edit.what << ": " << api()->get_last_error();
        auto change = sized<rubble_body_change>();
        change.body = m_body, change.fields = RUBBLE_SET_ASLEEP;
        ASSERT_EQ(api()->set_body(m_world, &change), RUBBLE_OK);
        step(40);
        EXPECT_FALSE(isAsleep()) << edit.what;
        EXPECT_LT(state().position[1], 9.5) << edit.what;
        for (const rubble_body body : {m_body, other}) ASSERT_EQ(api()->destroy_body(m_world, body), RUBBLE_OK);
        step();
    }
}

}  // namespace
}  // namespace rubble
