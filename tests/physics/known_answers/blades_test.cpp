#include <gtest/gtest.h>

#include <cmath>

#include "runtime/core/constants.h"
#include "tests/physics/scenes/known_scenes.h"

namespace rubble {
namespace {

/// A blade of 8 m that spins about the world's y axis, and a post that it meets.
struct Blade {
    double spin;      ///< rad/s
    double at;        ///< metres from the axis to the post
    double angle;     ///< radians from the blade to the post
    int thickness;    ///< of the blade, voxels
    int post;         ///< its side, voxels
    bool isHinged;    ///< to the world
    bool isAtItsEnd;  ///< the axis; else in the middle
    bool hasMotor;    ///< that turns it on
    bool isPostStatic;
};

double kineticEnergy(const PhysicsScene& scene) {
    double sum = 0.0;
    for (int i = 0; i < int(scene.level.bodies.size()); ++i) {
        const Body& body = scene.body(i);
        if (body.isStatic) continue;
        const MassProperties mass = bodyMass(scene.world, scene.handle(i));
        const glm::dvec3 v(body.velocity),
            w = glm::conjugate(body.pose.rotation * mass.principalAxes) * glm::dvec3(body.angularVelocity);
        sum += 0.5 * (mass.mass * glm::dot(v, v) + glm::dot(w, mass.principalInertia * w));
    }
    return sum;
}

/// A blade (body 0) and a post (body 1). hub: the axis, in the blade.
void addBlade(PhysicsScene& scene, const Blade& blade, const glm::dvec3& hub) {
    scene.level.environment.gravity = {0, 0, 0};
    const double half = 0.05 * blade.thickness, side = 0.1 * blade.post;
    LevelBody& body = scene.add(solidGrid({80, blade.thickness, blade.thickness}, 7), -hub, false);
    body.angularVelocity = {0.0f, float(blade.spin), 0.0f};
    body.velocity = glm::vec3(glm::cross(glm::dvec3(body.angularVelocity), glm::dvec3(4.0, half, half) - hub));
    const glm::dvec3 place(blade.at * std::cos(blade.angle), 0.0, -blade.at * std::sin(blade.angle));
    scene.add(solidGrid({blade.post, 20, blade.post}, 7), place - glm::dvec3(0.5 * side, 1.0, 0.5 * side),
              blade.isPostStatic);
    if (!blade.isHinged) return;
    LevelJoint joint{{.kind = JointKind::Hinge}, {scene.level.bodies[0].shapes[0].name, ""}};
    const glm::dquat up = glm::angleAxis(0.5 * kPi, glm::dvec3(0, 0, 1));  // x to y
    joint.joint.ends[0].frame = {hub, up};
    joint.joint.ends[1].frame = {{0, 0, 0}, up};
    if (blade.hasMotor) joint.joint.motor = {MotorMode::Speed, -blade.spin, 1e6};
    scene.level.joints.push_back(joint);
}

struct Hit {
    bool isHit = false;
    bool passed = false;  ///< the post has been on both sides of the blade
    double energy = 0.0;  ///< after the hit, as a share of that before
};

/// Spins until the blade has hit the post, or for a whole turn.
Hit spin(const Blade& blade) {
    PhysicsScene scene(known::sleepless({}));
    const double half = 0.05 * blade.thickness;
    const glm::dvec3 hub(blade.isAtItsEnd ? 0.05 : 4.0, half, half);
    addBlade(scene, blade, hub);
    scene.load();
    const double before = kineticEnergy(scene);
    // The angle from the blade to the post about y, as the blade sees it from its hub.
    const auto angleNow = [&] {
        const Pose& pose = scene.body(0).pose;
        const glm::dvec3 along = pose.rotation * glm::dvec3(1, 0, 0), to = scene.center(1) - pose.transformPoint(hub);
        return std::atan2(glm::cross(along, to).y, along.x * to.x + along.z * to.z);
    };
    Hit hit;
    const double arms = blade.isAtItsEnd ? 2.0 * kPi : kPi;  // from one arm to the next
    const int turn = int(std::ceil(2.0 * kPi / blade.spin * 60.0)) + 1;
    double angle = angleNow();
    for (int i = 0; i < turn && !hit.isHit; ++i) {
        scene.step();
        hit.isHit = std::abs(double(scene.body(0).angularVelocity.y) / blade.spin - 1.0) > 1e-3 ||
                    glm::length(scene.body(1).velocity) > 0.0f;
        const double now = angle + std::remainder(angleNow() - angle, 2.0 * kPi);
        const double away = glm::length(scene.center(1) - scene.body(0).pose.transformPoint(hub));
        const bool isInReach = away < (blade.isAtItsEnd ? 8.0 : 4.0);  // not flung out of it
        hit.passed = hit.passed || (isInReach && std::floor(now / arms) != std::floor(angle / arms));
        angle = now;
    }
    hit.energy = kineticEnergy(scene) / before;
    return hit;
}

TEST(Blades, NoBladePassesAPost) {
    int passed = 0, gained = 0, missed = 0, all = 0;
    const auto check = [&](const Blade& blade) {
        const Hit hit = spin(blade);
        ++all, passed += hit.passed, missed += !hit.isHit, gained += !blade.hasMotor && hit.energy > 1.001;
    };
    for (const int kind : {0, 1, 2, 3})  // free; hinged at its end; in its middle; at its end, with a motor
        for (const int post : {1, 2, 4})
            for (const double speed : {10.0, 30.0, 60.0, 80.0, 100.0})
                for (const double at : {0.5, 1.7, 3.0, 3.7})
                    for (const double angle : {0.6, 1.1, 1.7, 2.6})
                        for (const int variant : {0, 1, 2, 3}) {
                            const bool isAtItsEnd = kind % 2 == 1;
                            check({speed, isAtItsEnd ? 2.0 * at : at, angle, variant % 2 ? 3 : 1, post, kind > 0,
                                   isAtItsEnd, kind == 3, variant < 2});
                        }
    EXPECT_EQ(passed, 0) << "of " << all;
    EXPECT_EQ(missed, 0) << "of " << all;
    EXPECT_EQ(gained, 0) << "of " << all;
}

}  // namespace
}  // namespace rubble
