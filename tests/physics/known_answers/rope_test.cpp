#include <gtest/gtest.h>

#include "tests/physics/scenes/energy.h"
#include "tests/physics/scenes/known_scenes.h"
#include "tests/physics/scenes/load_scenes.h"
#include "tests/physics/scenes/rope_scenes.h"

namespace rubble {
namespace {

std::string nameOf(const known::BeamDrop& drop) {
    return std::to_string(drop.thickness) + " voxels, " + std::to_string(drop.mass) + " kg from " +
           std::to_string(drop.drop) + " m, end at " + std::to_string(drop.anchor) + " m, " +
           std::to_string(drop.seams) + " seams, " + std::to_string(drop.spin) + " rad/s";
}

/// The chain has a point every 0.4 m: it goes round a beam to half of that.
void expectStaysOver(const known::BeamDrop& drop) {
    const known::BeamRope rope = known::dropOverBeam({}, drop);
    EXPECT_TRUE(rope.isOver) << nameOf(drop);
    EXPECT_LT(rope.inside, 0.05) << nameOf(drop);
    EXPECT_LT(std::abs(rope.below), drop.spin == 0.0 ? 0.2 : 0.25) << nameOf(drop);
    EXPECT_LT(rope.gained, 1e-3 * rope.lost + 0.01) << nameOf(drop);
}

TEST(Rope, IsNotPulledThroughAThinBeam) {
    for (const int thickness : {1, 2, 3, 4})
        for (const double mass : {1.0, 100.0, 1000.0})
            for (const double drop : {0.0, 1.0, 5.0, 20.0})
                expectStaysOver({.thickness = thickness, .mass = mass, .drop = drop});
}

TEST(Rope, WindsOnWhatIsNextToAHeldEnd) {
    for (const int thickness : {2, 4})
        for (const double anchor : {0.0, 0.05, 0.1, 0.2, 0.3, 0.5})
            expectStaysOver({.thickness = thickness, .anchor = anchor});
}

TEST(Rope, LiesOnASeamAndOnWhatTurns) {
    for (const int thickness : {1, 2, 4}) {
        expectStaysOver({.thickness = thickness, .seams = 1});
        expectStaysOver({.thickness = thickness, .drop = 0.0, .spin = 2.0});
    }
}

/// A block that hangs from a rope whose end is under it, inside it or near its top.
TEST(Rope, GoesRoundTheBodyAtItsEndWithoutGainingEnergy) {
    for (const double depth : {0.0, 0.25, 0.4}) {
        PhysicsScene scene(known::sleepless({}));
        scene.add(solidGrid({5, 5, 5}, known::entryOfMass(scene, 100.0, 125)), {1.0, -2.0, -0.25}, false);
        known::addJoint(scene, JointKind::Rope, "", "body 0", {}, {0.25, depth, 0.25}).joint.ends[1].radius = 0.5;
        scene.load();
        known::EnergyRecord energy(scene.world, {});
        for (int i = 0; i < 1200; ++i) {
            scene.step();
            energy.update(scene.world);
        }
        EXPECT_LT(energy.excess(), 2e-3 * energy.lost()) << depth;
    }
}

}  // namespace
}  // namespace rubble
