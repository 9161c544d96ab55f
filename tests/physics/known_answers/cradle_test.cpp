#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "physics/shapes/voxel_collider.h"
#include "runtime/core/constants.h"
#include "tests/physics/scenes/impact_scenes.h"
#include "tests/physics/scenes/known_scenes.h"
#include "tests/support/grids.h"

namespace rubble {
namespace {

using known::kCradleBodies;

TEST(Cradle, AsManyLeaveAsCameIn) {
    for (const bool areBalls : {false, true})
        for (const int incoming : {1, 2, 3})
            for (const double speed : {0.5, 1.0, 3.0, 10.0, 30.0})
                EXPECT_LT(known::cradleError({}, areBalls, incoming, speed), 0.02)
                    << incoming << (areBalls ? " balls at " : " cubes at ") << speed << " m/s";
}

/// What sleeps behind what is hit is woken with it: it is no wall.
TEST(Cradle, ARowThatSleepsHandsOnWhatHitsIt) {
    for (const bool isElastic : {true, false}) {
        PhysicsScene scene;
        scene.level.environment.gravity = {0, 0, 0};
        const uint8_t entry = known::setMaterial(scene, 7, 0.0f, isElastic ? 1.0f : 0.0f);
        for (int i = 0; i < kCradleBodies; ++i)
            scene.add(solidGrid({8, 8, 8}, entry), {0.8 * i - (i ? 0.0 : 0.23), 0, 0}, false);
        scene.level.bodies[0].velocity = {6.0f, 0.0f, 0.0f};
        scene.load(false);  // all but the first are asleep
        scene.step(30);
        double momentum = 0.0;
        for (int i = 0; i < kCradleBodies; ++i) {
            const double v = double(scene.body(i).velocity.x);
            momentum += v;
            if (isElastic) {
                EXPECT_NEAR(v, i + 1 < kCradleBodies ? 0.0 : 6.0, 0.12) << i;
            }
        }
        EXPECT_NEAR(momentum, 6.0, 0.06) << (isElastic ? "elastic" : "plastic");
    }
}

/// Momentum of a row after its first body has hit the others, which slept, of that before; the farthest from 1.
/// phase: of a step, in which it hits. areJoined: by ball joints.
double worstMomentum(int count, bool areJoined, double speed, double phase) {
    PhysicsScene scene;
    scene.level.environment.gravity = {0, 0, 0};
    const uint8_t entry = known::setMaterial(scene, 7, 0.0f, 0.0f);
    for (int i = 0; i <= count; ++i)
        scene.add(solidGrid({8, 8, 8}, entry), {0.8 * i - (i ? 0.0 : speed * (5.0 + phase) / 60.0), 0, 0}, false);
    for (int i = 1; areJoined && i < count; ++i) {
        LevelJoint joint{{.kind = JointKind::Ball}, {"body " + std::to_string(i), "body " + std::to_string(i + 1)}};
        for (const size_t end : {0u, 1u}) joint.joint.ends[end].frame.position = {end ? 0.0 : 0.8, 0.4, 0.4};
        scene.level.joints.push_back(joint);
    }
    scene.level.bodies[0].velocity.x = float(speed);
    scene.load(false);  // all but the first are asleep
    double worst = 1.0;
    for (int step = 0; step < 10; ++step) {
        scene.step(1);
        double momentum = 0.0;
        for (int i = 0; i <= count; ++i) momentum += double(scene.body(i).velocity.x) / speed;
        if (std::abs(momentum - 1.0) > std::abs(worst - 1.0)) worst = momentum;
    }
    return worst;
}

/// Wherever in a step the hit comes, and whatever is behind what is hit or hangs on it.
TEST(Cradle, AHitOnSleepersKeepsItsMomentum) {
    for (const int count : {1, 2, 4})
        for (const bool areJoined : {false, true})
            for (const double speed : {0.5, 1.0, 2.0, 5.0, 10.0})
                for (double phase = 0.0; phase < 1.0; phase += 0.04)
                    EXPECT_NEAR(worstMomentum(count, areJoined, speed, phase), 1.0, 0.02)
                        << count << (areJoined ? " joined, " : ", ") << speed << " m/s, phase " << phase;
}

TEST(Cradle, ARowThatLosesSpeedGainsNoEnergyAndKeepsItsMomentum) {
    for (const float restitution : {0.3f, 0.8f}) {
        PhysicsScene scene(known::sleepless({}));
        known::addCradle(scene, false, 1, 10.0, restitution);
        scene.step(60);
        double momentum = 0.0, energy = 0.0;
        for (int i = 0; i < kCradleBodies; ++i) {
            const double v = double(scene.body(i).velocity.x);
            momentum += v, energy += v * v;
            const double behind = i > 0 ? double(scene.body(i - 1).velocity.x) : -1.0;
            EXPECT_GE(v, behind - 1e-3) << "they part";
        }
        EXPECT_NEAR(momentum, 10.0, 1e-3);
        EXPECT_LT(energy, 100.0);
    }
}

/// Balls on rods: the first is lifted by 40 degrees.
TEST(Cradle, TheLastBallSwingsAsHighAsTheFirst) {
    PhysicsScene scene(known::sleepless({}));
    const uint8_t entry = known::setMaterial(scene, 7, 0.0f, 1.0f);
    const VoxelGrid grid = known::ball(4, entry);
    const double r = 0.1 * double(fitRoundSurface(grid, {glm::ivec3(0), grid.size()}, CollisionShape::Sphere)->radius),
                 length = 2.0;
    for (int i = 0; i < kCradleBodies; ++i) {
        const glm::dvec3 pivot(2.0 * r * i, length, 0.0);
        const glm::dquat turn = glm::angleAxis(i ? 0.0 : -40.0 * kPi / 180.0, glm::dvec3(0, 0, 1));
        LevelBody& body = scene.add(grid, pivot + turn * glm::dvec3(-0.2, -length - 0.2, -0.2), false, turn);
        body.shapes[0].collisionShape = CollisionShape::Sphere;
        LevelJoint joint{{.kind = JointKind::Hinge}, {body.name, ""}};
        const glm::dquat aside = glm::angleAxis(-0.5 * kPi, glm::dvec3(0, 1, 0));  // x to z
        joint.joint.ends[0] = {.frame = {{0.2, length + 0.2, 0.2}, aside}, .radius = 10.0};
        joint.joint.ends[1] = {.frame = {pivot, aside}};
        scene.level.joints.push_back(joint);
    }
    scene.load();
    const double lift = scene.center(0).y - scene.center(1).y, fall = std::sqrt(2.0 * 9.81 * lift);
    double fastest = 0.0, highest = 0.0, others = 0.0;
    for (int i = 0; i < 100; ++i) {  // half a period is 1.46 s
        scene.step();
        fastest = std::max(fastest, double(scene.body(kCradleBodies - 1).velocity.x));
        highest = std::max(highest, scene.center(kCradleBodies - 1).y);
        if (fastest > 0.5 && double(scene.body(kCradleBodies - 1).velocity.x) > 0.0)
            for (int k = 0; k + 1 < kCradleBodies; ++k)
                others = std::max(others, double(glm::length(scene.body(k).velocity)));
    }
    EXPECT_NEAR(fastest / fall, 1.0, 0.02);
    EXPECT_NEAR(highest / lift, 1.0, 0.04);
    EXPECT_LT(others / fall, 0.02);
}

}  // namespace
}  // namespace rubble
