#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "runtime/core/random.h"
#include "tests/physics/scenes/known_scenes.h"
#include "tests/physics/scenes/load_scenes.h"

namespace rubble {
namespace {

/// The largest speed of a rope's point as it is reported, and by how far points move in a step, m/s.
struct RopeSpeeds {
    double reported = 0.0, moved = 0.0;
};

std::vector<RopePoint> pointsOf(const World& world) {
    std::vector<RopePoint> all;
    world.joints().forEach(
        [&](JointHandle, const Joint& joint) { all.insert(all.end(), joint.points.begin(), joint.points.end()); });
    return all;
}

RopeSpeeds speedsIn(PhysicsScene& scene) {
    const std::vector<RopePoint> before = pointsOf(scene.world);
    scene.step();
    const std::vector<RopePoint> now = pointsOf(scene.world);
    RopeSpeeds speeds;
    for (size_t i = 0; i < now.size(); ++i) {
        speeds.reported = std::max(speeds.reported, glm::length(now[i].velocity));
        speeds.moved = std::max(speeds.moved, glm::distance(now[i].position, before[i].position) / scene.stepSeconds);
    }
    return speeds;
}

/// The sag of a chain of a length between two places at one height: y = a cosh(x / a).
double sagOfCatenary(double length, double span) {
    double low = 1e-6, high = 20.0;
    for (int i = 0; i < 100; ++i) {
        const double x = 0.5 * (low + high);
        (std::sinh(x) / x < length / span ? low : high) = x;
    }
    return 0.5 * span / low * (std::cosh(low) - 1.0);
}

TEST(RopeAtRest, HangsAsACatenaryAndIsStill) {
    PhysicsScene scene(known::sleepless({}));
    LevelJoint& rope = known::addJoint(scene, JointKind::Rope, "", "", {0.0, 5.0, 0.0}, {3.0, 5.0, 0.0});
    rope.joint.rope.length = 4.0;
    rope.joint.rope.points = 41;
    scene.load();
    scene.seconds(20.0);
    double lowest = 5.0;
    for (const RopePoint& point : pointsOf(scene.world)) lowest = std::min(lowest, point.position.y);
    EXPECT_NEAR(5.0 - lowest, sagOfCatenary(4.0, 3.0), 0.03);
    const RopeSpeeds speeds = speedsIn(scene);
    EXPECT_LE(speeds.reported, 0.01);
    EXPECT_LE(speeds.moved, 0.01);
}

/// Over the edges of a box, with loops at both sides that swing until the air has stopped them.
TEST(RopeAtRest, OverABoxIsStillInTheEndAndMovesAsItSaysBefore) {
    for (const double length : {2.7, 3.0, 3.5}) {
        PhysicsScene scene;
        scene.add(solidGrid({10, 10, 10}, 7), {-0.5, 0.0, -0.5}, true);
        LevelJoint& rope = known::addJoint(scene, JointKind::Rope, "", "", {-0.6, 0.2, 0.0}, {0.6, 0.2, 0.0});
        rope.joint.rope.length = length;
        scene.load();
        scene.seconds(1.0);
        RopeSpeeds speeds;
        double reported = 0.0, moved = 0.0;  // sums
        for (int i = 0; i < 1800; ++i) {
            speeds = speedsIn(scene);
            reported += speeds.reported, moved += speeds.moved;
        }
        EXPECT_NEAR(reported / moved, 1.0, 0.05) << length;
        EXPECT_LE(speeds.reported, 0.01) << length;
        EXPECT_LE(speeds.moved, 0.01) << length;
    }
}

/// Crates in pairs, each pair on a rope that is a metre longer than their distance, dropped on each other.
void addPairs(PhysicsScene& scene, int pairs) {
    Random random(2);
    const auto place = [&] { return 2.0 * double(random.unit()) - 1.0; };
    for (int i = 0; i < pairs; ++i) {
        const double y = 1.0 + i * 0.05;
        glm::dvec3 ends[2];
        for (glm::dvec3& end : ends) {
            end = {place(), y, place()};
            scene.add(solidGrid({2, 2, 2}, 5), end, false);
        }
        const std::string first = "body " + std::to_string(1 + 2 * i), second = "body " + std::to_string(2 + 2 * i);
        LevelJoint& rope = known::addJoint(scene, JointKind::Rope, first, second, {0.1, 0.1, 0.1}, {0.1, 0.1, 0.1});
        rope.joint.rope.length = glm::distance(ends[0], ends[1]) + 1.0;
    }
}

TEST(RopeAtRest, APileOfThemSleeps) {
    for (const int pairs : {1, 4, 8}) {
        PhysicsScene scene;
        scene.addFloor();
        addPairs(scene, pairs);
        scene.load();
        scene.seconds(12.0);
        int awake = 0;
        scene.world.bodies().forEach([&](BodyHandle, const Body& body) { awake += !body.isStatic && !body.asleep; });
        EXPECT_EQ(awake, 0) << pairs;
        const RopeSpeeds speeds = speedsIn(scene);
        EXPECT_EQ(speeds.reported, 0.0) << pairs;
        EXPECT_EQ(speeds.moved, 0.0) << pairs;
        EXPECT_TRUE(scene.physics.ropes().empty()) << "of " << pairs << " pairs some are still simulated";
    }
}

/// How far points of a rope that lies on a plate of 2 x 2 m, held by an end in its middle, are from where they lie, at
/// most: above its top, and beside their places of half a second before. The plate flies with a velocity, metres.
double offOnFlyingPlate(glm::dvec3 velocity) {
    PhysicsScene scene(known::sleepless({}));
    LevelBody& plate = scene.add(solidGrid({20, 4, 20}, 7), {-1.0, -0.4, -1.0}, false);
    plate.velocity = velocity;
    plate.gravityScale = 0.0;
    LevelJoint& rope = known::addJoint(scene, JointKind::Rope, "body 0", "", {1.0, 0.4, 1.0}, {0.8, 0.02, 0.0});
    rope.joint.ends[1].isFree = true;
    rope.joint.rope.length = 0.85;
    scene.load();
    scene.seconds(1.0);
    const auto relative = [&] {
        std::vector<glm::dvec3> out;
        for (const RopePoint& point : pointsOf(scene.world))
            out.push_back(scene.body(0).pose.inversePoint(point.position) - glm::dvec3(0.0, 0.4, 0.0));
        return out;
    };
    double farthest = 0.0;
    std::vector<glm::dvec3> before = relative();
    for (int i = 0; i < 60; ++i) {
        scene.step();
        const std::vector<glm::dvec3> now = relative();
        for (size_t k = 0; k < now.size(); ++k)
            farthest = std::max({farthest, std::abs(now[k].y), glm::distance(now[k], before[k])});
        if (i == 30) before = now;
    }
    return farthest;
}

TEST(RopeAtRest, IsCarriedByWhatFlies) {
    for (const glm::dvec3 velocity : {glm::dvec3(0.0), {0.0, 3.0, 0.0}, {0.0, 10.0, 0.0}, {5.0, 0.0, 0.0}})
        EXPECT_LT(offOnFlyingPlate(velocity), 0.05) << velocity.x << ", " << velocity.y << " m/s";
}

}  // namespace
}  // namespace rubble
