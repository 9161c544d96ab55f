#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "runtime/core/angles.h"
#include "runtime/core/constants.h"
#include "tests/physics/scenes/joint_scenes.h"
#include "tests/physics/scenes/known_scenes.h"

namespace rubble {
namespace {

using namespace known;

TEST(Angles, AgreeWithTheLibrary) {
    double worst = 0.0, worstSine = 0.0;
    for (int i = -1000; i <= 1000; ++i) {
        const double angle = kPi * i / 1000.0;
        double cosine, sine;
        deterministicCosSin(angle, cosine, sine);
        worstSine = std::max({worstSine, std::abs(cosine - std::cos(angle)), std::abs(sine - std::sin(angle))});
        if (std::abs(i) < 1000)
            worst = std::max(worst, std::abs(deterministicAtan2(3.0 * std::sin(angle), 3.0 * std::cos(angle)) - angle));
    }
    EXPECT_LT(worst, 1e-12);
    EXPECT_LT(worstSine, 1e-11);
    EXPECT_EQ(deterministicAtan2(0.0, 0.0), 0.0);
}

TEST(Joint, PendulumSwingsAtThePeriodOfItsMomentAndAmplitude) {
    for (const PhysicsSettings& settings : {fastPhysics(), balancedPhysics(), accuratePhysics()})
        for (const double degrees : {5.0, 60.0}) {
            const Pendulum pendulum = swing(settings, degrees);
            EXPECT_NEAR(pendulum.period / pendulum.expected, 1.0, 0.002) << degrees;
            EXPECT_GT(pendulum.kept, 0.95);
            EXPECT_LT(pendulum.kept, 1.001);
        }
}

TEST(Joint, LimitMotorSpringAndBreakForce) {
    EXPECT_LT(hitLimit({}, 0.8), 0.01);
    const Motor motor = turn({});
    EXPECT_NEAR(motor.acceleration / motor.expected, 1.0, 0.01);
    EXPECT_NEAR(motor.speed, 5.0, 1e-3);
    EXPECT_NEAR(springPeriod({}, 1.0), 1.0, 0.005);
    EXPECT_NEAR(springPeriod({}, 3.0), 1.0 / 3.0, 0.002);
    EXPECT_NEAR(breakFixed({}, 5000.0), 1.0, 0.05);
}

TEST(Joint, ASpringWithoutDampingHasNone) {
    for (const double hertz : {0.5, 1.0, 4.0}) {
        EXPECT_NEAR(springKeeps({}, hertz, 0.0), 1.0, 0.01) << hertz;
        EXPECT_NEAR(springKeeps({}, hertz, 0.1) / std::exp(-0.2 * kPi * 0.5 * 5.0), 1.0, 0.05) << hertz;
    }
    EXPECT_LT(springKeeps({}, 100.0, 0.0), 1.001) << "nor does it gain";
}

TEST(Joint, APositionMotorReachesItsTargetWhereverItsLoadIs) {
    for (const PhysicsSettings& settings : {fastPhysics(), balancedPhysics(), accuratePhysics()})
        for (const JointKind kind : {JointKind::Prismatic, JointKind::Hinge})
            for (const double length : {0.5, 1.5, 4.0})
                for (const double maxForce : {0.0, 1e5})
                    EXPECT_LT(std::abs(missedBy(settings, kind, length, maxForce)), 1e-3)
                        << "kind " << int(kind) << ", " << length << " m, largest force " << maxForce;
}

TEST(Joint, AChainStaysTogether) {
    EXPECT_LT(swingChain({}, 10, 30.0).apart, 1e-3);
    EXPECT_LT(hangHeavy({}, 5, 100.0), 1e-3);
    EXPECT_LT(hangHeavy({}, 5, 1000.0), 1e-3);
    EXPECT_LT(hangHeavy(accuratePhysics(), 5, 1000.0), 1e-3);
}

/// The pull turns light links back into their line faster than substeps are short.
TEST(Joint, AChainOfLightLinksHoldsAnyEnd) {
    for (const PhysicsSettings& settings : {fastPhysics(), balancedPhysics(), accuratePhysics()})
        for (const int links : {1, 3, 10})
            for (const double ratio : {1e3, 3e3, 1e4, 2e4})
                EXPECT_LT(hangHeavy(settings, links, ratio), 0.01) << links << " links, 1:" << ratio;
}

TEST(Rope, HoldsAThousandTimesTheMassOfItsPoints) {
    for (const double ratio : {10.0, 1000.0}) {
        const RopeSwing swing = swingOnRope({}, ratio);
        EXPECT_LT(swing.stretched, 0.001);
        EXPECT_LT(swing.longest, 0.03);
        EXPECT_NEAR(swing.period / swing.expected, 1.0, 0.005);
    }
    const Pulley pulley = hangOver({});
    EXPECT_GT(pulley.risen, 1.5);
    EXPECT_LT(pulley.sunk, 0.03);
}

/// Adds a cube at the origin on a joint to the world, whose frame is turned about z.
void addCubeOn(PhysicsScene& scene, JointKind kind, double degrees) {
    scene.add(solidGrid({4, 4, 4}, 7), {-0.2, -0.2, -0.2}, false);
    LevelJoint joint{{.kind = kind}, {"", "body 0"}};
    const glm::dquat turn = glm::angleAxis(degrees * kPi / 180.0, glm::dvec3(0, 0, 1));
    joint.joint.ends[0].frame = {{}, turn};
    joint.joint.ends[1].frame = {{0.2, 0.2, 0.2}, turn};
    scene.level.joints.push_back(joint);
}

TEST(Joint, AMotorLiftsWithAllOfItsForce) {
    for (const PhysicsSettings& settings : {fastPhysics(), balancedPhysics(), accuratePhysics()})
        for (const double acceleration : {0.1, 1.0, 4.0}) {
            PhysicsScene scene(settings);
            addCubeOn(scene, JointKind::Prismatic, 90.0);
            scene.load();
            const double mass = bodyMass(scene.world, scene.handle(0)).mass;
            scene.level.joints[0].joint.motor = {MotorMode::Speed, 2.0, mass * (9.81 + acceleration)};
            scene.load();
            scene.seconds(1.0);
            EXPECT_NEAR(scene.body(0).velocity.y, std::min(acceleration, 2.0), 0.01) << acceleration;
        }
}

TEST(Rope, IsLongerByItsStretchUnderALoad) {
    for (const double stretch : {0.01, 0.1, 1.0}) {
        PhysicsScene scene;
        addCubeOn(scene, JointKind::Rope, 0.0);
        scene.level.joints[0].joint.ends[0].frame.position.y = 4.2;
        scene.level.joints[0].joint.ends[1].frame.position.y = 0.4;
        scene.level.joints[0].joint.rope.length = 4.0;
        scene.level.joints[0].joint.rope.stretch = stretch;
        scene.load();
        const double mass = bodyMass(scene.world, scene.handle(0)).mass, expected = 4.0 * stretch * mass * 9.81 / 1e4;
        scene.seconds(20.0);
        EXPECT_NEAR(4.2 - scene.center(0).y - 0.2, 4.0 + expected, 0.02 * expected + 1e-4) << stretch;
    }
}

/// A block on a hinge, one on a rope, and a chain of two.
void addMobile(PhysicsScene& scene) {
    scene.addFloor();
    const auto hang = [&](JointKind kind, std::string first, std::string second, glm::dvec3 in, glm::dvec3 at) {
        LevelJoint joint{{.kind = kind}, {std::move(first), std::move(second)}};
        joint.joint.ends[0].frame.position = in;
        joint.joint.ends[1].frame.position = at;
        scene.level.joints.push_back(joint);
    };
    for (int i = 0; i < 4; ++i) scene.add(solidGrid({4, 4, 4}, 7), {1.0 * i, 3.0, 0.0}, false);
    hang(JointKind::Hinge, "", "body 1", {0.0, 3.4, 0.2}, {0.0, 0.4, 0.2});
    hang(JointKind::Rope, "", "body 2", {0.0, 5.0, 0.2}, {0.2, 0.4, 0.2});
    hang(JointKind::Ball, "body 3", "body 4", {0.4, 0.2, 0.2}, {-0.6, 0.2, 0.2});
    scene.level.joints.back().joint.ends[1].radius = 1.0;
}

TEST(Joint, TheSameBitsWithAnyNumberOfThreads) {
    std::vector<uint64_t> hashes;
    for (const int threads : {1, 2, 5}) {
        PhysicsSettings settings;
        if (threads > 1)
            settings.parallelFor = [threads](size_t count, const std::function<void(size_t)>& f) {
                std::atomic<size_t> next{0};
                std::vector<std::thread> workers;
                for (int t = 0; t < threads; ++t)
                    workers.emplace_back([&] {
                        for (size_t i = next++; i < count; i = next++) f(i);
                    });
                for (std::thread& worker : workers) worker.join();
            };
        PhysicsScene scene(settings);
        addMobile(scene);
        scene.load();
        scene.seconds(3.0);
        hashes.push_back(scene.world.hash());
    }
    EXPECT_EQ(hashes[0], hashes[1]);
    EXPECT_EQ(hashes[0], hashes[2]);
}

TEST(Joint, ARebuildFromTheWorldContinuesWithTheSameBits) {
    PhysicsScene first;
    addMobile(first);
    first.load();
    first.seconds(1.0);
    World copy = first.world;
    PhysicsWorld rebuilt;
    rebuilt.load(copy);
    first.physics.load(first.world);
    for (int i = 0; i < 60; ++i) {
        first.step();
        rebuilt.step();
        copy.setPoses(rebuilt.poses());
        copy.setRopes(rebuilt.ropes());
        ASSERT_EQ(copy.hash(), first.world.hash()) << i;
    }
}

TEST(Joint, JointedBodiesSleepAndWakeTogether) {
    PhysicsScene scene;
    addMobile(scene);
    scene.load();
    scene.seconds(40.0);
    for (int i = 3; i <= 4; ++i) EXPECT_TRUE(scene.body(i).asleep) << i;
    FrameChanges push;
    push.impulses.push_back({scene.handle(4), scene.center(4), {0.0, 60.0, 0.0}});
    scene.physics.apply(push, scene.world);
    scene.step(2);
    EXPECT_FALSE(scene.body(3).asleep);
    EXPECT_FALSE(scene.body(4).asleep);
}

TEST(Joint, JointedBodiesDoNotCollideUnlessToldTo) {
    for (const bool collides : {false, true}) {
        PhysicsScene scene;
        scene.level.environment.gravity = {0, 0, 0};
        scene.add(solidGrid({4, 4, 4}, 7), {0.0, 0.0, 0.0}, true);
        scene.add(solidGrid({4, 4, 4}, 7), {0.35, 0.13, 0.07}, false);  // overlaps the other by half a cell
        LevelJoint slide{{.kind = JointKind::Prismatic, .collides = collides}, {"body 0", "body 1"}};
        slide.joint.ends[0].frame.position = {0.35, 0.33, 0.27};
        slide.joint.ends[1].frame.position = {0.0, 0.2, 0.2};
        scene.level.joints.push_back(slide);
        scene.load();
        scene.seconds(1.0);
        EXPECT_EQ(std::abs(scene.body(1).pose.position.x - 0.35) > 0.01, collides);
    }
}

/// Whether a joint of a block of 64 kg breaks within a second. prepare: gets the joint and the block.
template <class F>
bool breaks(JointKind kind, double breakForce, double breakTorque, F&& prepare) {
    PhysicsScene scene;
    const uint8_t entry = setMaterial(scene, 8, 0.5f, 0.0f, 1000);
    LevelBody& block = scene.add(solidGrid({4, 4, 4}, entry), {-0.2, -0.2, -0.2}, false);
    LevelJoint joint{{.kind = kind}, {"", "body 0"}};
    joint.joint.ends[1].frame.position = {0.2, 0.2, 0.2};
    joint.joint.breakForce = breakForce;
    joint.joint.breakTorque = breakTorque;
    prepare(joint.joint, block);
    scene.level.joints.push_back(joint);
    scene.load();
    bool isBroken = false;
    for (int i = 0; i < 60; ++i) {
        scene.step();
        isBroken = isBroken || !scene.physics.jointBreaks().empty();
    }
    return isBroken;
}

TEST(Joint, BreaksByTheForceOfItsMotorSpringAndFriction) {
    for (const bool isWeak : {true, false}) {
        const double share = isWeak ? 0.7 : 1.5;
        EXPECT_EQ(breaks(JointKind::Hinge, 0.0, 100.0 * share,
                         [](Joint& joint, LevelBody&) {
                             joint.motor = {MotorMode::Speed, 1e3, 100.0};
                         }),
                  isWeak);
        EXPECT_EQ(breaks(JointKind::Hinge, 0.0, 100.0 * share,
                         [](Joint& joint, LevelBody& block) {
                             joint.friction = 100.0;
                             block.angularVelocity = {1000.0f, 0.0f, 0.0f};
                         }),
                  isWeak);
        EXPECT_EQ(breaks(JointKind::Ball, 0.0, 100.0 * share,
                         [](Joint& joint, LevelBody& block) {
                             joint.friction = 100.0;
                             block.angularVelocity = {1000.0f, 0.0f, 0.0f};
                         }),
                  isWeak);
        EXPECT_EQ(breaks(JointKind::Prismatic, 64.0 * 9.81 * share, 0.0,
                         [](Joint& joint, LevelBody&) {
                             const glm::dquat down = glm::angleAxis(-0.5 * kPi, glm::dvec3(0, 0, 1));
                             joint.ends[0].frame.rotation = joint.ends[1].frame.rotation = down;
                             joint.spring = {4.0, 1.0};
                         }),
                  isWeak);
    }
}

/// A motor's axis turns with the bodies: at the end of a step the speed about the axis of then is the target.
TEST(Joint, AMotorTurnsAboutTheAxisOfNow) {
    PhysicsScene scene;
    scene.level.environment.gravity = {0, 0, 0};
    scene.add(solidGrid({10, 2, 2}, 7), {-1.0, -0.1, -0.1}, false);
    scene.add(solidGrid({10, 2, 6}, 7), {0.0, -0.1, -0.3}, false);
    LevelJoint hinge{{.kind = JointKind::Hinge}, {"body 0", "body 1"}};
    hinge.joint.ends[0].frame.position = {1.0, 0.1, 0.1};
    hinge.joint.ends[1].frame.position = {0.0, 0.1, 0.3};
    hinge.joint.motor = {MotorMode::Speed, 5.0, 1e6};
    scene.level.joints.push_back(hinge);
    for (LevelBody& body : scene.level.bodies) {
        body.angularVelocity = {0.0f, 0.0f, 30.0f};
        body.velocity = {0.0f, body.name == "body 0" ? -15.0f : 15.0f, 0.0f};
    }
    scene.load();
    double worst = 0.0;
    for (int i = 0; i < 60; ++i) {
        scene.step();
        const glm::dvec3 axis = scene.body(0).pose.rotation * glm::dvec3(1, 0, 0);
        if (i > 10)
            worst = std::max(worst, std::abs(glm::dot(axis, glm::dvec3(scene.body(1).angularVelocity) -
                                                                glm::dvec3(scene.body(0).angularVelocity)) -
                                             5.0));
    }
    EXPECT_LT(worst, 0.01) << "rad/s";
}

/// A joint that is changed in every step, as a grab that a host moves, holds as one that is left alone.
TEST(Joint, AChangedJointKeepsItsImpulses) {
    std::vector<double> heights;
    for (const bool isChanged : {false, true}) {
        PhysicsScene scene(sleepless({}));
        scene.add(solidGrid({5, 5, 5}, 7), {-0.25, -0.25, -0.25}, false);
        LevelJoint grab{{.kind = JointKind::Ball}, {"", "body 0"}};
        grab.joint.ends[1].frame.position = {0.25, 0.5, 0.25};
        grab.joint.spring = {4.0, 1.0};
        grab.joint.maxForce = 1e5;
        scene.level.joints.push_back(grab);
        scene.load();
        FrameChanges changes;
        if (isChanged) changes.jointsChanged.push_back(scene.world.joints().handleAt(0));
        for (int i = 0; i < 300; ++i) {
            scene.physics.apply(changes, scene.world);
            scene.step();
        }
        heights.push_back(scene.center(0).y);
    }
    EXPECT_NEAR(heights[0], heights[1], 1e-6);
}

}  // namespace
}  // namespace rubble
