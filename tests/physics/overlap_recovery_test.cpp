#include <gtest/gtest.h>

#include "tests/physics/baseline/overlap.h"
#include "tests/physics/physics_scene.h"

namespace rubble {
namespace {

/// Cubes that begin deep inside each other, aligned or slightly rotated: their corners accept no exit face.
TEST(OverlapRecovery, CubesComeApartSlowly) {
    for (const double turn : {0.0, 0.03, 0.1, 0.2, 0.4, 0.7}) {
        PhysicsSettings settings;
        settings.sleepTime = 1e9;
        PhysicsScene scene(settings);
        scene.addFloor();
        scene.add(solidGrid({10, 10, 10}, 7), {0.0, 0.0, 0.0}, false);
        scene.add(solidGrid({10, 10, 10}, 7), {0.7, 0.005, 0.01}, false, glm::angleAxis(turn, glm::dvec3(0, 1, 0)));
        scene.load();
        double fastest = 0.0;
        for (int i = 0; i < 180; ++i) {
            scene.step();
            fastest = std::max({fastest, glm::length(scene.body(1).velocity), glm::length(scene.body(2).velocity)});
        }
        EXPECT_GT(glm::length(scene.center(2) - scene.center(1)), 0.98) << turn;
        const std::vector<Pose> poses{scene.body(0).pose, scene.body(1).pose, scene.body(2).pose};
        EXPECT_LT(measureOverlaps(scene.level, poses).worst, 1e-3) << turn;
        EXPECT_LT(fastest, 4.0) << turn;
        EXPECT_LT(glm::length(scene.body(1).velocity) + glm::length(scene.body(2).velocity), 0.05) << turn;
    }
}

/// A tree of 25 tonnes whose foot is in the ground comes loose: it stays where it is and is not lifted out. Once it has
/// been pulled out, it lies on the ground as anything does.
TEST(OverlapRecovery, ABodyInTheGroundIsNotLiftedOut) {
    PhysicsScene scene;
    scene.add(solidGrid({200, 20, 200}, 7), {-10, -2, -10}, true);
    scene.add(solidGrid({20, 60, 20}, 7), {-1.0, -0.5, -1.0}, false);
    scene.load();
    const double height = scene.center(1).y, mass = bodyMass(scene.world, scene.handle(1)).mass;
    double highest = height;
    for (int i = 0; i < 240; ++i) {
        scene.step();
        highest = std::max(highest, scene.center(1).y);
    }
    EXPECT_LT(highest, height + 0.002);
    EXPECT_GT(scene.center(1).y, height - 0.01);
    EXPECT_TRUE(scene.body(1).asleep);

    FrameChanges pull;
    pull.impulses.push_back({scene.handle(1), scene.center(1), glm::dvec3(0.0, 6.0 * mass, 0.0)});
    scene.physics.apply(pull, scene.world);
    scene.seconds(5.0);
    EXPECT_GT(scene.center(1).y, height + 0.49);
}

/// How much energy a step gives to a plate of 133 tonnes on posts that overlap the walls of its holes a little on all
/// sides, at most, after the deepest overlap is gone: in metres of its height. turn: of the plate, radians.
double wedgedGain(double turn) {
    PhysicsSettings settings;
    settings.sleepTime = 1e9;
    PhysicsScene scene(settings);
    VoxelGrid posts({60, 30, 60}), plate = solidGrid({60, 20, 60}, 7);
    GridWriter post(posts), hole(plate);
    for (const int x : {10, 45})
        for (const int z : {10, 45})
            for (int i = 0; i < 25; ++i)
                for (int y = 0; y < 30; ++y) {
                    post.set({x + i % 5, y, z + i / 5}, 7);
                    if (y < 20) hole.set({x + i % 5, y, z + i / 5}, 0);
                }
    post.flush(), hole.flush();
    scene.add(posts, {0, 0, 0}, true);
    scene.add(plate, {0.2, 0.8, 0.04}, false, glm::angleAxis(turn, glm::normalize(glm::dvec3(0.3, 1.0, 0.2))));
    scene.load();
    const MassProperties mass = bodyMass(scene.world, scene.handle(1));
    const auto energy = [&] {
        const Body& body = scene.body(1);
        const glm::dvec3 w = glm::conjugate(body.pose.rotation * mass.principalAxes) * glm::dvec3(body.angularVelocity);
        return 0.5 * (mass.mass * glm::dot(body.velocity, body.velocity) + glm::dot(w, mass.principalInertia * w)) +
               mass.mass * 9.81 * scene.center(1).y;
    };
    scene.step();  // lifts it by eight millimetres
    double most = 0.0;
    for (int i = 1; i < 240; ++i) {
        const double before = energy();
        scene.step();
        most = std::max(most, energy() - before);
    }
    return most / (mass.mass * 9.81);
}

/// The scene is chaotic, so many of its kind are tried.
TEST(OverlapRecovery, AWedgedBodyGainsNoEnergy) {
    double worst = 0.0;
    for (int i = 0; i < 24; ++i) worst = std::max(worst, wedgedGain(0.04 + 0.001 * i));
    EXPECT_LT(worst, 0.0025) << "metres a step";
}

/// The impact of a very fast body has all of its impulse, including that of the inscribed sphere.
TEST(Impact, OfAFastBodyIsItsChangeOfMomentum) {
    PhysicsScene scene;
    scene.add(solidGrid({60, 60, 10}, 7), {-3.0, -3.0, 0.0}, true);
    scene.add(solidGrid({3, 3, 3}, 7), {0.0, 0.0, 3.0}, false,
              glm::angleAxis(0.3, glm::normalize(glm::dvec3(1, 1, 0))));
    scene.load();
    const double mass = bodyMass(scene.world, scene.handle(1)).mass;
    scene.physics.apply({}, scene.world);
    FrameChanges shot;
    shot.impulses.push_back({scene.handle(1), scene.center(1), glm::dvec3(0.0, 0.0, -200.0 * mass)});
    scene.physics.apply(shot, scene.world);
    double total = 0.0;
    for (int i = 0; i < 4 && total == 0.0; ++i) {
        const double before = i ? scene.body(1).velocity.z : -200.0;
        scene.step();
        for (const Impact& impact : scene.physics.impacts()) total += impact.impulse;
        if (total > 0.0) {
            EXPECT_NEAR(total / (mass * (scene.body(1).velocity.z - before)), 1.0, 0.05);
        }
    }
    EXPECT_GT(total, 0.0);
}

}  // namespace
}  // namespace rubble
