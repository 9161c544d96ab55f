#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "runtime/core/constants.h"
#include "tests/physics/scenes/joint_scenes.h"
#include "tests/physics/scenes/known_scenes.h"
#include "tests/physics/scenes/load_scenes.h"

namespace rubble {
namespace {

using namespace known;

const std::array<PhysicsSettings, 3> kPresets = {fastPhysics(), balancedPhysics(), accuratePhysics()};

/// A cube of 0.4 m on a vertical slider whose motor has `share` times its weight.
struct Slider {
    PhysicsScene scene;
    Slider(const PhysicsSettings& settings, MotorMode mode, double target, double share) : scene(settings) {
        scene.add(solidGrid({4, 4, 4}, entryOfMass(scene, 32.0, 64)), {-0.2, -0.2, -0.2}, false);
        const glm::dquat up = glm::angleAxis(0.5 * kPi, glm::dvec3(0.0, 0.0, 1.0));
        LevelJoint& joint = known::addJoint(scene.level, JointKind::Prismatic, -1, 0, {{}, up});
        joint.joint.motor = {mode, target, 0.0};
        scene.load();
        const double weight = bodyMass(scene.world, scene.handle(0)).mass * kGravity;
        joint.joint.motor.maxForce = share * weight;
        scene.load();
    }
    double height() const { return scene.center(0).y; }
    double speed() const { return double(scene.body(0).velocity.y); }
};

/// The net force, motor less weight, accelerates the load up to the target speed. Below the weight it sinks.
TEST(Lifting, ASliderAcceleratesByWhatItsMotorHasBeyondTheWeight) {
    for (const PhysicsSettings& settings : kPresets)
        for (const double share : {0.9, 1.01, 1.05, 1.2, 1.5, 2.5}) {
            Slider slider(settings, MotorMode::Speed, share < 1.0 ? 0.5 : 2.0, share);
            slider.scene.seconds(1.0);
            const double a = (share - 1.0) * kGravity, v = std::min(a, 2.0), rising = v / a;
            EXPECT_NEAR(slider.speed(), v, 0.01) << share;
            EXPECT_NEAR(slider.height(), 0.5 * v * rising + v * (1.0 - rising), 0.01) << share;
        }
}

TEST(Lifting, APositionMotorLiftsWhateverItIsStrongerThan) {
    for (const PhysicsSettings& settings : kPresets)
        for (const double share : {1.05, 1.5, 4.0}) {
            Slider slider(settings, MotorMode::Position, 1.0, share);
            slider.scene.seconds(5.0);
            EXPECT_NEAR(slider.height(), 1.0, 1e-3) << share;
        }
}

/// A bar that a hinge holds at one end, level: the net torque rotates it.
TEST(Lifting, AHingeRotatesByWhatItsMotorHasBeyondTheLoad) {
    for (const PhysicsSettings& settings : kPresets)
        for (const double share : {0.9, 1.05, 1.2, 1.5}) {
            PhysicsScene scene(settings);
            scene.add(solidGrid({10, 2, 2}, entryOfMass(scene, 40.0, 40)), {0.0, -0.1, -0.1}, false);
            LevelJoint& hinge = known::addJoint(scene.level, JointKind::Hinge, -1, 0, hingeAt({0, 0, 0}));
            hinge.joint.motor = {MotorMode::Speed, 100.0, 0.0};
            scene.load();
            const MassProperties mass = bodyMass(scene.world, scene.handle(0));
            const double load = mass.mass * kGravity * scene.center(0).x,
                         moment = mass.inertia[2] + mass.mass * scene.center(0).x * scene.center(0).x;
            hinge.joint.motor.maxForce = share * load;
            scene.load();
            scene.step(12);
            // The lever grows shorter as it turns: integrate the exact motion.
            double angle = 0.0, spin = 0.0;
            for (int i = 0; i < 12'000; ++i) {
                spin += (share - std::cos(angle)) * load / moment / 60'000.0;
                angle += spin / 60'000.0;
            }
            EXPECT_NEAR(double(scene.body(0).angularVelocity.z), spin, 0.02 * std::abs(spin) + 0.002) << share;
        }
}

/// A load on a rope of 4 m with its end at the origin. mass: kg. drop: metres that it falls until the rope is taut.
struct Hanging {
    PhysicsScene scene;
    Hanging(const PhysicsSettings& settings, double mass, double stretch, double drop, double length = 4.0)
        : scene(settings) {
        scene.add(solidGrid({5, 5, 5}, entryOfMass(scene, mass, 125)), {-0.25, drop - length - 0.5, -0.25}, false);
        Joint& rope = known::addJoint(scene, JointKind::Rope, "", "body 0", {}, {0.25, 0.5, 0.25}).joint;
        rope.rope.length = 4.0;
        rope.rope.stretch = stretch;
        scene.load();
    }
    double length() const { return -0.25 - scene.center(0).y; }
    double speed() const { return double(scene.body(0).velocity.y); }
    double mass() const { return bodyMass(scene.world, scene.handle(0)).mass; }
    void wind(double speed, double seconds) {
        const JointHandle rope = scene.world.joints().handleAt(0);
        scene.stepWith({SetJointMotorEdit{rope, {MotorMode::Speed, speed, 0.0}}});
        for (int i = 1; i < scene.stepsIn(seconds); ++i) scene.stepWith({});
    }
};

/// 10 kN stretch a rope by its `stretch`.
TEST(Lifting, ARopeStretchesByItsStiffness) {
    for (const PhysicsSettings& settings : kPresets)
        for (const double mass : {63.0, 502.0, 4019.0})
            for (const double stretch : {0.0, 0.01, 0.1, 1.0}) {
                Hanging load(settings, mass, stretch, 0.0);
                load.scene.seconds(20.0);
                const double elongation = 4.0 * stretch * load.mass() * kGravity / 1e4;
                EXPECT_NEAR(load.length(), 4.0 + elongation, 0.002 + 0.001 * elongation) << mass << " kg, " << stretch;
            }
}

/// What falls into a rope is caught by a critically damped spring: it swings through once, and only as far.
TEST(Lifting, ARopeThatStretchesCatchesAsASpring) {
    for (const double stretch : {0.1, 1.0}) {
        Hanging load({}, 63.0, stretch, 2.0);
        const double w = std::sqrt(1e4 / (stretch * 4.0 * load.mass())), sag = kGravity / (w * w),
                     v = std::sqrt(2.0 * kGravity * 2.0);
        // x(t) = sag - (sag + (sag w - v) t) e^-wt is largest where its speed, (v + (sag w - v) w t) e^-wt, is 0.
        const double t = v / ((v - sag * w) * w), deepest = sag - (sag + (sag * w - v) * t) * std::exp(-w * t);
        double longest = 0.0;
        for (int i = 0; i < 300; ++i) {
            load.scene.step();
            longest = std::max(longest, load.length());
        }
        EXPECT_NEAR((longest - 4.0) / deepest, 1.0, 0.05) << stretch;
    }
}

/// What a winch lifts has the speed of its rope, and arrives with it.
TEST(Lifting, AWinchGivesItsLoadTheSpeedOfTheRope) {
    for (const PhysicsSettings& settings : kPresets)
        for (const double mass : {4.0, 256.0})
            for (const double stretch : {0.0, 0.01})
                for (const double speed : {0.1, 1.0, -0.5}) {
                    Hanging load(settings, mass, stretch, 0.0);
                    load.scene.seconds(2.0);
                    const double start = load.length();
                    load.wind(-speed, 2.0);
                    EXPECT_NEAR(load.speed(), speed, 0.01) << mass << " kg, stretch " << stretch;
                    EXPECT_NEAR(start - load.length(), 2.0 * speed, 0.03) << mass << " kg, stretch " << stretch;
                }
}

/// A rope that is made shorter than the distance of its ends pulls them together at 0.2 m/s.
TEST(Lifting, ARopeThatIsTooShortPullsItsEndsTogether) {
    Hanging load({}, 100.0, 0.0, 0.0, 4.5);
    load.scene.seconds(1.0);
    EXPECT_NEAR(load.length(), 4.3, 0.01);
    EXPECT_NEAR(load.speed(), 0.2, 0.001);
    load.scene.seconds(2.0);
    EXPECT_NEAR(load.length(), 4.0, 0.001);
    EXPECT_NEAR(load.speed(), 0.0, 0.001);
}

}  // namespace
}  // namespace rubble
