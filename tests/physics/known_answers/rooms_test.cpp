#include "tests/physics/scenes/rooms.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include "tests/physics/scenes/impact_scenes.h"

namespace rubble {
namespace {

/// Throws bodies into rooms until there are enough of them.
void expectNoneLeaves(known::RoomBody body, int count) {
    const bool isLong = std::getenv("RUBBLE_LONG") != nullptr;
    int thrown = 0, outside = 0;
    for (uint64_t seed = 1; thrown < count; ++seed) {
        const known::RoomShots shots = known::throwIntoRoom({}, seed, body);
        thrown += shots.thrown;
        outside += shots.outside;
        EXPECT_EQ(shots.outside, 0) << "of " << shots.thrown << " left the room of seed " << seed;
        if (isLong && seed % 100 == 0) std::printf("%d thrown, %d outside\n", thrown, outside), std::fflush(stdout);
    }
    EXPECT_EQ(outside, 0) << "of " << thrown;
}

/// The long runs throw a million, and 100,000.
TEST(Rooms, NothingLeavesAClosedRoom) {
    expectNoneLeaves(known::RoomBody::Fixed, std::getenv("RUBBLE_LONG") ? 1'000'000 : 10'000);
}

TEST(Rooms, NothingLeavesAFreeRoom) {
    expectNoneLeaves(known::RoomBody::Free, std::getenv("RUBBLE_LONG") ? 100'000 : 2'000);
}

/// Found by the long run: a rod that fell along a seam of the floor lost the contact at its far end, got stuck in the
/// floor, and was pushed on through it.
TEST(Rooms, ARodDoesNotSinkIntoASeamOfAFreeRoom) {
    EXPECT_EQ(known::throwIntoRoom({}, 6228, known::RoomBody::Free).outside, 0);
}

/// A crate slides along two or four walls of a shaft of one shape towards its end.
TEST(Rooms, NothingPassesTheEndOfAShaft) {
    for (const bool isSnug : {false, true})
        for (const int thickness : {1, 2, 5, 10})
            for (const int size : {1, 6})
                for (const double speed : {5.0, 10.0, 20.0, 60.0, 150.0, 300.0})
                    EXPECT_TRUE(known::staysInShaft({}, {size, isSnug, thickness, speed}))
                        << size << " voxels at " << speed << " m/s, an end of " << thickness
                        << (isSnug ? ", snug" : "");
}

/// A hundred cubes in a room whose gravity turns about them.
TEST(Rooms, NothingLeavesARoomThatTurns) {
    const int inside = 40;
    PhysicsScene scene;
    scene.add(gridOf(glm::ivec3(inside + 4),
                     [&](glm::ivec3 c) {
                         const bool isOpen = glm::all(glm::greaterThanEqual(c, glm::ivec3(2))) &&
                                             glm::all(glm::lessThan(c, glm::ivec3(inside + 2)));
                         return uint8_t(isOpen ? 0 : 7);
                     }),
              {0, 0, 0}, true);
    for (int i = 0; i < 108; ++i)
        scene.add(solidGrid(glm::ivec3(5), 7), glm::dvec3(i % 6, i / 36, i / 6 % 6) * 0.62 + 0.4, false);
    scene.load();
    for (int step = 0; step < 600; ++step) {
        Environment environment = scene.world.environment();
        environment.gravity =
            glm::vec3(glm::angleAxis(0.02 * step, glm::normalize(glm::dvec3(0.3, 0.1, 1.0))) * glm::dvec3(0, -20, 0));
        scene.stepWith({SetEnvironmentEdit{environment}});
        for (int i = 1; i <= 108; ++i) {
            const glm::dvec3 at = scene.center(i);
            ASSERT_TRUE(glm::all(glm::greaterThan(at, glm::dvec3(0.2))) &&
                        glm::all(glm::lessThan(at, glm::dvec3(0.1 * inside + 0.2))))
                << "cube " << i << " in step " << step;
        }
    }
}

}  // namespace
}  // namespace rubble
