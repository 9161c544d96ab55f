// What bodies cost that fly tens of metres in a step. Work is counted, not timed.
#include <gtest/gtest.h>

#include "runtime/core/random.h"
#include "tests/physics/physics_scene.h"
#include "tests/support/allocation_count.h"

namespace rubble {
namespace {

constexpr double kFast = 5000.0;  ///< m/s, 83 m in a step

TEST(FastBodies, ArePairedWithWhatTheyMeetAndNotWithWhatIsNearTheirWay) {
    constexpr int kSide = 7;
    PhysicsScene scene;
    const glm::dvec3 middle(0.5 * (kSide - 1));
    for (int i = 0; i < kSide * kSide * kSide; ++i) {
        const glm::dvec3 at(i % kSide, i / kSide % kSide, i / kSide / kSide);
        const glm::dvec3 away = at - middle + glm::dvec3(0.01, 0.02, 0.03);
        scene.add(solidGrid({4, 4, 4}, 7), at, false).velocity = kFast * glm::normalize(away);
    }
    scene.load();
    scene.step();
    EXPECT_LT(scene.physics.stats().candidates, 3 * kSide * kSide * kSide) << "of 58,653 pairs";
}

TEST(FastBodies, LookAtWhatIsInTheirWayNotAtAllThatIsBelowIt) {
    Random random(3);
    std::vector<int> heights(320 * 320);
    for (int& height : heights) height = 8 + int(random.below(8));
    const auto allocations = [&](glm::dvec3 velocity) {
        PhysicsScene scene;
        scene.add(gridOf({320, 16, 320},
                         [&](glm::ivec3 c) { return uint8_t(c.y < heights[size_t(c.x + 320 * c.z)] ? 7 : 0); }),
                  {0, 0, 0}, true);
        scene.add(solidGrid({4, 4, 4}, 7), {1.0, 1.8, 1.0}, false).velocity = velocity;
        scene.load();
        const size_t before = allocationCount();
        scene.step();
        return allocationCount() - before;
    };
    const size_t still = allocations({0.0, 0.0, 0.0});
    EXPECT_LT(allocations(kFast * glm::normalize(glm::dvec3(1.0, -0.02, 1.0))), still + 5500)
        << "the surfaces of 40 x 40 bricks are found when they are looked at first";
}

}  // namespace
}  // namespace rubble
