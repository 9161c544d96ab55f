#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "runtime/core/constants.h"
#include "tests/physics/scenes/energy.h"
#include "tests/physics/scenes/joint_scenes.h"
#include "tests/physics/scenes/known_scenes.h"
#include "tests/physics/scenes/load_scenes.h"

namespace rubble {
namespace {

constexpr double kMaxGain = 1e-3;  ///< joules from nothing for each joule lost

/// Steps a scene without motors and expects that it gains nothing.
known::EnergyRecord expectNoGain(PhysicsScene& scene, int steps, const std::string& what) {
    known::EnergyRecord energy(scene.world, {});
    for (int i = 0; i < steps; ++i) {
        scene.step();
        energy.update(scene.world);
    }
    const double rounding = 1e-6 * (std::abs(known::mechanicalEnergy(scene.world, 0.0)) + energy.lost() + 1.0);
    EXPECT_LT(energy.excess(), kMaxGain * energy.lost() + rounding) << what << ", joules more than at the start";
    return energy;
}

/// A cube on a rope of 6 m flies round a pole, on which the rope winds itself.
TEST(JointEnergy, ARopeThatWindsRoundAPoleGainsNothing) {
    for (const double gravity : {0.0, 9.81})
        for (const int diameter : {2, 4, 8, 16})
            for (const double mass : {1.0, 122.0, 1000.0})
                for (const double speed : {1.0, 3.0, 10.0, 30.0}) {
                    const known::Winding wound = known::windRope({}, gravity, diameter, mass, speed, 600);
                    EXPECT_LT(wound.gained, kMaxGain * wound.lost + 1e-6 * (std::abs(wound.energy) + wound.lost + 1.0))
                        << gravity << " m/s2, " << diameter << " voxels, " << mass << " kg, " << speed << " m/s";
                }
}

TEST(JointEnergy, APendulumOnARopeGainsNothing) {
    for (const double mass : {1.0, 122.0, 1000.0})
        for (const double degrees : {20.0, 80.0, 150.0}) {
            PhysicsScene scene(known::sleepless({}));
            const double a = degrees * kPi / 180.0;
            const glm::dvec3 end(4.0 * std::sin(a), -4.0 * std::cos(a), 0.0);
            scene.add(solidGrid({5, 5, 5}, known::entryOfMass(scene, mass, 125)), end - glm::dvec3(0.25), false);
            known::addJoint(scene, JointKind::Rope, "", "body 0", {}, {0.25, 0.5, 0.25});
            scene.load();
            expectNoGain(scene, 1200, std::to_string(mass) + " kg, " + std::to_string(degrees) + " degrees");
        }
}

TEST(JointEnergy, AChainOfBodiesGainsNothing) {
    for (const bool isFree : {false, true})
        for (const JointKind kind : {JointKind::Ball, JointKind::Hinge})
            for (const double ratio : {1.0, 100.0}) {
                PhysicsScene scene(known::sleepless({}));
                if (isFree) scene.level.environment.gravity = {0, 0, 0};
                const uint8_t heavy = known::entryOfMass(scene, 8.0 * ratio, 8);
                for (int i = 0; i < 6; ++i) {
                    LevelBody& link = scene.add(
                        solidGrid(i == 5 ? glm::ivec3(2, 2, 2) : glm::ivec3(4, 2, 2), i == 5 ? heavy : uint8_t(7)),
                        {0.4 * i, -0.1, -0.1}, false);
                    if (isFree) link.velocity = {0.0f, float(i % 2 ? 4 : -6), float(i)};
                    if (i == 0 && isFree) continue;
                    known::addJoint(scene, kind, i ? "body " + std::to_string(i - 1) : "", "body " + std::to_string(i),
                                    i ? glm::dvec3(0.4, 0.1, 0.1) : glm::dvec3(0.0), {0.0, 0.1, 0.1});
                }
                scene.load();
                expectNoGain(scene, 1200,
                             (isFree ? "free" : "hanging") + std::string(" chain, ratio ") + std::to_string(ratio));
            }
}

/// Free bodies keep their momentum when energy is taken from them.
TEST(JointEnergy, AFreeChainKeepsItsMomentum) {
    PhysicsScene scene(known::sleepless({}));
    scene.level.environment.gravity = {0, 0, 0};
    for (int i = 0; i < 6; ++i) {
        scene.add(solidGrid({4, 2, 2}, 7), {0.4 * i, -0.1, -0.1}, false).velocity = {0.0f, float(i % 2 ? 9 : -6),
                                                                                     float(i)};
        if (i)
            known::addJoint(scene, JointKind::Ball, "body " + std::to_string(i - 1), "body " + std::to_string(i),
                            {0.4, 0.1, 0.1}, {0.0, 0.1, 0.1});
    }
    scene.load();
    const auto momenta = [&] {
        glm::dvec3 linear(0.0), angular(0.0);
        for (int i = 0; i < 6; ++i) {
            const MassProperties mass = bodyMass(scene.world, scene.handle(i));
            const glm::dmat3 axes = glm::mat3_cast(scene.body(i).pose.rotation * mass.principalAxes);
            const glm::dvec3 p = glm::dvec3(scene.body(i).velocity) * mass.mass;
            linear += p;
            angular += glm::cross(scene.center(i), p) +
                       axes * (mass.principalInertia * (glm::transpose(axes) * scene.body(i).angularVelocity));
        }
        return std::pair(linear, angular);
    };
    scene.step();  // the first step makes the links move together
    const auto before = momenta();
    scene.step(600);
    const auto after = momenta();
    EXPECT_LT(glm::length(after.first - before.first) / glm::length(before.first), 1e-4);
    EXPECT_LT(glm::length(after.second - before.second) / glm::length(before.second), 1e-2)
        << "links are apart by little";
}

/// A frame of 4 m on rails along x, and a flap of 2 m that a joint holds above it.
struct Tipper : PhysicsScene {
    explicit Tipper(JointKind kind) : PhysicsScene(known::sleepless({})) {
        level.environment.gravity = {0, 0, 0};
        add(solidGrid({40, 4, 10}, 5), {-2.0, -0.2, -0.5}, false);
        add(solidGrid({20, 2, 10}, 5), {-1.0, 0.2, -0.5}, false);
        known::addJoint(level, JointKind::Prismatic, -1, 0, {});
        const glm::dquat up = glm::angleAxis(0.5 * kPi, glm::dvec3(0.0, 0.0, 1.0));
        Pose frame = known::hingeAt({-0.95, 0.25, 0.0});
        if (kind == JointKind::Prismatic) frame.rotation = up;
        known::addJoint(level, kind, 0, 1, frame).joint.limits = {true, -0.02, 0.8};
        for (LevelBody& body : level.bodies) body.velocity = {2.0f, 0.0f, 0.0f};
    }
    Joint& flap() { return level.joints.back().joint; }
    void drive(const JointMotor& motor, double time) {
        stepWith({SetJointMotorEdit{world.joints().handleAt(1), motor}});
        seconds(time);
    }
    /// Steps, and expects that it rolls on.
    void expectRollsOn(const std::string& what) {
        const glm::dvec3 from = center(0);
        seconds(1.0);
        EXPECT_NEAR(double(body(0).velocity.x), 2.0, 0.005) << what;
        EXPECT_NEAR(center(0).x - from.x, 2.0, 0.005) << what;
    }
};

/// What a motor pushes against its limit does no work, and takes none: not while it pushes, nor once it holds.
TEST(JointEnergy, AMotorAgainstItsLimitDoesNotBrakeWhatCarriesIt) {
    for (const JointKind kind : {JointKind::Hinge, JointKind::Prismatic})
        for (const double force : {4e3, 4e5}) {
            Tipper tipper(kind);
            tipper.load();
            const std::string what = "kind " + std::to_string(int(kind)) + ", " + std::to_string(force) + ", ";
            tipper.drive({MotorMode::Speed, 0.5, force}, 2.0);
            tipper.expectRollsOn(what + "up");
            tipper.drive({MotorMode::Speed, 0.0, force}, 0.2);
            tipper.expectRollsOn(what + "held up");
            tipper.drive({MotorMode::Speed, -0.5, force}, 3.0);
            tipper.expectRollsOn(what + "down");
            tipper.drive({MotorMode::Speed, 0.0, force}, 0.2);
            tipper.expectRollsOn(what + "held down");
            tipper.drive({MotorMode::Position, -1.0, force}, 1.0);
            tipper.expectRollsOn(what + "with a target beyond the limit");
            tipper.drive({MotorMode::Speed, -0.5, force}, 0.2);
            tipper.expectRollsOn(what + "down again");
            tipper.drive({}, 1.0);
            tipper.expectRollsOn(what + "let go");
        }
}

/// The same of a spring that ends beyond a limit.
TEST(JointEnergy, ASpringAgainstItsLimitDoesNotBrakeWhatCarriesIt) {
    for (const JointKind kind : {JointKind::Hinge, JointKind::Prismatic})
        for (const double hertz : {1.0, 5.0, 20.0}) {
            Tipper tipper(kind);
            tipper.flap().spring = {hertz, 1.0};
            tipper.flap().motor = {MotorMode::Position, -0.5, 0.0};
            tipper.load();
            tipper.seconds(2.0);
            tipper.expectRollsOn("kind " + std::to_string(int(kind)) + ", " + std::to_string(hertz) + " Hz");
        }
}

/// The same of a motor that pushes against what it touches.
TEST(JointEnergy, AMotorAgainstAnObstacleDoesNotBrakeWhatCarriesIt) {
    for (const JointKind kind : {JointKind::Hinge, JointKind::Prismatic})
        for (const double force : {4e3, 4e4}) {
            Tipper tipper(kind);
            tipper.flap().collides = true;
            tipper.flap().limits = {};
            tipper.load();
            tipper.drive({MotorMode::Speed, -0.5, force}, 1.0);
            const std::string what = "kind " + std::to_string(int(kind)) + ", " + std::to_string(force) + ", ";
            tipper.expectRollsOn(what + "pushed");
            tipper.drive({MotorMode::Speed, 0.0, force}, 0.2);
            tipper.expectRollsOn(what + "held");
        }
}

/// A winch lifts a load over a beam: its work is the load's height.
TEST(JointEnergy, AWinchGivesALoadItsHeight) {
    PhysicsScene scene(known::sleepless({}));
    scene.add(solidGrid({6, 6, 20}, 7), {-0.3, 5.0, -1.0}, true);
    scene.add(solidGrid({4, 4, 4}, 7), {-0.7, 0.0, -0.2}, true);
    scene.add(solidGrid({4, 4, 4}, known::entryOfMass(scene, 122.0, 64)), {0.2, 1.0, -0.2}, false);
    LevelJoint& rope = known::addJoint(scene, JointKind::Rope, "body 1", "body 2", {0.2, 0.4, 0.2}, {0.2, 0.4, 0.2});
    rope.joint.rope.points = 49;
    rope.joint.rope.length = 10.1;
    rope.joint.motor = {MotorMode::Speed, -0.5, 1.0};
    for (int i = 0; i <= 48; ++i) {  // up, over the beam, and down
        const double along = 10.1 * i / 48.0;
        const glm::dvec3 place = along < 5.25   ? glm::dvec3(-0.5 + 0.1 * along / 5.25, 0.4 + along, 0.0)
                                 : along < 6.05 ? glm::dvec3(-0.4 + (along - 5.25), 5.65, 0.0)
                                                : glm::dvec3(0.4, 5.65 - (along - 6.05), 0.0);
        rope.joint.points.push_back({place});
    }
    scene.load();
    scene.stepWith({});
    const double before = scene.center(2).y;
    double fastest = 0.0;
    for (int i = 0; i < 300; ++i) {
        scene.stepWith({});
        fastest = std::max(fastest, glm::length(scene.body(2).velocity));
    }
    EXPECT_NEAR(scene.center(2).y - before, 2.5, 0.3);
    EXPECT_LT(fastest, 1.5) << "m/s: it is lifted, not thrown";
}

}  // namespace
}  // namespace rubble
