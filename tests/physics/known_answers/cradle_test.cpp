#include <gtest/gtest.h>

#include <cmath>

#include "physics/shapes/voxel_collider.h"
#include "runtime/core/constants.h"
#include "tests/physics/scenes/known_scenes.h"

namespace rubble {
namespace {

constexpr int kBalls = 5;

VoxelGrid ball(int across, uint8_t entry) {
    return gridOf(glm::ivec3(across), [&](glm::ivec3 c) {
        const glm::ivec3 d = 2 * c + 1 - across;
        return uint8_t(d.x * d.x + d.y * d.y + d.z * d.z <= across * across ? entry : 0);
    });
}

/// A row of elastic bodies that touch, along x; the first `incoming` come in a little later.
void addRow(PhysicsScene& scene, bool areBalls, int incoming, double speed, float restitution = 1.0f) {
    scene.level.environment.gravity = {0, 0, 0};
    const uint8_t entry = known::setMaterial(scene, 7, 0.0f, restitution);
    const VoxelGrid grid = areBalls ? ball(8, entry) : solidGrid({8, 8, 8}, entry);
    const std::optional<RoundSurface> fit = fitRoundSurface(grid, {glm::ivec3(0), grid.size()}, CollisionShape::Sphere);
    const double apart = areBalls ? 0.2 * double(fit->radius) : 0.8;
    for (int i = 0; i < kBalls; ++i) {
        const bool isIncoming = i < incoming;
        LevelBody& body = scene.add(grid, {i * apart - (isIncoming ? 0.23 : 0.0), 0, 0}, false);
        if (isIncoming) body.velocity = {float(speed), 0, 0};
        if (areBalls) body.shapes[0].collisionShape = CollisionShape::Sphere;
    }
    scene.load();
}

TEST(Cradle, AsManyLeaveAsCameIn) {
    for (const bool areBalls : {false, true})
        for (const int incoming : {1, 2, 3})
            for (const double speed : {2.0, 3.0, 10.0, 30.0}) {
                PhysicsScene scene(known::sleepless({}));
                addRow(scene, areBalls, incoming, speed);
                scene.step(30);
                for (int i = 0; i < kBalls; ++i)
                    EXPECT_NEAR(double(scene.body(i).velocity.x), i < kBalls - incoming ? 0.0 : speed, 0.02 * speed)
                        << (areBalls ? "ball " : "cube ") << i << " of " << incoming << " at " << speed << " m/s";
            }
}

TEST(Cradle, ARowThatLosesSpeedGainsNoEnergyAndKeepsItsMomentum) {
    for (const float restitution : {0.3f, 0.8f}) {
        PhysicsScene scene(known::sleepless({}));
        addRow(scene, false, 1, 10.0, restitution);
        scene.step(60);
        double momentum = 0.0, energy = 0.0;
        for (int i = 0; i < kBalls; ++i) {
            const double v = double(scene.body(i).velocity.x);
            momentum += v, energy += v * v;
            if (i > 0) EXPECT_GE(v, double(scene.body(i - 1).velocity.x) - 1e-3) << "they part";
        }
        EXPECT_NEAR(momentum, 10.0, 1e-3);
        EXPECT_LT(energy, 100.0);
    }
}

/// Balls on rods: the first is lifted by 40 degrees.
TEST(Cradle, TheLastBallSwingsAsHighAsTheFirst) {
    PhysicsScene scene(known::sleepless({}));
    const uint8_t entry = known::setMaterial(scene, 7, 0.0f, 1.0f);
    const VoxelGrid grid = ball(4, entry);
    const double r = 0.1 * double(fitRoundSurface(grid, {glm::ivec3(0), grid.size()}, CollisionShape::Sphere)->radius),
                 length = 2.0;
    for (int i = 0; i < kBalls; ++i) {
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
        fastest = std::max(fastest, double(scene.body(kBalls - 1).velocity.x));
        highest = std::max(highest, scene.center(kBalls - 1).y);
        if (fastest > 0.5 && double(scene.body(kBalls - 1).velocity.x) > 0.0)
            for (int k = 0; k + 1 < kBalls; ++k) others = std::max(others, double(glm::length(scene.body(k).velocity)));
    }
    EXPECT_NEAR(fastest / fall, 1.0, 0.02);
    EXPECT_NEAR(highest / lift, 1.0, 0.04);
    EXPECT_LT(others / fall, 0.02);
}

}  // namespace
}  // namespace rubble
