#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/physics/scenes/known_scenes.h"

namespace rubble {
namespace {

using namespace known;

TEST(FreeMotion, AnArcIsTheParabolaWhateverTheSpin) {
    for (const glm::vec3 spin : {glm::vec3(0.0f), glm::vec3(3.0f, 11.0f, -7.0f)}) {
        PhysicsScene scene(sleepless({}));
        LevelBody& body = scene.add(tHandle(), {0, 50, 0}, false);
        body.velocity = {8, 12, -3};
        body.angularVelocity = spin;
        scene.load();
        const glm::dvec3 start = scene.center(0), gravity = scene.world.environment().gravity;
        scene.seconds(3.0);
        const glm::dvec3 expected = start + glm::dvec3(8, 12, -3) * 3.0 + gravity * 4.5;
        EXPECT_LT(glm::length(scene.center(0) - expected), 1e-9);
    }
}

const std::vector<PhysicsSettings> kPresets{fastPhysics(), balancedPhysics(), accuratePhysics()};

TEST(FreeMotion, ASpinKeepsItsAngularMomentum) {
    for (const PhysicsSettings& settings : kPresets)
        for (const double speed : {0.02, 0.1, 0.29, 0.31, 5.0}) {
            SCOPED_TRACE(std::to_string(settings.substeps) + " substeps, " + std::to_string(speed) + " rad/s");
            const glm::dvec3 axis = glm::normalize(glm::dvec3(1.0, 2.0, -1.5));
            const FreeSpin spin = spinFreely(settings, tHandle(), axis * speed, 120.0);
            EXPECT_LT(spin.momentum, 1e-6);
            EXPECT_LT(spin.direction, 1e-6);
            EXPECT_LT(spin.energy, 1e-5);
        }
}

TEST(FreeMotion, THandleFlipsAsTheReferenceDoes) {
    PhysicsScene probe;
    probe.add(tHandle(), {0, 0, 0}, false);
    probe.load();
    const MassProperties mass = bodyMass(probe.world, probe.handle(0));
    const glm::dvec3& i = mass.principalInertia;
    int middle = 0;
    for (int k = 0; k < 3; ++k)
        if ((i[k] > i[(k + 1) % 3]) != (i[k] > i[(k + 2) % 3])) middle = k;
    glm::dvec3 spin(0.01);
    spin[middle] = 6.0;
    const glm::dvec3 world = glm::vec3(mass.principalAxes * spin);
    const FreeSpin ours = spinFreely({}, tHandle(), world, 60.0);
    const FreeSpin reference = spinReference(i, glm::conjugate(mass.principalAxes) * world, 60.0, 64);
    ASSERT_GT(reference.flips.size(), 10u);
    ASSERT_EQ(ours.flips.size(), reference.flips.size());
    const auto period = [](const FreeSpin& s) {
        return (s.flips.back() - s.flips.front()) / double(s.flips.size() - 1);
    };
    EXPECT_NEAR(period(ours), period(reference), 1e-3 * period(reference));
    EXPECT_LT(ours.momentum, 1e-9);
    EXPECT_LT(ours.energy, 1e-4);
}

TEST(FreeMotion, SymmetricTopPrecessesAtTheRateOfItsMomentum) {
    for (const PhysicsSettings& settings : kPresets) {
        PhysicsScene scene(sleepless(settings));
        scene.level.environment.gravity = {0, 0, 0};
        scene.add(solidGrid({9, 1, 9}, 7), {0, 0, 0}, false).angularVelocity = {4, 15, 0};
        scene.load();
        // The axis precesses about the constant momentum L at |L| / I, where I is the moment across the axis
        // (Goldstein, "Classical Mechanics", 5.6).
        const double across = (0.9 * 0.9 + 0.1 * 0.1) / 12.0, along = 2.0 * 0.9 * 0.9 / 12.0;
        const glm::dvec3 momentum(4.0 * across, 15.0 * along, 0.0);
        const double seconds = 20.0, rate = glm::length(momentum) / across;
        scene.seconds(seconds);
        const glm::dvec3 expected = glm::angleAxis(rate * seconds, glm::normalize(momentum)) * glm::dvec3(0, 1, 0);
        const glm::dvec3 axis = scene.body(0).pose.rotation * glm::dvec3(0, 1, 0);
        EXPECT_LT(glm::length(axis - expected), 0.02) << settings.substeps;  // of some 600 radians
    }
}

TEST(FreeMotion, RodsKeepMomentumAndEnergy) {
    for (const int length : {1, 4, 16, 64})
        for (const double speed : {1.0, 30.0}) {
            const glm::dvec3 spin = glm::normalize(glm::dvec3(1, 0.9, 0.3)) * speed;
            const FreeSpin rod = spinFreely({}, solidGrid({length, 1, 1}, 7), spin, 60.0);
            EXPECT_LT(rod.momentum, 1e-5) << length << " at " << speed;
            EXPECT_LT(rod.direction, 1e-5) << length << " at " << speed;
            EXPECT_LT(rod.energy, 1e-3) << length << " at " << speed;
        }
    const FreeSpin plank = spinFreely({}, solidGrid({24, 5, 2}, 7), {12, 17, 9}, 60.0);  // three different moments
    EXPECT_LT(plank.momentum, 1e-5);
    EXPECT_LT(plank.energy, 1e-3);
}

/// Their velocities are rounded to float, as those of bodies that may touch are. What that adds to the energy of both
/// is much of the energy of their motion against each other, and is not taken from it.
TEST(FreeMotion, NeighboursThatDoNotTouchKeepTheirVelocities) {
    for (int i = 1; i <= 20; ++i) {
        PhysicsScene scene(sleepless({}));
        const glm::dvec3 together = glm::dvec3(3.7, -2.9, 0.89) * (0.3 + 0.037 * i), past(0.0, 0.1, 0.0);
        scene.level.environment.gravity = {0, 0, 0};
        scene.add(solidGrid({10, 10, 3}, 7), {0, 50, 0}, false).velocity = together - past;
        scene.add(solidGrid({10, 10, 3}, 7), {1.001, 50, 0}, false).velocity = together + past;
        scene.load();
        const glm::dvec3 first = scene.body(0).velocity, second = scene.body(1).velocity;
        scene.step(2);
        const double rounding = glm::length(together) * 0x1p-24;  // half of the last digit of each component
        EXPECT_LE(glm::length(scene.body(0).velocity - first), rounding) << i;
        EXPECT_LE(glm::length(scene.body(1).velocity - second), rounding) << i;
    }
}

}  // namespace
}  // namespace rubble
