#include <algorithm>
#include <cmath>

#include "tests/abi/create_fixture.h"

namespace rubble {
namespace {

/// Free cubes of concrete that float, without gravity.
class AbiConstraints : public AbiCreate {
protected:
    void SetUp() override {
        AbiCreate::SetUp();
        auto environment = sized<rubble_environment>();
        ASSERT_EQ(api()->get_environment(m_world, &environment), RUBBLE_OK);
        std::fill_n(environment.gravity, 3, 0.0);
        ASSERT_EQ(api()->set_environment(m_world, &environment), RUBBLE_OK);
    }
    /// Of `side` cells of 0.1 m, from x on, with its middle at a height of 20.2 and a z of 0.2.
    rubble_body cubeAt(double x, int32_t side) {
        rubble_body_settings settings = bodyAt(x, 20.2 - 0.05 * side, 0);
        settings.position[2] = 0.2 - 0.05 * side;
        const rubble_body body = make(settings);
        make(shapeOn(body, RUBBLE_SHAPE_BOX, side));
        step();
        return body;
    }
    double massOf(rubble_body body) {
        auto properties = sized<rubble_body_properties>();
        EXPECT_EQ(api()->get_body_properties(m_world, body, &properties), RUBBLE_OK);
        return properties.mass;
    }
    /// A point of the cube's middle is held along x, or it turns about x.
    static rubble_body_constraint alongX(rubble_body body, double x, double speed) {
        auto out = sized<rubble_body_constraint>();
        out.body = body, out.direction[0] = 3.0, out.speed = speed;
        out.position[0] = x, out.position[1] = 20.2, out.position[2] = 0.2;
        return out;
    }
    void constrain(const rubble_body_constraint& constraint) {
        ASSERT_EQ(api()->constrain_bodies(m_world, &constraint), RUBBLE_OK) << api()->get_last_error();
    }
    double velocityOf(rubble_body body) { return bodyState(body).velocity[0]; }
};

TEST_F(AbiConstraints, TwoBodiesPartAtTheSpeedAndKeepTheirMomentum) {
    const rubble_body light = cubeAt(0.0, 4), heavy = cubeAt(2.0, 8);
    rubble_body_constraint part = alongX(light, 0.2, -3.0);
    part.other = heavy;
    constrain(part);
    step();
    EXPECT_NEAR(velocityOf(light) - velocityOf(heavy), -3.0, 0.02);
    EXPECT_NEAR(massOf(light) * velocityOf(light), -massOf(heavy) * velocityOf(heavy), 0.01 * massOf(light));
    step(30);
    EXPECT_NEAR(velocityOf(light) - velocityOf(heavy), -3.0, 0.1) << "nothing holds them any more, nothing slows them";
}

TEST_F(AbiConstraints, ALimitedForceGivesNoMoreThanItsImpulse) {
    const rubble_body cube = cubeAt(0.0, 4);
    rubble_body_constraint pull = alongX(cube, 0.2, 100.0);
    pull.max_force = 60.0 * massOf(cube);
    constrain(pull);
    step();
    EXPECT_NEAR(velocityOf(cube), 1.0, 1e-3);
    pull.speed = -100.0;  // it may not pull back
    constrain(pull);
    step();
    EXPECT_NEAR(velocityOf(cube), 1.0, 1e-3);
}

TEST_F(AbiConstraints, ItHoldsAVelocityAgainstAPush) {
    const rubble_body cube = cubeAt(0.0, 4);
    auto push = sized<rubble_impulse>();
    push.body = cube, push.position[0] = push.position[2] = 0.2, push.position[1] = 20.2;
    push.impulse[0] = 10.0 * massOf(cube);
    ASSERT_EQ(api()->apply_impulse(m_world, &push), RUBBLE_OK);
    constrain(alongX(cube, 0.2, 0.0));
    step();
    EXPECT_NEAR(velocityOf(cube), 0.0, 1e-3);
}

TEST_F(AbiConstraints, ItTurnsABodyAboutItsDirection) {
    const rubble_body cube = cubeAt(0.0, 4);
    rubble_body_constraint spin = alongX(cube, 0.0, 5.0);
    spin.kind = RUBBLE_CONSTRAINT_ANGULAR_VELOCITY;
    constrain(spin);
    step();
    EXPECT_NEAR(bodyState(cube).angular_velocity[0], 5.0, 0.01);
    EXPECT_NEAR(bodyState(cube).angular_velocity[1], 0.0, 1e-3);
    EXPECT_NEAR(velocityOf(cube), 0.0, 1e-6);
}

TEST_F(AbiConstraints, ItWakesASleeperAndOneThatIsHeldStaysAwake) {
    const rubble_body cube = cubeAt(0.0, 4);
    step(200);
    ASSERT_TRUE(bodyState(cube).flags & RUBBLE_BODY_ASLEEP);
    for (int i = 0; i < 200; ++i) {
        constrain(alongX(cube, 0.2, 0.0));
        step();
    }
    EXPECT_FALSE(bodyState(cube).flags & RUBBLE_BODY_ASLEEP);
}

TEST_F(AbiConstraints, ABodyThatIsGoneByThenIsNotHeldAtItsPlace) {
    const rubble_body cube = cubeAt(0.0, 4), other = cubeAt(2.0, 4);
    rubble_body_constraint part = alongX(cube, 0.2, 3.0);
    part.other = other;
    constrain(part);
    ASSERT_EQ(api()->destroy_body(m_world, other), RUBBLE_OK);
    step();
    EXPECT_EQ(velocityOf(cube), 0.0);
}

TEST_F(AbiConstraints, ARecordingHasThem) {
    const rubble_body cube = cubeAt(0.0, 4);
    const std::string path = testing::TempDir() + "constraints.rubblelog";
    ASSERT_EQ(api()->start_recording(m_world, path.c_str()), RUBBLE_OK) << api()->get_last_error();
    constrain(alongX(cube, 0.2, 2.0));
    step(3);
    ASSERT_EQ(api()->stop_recording(m_world), RUBBLE_OK);
    const uint64_t there = hash();
    uint64_t steps = 0;
    ASSERT_EQ(api()->play_recording(m_world, path.c_str(), &steps), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(hash(), there);
    std::filesystem::remove(path);
}

TEST_F(AbiConstraints, WhatHoldsNothingIsRefused) {
    const rubble_body cube = cubeAt(0.0, 4);
    rubble_body_constraint bad = alongX(cube, 0.2, 1.0);
    bad.direction[0] = 0.0;
    expectRefused(api()->constrain_bodies(m_world, &bad), RUBBLE_ERROR_ARGUMENT, "direction is zero");
    bad = alongX(cube, 0.2, 1.0), bad.other = cube;
    expectRefused(api()->constrain_bodies(m_world, &bad), RUBBLE_ERROR_ARGUMENT, "other is the body itself");
    bad = alongX(cube, 0.2, 1.0), bad.min_force = 2.0, bad.max_force = 1.0;
    expectRefused(api()->constrain_bodies(m_world, &bad), RUBBLE_ERROR_ARGUMENT, "min_force is 2");
    bad = alongX(cube, 0.2, 1.0), bad.kind = 2;
    expectRefused(api()->constrain_bodies(m_world, &bad), RUBBLE_ERROR_ARGUMENT, "kind is 2");
}

}  // namespace
}  // namespace rubble
