#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "tests/physics/scenes/known_scenes.h"

namespace rubble {
namespace {

using namespace known;

TEST(Impact, HeadOnKeepsMomentumAndItsRestitution) {
    for (const double restitution : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const Collision collision = collide({}, restitution);
        EXPECT_NEAR(collision.momentum, 0.0, 1e-6) << restitution;
        EXPECT_NEAR(collision.restitution, restitution, 0.01) << restitution;
    }
}

TEST(Impact, FarAwayComesOutTheSame) {
    const std::vector<glm::dvec3> here = tumble({}, {0, 0, 0});
    for (const double far : {1e4, 1e5}) {
        const std::vector<glm::dvec3> there = tumble({}, {far, 30.25, -far});
        for (size_t i = 0; i < here.size(); ++i)
            EXPECT_LT(glm::length(there[i] - here[i]), 1e-3) << far << " m, body " << i;
    }
}

TEST(Impact, AFullContainerHoldsWhatIsInIt) {
    std::vector<int> counts{6};
    if (std::getenv("RUBBLE_LONG")) counts.push_back(10);
    for (const int count : counts) {
        const Container container = fillContainer({}, count, 4.0);
        EXPECT_TRUE(container.allInside) << count;
        EXPECT_LT(container.meanOverlap, 1e-3) << count;
        EXPECT_LT(container.worstOverlap, 0.005) << count;
        EXPECT_LT(container.fastest, 0.05) << count;
    }
}

/// Cubes on all sides of a blast: each flies off, and their common centre of mass stays.
TEST(Impact, ASymmetricBlastHasNoNetImpulse) {
    PhysicsScene scene;
    scene.level.environment.gravity = {0, 0, 0};
    for (int i = 0; i < 6; ++i) {
        glm::dvec3 middle(0.0);
        middle[i / 2] = i % 2 ? 1.3 : -1.3;
        scene.add(solidGrid({4, 4, 4}, 7), middle - 0.2, false);
    }
    scene.load();
    scene.world.applyEdits({});  // takes out the change that loaded the level: physics has it already
    scene.physics.apply(scene.world.applyEdits({ExplodeEdit{.position = glm::dvec3(0.0), .size = 1.0}}), scene.world);
    scene.step(30);
    glm::dvec3 sum(0.0);
    double each = 0.0;
    scene.world.bodies().forEach([&](BodyHandle handle, const Body& body) {
        const glm::dvec3 momentum = glm::dvec3(body.velocity) * bodyMass(scene.world, handle).mass;
        sum += momentum, each += glm::length(momentum);
    });
    EXPECT_GT(each, 10.0);
    EXPECT_LT(glm::length(sum), 1e-3 * each);
}

TEST(Impact, ABlastPushesTheNearest) {
    PhysicsScene scene;
    scene.level.environment.gravity = {0, 0, 0};
    for (int i = 0; i < 729; ++i)
        scene.add(solidGrid({2, 2, 2}, 7), glm::dvec3(i % 9, i / 9 % 9, i / 81) * 1.0 - 4.1, false);
    scene.load(false);
    scene.world.applyEdits({});
    const glm::dvec3 from(0.3, 0.2, 0.1);
    const FrameChanges blast = scene.world.applyEdits({ExplodeEdit{.position = from, .size = 4.0}});
    EXPECT_EQ(blast.impulses.size(), 256u) << "the largest number of bodies that one blast pushes";
    double farthest = 0.0, nearest = 1e300;  // that is pushed; that is not
    scene.world.bodies().forEach([&](BodyHandle handle, const Body& body) {
        const bool isPushed = std::any_of(blast.impulses.begin(), blast.impulses.end(),
                                          [&](const ImpulseApplied& each) { return each.body == handle; });
        const glm::dvec3 center = body.pose.transformPoint(bodyMass(scene.world, handle).center);
        (isPushed ? farthest : nearest) =
            isPushed ? std::max(farthest, glm::distance(center, from)) : std::min(nearest, glm::distance(center, from));
    });
    EXPECT_LE(farthest, nearest);
}

/// The impulse acts a little beside the centre; about a rod's own axis that is a long arm.
TEST(Impact, ABlastDoesNotSpinRodsLikeDrills) {
    PhysicsScene scene;
    scene.level.environment.gravity = {0, 0, 0};
    const glm::dvec3 blast(0.0);
    for (int i = 0; i < 40; ++i) {
        const double angle = 0.157 * i;
        const glm::ivec3 size = i % 2 ? glm::ivec3(1, 1, 8) : glm::ivec3(1);
        scene.add(solidGrid(size, 7), {1.5 * std::cos(angle), 1.5 * std::sin(angle), -0.05 * size.z}, false);
        if (i % 4 == 0) scene.level.bodies.back().shapes[0].voxelSize = 0.02f;
    }
    scene.load();
    scene.world.applyEdits({});
    scene.physics.apply(scene.world.applyEdits({ExplodeEdit{.position = blast, .size = 2.0}}), scene.world);
    scene.step();
    scene.world.bodies().forEach([&](BodyHandle, const Body& body) {
        EXPECT_GT(glm::length(body.velocity), 1.0);
        EXPECT_LT(glm::length(body.angularVelocity), 150.0);
    });
}

TEST(Impact, OverlapsComeApartWithoutAnExplosion) {
    for (const double share : {0.1, 0.3, 0.5, 0.7}) EXPECT_LT(partOverlapping({}, share).fastest, 3.5) << share;
    EXPECT_LT(partOverlapping({}, 0.1).overlap, 1e-3);
}

/// A body with invalid numbers does not change a bit of the others.
TEST(Impact, InvalidNumbersDoNotSpreadToOtherBodies) {
    const double infinity = std::numeric_limits<double>::infinity(), none = std::numeric_limits<double>::quiet_NaN();
    const auto run = [](glm::dvec3 impulse, uint32_t density) {
        PhysicsScene scene;
        const uint8_t weightless = setMaterial(scene, 8, 0.5f, 0.1f, density);
        scene.addFloor();
        for (int i = 0; i < 3; ++i) scene.add(solidGrid({5, 5, 5}, 7), {1.2 * i, 1, 0}, false);
        scene.add(solidGrid({5, 5, 5}, weightless), {0, 1, 5}, false);
        scene.load();
        FrameChanges changes;
        changes.impulses.push_back({scene.handle(4), scene.center(4), impulse});
        scene.physics.apply(changes, scene.world);
        scene.seconds(2.0);
        const glm::dvec3 last = scene.center(4);
        EXPECT_TRUE(std::isfinite(last.x + last.y + last.z));
        return std::vector<glm::dvec3>{scene.center(1), scene.center(2), scene.center(3)};
    };
    const auto expected = run(glm::dvec3(0.0), 2000);
    for (const double bad : {none, infinity, -infinity, 1e30, 1e300})
        EXPECT_EQ(run(glm::dvec3(0.0, bad, 0.0), 2000), expected) << bad;
    EXPECT_EQ(run(glm::dvec3(0.0), 0), expected) << "no mass";
}

}  // namespace
}  // namespace rubble
