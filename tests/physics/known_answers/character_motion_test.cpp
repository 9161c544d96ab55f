#include <gtest/gtest.h>

#include "tests/physics/walk_scene.h"

namespace rubble {
namespace {

/// Who stands on a platform of 8 x 4 m that flies.
struct Platform : Walk {
    Platform() : Walk({0.0, 0.21, 0.0}) { add(solidGrid({80, 2, 40}, 7), {-4.0, 0.0, -2.0}, false); }
    /// Sets the platform's velocity, and how it falls.
    void fly(glm::dvec3 velocity, double gravityScale) {
        edits.push_back(SetBodyEdit{.body = handle(0),
                                    .setsVelocity = true,
                                    .velocity = velocity,
                                    .setsGravityScale = true,
                                    .gravityScale = gravityScale});
    }
    /// Steps while the platform moves at a velocity, whatever stands on it.
    void carry(int steps, glm::dvec3 velocity) {
        for (int i = 0; i < steps; ++i) fly(velocity, 0.0), walk(1);
    }
};

TEST(CharacterMotion, WhoWalksOffTheSideOfWhatMovesKeepsItsVelocity) {
    Platform scene;
    scene.load();
    scene.wish({0.0, 0.0, 3.0});
    scene.carry(60, {5.0, 0.0, 0.0});
    ASSERT_FALSE(scene.me().grounded);
    EXPECT_NEAR(scene.me().velocity.x, 5.0, 0.02);
    EXPECT_NEAR(scene.me().velocity.z, 3.0, 0.02);
}

TEST(CharacterMotion, WhoseGroundVanishesKeepsItsVelocity) {
    for (const glm::dvec3 velocity : {glm::dvec3(10.0, 0.0, 0.0), glm::dvec3(0.0, -2.0, 0.0)}) {
        Platform scene;
        scene.load();
        scene.carry(60, velocity);
        ASSERT_TRUE(scene.me().grounded);
        const glm::dvec3 from = scene.me().position;
        scene.edits.push_back(DestroyBodyEdit{scene.handle(0)});
        scene.walk(30);
        const glm::dvec3 way = velocity * 0.5 + glm::dvec3(0.0, -0.5 * 9.81 * 0.25, 0.0);
        EXPECT_LT(glm::distance(scene.me().position - from, way), 0.02) << velocity.x << " " << velocity.y;
    }
}

/// A crumb of 18 kg that flies from under 80 kg.
TEST(CharacterMotion, ACrumbTakesNobodyAlong) {
    Walk scene({0.0, 0.11, 0.0});
    LevelBody& crumb = scene.add(solidGrid({3, 1, 3}, 7), {-0.15, 0.0, -0.15}, false);
    crumb.velocity = {10.0f, 3.0f, 0.0f};
    crumb.angularVelocity = {0.0f, 30.0f, 0.0f};
    scene.load();
    scene.walk(30);
    EXPECT_LT(glm::length(glm::dvec2(scene.me().position.x, scene.me().position.z)), 0.2);
    EXPECT_LT(scene.me().position.y, 0.2);
}

/// A trap door that is pulled away, one that only falls, and one that is braked.
TEST(CharacterMotion, NothingPullsItDownFasterThanItFalls) {
    for (const double gravityScale : {3.0, 1.2, 1.0}) {
        Platform scene;
        scene.load();
        scene.fly({}, 0.0);
        scene.walk(10);
        ASSERT_TRUE(scene.me().grounded);
        const double from = scene.me().position.y;
        scene.fly({}, gravityScale);
        scene.walk(60);
        EXPECT_NEAR(scene.me().position.y - from, -0.5 * 9.81, 0.05) << gravityScale;
        EXPECT_NEAR(scene.me().velocity.y + scene.me().groundVelocity.y, -9.81, 0.1) << gravityScale;
    }
}

TEST(CharacterMotion, WhoseGroundStopsRisingFliesOn) {
    Platform scene;
    scene.load();
    for (int i = 0; i <= 60; ++i) scene.carry(1, {0.0, i / 12.0, 0.0});
    ASSERT_TRUE(scene.me().grounded);
    const double from = scene.me().position.y;
    double highest = 0.0;
    for (int i = 0; i < 60; ++i) scene.carry(1, {}), highest = std::max(highest, scene.me().position.y);
    EXPECT_NEAR(highest - from, 5.0 * 5.0 / (2.0 * 9.81), 0.01);
}

TEST(CharacterMotion, WhoStandsFallsUpwardWhenGravityTurns) {
    Walk scene;
    scene.addFloor();
    scene.load();
    scene.walk(10);
    ASSERT_TRUE(scene.me().grounded);
    Environment turned = scene.world.environment();
    turned.gravity = -turned.gravity;
    scene.edits.push_back(SetEnvironmentEdit{turned});
    scene.walk(60);
    EXPECT_FALSE(scene.me().grounded);
    EXPECT_NEAR(scene.me().position.y, 0.5 * 9.81, 0.1);
    turned.gravity = -turned.gravity;
    scene.edits.push_back(SetEnvironmentEdit{turned});
    scene.walk(240);
    EXPECT_TRUE(scene.me().grounded);
    EXPECT_NEAR(scene.me().position.y, 0.0, 0.02);
}

/// Two of the same mass that walk against each other stop; the lighter of two gives way.
TEST(CharacterMotion, CharactersPushEachOtherApart) {
    for (const double mass : {80.0, 40.0, 0.0}) {
        Walk scene({-1.0, 0.01, 0.0});
        scene.addFloor();
        scene.level.characters.push_back(scene.level.characters[0]);
        scene.level.characters[1].position.x = 1.0;
        if (mass > 0.0)
            scene.level.characters[1].mass = mass;
        else
            scene.level.characters[1].collisionMask = 2;  // meets nobody
        scene.load();
        const CharacterHandle other = scene.world.characters().handleAt(1);
        scene.wish({2.0, 0.0, 0.0});
        scene.edits.push_back(MoveCharacterEdit{other, {-2.0, 0.0, 0.0}});
        scene.walk(120);
        const double a = scene.me().position.x, b = scene.world.characters().at(other).position.x;
        if (mass == 0.0) {
            EXPECT_NEAR(a, 3.0, 0.1);
            continue;
        }
        EXPECT_GT(b - a, 0.4) << "they are 0.6 m wide";
        EXPECT_GT(a + b, mass < 80.0 ? 0.4 : -0.2);
        EXPECT_LT(a + b, mass < 80.0 ? 9.0 : 0.2);
    }
}

}  // namespace
}  // namespace rubble
