#include <gtest/gtest.h>

#include "tests/physics/scenes/known_scenes.h"

namespace rubble {
namespace {

/// What slides without friction keeps its speed, however slow and whatever it slides on.
TEST(SlowSlider, KeepsItsSpeed) {
    for (const bool isFixed : {true, false})
        for (const double speed : {0.2, 0.05, 0.02, 0.005}) {
            PhysicsScene scene(known::sleepless({}));
            const uint8_t ice = known::setMaterial(scene, 8, 0.0f, 0.0f, 2000);
            scene.addFloor(ice);
            scene.add(solidGrid({100, 2, 24}, ice), {-5.0, 0.0, -1.2}, isFixed);
            scene.add(solidGrid({5, 5, 5}, ice), {-0.25, 0.2, -0.25}, false);
            scene.load();
            SetBodyEdit push{.body = scene.handle(2), .setsVelocity = true};
            push.velocity.x = speed;
            scene.stepWith({push});
            scene.seconds(10.0);
            EXPECT_NEAR(double(scene.body(2).velocity.x) / speed, 1.0, 2e-3) << speed << " m/s, " << isFixed;
        }
}

}  // namespace
}  // namespace rubble
