#include <gtest/gtest.h>

#include "tests/physics/scenes/known_scenes.h"
#include "tests/physics/scenes/load_scenes.h"

namespace rubble {
namespace {

/// known::PlankWalk with the default settings.
struct PlankWalk : known::PlankWalk {
    explicit PlankWalk(double mass) : known::PlankWalk({}, mass) {}
};

/// 80 kg at d beyond the edge tip 75 kg whose middle is 1 m behind it from d = 0.9375 m on.
TEST(CharacterLoad, APlankTipsUnderWhoWalksBeyondItsSupport) {
    for (const double d : {1.05, 1.25}) {
        PlankWalk scene(75.0);
        scene.load();
        scene.seconds(3.0);
        ASSERT_TRUE(scene.asleep());
        EXPECT_GT(scene.walkTo(d), 0.3) << d;
    }
    for (const double d : {0.3, 0.8}) {
        PlankWalk scene(75.0);
        scene.load();
        scene.seconds(3.0);
        EXPECT_LT(scene.walkTo(d, 12.0), 0.02) << d;
        EXPECT_TRUE(scene.asleep()) << "nothing moves any more, " << d;
    }
}

/// Who stands on the inner end as a counterweight holds up a plank that tips without.
TEST(CharacterLoad, APlankTipsWhenItsCounterweightLeaves) {
    for (const bool isRemoved : {false, true}) {
        PlankWalk scene(75.0);
        scene.level.bodies[2].pose.position.x = -2.2;  // its middle is 0.3 m beyond the edge
        scene.level.characters[0].position = {-1.5, 0.12, 0.0};
        scene.load();
        scene.seconds(3.0);
        ASSERT_TRUE(scene.asleep());
        const double before = scene.tip();
        scene.stepWith({isRemoved ? Edit(RemoveCharacterEdit{scene.who()})
                                  : Edit(MoveCharacterEdit{scene.who(), {0.0, 0.0, 2.0}})});
        scene.seconds(3.0);
        EXPECT_GT(before - scene.tip(), 0.3);
    }
}

/// 80 kg stand on a crate of 40 kg whose middle is 0.65 m beyond the edge. The plank bears the crate alone.
TEST(CharacterLoad, APlankTipsUnderWhoStandsOnACrateOnIt) {
    for (const bool isOnCrate : {false, true}) {
        PlankWalk scene(75.0);
        const uint8_t light = known::setMaterial(scene, 9, 0.6f, 0.0f, 625);
        scene.add(solidGrid({4, 4, 4}, light), {0.45, 0.1, -0.2}, false);
        scene.level.characters[0].position = isOnCrate ? glm::dvec3(0.65, 0.51, 0.0) : glm::dvec3(-0.5, 0.12, 0.0);
        scene.level.characters[0].radius = 0.2;
        scene.load(false);
        const double before = scene.tip();
        scene.seconds(4.0);
        EXPECT_EQ(before - scene.tip() > 0.3, isOnCrate) << before - scene.tip();
    }
}

TEST(CharacterLoad, WhoStandsStillLetsWhatBearsItSleep) {
    PlankWalk scene(75.0);
    scene.load();
    scene.seconds(3.0);
    for (int i = 0; i < 120; ++i) {
        scene.step();
        ASSERT_TRUE(scene.asleep());
    }
}

TEST(CharacterLoad, IsTheSameAfterASave) {
    PlankWalk scene(75.0);
    scene.load();
    scene.seconds(3.0);
    scene.stepWith({MoveCharacterEdit{scene.who(), {1.0, 0.0, 0.0}}});
    scene.seconds(0.5);
    World copy = scene.world;
    PhysicsWorld rebuilt;
    rebuilt.load(copy);
    scene.physics.load(scene.world);
    for (int i = 0; i < 180; ++i) {
        scene.step();
        rebuilt.step();
        copyMotion(rebuilt, copy);
        ASSERT_EQ(copy.hash(), scene.world.hash()) << i;
    }
}

}  // namespace
}  // namespace rubble
