#include <gtest/gtest.h>

#include "runtime/world/impacts/impact_damage.h"
#include "tests/physics/physics_scene.h"

namespace rubble {
namespace {

/// A detached brick tower, 60 voxels tall, that leans over its edge; stress analysis is on.
struct Felled {
    explicit Felled(bool loadIsOn) {
        scene.addFloor(4);
        const glm::dquat lean = glm::angleAxis(-0.35, glm::dvec3(0, 0, 1));
        scene.add(solidGrid({12, 60, 12}, 7), {0.0, 0.45, 0.0}, false, lean);
        WorldSettings settings;
        settings.stress.on = loadIsOn;
        settings.impactThreshold = 1e12;  // no damage where it is hit, only fracture of the whole
        scene.world.setSettings(settings);
        scene.load();
        scene.physics.apply(scene.world.applyEdits({}), scene.world);
        edits = {
            ImpulseEdit{scene.handle(1), scene.center(1), {0.0, 0.0, 0.0}}};  // dynamic bodies of a level start asleep
    }
    void run(double seconds) {
        for (int i = 0; i < int(seconds * 60.0); ++i) {
            cracks += scene.stepWith(edits).cracks.size();
            edits = impactDamage(scene.world, scene.physics.impacts());
            ASSERT_TRUE(voxelAccounting(scene.world).balances()) << i;
        }
    }
    size_t bodies() const {
        size_t count = 0;
        scene.world.bodies().forEach([&](BodyHandle, const Body& body) { count += !body.isStatic; });
        return count;
    }
    PhysicsScene scene;
    Edits edits;
    size_t cracks = 0;
};

TEST(Landing, AFelledTowerBreaksIntoPieces) {
    Felled tower(true);
    tower.run(4.0);
    EXPECT_GE(tower.bodies(), 3u);
    EXPECT_GT(voxelAccounting(tower.scene.world).inPieces + voxelAccounting(tower.scene.world).removed, 0u);
    // Cracks remove few voxels.
    EXPECT_LT(voxelAccounting(tower.scene.world).removed, 60u * 144u / 4u);
}

TEST(Landing, WithoutStressAnalysisItStaysWhole) {
    Felled tower(false);
    tower.run(4.0);
    EXPECT_EQ(tower.bodies(), 1u);
    EXPECT_EQ(tower.cracks, 0u);
}

TEST(Landing, ItBreaksTheSameEveryTime) {
    Felled first(true), second(true);
    first.run(3.0);
    second.run(3.0);
    EXPECT_EQ(first.scene.world.hash(), second.scene.world.hash());
}

}  // namespace
}  // namespace rubble
