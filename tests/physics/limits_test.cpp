#include "physics/bodies/limits.h"

#include <gtest/gtest.h>

#include "runtime/core/log.h"
#include "tests/physics/scenes/known_scenes.h"

namespace rubble {
namespace {

using namespace known;

/// Collects the library's warnings while it exists.
struct Warnings {
    Warnings() {
        setLogSink([](void* user, LogLevel,
                      std::string_view message) { static_cast<Warnings*>(user)->list.emplace_back(message); },
                   this);
    }
    ~Warnings() { setLogSink(nullptr, nullptr); }
    std::vector<std::string> list;
};

uint64_t countOf(const PhysicsScene& scene, LimitKind kind) {
    return scene.physics.stats().clamped[size_t(kind)];
}

TEST(PhysicsLimits, SpeedAndSpinAreClampedCountedAndWarnedOfOnce) {
    Warnings warnings;
    PhysicsScene scene(sleepless({}));
    scene.level.environment.gravity = {0, 0, 0};
    scene.add(solidGrid({3, 3, 3}, 7), {0, 0, 0}, false).velocity = {0, 1e6, 0};
    LevelBody& spinning = scene.add(solidGrid({3, 3, 3}, 7), {10, 0, 0}, false);
    spinning.angularVelocity = {0, 0, 1e6};
    scene.load();
    scene.step();
    EXPECT_NEAR(scene.body(0).velocity.y, limits::kMaxSpeed, 1e-6);
    EXPECT_NEAR(scene.body(1).angularVelocity.z, limits::kMaxAngularSpeed, 1e-6);
    EXPECT_EQ(countOf(scene, LimitKind::Speed), 1u);
    EXPECT_EQ(countOf(scene, LimitKind::Spin), 1u);
    FrameChanges push;  // the same by an impulse
    push.impulses.push_back({scene.handle(0), scene.center(0), {0, 1e6, 0}});
    scene.physics.apply(push, scene.world);
    scene.step(3);
    EXPECT_NEAR(scene.body(0).velocity.y, limits::kMaxSpeed, 1e-6);
    EXPECT_EQ(countOf(scene, LimitKind::Speed), 2u);
    EXPECT_EQ(warnings.list.size(), 2u);
}

TEST(PhysicsLimits, AnyImpulseInRangeIsClampedAndFreezesNobody) {
    for (const double voxelSize : {0.1, 1e-3})
        for (const double arm : {0.0, 0.1, 300.0, 1e6, 1e9})
            for (const double impulse : {1.0, 2000.0, 1e12, 1e16}) {
                SCOPED_TRACE(testing::Message() << voxelSize << " m, arm " << arm << ", impulse " << impulse);
                Warnings warnings;
                PhysicsScene scene(sleepless({}));
                scene.level.environment.gravity = {0, 0, 0};
                scene.add(solidGrid({3, 3, 3}, 7), {0, 0, 0}, false).shapes[0].voxelSize = float(voxelSize);
                scene.load();
                FrameChanges push;
                push.impulses.push_back({scene.handle(0), scene.center(0) + glm::dvec3(arm, 0, 0), {0, impulse, 0}});
                scene.physics.apply(push, scene.world);
                scene.step(3);
                EXPECT_GT(glm::length(scene.body(0).velocity), 0.0);
                EXPECT_LE(glm::length(scene.body(0).velocity), limits::kMaxSpeed * 1.001);
                EXPECT_LE(glm::length(scene.body(0).angularVelocity), limits::kMaxAngularSpeed * 1.001);
                EXPECT_FALSE(scene.body(0).asleep);
                for (const std::string& warning : warnings.list)
                    EXPECT_NE(warning.find("clamped"), std::string::npos) << warning;
            }
}

TEST(PhysicsLimits, AMotorAndAGrabBeyondTheLimitsFreezeNobody) {
    Joint motor{.kind = JointKind::Hinge};
    motor.motor = {MotorMode::Speed, 1e12, 1e12};
    PhysicsScene scene(sleepless({}));
    scene.add(solidGrid({3, 3, 3}, 7), {0, 0, 0}, false);
    scene.load();
    motor.ends[0].shape = scene.body(0).shapes[0];
    motor.ends[0].frame.position = glm::dvec3(0.15);
    motor.ends[1].frame.position = glm::dvec3(0.15);
    scene.stepWith({AddJointEdit{motor}, GrabEdit{.body = scene.handle(0),
                                                  .point = glm::dvec3(0.3),
                                                  .target = glm::dvec3(1e9, 0, 0),
                                                  .maxForce = 1e9,
                                                  .hertz = 60.0}});
    scene.step(60);
    EXPECT_FALSE(scene.body(0).asleep);
    EXPECT_GT(glm::length(scene.body(0).angularVelocity), 1.0);
    EXPECT_LE(glm::length(scene.body(0).angularVelocity), limits::kMaxAngularSpeed * 1.001);
    EXPECT_EQ(countOf(scene, LimitKind::Distance), 0u);
    EXPECT_LT(glm::length(scene.center(0) - glm::dvec3(0.15)), 100.0);
}

TEST(PhysicsLimits, AMassBeyondTheLimitIsClamped) {
    PhysicsScene scene(sleepless({}));
    LevelBody& speck = scene.add(solidGrid({1, 1, 1}, setMaterial(scene, 7, 0.5f, 0.0f, 1)), {0, 0, 0}, false);
    speck.shapes[0].voxelSize = 1e-4f;
    scene.load();
    EXPECT_EQ(countOf(scene, LimitKind::Mass), 1u);
    scene.seconds(1.0);
    EXPECT_TRUE(std::isfinite(scene.center(0).y));
    EXPECT_EQ(countOf(scene, LimitKind::Mass), 1u);
}

TEST(PhysicsLimits, ABodyThatGetsTooFarIsFrozen) {
    Warnings warnings;
    PhysicsScene scene(sleepless({}));
    scene.level.environment.gravity = {0, 0, 0};
    scene.add(solidGrid({1, 1, 1}, 7), {0, 0, 0}, true);
    scene.add(solidGrid({3, 3, 3}, 7), {limits::kMaxDistance - 100.0, 0, 0}, false).velocity = {4000, 0, 0};
    scene.add(solidGrid({3, 3, 3}, 7), {-limits::kMaxDistance + 100.0, 0, 0},
              false);  // keeps the middle of the level at 0
    scene.load();
    scene.step(10);
    EXPECT_EQ(countOf(scene, LimitKind::Distance), 1u);
    EXPECT_EQ(warnings.list.size(), 1u);
    EXPECT_LE(scene.body(1).pose.position.x, limits::kMaxDistance);
    EXPECT_TRUE(scene.body(1).asleep);
}

TEST(PhysicsLimits, BodiesThatBeginTooFarAwayAreWarnedOfOnce) {
    Warnings warnings;
    PhysicsScene scene;
    for (const double x : {3e6, -3e6, 4e6, -4e6}) scene.add(solidGrid({4, 4, 4}, 7), {x, 1.0, 0.0}, false);
    scene.load();
    scene.step(3);
    EXPECT_EQ(countOf(scene, LimitKind::Distance), 4u);
    ASSERT_EQ(warnings.list.size(), 1u);
    EXPECT_NE(warnings.list[0].find("1,000 km"), std::string::npos) << warnings.list[0];
}

TEST(PhysicsLimits, WhatRestsOnABodyThatIsFrozenFalls) {
    Warnings warnings;
    PhysicsScene scene;
    scene.addFloor();
    for (int i = 0; i < 2; ++i) scene.add(solidGrid({5, 5, 5}, 7), {0, 0.5 * i, 0}, false);
    scene.load(false);
    FrameChanges push;
    push.impulses.push_back({scene.handle(1), scene.center(1), glm::dvec3(std::nan(""))});
    scene.physics.apply(push, scene.world);
    scene.seconds(2.0);
    EXPECT_NEAR(scene.center(2).y, 0.25, 0.01);
    EXPECT_EQ(warnings.list.size(), 1u);
}

TEST(PhysicsLimits, NothingIsCountedWithinTheLimits) {
    PhysicsScene scene;
    scene.addFloor();
    for (int i = 0; i < 5; ++i) scene.add(solidGrid({5, 5, 5}, 7), {0.1 * i, 0.7 * i, 0}, false);
    scene.load();
    scene.seconds(2.0);
    EXPECT_EQ(scene.physics.stats().clamped, LimitCounts{});
}

}  // namespace
}  // namespace rubble
