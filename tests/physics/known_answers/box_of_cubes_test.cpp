#include <gtest/gtest.h>

#include <cstdlib>

#include "runtime/core/constants.h"
#include "tests/physics/scenes/known_scenes.h"
#include "tests/physics/scenes/load_scenes.h"

// Loose cubes in a closed box that is no static room but a body: it flies, or something drives it. None may get out.

namespace rubble {
namespace {

/// A closed box of 1 m of metal, body 0, with one cube or more of one voxel of metal in it; no gravity, nothing sleeps.
struct BoxOfCubes : PhysicsScene {
    int cubes;
    /// wall: voxels.
    BoxOfCubes(const PhysicsSettings& settings, int wall, int count)
        : PhysicsScene(known::sleepless(settings)), cubes(count) {
        level.environment.gravity = {0, 0, 0};
        add(gridOf(glm::ivec3(10),
                   [&](glm::ivec3 c) {
                       const bool isOpen = glm::all(glm::greaterThanEqual(c, glm::ivec3(wall))) &&
                                           glm::all(glm::lessThan(c, glm::ivec3(10 - wall)));
                       return uint8_t(isOpen ? 0 : 10);
                   }),
            glm::dvec3(-0.5), false);
        for (int i = 0; i < count; ++i)
            add(solidGrid({1, 1, 1}, 10), glm::dvec3(i & 1, i >> 1 & 1, i >> 2) * 0.2 - 0.15, false);
    }
    /// Of all, upward, N s.
    double momentum() const {
        double sum = 0.0;
        for (int i = 0; i <= cubes; ++i) sum += bodyMass(world, handle(i)).mass * double(body(i).velocity.y);
        return sum;
    }
    /// The cubes whose centres are farther from the box's middle than its walls.
    int outside() const {
        const Pose& box = body(0).pose;
        int count = 0;
        for (int i = 1; i <= cubes; ++i) {
            const glm::dvec3 at = box.inversePoint(center(i)) - 0.5;
            count += glm::any(glm::greaterThan(glm::abs(at), glm::dvec3(0.5)));
        }
        return count;
    }
};

TEST(BoxOfCubes, NothingLeavesABoxThatFlies) {
    for (const PhysicsSettings& settings : {fastPhysics(), balancedPhysics(), accuratePhysics()})
        for (const int wall : {1, 2, 3})
            for (const double speed : {5.0, 10.0, 20.0, 40.0, 100.0})
                for (const int cubes : {1, 2, 4, 8}) {
                    BoxOfCubes scene(settings, wall, cubes);
                    scene.level.bodies[0].velocity = {0.0f, float(speed), 0.0f};
                    scene.load();
                    const double momentum = scene.momentum();
                    scene.step(60);
                    EXPECT_NEAR(scene.momentum(), momentum, 0.02 * momentum);
                    EXPECT_EQ(scene.outside(), 0) << "of " << cubes << " in walls of " << wall << " voxels at " << speed
                                                  << " m/s, " << settings.substeps << " substeps";
                }
}

/// Shakes a box of eight cubes for 2 s, back and forth every `period` steps.
void expectNothingLeaves(int wall, double speed, int period) {
    BoxOfCubes scene({}, wall, 8);
    Joint& joint =
        known::addJoint(scene, JointKind::Prismatic, "", "body 0", {0.0, -0.45, 0.0}, {0.5, 0.05, 0.5}).joint;
    joint.ends[0].frame.rotation = joint.ends[1].frame.rotation = glm::angleAxis(0.5 * kPi, glm::dvec3(0.0, 0.0, 1.0));
    joint.motor = {MotorMode::Speed, speed, 1e7};
    scene.load();
    double way = 0.0;
    for (int i = 0; i < 120; ++i) {
        const glm::dvec3 before = scene.center(0);
        const JointMotor motor{MotorMode::Speed, i / period % 2 ? -speed : speed, 1e7};
        scene.stepWith({SetJointMotorEdit{.joint = scene.world.joints().handleAt(0), .motor = motor}});
        way += glm::length(scene.center(0) - before);
    }
    EXPECT_EQ(scene.outside(), 0) << "walls of " << wall << " voxels, " << speed << " m/s, " << period << " steps";
    EXPECT_GT(way, speed) << "the motor shakes it";
}

/// A cube that flies at a wall does not see that the wall turns back; a wall does not see that the cube before it is
/// stopped by another. The long run shakes 2,000 boxes.
TEST(BoxOfCubes, NothingLeavesABoxThatAMotorShakes) {
    const int steps = std::getenv("RUBBLE_LONG") ? 31 : 1;
    for (const int wall : {1, 2})
        for (const int period : {6, 7}) {
            for (int i = 0; i <= 16 * steps; ++i) expectNothingLeaves(wall, 4.0 + double(i) / steps, period);
            for (const double speed : {9.976, 10.012, 10.03, 10.04}) expectNothingLeaves(wall, speed, period);
        }
}

}  // namespace
}  // namespace rubble
