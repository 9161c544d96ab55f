#include <gtest/gtest.h>

#include <cmath>

#include "runtime/core/constants.h"
#include "tests/physics/walk_scene.h"

namespace rubble {
namespace {

/// Stairs of four steps that rise along x from x = 1 m on, with a landing behind, and who walks up and down them.
struct Stairs : Walk {
    /// rise, run: voxels. size: of a voxel, metres. width: metres, about z = 0.
    Stairs(int rise, int run, double size = 0.1, double radius = 0.3, double width = 3.0) : top(4 * rise * size) {
        addFloor();
        const int length = 4 * run + int(4.0 / size);
        const VoxelGrid grid = gridOf({length, 4 * rise, int(width / size)}, [&](glm::ivec3 c) {
            return uint8_t(c.y < std::min(4, c.x / run + 1) * rise ? 7 : 0);
        });
        add(grid, {1.0, 0.0, -0.5 * width}, true).shapes[0].voxelSize = size;
        level.characters[0].radius = radius;
        end = 1.0 + 4.0 * run * size;
    }
    /// Walks at a velocity until it is at x, at most as long as twice the way takes. Returns whether it got there.
    bool walkTo(double x, glm::dvec3 velocity) {
        wish(velocity);
        airborne = 0;
        const double way = std::abs(x - me().position.x);
        for (double time = 2.0 * way / std::abs(velocity.x) + 0.5; time > 0.0; time -= stepSeconds) {
            walk(1);
            airborne += !me().grounded;
            if ((me().position.x - x) * velocity.x > 0.0) return true;
        }
        return false;
    }
    double top, end;   ///< height of the landing, and the x where it begins, metres
    int airborne = 0;  ///< steps without ground on the last walk
};

/// Up to the landing and back, without losing the ground.
void expectUpAndDown(Stairs& scene, glm::dvec3 velocity) {
    scene.load();
    scene.walk(10);
    ASSERT_TRUE(scene.walkTo(scene.end + 0.4, velocity)) << "up, at x " << scene.me().position.x;
    EXPECT_NEAR(scene.me().position.y, scene.top, 0.02);
    EXPECT_EQ(scene.airborne, 0) << "up";
    ASSERT_TRUE(scene.walkTo(0.5, -velocity)) << "down, at x " << scene.me().position.x;
    EXPECT_NEAR(scene.me().position.y, 0.0, 0.02);
    EXPECT_EQ(scene.airborne, 0) << "down";
    EXPECT_FALSE(scene.isInside());
}

TEST(Stairs, OfTreadsOfTwentyCentimetresAreClimbedUpToTheStepHeightAtAnySpeed) {
    for (const int rise : {1, 2, 3, 4})
        for (const int run : {2, 3, 4, 6})
            for (const double speed : {1.0, 2.0, 4.0}) {
                SCOPED_TRACE(testing::Message() << "rise " << rise << " run " << run << " speed " << speed);
                Stairs scene(rise, run);
                expectUpAndDown(scene, {speed, 0.0, 0.0});
            }
}

TEST(Stairs, OfAnyVoxelsAreClimbedByAnyRadius) {
    for (const double size : {0.05, 0.15, 0.2})
        for (const double rise : {0.2, 0.3, 0.45})
            for (const double run : {0.2, 0.3, 0.45})
                for (const double radius : {0.15, 0.25, 0.5}) {
                    const int up = int(rise / size + 1e-6), along = int(std::ceil(run / size - 1e-6));
                    SCOPED_TRACE(testing::Message() << "voxels of " << size << ", rise " << up << " run " << along
                                                    << " radius " << radius);
                    Stairs scene(up, along, size, radius);
                    expectUpAndDown(scene, {2.0, 0.0, 0.0});
                }
}

/// In one step it gets about as far as a tread is deep.
TEST(Stairs, AreClimbedAtARun) {
    for (const int run : {2, 3, 5})
        for (const double radius : {0.15, 0.3}) {
            SCOPED_TRACE(testing::Message() << "run " << run << " radius " << radius);
            Stairs scene(3, run, 0.1, radius);
            scene.level.characters[0].walkSpeed = 10.0;
            expectUpAndDown(scene, {10.0, 0.0, 0.0});
        }
}

TEST(Stairs, AreClimbedDiagonally) {
    for (const int rise : {2, 3, 4})
        for (const int run : {2, 3, 5})
            for (const double degrees : {20.0, 45.0, 60.0})
                for (const double speed : {1.0, 4.0}) {
                    SCOPED_TRACE(testing::Message() << "rise " << rise << " run " << run << " at " << degrees
                                                    << " degrees, speed " << speed);
                    const double angle = degrees * kPi / 180.0;
                    Stairs scene(rise, run, 0.1, 0.3, 16.0);
                    scene.level.characters[0].position.z = -3.0;
                    expectUpAndDown(scene, {speed * std::cos(angle), 0.0, speed * std::sin(angle)});
                }
}

/// Between two walls, into one of which it walks all the time.
TEST(Stairs, AreClimbedAlongAWall) {
    for (const int rise : {2, 3, 4})
        for (const int run : {2, 3, 5}) {
            SCOPED_TRACE(testing::Message() << "rise " << rise << " run " << run);
            Stairs scene(rise, run);
            for (const double z : {-0.6, 0.5}) scene.add(solidGrid({100, 60, 1}, 7), {-1.0, 0.0, z}, true);
            expectUpAndDown(scene, {1.5, 0.0, 1.0});
        }
}

/// Under a ceiling that is only as high as it needs.
TEST(Stairs, AreClimbedUnderALowCeiling) {
    Stairs scene(2, 4);
    scene.add(solidGrid({50, 5, 30}, 7), {0.0, 0.8 + 1.8 + 0.1, -1.5}, true);
    expectUpAndDown(scene, {2.0, 0.0, 0.0});
}

TEST(Stairs, AStepThatIsNoDeeperThanAToeIsAWall) {
    Walk scene;
    scene.addFloor();
    scene.add(gridOf({20, 40, 30}, [](glm::ivec3 c) { return uint8_t(c.y < 3 || c.x > 0 ? 7 : 0); }), {1.0, 0.0, -1.5},
              true);  // 0.3 m high, 0.1 m deep, before a wall
    scene.load();
    scene.walk(10);
    scene.go({2.0, 0.0, 0.0}, 2.0);
    EXPECT_NEAR(scene.me().position.y, 0.0, 0.02);
    EXPECT_NEAR(scene.me().position.x, 0.7, 0.02);
}

}  // namespace
}  // namespace rubble
