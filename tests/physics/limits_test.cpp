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
