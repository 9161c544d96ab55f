#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "runtime/core/constants.h"
#include "runtime/world/objects/transforms.h"
#include "tests/physics/scenes/energy.h"
#include "tests/physics/scenes/known_scenes.h"
#include "tests/physics/scenes/load_scenes.h"

namespace rubble {
namespace {

const glm::dquat kXToZ = glm::angleAxis(-0.5 * kPi, glm::dvec3(0.0, 1.0, 0.0));

/// A rod on a hinge along z at its end, without gravity. Returns the share of its spin that it has after 10 s.
double spinLeft(const PhysicsSettings& settings, int voxels, double spin) {
    PhysicsScene scene(known::sleepless(settings));
    scene.level.environment.gravity = {0, 0, 0};
    LevelBody& rod = scene.add(solidGrid({voxels, 1, 1}, 5), {-0.05, -0.05, -0.05}, false);
    rod.angularVelocity = {0.0f, 0.0f, float(spin)};
    rod.velocity = {0.0f, float(spin * (0.05 * voxels - 0.05)), 0.0f};
    Joint& hinge = known::addJoint(scene, JointKind::Hinge, "", "body 0", {}, glm::dvec3(0.05)).joint;
    for (JointEnd& end : hinge.ends) end.frame.rotation = kXToZ;
    scene.load();
    scene.seconds(10.0);
    return double(scene.body(0).angularVelocity.z) / spin;
}

TEST(JointMotion, AnUnbalancedRotorKeepsItsSpin) {
    for (const int voxels : {10, 40})
        for (const double spin : {10.0, 30.0, 60.0}) {
            EXPECT_NEAR(spinLeft({}, voxels, spin), 1.0, 0.01) << voxels << " voxels, " << spin << " rad/s";
            EXPECT_NEAR(spinLeft(accuratePhysics(), voxels, spin), 1.0, 0.01) << voxels << " voxels, " << spin;
        }
}

/// Two rods end to end that whirl about their middle, without anything else. Returns the spin of the first after 10 s.
double whirlLeft(JointKind kind, double spin, double& energy) {
    PhysicsScene scene(known::sleepless({}));
    scene.level.environment.gravity = {0, 0, 0};
    for (const int side : {-1, 1}) {
        LevelBody& rod = scene.add(solidGrid({5, 1, 1}, 5), {side < 0 ? -0.5 : 0.0, -0.05, -0.05}, false);
        rod.angularVelocity = {0.0f, 0.0f, float(spin)};
        rod.velocity = {0.0f, float(spin * side * 0.25), 0.0f};
    }
    Joint& joint = known::addJoint(scene, kind, "body 0", "body 1", {0.5, 0.05, 0.05}, {0.0, 0.05, 0.05}).joint;
    if (kind == JointKind::Hinge)
        for (JointEnd& end : joint.ends) end.frame.rotation = kXToZ;
    if (kind == JointKind::Prismatic) joint.limits = {true, 0.0, 0.0};
    scene.load();
    const double before = known::mechanicalEnergy(scene.world, 0.0);
    scene.seconds(10.0);
    energy = known::mechanicalEnergy(scene.world, 0.0) / before;
    return double(scene.body(0).angularVelocity.z) / spin;
}

TEST(JointMotion, JoinedRodsWhirlOn) {
    for (const JointKind kind : {JointKind::Fixed, JointKind::Hinge, JointKind::Ball, JointKind::Prismatic})
        for (const double spin : {10.0, 30.0, 60.0}) {
            double energy = 0.0;
            EXPECT_NEAR(whirlLeft(kind, spin, energy), 1.0, 0.01) << int(kind) << ", " << spin << " rad/s";
            EXPECT_NEAR(energy, 1.0, 0.02) << int(kind) << ", " << spin << " rad/s";
        }
}

/// A disc of steel on a thin rod whose tip is held: its axis is level, along z, and goes round at m g d / (I spin).
void expectPrecesses(const PhysicsSettings& settings, double spin) {
    PhysicsScene scene(known::sleepless(settings));
    const VoxelGrid disc = gridOf({41, 41, 6}, [](glm::ivec3 c) {
        const double r = std::hypot(c.x - 20.0, c.y - 20.0);
        return uint8_t(c.z < 4 ? (r == 0.0 ? 9 : 0) : r < 20.5 ? 9 : 0);
    });
    scene.add(disc, {-0.205, -0.205, 0.0}, false).shapes[0].voxelSize = 0.01f;
    known::addJoint(scene, JointKind::Ball, "", "body 0", {}, {0.205, 0.205, 0.0});
    scene.load();
    const MassProperties mass = bodyMass(scene.world, scene.handle(0));
    const double far = mass.center.z, turn = mass.mass * kGravity * far / (mass.inertia[2] * spin);
    scene.stepWith({SetBodyEdit{.body = scene.handle(0),
                                .setsVelocity = true,
                                .velocity = {turn * far, 0.0, 0.0},
                                .angularVelocity = {0.0, turn, spin}}});
    const auto axis = [&] { return scene.body(0).pose.rotation * glm::dvec3(0.0, 0.0, 1.0); };
    double round = 0.0, tilt = 0.0, last = std::atan2(axis().x, axis().z);
    for (int i = 0; i < 600; ++i) {
        scene.step();
        const double now = std::atan2(axis().x, axis().z);
        round += std::remainder(now - last, 2.0 * kPi);
        last = now;
        tilt = std::max(tilt, std::abs(axis().y));
    }
    const auto of = testing::Message() << spin << " rad/s, " << settings.substeps << " substeps";
    EXPECT_NEAR(glm::dot(axis(), glm::dvec3(scene.body(0).angularVelocity)) / spin, 1.0, 0.001) << of;
    EXPECT_NEAR(round / 10.0 / turn, 1.0, 0.003) << of;
    EXPECT_LT(tilt, 0.005) << of;
}

/// At 400 rad/s it turns by up to 2.2 radians in a substep.
TEST(JointMotion, AHeavyTopPrecessesAtEverySpin) {
    for (const PhysicsSettings& settings : {fastPhysics(), balancedPhysics(), accuratePhysics()})
        for (const double spin : {50.0, 100.0, 200.0, 300.0, 400.0}) expectPrecesses(settings, spin);
}

/// Joules per kg at the lowest point of the last swing, as a share of those of the first.
double swingLeft(double length, double speed, double seconds) {
    PhysicsScene scene(known::sleepless({}));
    scene.add(solidGrid({2, 2, 2}, 9), {-0.1, length, -0.1}, true);
    scene.add(solidGrid({5, 5, 5}, 9), {-0.25, -0.5, -0.25}, false).velocity = {float(speed), 0.0f, 0.0f};
    known::addJoint(scene, JointKind::Rope, "body 0", "body 1", {0.1, 0.0, 0.1}, {0.25, 0.5, 0.25});
    scene.load();
    const int swing = scene.stepsIn(kPi * std::sqrt(length / kGravity)), steps = scene.stepsIn(seconds);
    double fastest = 0.0;
    for (int i = 0; i < steps; ++i) {
        scene.step();
        if (i >= steps - swing - 2) fastest = std::max(fastest, double(glm::length(scene.body(1).velocity)));
    }
    return fastest * fastest / (speed * speed);
}

TEST(JointMotion, ALoadOnARopeKeepsItsSwing) {
    for (const double length : {3.0, 8.0})
        for (const double speed : {0.1, 0.3, 1.0, 3.0})
            EXPECT_NEAR(swingLeft(length, speed, 20.0), 1.0, 0.1) << length << " m, " << speed << " m/s";
}

/// A load of 502 kg under a soft joint, the lowest and the highest of its centre in the last 5 of 10 s, from the start.
std::pair<double, double> softSwing(JointKind kind, double hertz, double damping) {
    PhysicsScene scene(known::sleepless({}));
    scene.add(solidGrid({4, 4, 4}, 9), {-0.2, -0.2, -0.2}, false);
    Joint& joint = known::addJoint(scene, kind, "", "body 0", {0.0, 0.2, 0.0}, {0.2, 0.4, 0.2}).joint;
    joint.spring = {hertz, damping};
    joint.limits = {kind == JointKind::Cone, 0.0, 1.0};
    scene.load();
    std::pair<double, double> range(1e9, -1e9);
    for (int i = 0; i < 600; ++i) {
        scene.step();
        if (i >= 300) range = {std::min(range.first, scene.center(0).y), std::max(range.second, scene.center(0).y)};
    }
    return range;
}

TEST(JointMotion, ASoftJointIsASpring) {
    for (const JointKind kind : {JointKind::Ball, JointKind::Fixed, JointKind::Cone})
        for (const double hertz : {0.5, 1.0, 3.0}) {
            const double sag = kGravity / std::pow(2.0 * kPi * hertz, 2.0);
            const auto [low, high] = softSwing(kind, hertz, 0.0);
            EXPECT_NEAR(low, -2.0 * sag, 0.05 * sag) << int(kind) << ", " << hertz << " Hz";
            EXPECT_NEAR(high, 0.0, 0.05 * sag) << int(kind) << ", " << hertz << " Hz";
            const auto [lowest, highest] = softSwing(kind, hertz, 1.0);
            EXPECT_NEAR(lowest, -sag, 0.01 * sag) << int(kind) << ", " << hertz << " Hz, damped";
            EXPECT_NEAR(highest, -sag, 0.01 * sag) << int(kind) << ", " << hertz << " Hz, damped";
        }
}

/// A beam of 96 kg, 1.2 m along z, that floats.
struct Beam : PhysicsScene {
    Beam() : PhysicsScene(known::sleepless({})) {
        level.environment.gravity = {0, 0, 0};
        add(solidGrid({4, 4, 12}, known::entryOfMass(*this, 96.0, 192)), {-0.2, -0.2, -0.6}, false);
        load();
    }
    /// Turned about y since the start, radians.
    double angle() const { return 2.0 * std::atan2(body(0).pose.rotation.y, body(0).pose.rotation.w); }
};

TEST(JointMotion, AHandOfAnyTorqueTurnsWithoutSwinging) {
    for (const double torque : {1.0, 10.0, 50.0, 1000.0, 0.0})
        for (const double at : {0.0, -0.5}) {
            Beam beam;
            const double inertia = 96.0 * ((0.16 + 1.44) / 12.0 + at * at),
                         least = torque > 0.0 ? 2.0 * std::sqrt(inertia / torque) : 0.0;
            GrabEdit grab{.body = beam.handle(0), .point = {0, 0, at}, .target = {0, 0, at}, .maxForce = 1e6};
            grab.turns = true;
            grab.rotation = glm::angleAxis(1.0, glm::dvec3(0.0, 1.0, 0.0));
            grab.maxTorque = torque;
            beam.stepWith({grab});
            double most = 0.0, settled = 0.0;
            for (int i = 0; i < 1800; ++i) {
                beam.step();
                most = std::max(most, beam.angle());
                if (std::abs(beam.angle() - 1.0) > 0.02) settled = i / 60.0;
            }
            EXPECT_LT(most, 1.05) << torque << " N m, at " << at;
            EXPECT_LT(settled, 2.0 * least + 1.0) << torque << " N m, at " << at;
        }
}

/// The point that the second edit names is long behind: it counts when a body is grabbed.
TEST(JointMotion, AHandThatBeginsToTurnKeepsItsGrip) {
    Beam beam;
    GrabEdit grab{.body = beam.handle(0), .point = {0, 0, 0.55}, .target = {0, 2, 0.55}, .maxForce = 1e5};
    beam.stepWith({grab});
    beam.step(300);
    grab.turns = true;
    grab.rotation = beam.body(0).pose.rotation;
    grab.target.x = 1.0;
    beam.stepWith({grab});
    beam.step(300);
    const Joint* held = nullptr;
    beam.world.joints().forEach([&](JointHandle, const Joint& joint) { held = &joint; });
    ASSERT_TRUE(held);
    EXPECT_EQ(held->kind, JointKind::Fixed);
    EXPECT_LT(glm::distance(jointToWorld(beam.world, held->ends[0]).position, grab.target), 0.01);
    grab.turns = false;
    grab.target.x = 0.0;
    beam.stepWith({grab});
    beam.step(300);
    ASSERT_EQ(beam.world.joints().size(), 1u);
    EXPECT_LT(std::abs(beam.center(0).x), 0.7);
}

TEST(JointMotion, AHandOfAnyForcePullsWithoutSwinging) {
    for (const double force : {10.0, 100.0, 1000.0, 1e5}) {
        Beam beam;
        beam.stepWith({GrabEdit{.body = beam.handle(0), .point = {0, 0, 0}, .target = {2, 0, 0}, .maxForce = force}});
        double most = 0.0, settled = 0.0;
        for (int i = 0; i < 1800; ++i) {
            beam.step();
            most = std::max(most, beam.center(0).x);
            if (std::abs(beam.center(0).x - 2.0) > 0.02) settled = i / 60.0;
        }
        EXPECT_LT(most, 2.1) << force << " N";
        EXPECT_LT(settled, 2.0 * 2.0 * std::sqrt(2.0 * 96.0 / force) + 1.0) << force << " N";
    }
}

}  // namespace
}  // namespace rubble
