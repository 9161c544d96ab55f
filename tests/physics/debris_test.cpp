#include <gtest/gtest.h>

#include "runtime/core/random.h"
#include "tests/physics/physics_scene.h"
#include "tests/support/allocation_count.h"

namespace rubble {
namespace {

/// A scene with settings of debris.
struct DebrisScene : PhysicsScene {
    void setDebris(const DebrisSettings& debris) {
        WorldSettings settings = world.settings();
        settings.debris = debris;
        world.setSettings(settings);
    }
};

/// A wall of brick, 12 x 6 x 0.4 m, on a floor.
void addWall(DebrisScene& scene) {
    scene.addFloor();
    scene.add(solidGrid({120, 60, 4}, defaultMaterials().find("brick")), {-6.0, 0.0, 0.0}, true);
}

TEST(DebrisPhysics, TheBudgetOfMovingPiecesHoldsAtEveryStep) {
    DebrisScene scene;
    addWall(scene);
    scene.setDebris({.awakeBodies = 40, .bodies = 120, .voxels = 4000});
    scene.load(false);
    Random random(8);
    size_t pieces = 0, unsettled = 0;
    for (int i = 0; i < 120; ++i) {
        BreakEdit hit{.position = {random.unit() * 10.0 - 5.0, 0.0, 0.2}, .seed = uint32_t(i)};
        hit.position.y = 0.5 + random.unit() * 5.0;
        hit.radii.fill(0.8);
        const FrameChanges changes = scene.stepWith(i % 3 ? Edits{} : Edits{hit});
        pieces += changes.bodiesCreated.size();
        unsettled += changes.unsettled.size();
        const DebrisQueue& debris = scene.world.data().debris;
        ASSERT_LE(debris.awakeCount(), 40u) << i;
        ASSERT_LE(scene.physics.stats().awake, 40) << i;
        ASSERT_LE(debris.count(), 120u) << i;
        ASSERT_LE(debris.voxels(), 4000u) << i;
        ASSERT_TRUE(voxelAccounting(scene.world).balances()) << i;
    }
    EXPECT_GT(pieces, 300u);
}

/// Steps until nothing is awake.
void rest(DebrisScene& scene) {
    for (int i = 0; i < 900 && scene.physics.stats().awake; ++i) scene.stepWith({});
    ASSERT_EQ(scene.physics.stats().awake, 0);
}

TEST(DebrisPhysics, SettledPiecesWakeWhenHitOrWhenTheirSupportGoes) {
    DebrisScene scene;
    addWall(scene);
    scene.setDebris({.settleSteps = 20});
    scene.load(false);
    CarveEdit cut{.kind = BrushKind::Box, .position = {0.0, 5.45, 0.2}, .halfSize = {6.1, 0.05, 0.4}};
    CarveEdit slit{.kind = BrushKind::Box, .position = {0.0, 5.75, 0.2}, .halfSize = {0.05, 0.3, 0.4}};
    const std::vector<BodyHandle> beams = scene.stepWith({cut, slit}).bodiesCreated;
    ASSERT_EQ(beams.size(), 2u);
    rest(scene);
    for (int i = 0; i < 25; ++i) scene.stepWith({});
    const auto settled = [&](size_t i) { return scene.world.bodies().at(beams[i]).settled; };
    ASSERT_TRUE(settled(0) && settled(1));

    const Edits none;
    scene.stepWith(none);
    const size_t before = allocationCount();
    scene.stepWith(none);
    EXPECT_EQ(allocationCount(), before);

    const glm::dvec3 center =
        scene.world.bodies().at(beams[0]).pose.transformPoint(bodyMass(scene.world, beams[0]).center);
    EXPECT_EQ(scene.stepWith({ImpulseEdit{beams[0], center, {0, 900, 0}}}).unsettled, std::vector{beams[0]});
    EXPECT_FALSE(settled(0));
    EXPECT_TRUE(settled(1));
    // Its support is removed: the top of the wall below the second beam.
    CarveEdit below{.kind = BrushKind::Box, .position = {-3.0, 4.0, 0.2}, .halfSize = {3.2, 1.8, 0.4}};
    below.position.x = scene.world.bodies().at(beams[1]).pose.transformPoint(bodyMass(scene.world, beams[1]).center).x;
    below.shape = scene.world.shapes().handleAt(1);
    scene.stepWith({below});
    scene.stepWith({});
    EXPECT_FALSE(settled(1));
}

}  // namespace
}  // namespace rubble
