#include <gtest/gtest.h>

#include <algorithm>

#include "runtime/core/random.h"
#include "tests/physics/physics_scene.h"

// A pile that sleeps, and of which one body is woken. Physics may have been made from the World since, as it is when a
// game is saved or loaded: that must not show.

namespace rubble {
namespace {

/// Boxes of two to four voxels, in layers, on a floor, a millimetre from where another seed has them.
struct Pile : PhysicsScene {
    static constexpr int kSide = 4, kBoxes = kSide * kSide * kSide;
    explicit Pile(uint64_t seed) {
        addFloor();
        Random random(seed);
        const auto jitter = [&] { return 1e-5 * int(random.below(100)); };
        for (int i = 0; i < kBoxes; ++i) {
            const int x = i % kSide, z = i / kSide % kSide, y = i / kSide / kSide;
            const glm::dvec3 corner((x - kSide / 2) * 0.45 + 0.03 * (y % 3), 0.2 + y * 0.45,
                                    (z - kSide / 2) * 0.45 + 0.02 * (y % 2));
            add(solidGrid({2 + i % 3, 2 + i % 2, 2}, uint8_t(4 + i % 4)), corner + glm::dvec3(jitter(), 0.0, jitter()),
                false);
        }
        load();
    }
    /// Steps until all sleep, a minute at most.
    void comeToRest() {
        for (int i = 0; i < 60 && awake() > 0; ++i) seconds(1.0);
    }
    /// How many boxes are awake.
    int awake() const { return physics.stats().awake; }
    /// Wakes a box, steps for two seconds, and returns how many boxes were awake at once.
    int wakeOne(int index) {
        stepWith({SetBodyEdit{.body = handle(index), .setsSleep = true}});
        int most = awake();
        for (int i = 0; i < stepsIn(2.0); ++i) step(), most = std::max(most, awake());
        return most;
    }
};

/// Of 216 such wakes none woke more than without the load nor left anything awake, and one box moved by more than 2 mm.
/// Without the impulses that the World keeps, eight more wake in each pile.
TEST(LoadedPile, WakesNoMoreThanOneThatWasNotLoaded) {
    int more = 0, awake = 0, moved = 0;
    for (uint64_t seed = 1; seed <= 8; ++seed) {
        Pile pile(seed);
        pile.comeToRest();
        ASSERT_EQ(pile.awake(), 0);
        const World asleep = pile.world;
        for (const int index : {Pile::kBoxes / 7, Pile::kBoxes / 3, Pile::kBoxes / 2}) {
            const int before = pile.wakeOne(index);
            pile.seconds(10.0);
            Pile loaded(seed);
            loaded.world = asleep;
            loaded.physics.load(loaded.world);
            more += std::max(loaded.wakeOne(index) - before, 0);
            awake += loaded.awake();
            for (int i = 1; i <= Pile::kBoxes; ++i) {
                const glm::dvec3 then = asleep.bodies().at(loaded.handle(i)).pose.position;
                moved += glm::length(loaded.body(i).pose.position - then) > 0.002;
            }
        }
    }
    EXPECT_LE(more, 6);
    EXPECT_LE(awake, 3);
    EXPECT_LE(moved, 6);
}

/// What wakes a sleeper beside it does so after a load too.
TEST(LoadedPile, ALoadedSleeperWakesUnderWhatIsSetDownOnIt) {
    PhysicsScene scene;
    scene.addFloor();
    scene.add(solidGrid({5, 5, 5}, 5), {0.0, 0.0, 0.0}, false);
    scene.add(solidGrid({5, 5, 5}, 9), {2.0, 0.0, 0.0}, false);
    scene.load();
    scene.seconds(5.0);
    ASSERT_TRUE(scene.body(1).asleep);
    scene.physics.load(scene.world);
    SetBodyEdit move{.body = scene.handle(2), .setsPose = true};
    move.pose.position = {0.0, 0.5, 0.0};
    scene.stepWith({move});
    bool hasWoken = false;
    for (int i = 0; i < 20; ++i) scene.step(), hasWoken = hasWoken || !scene.body(1).asleep;
    EXPECT_TRUE(hasWoken);
}

}  // namespace
}  // namespace rubble
