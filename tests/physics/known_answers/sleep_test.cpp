#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "runtime/core/constants.h"
#include "runtime/core/random.h"
#include "tests/physics/baseline/voronoi_pit.h"
#include "tests/physics/scenes/joint_scenes.h"
#include "tests/physics/scenes/known_scenes.h"

// Nothing sleeps that would move if it were left awake, and nothing slows down that theory keeps in motion.

namespace rubble {
namespace {

/// Steps until a coordinate changes its sign a second time; seconds between the two, or 0.
double halfPeriod(PhysicsScene& scene, double limit, const std::function<double()>& coordinate) {
    double first = -1.0, last = coordinate();
    for (int i = 1; i < scene.stepsIn(limit); ++i) {
        scene.step();
        const double now = coordinate();
        if (last * now < 0.0) {
            const double time = (i - 1 + last / (last - now)) * scene.stepSeconds;
            if (first >= 0.0) return time - first;
            first = time;
        }
        last = now;
    }
    return 0.0;
}

/// A bob on a hinge far above it; it starts at a turning point, and passes others.
TEST(Sleep, APendulumDoesNotStopAtItsTurningPoints) {
    for (const double period : {7.0, 12.0, 20.0})
        for (const double amplitude : {0.15, 1.0}) {  // metres
            PhysicsScene scene;
            const double length = kGravity * period * period / (4.0 * kPi * kPi);
            scene.add(solidGrid({4, 4, 4}, 7), {amplitude - 0.2, -length - 0.2, -0.2}, false);
            LevelJoint& hinge = known::addJoint(scene.level, JointKind::Hinge, -1, 0, known::hingeAt({0, 0, 0}));
            hinge.joint.ends[1].cell = {0, 0, 0};
            scene.load();
            const double half = halfPeriod(scene, 2.0 * period, [&] { return scene.center(0).x; });
            EXPECT_NEAR(half, 0.5 * period, 0.01 * period) << period << " s, " << amplitude << " m";
        }
}

TEST(Sleep, ASlowSpringSwings) {
    PhysicsScene scene;
    scene.level.environment.gravity = {0, 0, 0};
    scene.add(solidGrid({3, 3, 3}, 7), {-0.15, -0.15, -0.15}, false);
    LevelJoint& slide = known::addJoint(scene.level, JointKind::Prismatic, -1, 0, {});
    slide.joint.spring = {0.1, 0.0};
    slide.joint.ends[0].frame.position.x = 0.3;
    scene.load();
    EXPECT_NEAR(halfPeriod(scene, 20.0, [&] { return scene.center(0).x - 0.3; }), 5.0, 0.05);
}

/// The time in which a rigid body falls from standstill about an edge until it has turned by `angle`: its centre is
/// `beyond` metres beyond the edge and `height` above it. moment: about the edge, over the mass, m2.
double fallTime(double beyond, double height, double moment, double angle) {
    double turned = 0.0, spin = 0.0, time = 0.0;
    for (const double h = 1e-4; turned < angle; time += h) {
        spin += h * kGravity * (beyond * std::cos(turned) + height * std::sin(turned)) / moment;
        turned += h * spin;
    }
    return time;
}

/// A pillar of 30 m in one piece or of blocks, whose middle is a little beyond the edge of what it stands on.
TEST(Sleep, APillarBeyondItsEdgeFalls) {
    for (const double beyond : {0.26, 0.05}) {
        PhysicsScene scene;
        scene.add(solidGrid({20, 50, 20}, 7), {-2.0, -5.0, -1.0}, true);
        scene.add(solidGrid({10, 300, 10}, 7), {beyond - 0.5, 0.0, -0.5}, false);
        scene.load();
        const double angle = 1.0, moment = (900.0 + 1.0) / 12.0 + 225.0 + beyond * beyond;
        double time = 0.0;
        while (time < 30.0) {
            scene.step();
            time += scene.stepSeconds;
            const glm::dvec3 up = scene.body(1).pose.rotation * glm::dvec3(0, 1, 0);
            if (std::acos(std::clamp(up.y, -1.0, 1.0)) > angle) break;
        }
        const double expected = fallTime(beyond, 15.0, moment, angle);
        EXPECT_NEAR(time, expected, 0.05 * expected) << beyond << " m beyond";
    }
}

TEST(Sleep, ATowerOfBlocksBeyondItsEdgeFalls) {
    PhysicsScene scene;
    scene.add(solidGrid({20, 50, 20}, 7), {-2.0, -5.0, -1.0}, true);
    for (int i = 0; i < 6; ++i) scene.add(solidGrid({10, 50, 10}, 7), {-0.3, 5.0 * i, -0.5}, false);
    scene.load();
    scene.seconds(12.0);
    for (int i = 1; i <= 6; ++i) EXPECT_LT(scene.center(i).y, 5.0 * i - 4.0) << i;
}

TEST(Sleep, AFrictionlessPlateKeepsItsSpin) {
    PhysicsScene scene;
    const uint8_t entry = known::setMaterial(scene, 7, 0.0f, 0.0f);
    scene.addFloor(entry);
    scene.add(solidGrid({80, 1, 20}, entry), {-4.0, 0.0, -1.0}, false).angularVelocity = {0.0f, 1.0f, 0.0f};
    scene.load();
    scene.seconds(10.0);
    EXPECT_NEAR(scene.body(1).angularVelocity.y, 1.0, 0.01);
}

TEST(Sleep, ASlowSliderWithoutFrictionGoesOn) {
    for (const double speed : {0.28, 0.1, 0.03}) {
        PhysicsScene scene;
        const uint8_t entry = known::setMaterial(scene, 7, 0.0f, 0.0f);
        scene.addFloor(entry);
        scene.add(solidGrid({5, 5, 5}, entry), {-4.0, 0.0, 0.0}, false).velocity = {float(speed), 0.0f, 0.0f};
        scene.load();
        const double start = scene.center(1).x;
        scene.seconds(10.0);
        EXPECT_NEAR((scene.center(1).x - start) / (10.0 * speed), 1.0, 0.02) << speed;
    }
}

TEST(Sleep, IceAboveItsAngleOfFrictionSlides) {
    const double friction = 0.03;
    for (const double more : {0.002, 0.0005}) {  // radians
        PhysicsScene scene;
        const uint8_t entry = known::setMaterial(scene, 7, float(friction), 0.0f);
        const double angle = std::atan(friction) + more;
        const glm::dquat tilt = glm::angleAxis(angle, glm::dvec3(0, 0, 1));
        scene.add(solidGrid({300, 5, 40}, entry), tilt * glm::dvec3(-25, -0.5, -2), true, tilt);
        scene.add(solidGrid({6, 3, 6}, entry), tilt * glm::dvec3(0.0, 0.0, -0.3), false, tilt);
        scene.load();
        const glm::dvec3 start = scene.center(1);
        scene.seconds(10.0);
        const double expected = 50.0 * kGravity * (std::sin(angle) - friction * std::cos(angle));
        EXPECT_NEAR(glm::length(scene.center(1) - start) / expected, 1.0, 0.05) << more;
    }
}

/// 64 t on a lake whose water brakes by e in `1 / drag` seconds.
TEST(Sleep, ARaftLosesWhatItsWaterTakes) {
    const double drag = 0.1, speed = 0.25;
    PhysicsScene scene;
    scene.level.materials.materials[1].density = 500;
    scene.level.waters.push_back({.name = "lake",
                                  .outline = {{-50, -50}, {50, -50}, {50, 50}, {-50, 50}},
                                  .depth = 40.0,
                                  .linearDrag = drag,
                                  .angularDrag = drag});
    scene.add(solidGrid({80, 20, 80}, 1), {-4.0, -1.0, -4.0}, false).velocity = {float(speed), 0.0f, 0.0f};
    scene.load();
    scene.seconds(15.0);
    EXPECT_NEAR(scene.center(0).x, speed / drag * (1.0 - std::exp(-15.0 * drag)), 0.05);
}

/// A closed box turns slowly in zero gravity. The speck in it, a millionth of its mass, always touches it somewhere.
TEST(Sleep, SlowRotationOfWhatTouchesSomethingKeepsItsMomentum) {
    for (const double spin : {0.05, 0.2, 0.29}) {
        PhysicsScene scene(known::sleepless({}));
        scene.level.environment.gravity = {0, 0, 0};
        const uint8_t heavy = known::setMaterial(scene, 7, 0.0f, 0.0f, 4000),
                      light = known::setMaterial(scene, 8, 0.0f, 0.0f, 1);
        const glm::ivec3 size(40, 10, 4);
        VoxelGrid box = gridOf(size, [&](glm::ivec3 c) {
            const bool isInside = glm::all(glm::greaterThan(c, glm::ivec3(0))) && glm::all(glm::lessThan(c, size - 1));
            return isInside ? uint8_t(0) : heavy;
        });
        scene.add(std::move(box), -0.05 * glm::dvec3(size), false).angularVelocity =
            glm::vec3(spin * glm::normalize(glm::dvec3(1.0, 0.2, 1.0)));
        scene.add(solidGrid({1, 1, 1}, light), {1.85, 0.35, 0.0}, false);
        scene.load();
        const MassProperties mass = bodyMass(scene.world, scene.handle(0));
        const auto momentum = [&] {
            const Body& body = scene.body(0);
            const glm::dquat axes = body.pose.rotation * mass.principalAxes;
            return axes * (mass.principalInertia * (glm::conjugate(axes) * glm::dvec3(body.angularVelocity)));
        };
        const glm::dvec3 before = momentum();
        int touching = 0;
        for (int i = 0; i < 60 * 60; ++i) scene.step(), touching += scene.physics.stats().contacts > 0;
        EXPECT_GT(touching, 1800);
        EXPECT_LT(glm::length(momentum() - before) / glm::length(before), 0.005) << spin << " rad/s";
    }
}

/// A crate on a lift that has moved before, and holds still while the crate comes to rest and settles.
TEST(Sleep, SettledDebrisWakesWhenWhatBearsItLeaves) {
    PhysicsScene scene;
    scene.add(solidGrid({20, 2, 20}, 7), {-1.0, 0.0, -1.0}, false);
    LevelJoint& lift = known::addJoint(scene.level, JointKind::Prismatic, -1, 0,
                                       {{0.0, 0.1, 0.0}, glm::angleAxis(0.5 * kPi, glm::dvec3(0, 0, 1))});
    lift.joint.limits = {true, -3.0, 0.3};
    lift.joint.motor = {MotorMode::Speed, 0.5, 1e6};  // it presses against its upper limit
    scene.add(solidGrid({4, 4, 4}, 7), {-0.2, 0.8, -0.2}, false);
    scene.load();
    scene.seconds(4.0);
    ASSERT_TRUE(scene.body(1).asleep);
    ASSERT_FALSE(scene.body(0).asleep);
    FrameChanges settled;
    settled.settled.push_back(scene.handle(1));
    scene.physics.apply(settled, scene.world);
    scene.seconds(1.0);
    ASSERT_TRUE(scene.body(1).asleep);
    scene.world.joints().forEach([&](JointHandle joint, const Joint&) {
        scene.stepWith({SetJointMotorEdit{joint, {MotorMode::Speed, -0.5, 1e6}}});
    });
    scene.seconds(4.0);
    const double gap = scene.center(1).y - scene.center(0).y;
    EXPECT_NEAR(gap, 0.3, 0.02) << "it goes down with the lift";
}

/// A plank whose end a motor lifts by 6 mm/s, and next to its hinge a cube, which is as slow as what rests.
TEST(Sleep, WhatLiesOnSomethingThatMovesStaysAwake) {
    PhysicsScene scene;
    scene.add(solidGrid({60, 2, 6}, 7), {0.0, 0.0, -0.3}, false);
    LevelJoint& hinge = known::addJoint(scene.level, JointKind::Hinge, -1, 0,
                                        {{0.0, 0.1, 0.0}, glm::angleAxis(-0.5 * kPi, glm::dvec3(0, 1, 0))});
    hinge.joint.motor = {MotorMode::Speed, 1e-3, 1e6};
    scene.add(solidGrid({4, 4, 4}, 7), {0.1, 0.2, -0.2}, false);
    scene.load();
    scene.seconds(1.0);
    int asleep = 0;
    for (int i = 0; i < 120; ++i) scene.step(), asleep += scene.body(1).asleep;
    EXPECT_EQ(asleep, 0) << "steps";
    EXPECT_NEAR(double(glm::length(scene.body(0).angularVelocity)), 1e-3, 1e-4) << "the plank turns";
}

/// What wakes by a hit has contacts in that step, with what it lies on too.
TEST(Sleep, AThinPlateThatIsHitInItsSleepIsNotPressedIntoTheFloor) {
    PhysicsScene scene;
    scene.addFloor();
    scene.add(solidGrid({10, 1, 10}, 7), {-0.5, 0.0, -0.5}, false);
    scene.add(solidGrid({4, 4, 4}, 7), {-0.2, 4.0, -0.2}, false);
    scene.load();
    scene.seconds(0.0);
    double lowest = 1.0;
    bool slept = false;
    for (int i = 0; i < 180; ++i) {
        scene.step();
        slept = slept || scene.body(1).asleep;
        lowest = std::min(lowest, scene.center(1).y);
    }
    EXPECT_TRUE(slept);
    EXPECT_GT(lowest, 0.045);
}

/// How far the awake bodies move in a quarter of a second, metres, on average.
double stirs(PhysicsScene& scene) {
    std::vector<std::pair<int, Pose>> before;
    for (int i = 0; i < int(scene.level.bodies.size()); ++i)
        if (!scene.body(i).asleep && !scene.body(i).isStatic) before.emplace_back(i, scene.body(i).pose);
    scene.seconds(0.25);
    double sum = 0.0;
    for (const auto& [i, pose] : before) sum += glm::length(scene.body(i).pose.position - pose.position);
    return sum / double(before.size());
}

/// Contacts with sleepers and of what wakes bear what they bore before. What the last crumbs do is chaos: see
/// docs/measurements.md.
TEST(Sleep, WhatIsInBalanceStaysWhereItIsWhenItSleepsAndWhenItWakes) {
    constexpr double kMaxStir = 5e-3;  // metres
    PhysicsScene scene;
    scene.level = voronoiPit(200, 1, 6);
    scene.load();
    scene.world.applyEdits({});
    for (int i = 0; i < 60 * 20 && scene.physics.stats().awake > 0; ++i) scene.step();
    ASSERT_EQ(scene.physics.stats().awake, 0);
    for (const int every : {7, 2, 1}) {
        FrameChanges nudge;
        for (int i = 1; i <= 200; i += every)
            nudge.impulses.push_back({scene.handle(i), glm::dvec3(0.0), glm::dvec3(0.0)});
        scene.physics.apply(nudge, scene.world);
        scene.step();
        EXPECT_GE(scene.physics.stats().awake, 200 / every);
        EXPECT_LT(stirs(scene), kMaxStir) << "one of " << every << " woke";
        for (int i = 0; i < 60 * 20 && scene.physics.stats().awake > 0; ++i) scene.step();
    }
}

constexpr int kKinds = 8, kPlanks = 3, kBars = 4, kPendulums = 6, kPillars = 7;

/// Random scenes of the kinds that come to rest, or seem to.
PhysicsScene& fill(PhysicsScene& scene, int kind, Random& random) {
    scene.addFloor();
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * (double(random.below(1u << 30)) / double(1u << 30));
    };
    const auto boxOf = [&](int least, int most) {
        const int x = random.between(least, most), y = random.between(least, most), z = random.between(least, most);
        return solidGrid({x, y, z}, 7);
    };
    if (kind == 0)  // a heap
        for (int i = 0; i < 40; ++i) {
            const double x = uniform(-1, 1), z = uniform(-1, 1), a = uniform(0, 3);
            scene.add(boxOf(1, 8), {x, 0.5 + 0.4 * i / 2, z}, false,
                      glm::angleAxis(a, glm::normalize(glm::dvec3(1, 2, x))));
        }
    if (kind == 1)  // a tower whose blocks are not quite above each other
        for (int i = 0; i < 8; ++i) {
            const double x = uniform(-0.12, 0.12), z = uniform(-0.12, 0.12);
            scene.add(solidGrid({6, 6, 6}, 7), {x, 0.6 * i, z}, false);
        }
    if (kind == 2)  // planks that lean on a wall
        for (int i = 0; i < 6; ++i) {
            if (i == 0) scene.add(solidGrid({2, 40, 100}, 7), {-0.2, 0.0, -5.0}, true);
            const double angle = uniform(0.1, 1.0);
            const glm::dquat turned = glm::angleAxis(angle, glm::dvec3(0, 0, 1));
            scene.add(solidGrid({1, 20, 5}, 7), {2.0 * std::sin(angle) + 0.01, 0.0, 1.2 * i - 4.0}, false, turned);
        }
    if (kind == kPlanks)  // planks over the edge of a step, near their balance
        for (int i = 0; i < 6; ++i) {
            if (i == 0) scene.add(solidGrid({20, 10, 100}, 7), {-2.0, 0.0, -5.0}, true);
            const double beyond = uniform(-0.05, 0.05);
            scene.add(solidGrid({30, 1, 4}, 7), {beyond - 1.5, 1.0, 1.2 * i - 4.0}, false);
        }
    if (kind == kBars)  // bars that hang, nearly at rest or far from it
        for (int i = 0; i < 6; ++i) {
            const double angle = uniform(0.0, 1.0) * uniform(0.0, 1.0);
            const glm::dquat turned = glm::angleAxis(angle, glm::dvec3(0, 0, 1));
            const glm::dvec3 top(0.0, 4.0, i - 3.0);
            scene.add(solidGrid({1, 20, 1}, 7), top + turned * glm::dvec3(-0.05, -2.0, -0.05), false, turned);
            known::addJoint(scene.level, JointKind::Hinge, -1, int(scene.level.bodies.size()) - 1, known::hingeAt(top));
        }
    if (kind == 5)  // slabs on edge
        for (int i = 0; i < 6; ++i) {
            const double angle = uniform(-0.02, 0.02);
            const glm::dquat turned = glm::angleAxis(angle, glm::dvec3(0, 0, 1));
            scene.add(solidGrid({1, 25, 6}, 7), {0.0, 0.005, 1.2 * i - 4.0}, false, turned);
        }
    if (kind == kPendulums)  // that begin at their turning points, far below their hinges
        for (int i = 0; i < 6; ++i) {
            const double period = uniform(8, 20), length = kGravity * period * period / (4.0 * kPi * kPi);
            const glm::dvec3 top(0.0, length + 1.0, 1.2 * i - 4.0);
            scene.add(solidGrid({4, 4, 4}, 7), {uniform(0.15, 0.5) - 0.2, 0.8, top.z - 0.2}, false);
            known::addJoint(scene.level, JointKind::Hinge, -1, int(scene.level.bodies.size()) - 1, known::hingeAt(top))
                .joint.ends[1]
                .cell = {0, 0, 0};
        }
    if (kind == kPillars)  // whose middle is a little beyond the edge of what they stand on
        for (int i = 0; i < 6; ++i) {
            if (i == 0) scene.add(solidGrid({20, 10, 120}, 7), {-2.0, 0.0, -5.0}, true);
            const double beyond = i % 2 ? uniform(5e-4, 1e-3) : uniform(2e-3, 2e-2);
            scene.add(solidGrid({10, 300, 6}, 7), {beyond - 0.5, 1.0, 1.2 * i - 4.0}, false);
        }
    scene.load();
    return scene;
}

/// How far a body's farthest point is from where it was, metres, at least.
double movedBy(const PhysicsScene& scene, int index, const World& then) {
    const Body &now = scene.body(index), &before = then.bodies().at(scene.handle(index));
    double most = 0.0;
    const glm::vec3 size = glm::vec3(scene.world.shapes().at(now.shapes[0]).grid.size()) * 0.1f;
    for (int k = 0; k < 8; ++k) {
        const glm::dvec3 corner(k & 1 ? size.x : 0, k & 2 ? size.y : 0, k & 4 ? size.z : 0);
        most = std::max(most, glm::length(now.pose.transformPoint(corner) - before.pose.transformPoint(corner)));
    }
    return most;
}

/// Whenever something has fallen asleep and nothing flies about, the same scene goes on with all awake. In 20
/// seeds two of 120 planks near their balance slept that would have fallen, and nothing else. Pendulums and pillars are
/// what sleeps if the rule does not look at acceleration.
TEST(Sleep, NothingSleepsThatWouldMoveByAVoxelInTenSeconds) {
    int checked = 0;
    std::set<std::tuple<int, uint64_t, int>> moving;
    for (int kind = 0; kind < kKinds; ++kind)
        for (uint64_t seed = 1; seed <= 3; ++seed) {
            Random random(seed);
            PhysicsScene scene;
            fill(scene, kind, random);
            int asleep = 0;
            for (int second = 0; second < 15; ++second) {
                scene.seconds(1.0);
                const int bodies = int(scene.level.bodies.size());
                int now = 0;
                double fastest = 0.0;
                for (int i = 0; i < bodies; ++i) {
                    now += scene.body(i).asleep;
                    if (!scene.body(i).asleep) fastest = std::max(fastest, double(glm::length(scene.body(i).velocity)));
                }
                if (now <= asleep || (kind < kBars && fastest > 0.3)) continue;
                asleep = now;
                PhysicsScene awake(known::sleepless({}));
                awake.level = scene.level;
                awake.world = scene.world;
                awake.physics.load(awake.world);
                FrameChanges nudge;
                for (int i = 0; i < bodies; ++i)
                    if (awake.body(i).asleep)
                        nudge.impulses.push_back({awake.handle(i), glm::dvec3(0.0), glm::dvec3(0.0)});
                awake.physics.apply(nudge, awake.world);
                awake.seconds(10.0);
                for (int i = 0; i < bodies; ++i) {
                    if (!scene.body(i).asleep) continue;
                    ++checked;
                    if (movedBy(awake, i, scene.world) >= 0.1) moving.emplace(kind, seed, i);
                }
            }
        }
    EXPECT_GT(checked, 100);
    for (const auto& [kind, seed, body] : moving) ADD_FAILURE() << "kind " << kind << ", seed " << seed << ", " << body;
}

}  // namespace
}  // namespace rubble
