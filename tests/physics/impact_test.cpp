#include <gtest/gtest.h>

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
        for (size_t i = 0; i < here.size(); ++i) EXPECT_LT(glm::length(there[i] - here[i]), 1e-3) << far << " m, body " << i;
    }
}

TEST(Impact, AFullContainerHoldsWhatIsInIt) {
    const Container container = fillContainer({}, 4, 4.0);
    EXPECT_TRUE(container.allInside);
    EXPECT_LT(container.meanOverlap, 1e-3);
    EXPECT_LT(container.worstOverlap, 0.005);
}

TEST(Impact, OverlapsComeApartWithoutAnExplosion) {
    for (const double share : {0.1, 0.3, 0.5, 0.7}) EXPECT_LT(partOverlapping({}, share).fastest, 3.5) << share;
    EXPECT_LT(partOverlapping({}, 0.1).overlap, 1e-3);
}

/// Everything but one body that is given nonsense goes on bit by bit as without it.
TEST(Impact, NonsenseStaysWithTheBodyThatItIsGiven) {
    const double infinity = std::numeric_limits<double>::infinity(), none = std::numeric_limits<double>::quiet_NaN();
    const auto run = [](glm::dvec3 impulse, uint32_t density) {
        PhysicsScene scene;
        const uint8_t weightless = setMaterial(scene, 8, 0.5f, 0.1f, density);
        scene.addFloor();
        for (int i = 0; i < 3; ++i) scene.add(blockGrid({5, 5, 5}, 7), {1.2 * i, 1, 0}, false);
        scene.add(blockGrid({5, 5, 5}, weightless), {0, 1, 5}, false);
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
    for (const double bad : {none, infinity, -infinity, 1e30, 1e300}) EXPECT_EQ(run(glm::dvec3(0.0, bad, 0.0), 2000), expected) << bad;
    EXPECT_EQ(run(glm::dvec3(0.0), 0), expected) << "no mass";
}

}  // namespace
}  // namespace rubble
