#include <gtest/gtest.h>

#include "tests/physics/baseline/overlap.h"
#include "tests/physics/physics_scene.h"

namespace rubble {
namespace {

TEST(Crowd, ThingsInOnePlacePartAndHaveNoMorePairsThanAPile) {
    constexpr int kBodies = 400, kSteps = 300;
    PhysicsScene scene;
    scene.addFloor();
    for (int i = 0; i < kBodies; ++i) scene.add(solidGrid({4, 4, 4}, 7), {0, 1, 0}, false);
    scene.load();
    scene.step();
    EXPECT_EQ(scene.physics.stats().crowded, kBodies);
    EXPECT_GT(scene.physics.stats().leftOut, kBodies * kBodies / 4) << "named, not hidden";
    EXPECT_LT(scene.physics.stats().candidates, 20 * kBodies);
    for (int step = 1; step < kSteps; ++step) {
        scene.step();
        EXPECT_LE(scene.physics.stats().pairs, 10 * kBodies) << "of " << kBodies * kBodies / 2 << " in step " << step;
    }
    EXPECT_EQ(scene.physics.stats().crowded, 0);
    EXPECT_EQ(scene.physics.stats().leftOut, 0);
    std::vector<Pose> poses;
    double highest = 0.0;
    scene.world.bodies().forEach([&](BodyHandle, const Body& body) {
        poses.push_back(body.pose);
        highest = std::max(highest, body.pose.position.y);
    });
    EXPECT_LT(measureOverlaps(scene.level, poses).worst, 0.05) << "metres";
    EXPECT_LT(highest, 3.0) << "metres: they push each other apart gently";
}

}  // namespace
}  // namespace rubble
