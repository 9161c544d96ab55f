#include <array>
#include <cmath>
#include <vector>

#include "runtime/core/constants.h"
#include "tests/abi/create_fixture.h"

namespace rubble {
namespace {

TEST_F(Abi, JointsAreMadeReadAndRemoved) {
    auto table = sized<rubble_joint_settings>();
    table.kind = RUBBLE_JOINT_ROPE;
    const rubble_body body = bodies(m_world).at(0).body;
    std::array<rubble_shape_state, 1> shape{};
    uint32_t count = 0;
    ASSERT_EQ(api()->get_shape_states(m_world, body, shape.data(), 1, &count), RUBBLE_OK);
    table.shapes[0] = shape[0].shape;
    table.position[0] = table.position[1] = table.position[2] = 0.85;
    table.rope_end[1] = 4.0;
    ASSERT_EQ(api()->add_joint(m_world, &table), RUBBLE_OK) << api()->get_last_error();
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    std::array<rubble_joint_state, 2> joints{};
    ASSERT_EQ(api()->get_joint_states(m_world, joints.data(), 2, &count), RUBBLE_OK);
    ASSERT_EQ(count, 1u);
    EXPECT_EQ(joints[0].shapes[0], shape[0].shape);
    ASSERT_GE(joints[0].rope_point_count, 3u);
    std::vector<double> points(3 * joints[0].rope_point_count);
    ASSERT_EQ(api()->get_rope_points(m_world, joints[0].joint, points.data(), uint32_t(points.size()), &count),
              RUBBLE_OK);
    EXPECT_EQ(count, points.size());
    EXPECT_NEAR(points[1], 0.85, 1e-6);
    std::vector<rubble_rope_point> rope(joints[0].rope_point_count);
    ASSERT_EQ(api()->get_ropes(m_world, rope.data(), uint32_t(rope.size()), &count), RUBBLE_OK);
    ASSERT_EQ(count, rope.size());
    for (size_t i = 0; i < rope.size(); ++i) {
        EXPECT_EQ(rope[i].joint, joints[0].joint);
        EXPECT_EQ(rope[i].position[1], points[3 * i + 1]);
        EXPECT_EQ(rope[i].is_last, i + 1 == rope.size() ? 1u : 0u);
        EXPECT_NEAR(rope[i].radius, 0.03, 1e-6);
    }
    auto motor = sized<rubble_joint_motor>();
    motor.joint = joints[0].joint;
    motor.motor = 3;
    EXPECT_EQ(api()->set_joint_motor(m_world, &motor), RUBBLE_ERROR_ARGUMENT);
    motor.motor = RUBBLE_MOTOR_SPEED;
    EXPECT_EQ(api()->set_joint_motor(m_world, &motor), RUBBLE_OK);
    auto grab = sized<rubble_grab>();
    EXPECT_EQ(api()->grab_body(m_world, &grab), RUBBLE_ERROR_STALE);
    auto release = sized<rubble_release>();
    EXPECT_EQ(api()->release_body(m_world, &release), RUBBLE_OK);
    ASSERT_EQ(api()->remove_joint(m_world, joints[0].joint), RUBBLE_OK);
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    EXPECT_EQ(api()->remove_joint(m_world, joints[0].joint), RUBBLE_ERROR_STALE);
    table.kind = 7;
    EXPECT_EQ(api()->add_joint(m_world, &table), RUBBLE_ERROR_ARGUMENT);
    table.kind = RUBBLE_JOINT_FIXED;
    table.shapes[1] = table.shapes[0];
    expectRefused(api()->add_joint(m_world, &table), RUBBLE_ERROR_ARGUMENT, "both ends are on one body");
    table.kind = RUBBLE_JOINT_ROPE;
    EXPECT_EQ(api()->add_joint(m_world, &table), RUBBLE_OK);
}

TEST_F(Abi, AnglesOfJointsAreWithinHalfATurn) {
    auto joint = sized<rubble_joint_settings>();
    rubble_shape_state shape{};
    uint32_t count = 0;
    ASSERT_EQ(api()->get_shape_states(m_world, bodies(m_world).at(0).body, &shape, 1, &count), RUBBLE_OK);
    joint.shapes[0] = shape.shape;
    joint.position[0] = joint.position[1] = joint.position[2] = 0.85;
    joint.kind = RUBBLE_JOINT_HINGE, joint.flags = RUBBLE_JOINT_LIMITED;
    joint.lower_limit = -4.0, joint.upper_limit = 4.0;
    rubble_joint made = 0;
    expectRefused(api()->create_joint(m_world, &joint, &made), RUBBLE_ERROR_ARGUMENT, "lower_limit is -4, expected");
    joint.lower_limit = -kPi;
    expectRefused(api()->create_joint(m_world, &joint, &made), RUBBLE_ERROR_ARGUMENT, "upper_limit is 4, expected");
    joint.upper_limit = kPi;
    joint.motor = RUBBLE_MOTOR_POSITION, joint.motor_target = 100.0;
    expectRefused(api()->create_joint(m_world, &joint, &made), RUBBLE_ERROR_ARGUMENT, "motor_target is 100, expected");
    joint.motor_target = 3.0;
    EXPECT_EQ(api()->create_joint(m_world, &joint, &made), RUBBLE_OK) << api()->get_last_error();
    step();
    auto motor = sized<rubble_joint_motor>();
    motor.joint = made, motor.motor = RUBBLE_MOTOR_POSITION, motor.motor_target = 100.0;
    expectRefused(api()->set_joint_motor(m_world, &motor), RUBBLE_ERROR_ARGUMENT, "motor_target is 100, expected");
    motor.motor = RUBBLE_MOTOR_SPEED;
    EXPECT_EQ(api()->set_joint_motor(m_world, &motor), RUBBLE_OK) << "rad/s";
    joint.kind = RUBBLE_JOINT_CONE, joint.motor = RUBBLE_MOTOR_OFF, joint.upper_limit = 4.0;
    expectRefused(api()->create_joint(m_world, &joint, &made), RUBBLE_ERROR_ARGUMENT, "upper_limit is 4, expected");
}

TEST_F(Abi, WheelsAreDriven) {
    const auto addWheel = [](rubble_world world, double steerAngle) {
        rubble_shape_state shape{};
        uint32_t count = 0;
        EXPECT_EQ(api()->get_shape_states(world, bodies(world).at(0).body, &shape, 1, &count), RUBBLE_OK);
        auto wheel = sized<rubble_joint_settings>();
        wheel.kind = RUBBLE_JOINT_WHEEL;
        wheel.shapes[0] = shape.shape;
        wheel.position[0] = wheel.position[1] = wheel.position[2] = 0.85;
        wheel.drive_torque = 1000.0;
        wheel.max_steer_angle = steerAngle;
        return api()->add_joint(world, &wheel);
    };
    const auto hashOf = [](rubble_world world) {
        uint64_t value = 0;
        EXPECT_EQ(api()->get_state_hash(world, &value), RUBBLE_OK);
        return value;
    };
    const auto stepBoth = [&](rubble_world other) {
        for (const rubble_world world : {m_world, other}) EXPECT_EQ(api()->step(world), RUBBLE_OK);
    };
    const rubble_world idle = makeWorld();  // equal, but nothing drives its wheel
    EXPECT_EQ(addWheel(m_world, -1.0), RUBBLE_ERROR_ARGUMENT) << "the angle is one for both sides";
    for (const rubble_world world : {m_world, idle})
        ASSERT_EQ(addWheel(world, 0.5), RUBBLE_OK) << api()->get_last_error();
    stepBoth(idle);
    EXPECT_EQ(hashOf(m_world), hashOf(idle));
    auto drive = sized<rubble_drive>();
    EXPECT_EQ(api()->drive_wheels(m_world, &drive), RUBBLE_ERROR_STALE);
    drive.body = bodies(m_world).at(0).body;
    drive.throttle = 1.5;
    EXPECT_EQ(api()->drive_wheels(m_world, &drive), RUBBLE_ERROR_ARGUMENT);
    drive.throttle = 0.5;
    ASSERT_EQ(api()->drive_wheels(m_world, &drive), RUBBLE_OK) << api()->get_last_error();
    stepBoth(idle);
    EXPECT_NE(hashOf(m_world), hashOf(idle));
    EXPECT_EQ(api()->destroy_world(idle), RUBBLE_OK);
}

TEST_F(AbiCreate, AJointSaysItsLimitsAndWhereItsMotionIs) {
    const rubble_body body = make(bodyAt(20.0, 20.0, 0));
    const rubble_shape shape = make(shapeOn(body, RUBBLE_SHAPE_BOX, 4));
    auto settings = sized<rubble_joint_settings>();
    settings.shapes[1] = shape, settings.kind = RUBBLE_JOINT_HINGE;
    settings.position[0] = 20.2, settings.position[1] = 20.2, settings.position[2] = 0.2;
    settings.rotation[2] = settings.rotation[3] = std::sqrt(0.5);  // about y
    settings.anchor_radius = 0.4;
    settings.flags = RUBBLE_JOINT_LIMITED | RUBBLE_JOINT_COLLIDES;
    settings.lower_limit = -1.0, settings.upper_limit = 2.0, settings.friction = 3.0, settings.break_force = 1e6;
    settings.motor = RUBBLE_MOTOR_SPEED, settings.motor_target = 1.0, settings.motor_max_force = 1e6;
    rubble_joint joint = 0;
    ASSERT_EQ(api()->create_joint(m_world, &settings, &joint), RUBBLE_OK) << api()->get_last_error();
    auto now = sized<rubble_joint_properties>();
    expectRefused(api()->get_joint_properties(m_world, joint, &now), RUBBLE_ERROR_STALE, "joint");
    step(30);
    ASSERT_EQ(api()->get_joint_properties(m_world, joint, &now), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(now.kind, uint32_t(RUBBLE_JOINT_HINGE));
    EXPECT_EQ(now.flags, settings.flags);
    EXPECT_EQ(now.lower_limit, -1.0);
    EXPECT_EQ(now.upper_limit, 2.0);
    EXPECT_EQ(now.motor_target, 1.0);
    EXPECT_EQ(now.friction, 3.0);
    EXPECT_EQ(now.break_force, 1e6);
    EXPECT_NEAR(now.movement, 0.5, 0.02) << "half a second at 1 rad/s";
    for (int i = 0; i < 4; ++i)
        EXPECT_NEAR(now.rotation[i], settings.rotation[i], 1e-12) << "its first end is the world";
    EXPECT_EQ(now.anchor_radius, 0.4);
    rubble_joint_state row = {};
    ASSERT_EQ(api()->get_joint_state(m_world, joint, &row), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(row.joint, joint);
    EXPECT_EQ(row.shapes[1], shape);
    EXPECT_EQ(now.max_spin, 0.0) << "only wheels have that";
}

TEST_F(AbiCreate, AWheelSaysHowItDrivesSteersAndBrakes) {
    auto settings = sized<rubble_joint_settings>();
    settings.kind = RUBBLE_JOINT_WHEEL;
    settings.shapes[0] = make(shapeOn(make(bodyAt(20.0, 20.0, 0)), RUBBLE_SHAPE_BOX, 4));
    settings.shapes[1] = make(shapeOn(make(bodyAt(20.5, 20.0, 0)), RUBBLE_SHAPE_BOX, 4));
    settings.position[0] = 20.45, settings.position[1] = 20.2, settings.position[2] = 0.2;
    settings.anchor_radius = 0.4;
    settings.drive_torque = 700.0, settings.brake_torque = 900.0;
    settings.max_spin = 40.0, settings.max_steer_angle = 0.5;
    rubble_joint joint = 0;
    ASSERT_EQ(api()->create_joint(m_world, &settings, &joint), RUBBLE_OK) << api()->get_last_error();
    step(1);
    auto now = sized<rubble_joint_properties>();
    ASSERT_EQ(api()->get_joint_properties(m_world, joint, &now), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(now.drive_torque, 700.0);
    EXPECT_EQ(now.brake_torque, 900.0);
    EXPECT_EQ(now.max_spin, 40.0);
    EXPECT_EQ(now.max_steer_angle, 0.5);
    EXPECT_EQ(now.steer_rate, 2.0) << "the default";
}

}  // namespace
}  // namespace rubble
