#include <gtest/gtest.h>

#include <cmath>

#include "tests/runtime/world/worlds.h"
#include "tests/support/grids.h"

namespace rubble {
namespace {

using namespace test;

/// A chassis of 20 x 2 x 4 cells with a wheel below each end. The front one, at +x, drives and steers; both brake.
Level cart() {
    Level level = oneShapeLevel(solidGrid({20, 2, 4}), false, {{0.0, 1.0, 0.0}});
    for (int i = 0; i < 2; ++i) {
        LevelBody wheel{.name = "wheel", .isStatic = false};
        wheel.shapes.push_back(levelShape(i ? "front" : "back", solidGrid({2, 2, 2})));
        wheel.pose.position = {i ? 1.7 : 0.1, 0.75, 0.1};
        level.bodies.push_back(wheel);
        LevelJoint joint{{.name = "axle", .kind = JointKind::Wheel}, {"shape", i ? "front" : "back"}};
        joint.joint.ends[0].frame.position = {i ? 1.8 : 0.2, 0.0, 0.2};
        joint.joint.ends[1].frame.position = {0.1, 0.1, 0.1};
        joint.joint.wheel = {.driveTorque = i ? 200.0 : 0.0,
                             .maxSpin = 40.0,
                             .brakeTorque = 500.0,
                             .steerAngle = i ? 0.5 : 0.0,
                             .steerRate = 3.0};
        level.joints.push_back(joint);
    }
    return level;
}

struct Cart {
    World world;
    BodyHandle body;
    Cart() {
        world.load(cart());
        world.applyEdits({});
        body = world.shapes().at(wheel(1).ends[0].shape).body;
    }
    const Joint& wheel(uint32_t i) const { return world.joints().at(world.joints().handleAt(i)); }
    size_t drive(double throttle, double steer, double brake) {
        return world.applyEdits({DriveEdit{body, throttle, steer, brake}}).jointsChanged.size();
    }
};

TEST(Drive, WheelsFollowTheirSettings) {
    Cart cart;
    cart.drive(0.5, 0.0, 0.0);
    EXPECT_EQ(cart.wheel(0).motor.mode, MotorMode::Off);
    EXPECT_EQ(cart.wheel(1).motor.mode, MotorMode::Speed);
    EXPECT_EQ(cart.wheel(1).motor.target, 40.0);
    EXPECT_EQ(cart.wheel(1).motor.maxForce, 100.0);
    cart.drive(-1.0, 0.0, 0.0);
    EXPECT_EQ(cart.wheel(1).motor.target, -20.0);
    cart.drive(0.0, 0.0, 1.0);
    EXPECT_EQ(cart.wheel(1).motor.mode, MotorMode::Off);
    for (uint32_t i = 0; i < 2; ++i) EXPECT_NEAR(cart.wheel(i).friction, 500.0, 10.0);
}

TEST(Drive, OnlySteeredWheelsSteerAtTheirRate) {
    Cart cart;
    int steps = 0;
    for (; cart.wheel(1).steer < 0.5 - 1e-9 && steps < 100; ++steps) cart.drive(0.0, 1.0, 0.0);
    EXPECT_EQ(steps, 10);  // 0.5 rad at 3 rad/s
    cart.drive(0.0, 1.0, 0.0);
    EXPECT_EQ(cart.wheel(1).steer, 0.5);
    EXPECT_EQ(cart.wheel(0).steer, 0.0);
    EXPECT_EQ(cart.drive(0.0, 1.0, 0.0), 0u) << "nothing changes, nothing wakes";
}

TEST(Drive, OneCommandSteersUntilTheWheelsAreThere) {
    Cart cart;
    cart.drive(0.0, 1.0, 0.0);
    EXPECT_NEAR(cart.wheel(1).steer, 0.05, 1e-12) << "3 rad/s";
    EXPECT_EQ(cart.world.data().jointIndex.turning().size(), 1u) << "steps look at wheels that turn";
    EXPECT_TRUE(cart.world.data().isBusy());
    World copy = cart.world;  // as a save made while they turn
    for (int i = 0; i < 8; ++i) cart.world.applyEdits({});
    EXPECT_LT(cart.wheel(1).steer, 0.5);
    EXPECT_EQ(cart.world.applyEdits({}).jointsChanged.size(), 1u);
    EXPECT_EQ(cart.wheel(1).steer, 0.5);
    EXPECT_TRUE(cart.world.applyEdits({}).jointsChanged.empty()) << "nothing turns any more";
    EXPECT_TRUE(cart.world.data().jointIndex.turning().empty());
    EXPECT_FALSE(cart.world.data().isBusy());
    copy.applyEdits({SetJointMotorEdit{.joint = copy.joints().handleAt(1), .steer = 0.2}});
    for (int i = 0; i < 3; ++i) copy.applyEdits({});
    EXPECT_EQ(copy.joints().at(copy.joints().handleAt(1)).steer, 0.2) << "a motor's angle ends the turning";
    EXPECT_TRUE(copy.data().jointIndex.turning().empty());
}

/// Two wheels that stand still and two that turn, ahead of them or behind.
TEST(Drive, AxlesMeetInOnePoint) {
    for (const double ahead : {1.6, -1.6})
        for (const double steer : {-1.0, -0.3, 0.2, 1.0}) {
            Level level = oneShapeLevel(solidGrid({20, 2, 10}), false, {{0.0, 1.0, 0.0}});
            for (int i = 0; i < 4; ++i) {
                const bool steers = i / 2;
                LevelBody wheel{.name = "wheel", .isStatic = false};
                wheel.shapes.push_back(levelShape("wheel " + std::to_string(i), solidGrid({2, 2, 2})));
                level.bodies.push_back(wheel);
                LevelJoint joint{{.name = "axle", .kind = JointKind::Wheel}, {"shape", wheel.shapes[0].name}};
                const glm::dquat leftward(std::sqrt(0.5), 0.0, std::sqrt(0.5), 0.0);  // x to -z: +x is ahead
                joint.joint.ends[0].frame = {{1.0 + (steers ? 0.5 : -0.5) * ahead, 0.0, i % 2 ? 0.9 : 0.1}, leftward};
                joint.joint.wheel = {.steerAngle = steers ? 0.5 : 0.0, .steerRate = 100.0};
                level.joints.push_back(joint);
            }
            World world;
            world.load(level);
            world.applyEdits({});
            const auto wheel = [&](uint32_t i) { return world.joints().at(world.joints().handleAt(i)); };
            world.applyEdits({DriveEdit{world.shapes().at(wheel(0).ends[0].shape).body, 0.0, steer, 0.0}});
            EXPECT_EQ(wheel(0).steer, 0.0);
            const double center = 0.5 - ahead / std::tan(0.5 * steer);  // z on the line of the fixed wheels
            for (const uint32_t i : {2u, 3u})
                EXPECT_NEAR(std::tan(wheel(i).steer), ahead / (wheel(i).ends[0].frame.position.z - center), 1e-9);
        }
}

TEST(Drive, DetachedPartsKeepTheirWheels) {
    Cart cart;
    const FrameChanges cut = cart.world.applyEdits(
        {sphereCarve(cart.world.bodies().at(cart.body).pose.transformPoint({1.0, 0.1, 0.2}), 0.35)});
    ASSERT_EQ(cut.splits.size(), 1u);
    const BodyHandle front = cart.world.shapes().at(cart.wheel(1).ends[0].shape).body,
                     back = cart.world.shapes().at(cart.wheel(0).ends[0].shape).body;
    ASSERT_NE(front, back);
    cart.body = back;
    cart.drive(1.0, 0.0, 0.0);
    EXPECT_EQ(cart.wheel(1).motor.mode, MotorMode::Off);
    cart.body = front;
    cart.drive(1.0, 0.0, 0.0);
    EXPECT_EQ(cart.wheel(1).motor.mode, MotorMode::Speed);
}

TEST(Drive, InvalidInputIsRefused) {
    Cart cart;
    EXPECT_EQ(cart.drive(2.0, 0.0, 0.0), 0u);
    EXPECT_EQ(cart.drive(0.0, NAN, 0.0), 0u);
    EXPECT_EQ(cart.drive(0.0, 0.0, -1.0), 0u);
    cart.body = BodyHandle::make(1, 99, 1);
    EXPECT_EQ(cart.drive(1.0, 0.0, 0.0), 0u);
    EXPECT_EQ(cart.wheel(1).motor.mode, MotorMode::Off);
}

}  // namespace
}  // namespace rubble
