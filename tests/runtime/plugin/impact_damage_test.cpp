// What a hit breaks by its speed: physics and damage together.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "tests/runtime/plugin/headless_loop.h"
#include "tests/runtime/world/worlds.h"

namespace rubble {
namespace {

using namespace test;

constexpr uint8_t kWall = 1, kBall = 2;

LevelShape shapeOf(const char* name, VoxelGrid grid, const char* wallMaterial) {
    LevelShape shape{.name = name, .grid = std::move(grid)};
    Palette palette;
    palette[kWall].material = defaultMaterials().find(wallMaterial);
    palette[kBall].material = defaultMaterials().find("heavy metal");
    shape.palette = std::make_shared<const Palette>(palette);
    return shape;
}

/// A ball of 0.4 m that flies at the middle of a wall of 4 x 4 m, whose face is in z = 0.
Level thrownBall(const char* material, int thickness, double speed, double distance, double density) {
    Level level;
    level.environment.gravity = {0, 0, 0};
    LevelBody wall{.name = "wall", .pose = {{-2.0, -2.0, 0.0}}, .isStatic = true};
    wall.shapes.push_back(shapeOf("wall", solidGrid({40, 40, thickness}, kWall), material));
    VoxelGrid sphere({4, 4, 4});
    GridWriter writer(sphere);
    for (int z = 0; z < 4; ++z)
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 4; ++x)
                if (const glm::dvec3 d = glm::dvec3(x, y, z) - 1.5; glm::dot(d, d) < 4.0) writer.set({x, y, z}, kBall);
    writer.flush();
    LevelBody ball{.name = "ball", .pose = {{-0.2, -0.2, -0.4 - distance}}, .isStatic = false};
    ball.velocity = {0.0f, 0.0f, float(speed)};
    ball.shapes.push_back(shapeOf("ball", std::move(sphere), material));
    ball.shapes.back().density = float(density);
    level.bodies.push_back(std::move(wall));
    level.bodies.push_back(std::move(ball));
    return level;
}

/// Voxels that the first hit breaks out of the wall.
uint64_t brokenBy(const Level& level) {
    FrameLoop loop(headlessSettings());
    loop.load(level);
    for (int i = 0; i < 60; ++i) {
        loop.step();
        const VoxelAccounting voxels = voxelAccounting(loop.world().data());
        if (const uint64_t broken = voxels.removed + voxels.inPieces) return broken;
    }
    return 0;
}

/// A hit was placed where the ball was at the start of its step: up to half a step's way in front of the wall, where it
/// broke less the faster it was.
TEST(ImpactDamage, GrowsWithTheSpeedOfTheHit) {
    for (const char* material : {"generic", "brick"})
        for (const int thickness : {1, 3}) {
            uint64_t before = 0;
            for (const double speed : {10.0, 16.0, 20.0, 25.0, 29.0, 36.0, 45.0, 60.0, 90.0}) {
                const uint64_t broken = brokenBy(thrownBall(material, thickness, speed, 0.31, 1.0));
                EXPECT_GE(broken, before) << material << ", " << thickness << " voxels, " << speed << " m/s";
                before = broken;
            }
            EXPECT_GT(before, 0u);
        }
}

TEST(ImpactDamage, GrowsWithTheMassOfWhatHits) {
    uint64_t before = 0;
    for (const double density : {0.1, 0.3, 1.0, 2.0, 4.0, 10.0}) {
        const uint64_t broken = brokenBy(thrownBall("generic", 3, 30.0, 0.31, density));
        EXPECT_GE(broken, before) << density;
        before = broken;
    }
    EXPECT_GT(before, 0u);
}

/// Where in its step a ball meets the wall is chance.
TEST(ImpactDamage, DoesNotDependOnTheWayOfTheLastStep) {
    for (const double speed : {20.0, 36.0}) {
        const uint64_t broken = brokenBy(thrownBall("generic", 3, speed, 0.1, 1.0));
        EXPECT_GT(broken, 0u);
        for (int i = 1; i < 12; ++i)
            EXPECT_EQ(brokenBy(thrownBall("generic", 3, speed, 0.1 + speed / 60.0 * i / 12.0, 1.0)), broken)
                << speed << " m/s, " << i;
    }
}

}  // namespace
}  // namespace rubble
