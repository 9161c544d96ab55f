#include <gtest/gtest.h>

#include <algorithm>

#include "runtime/core/constants.h"
#include "tests/physics/physics_scene.h"

namespace rubble {
namespace {

constexpr uint8_t kWood = 5, kMetal = 10;

/// A crate of wood, 0.5 m and 75 kg, on the floor, under a plate of metal of 1.5 t.
struct Press : PhysicsScene {
    static constexpr int kPlate = 2;
    /// gap: metres between crate and plate. hasMotor: the plate slides up and down on a joint with a motor, off.
    explicit Press(double gap, bool hasMotor) {
        addFloor();
        add(solidGrid({5, 5, 5}, kWood), {-0.25, 0.0, -0.25}, false);
        add(solidGrid({10, 2, 10}, kMetal), {-0.5, 0.5 + gap, -0.5}, false);
        if (hasMotor) {
            LevelJoint joint{{.kind = JointKind::Prismatic}, {"", "body 2"}};
            const glm::dquat up = glm::angleAxis(0.5 * kPi, glm::dvec3(0, 0, 1));
            joint.joint.ends[0].frame = {{0.0, 0.6, 0.0}, up};
            joint.joint.ends[1].frame = {{0.5, 0.1, 0.5}, up};
            level.joints.push_back(joint);
        }
        load();
    }
    /// Steps, and returns the fastest impact, m/s; 0: there was none.
    double fastestImpact(double time) {
        double fastest = 0.0;
        for (int i = 0; i < stepsIn(time); ++i) {
            step();
            for (const Impact& impact : physics.impacts()) fastest = std::max(fastest, impact.speed);
        }
        return fastest;
    }
};

/// A force that begins at once presses a spring to about twice as deep as one that grows slowly, and hits nothing.
TEST(Press, AForceSwitchedOnIsNoImpact) {
    for (const double force : {3e4, 1e5, 3e5}) {
        double deepest[2] = {};
        for (const bool isRamp : {false, true}) {
            Press scene(0.0, true);
            scene.seconds(1.0);
            const double rest = scene.center(Press::kPlate).y;
            for (int i = 0; i < 180; ++i) {
                SetJointMotorEdit edit{.joint = scene.world.joints().handleAt(0)};
                edit.motor = {MotorMode::Speed, -1.0, force * (isRamp ? std::min(i / 120.0, 1.0) : 1.0)};
                scene.stepWith({edit});
                EXPECT_TRUE(scene.physics.impacts().empty()) << force << " N, step " << i;
                deepest[isRamp] = std::max(deepest[isRamp], rest - scene.center(Press::kPlate).y);
            }
        }
        EXPECT_LT(deepest[0], 2.25 * deepest[1]) << force << " N";
    }
}

TEST(Press, WhatFallsOnItHits) {
    for (const double height : {0.5, 5.0, 20.0}) {
        Press scene(height, false);
        EXPECT_NEAR(scene.fastestImpact(3.0) / std::sqrt(2.0 * 9.81 * height), 1.0, 0.02) << height;
    }
}

}  // namespace
}  // namespace rubble
