#include "runtime/world/level/fit_lights.h"

#include <gtest/gtest.h>

#include "runtime/core/constants.h"
#include "tests/runtime/world/worlds.h"

namespace rubble {
namespace {

/// A wall with glowing voxels in three places: a tube, a panel and a bulb, all of one palette entry.
Level glowingWall() {
    VoxelGrid grid = solidGrid({80, 60, 4});
    {
        GridWriter writer(grid);
        for (int x = 10; x < 50; ++x)
            for (int y = 10; y < 12; ++y) writer.set({x, y, 3}, 6), writer.set({x, y, 2}, 6);
        for (int x = 10; x < 26; ++x)
            for (int y = 30; y < 46; ++y) writer.set({x, y, 3}, 6);
        for (int x = 60; x < 63; ++x)
            for (int y = 30; y < 33; ++y)
                for (int z = 1; z < 4; ++z) writer.set({x, y, z}, 6);
    }
    Level level = test::oneShapeLevel(std::move(grid), true);
    Palette palette = test::fiveEntries();
    palette[6] = {.red = 255, .green = 200, .blue = 100, .material = 1, .emission = 4.0f};
    level.bodies[0].shapes[0].palette = std::make_shared<const Palette>(palette);
    level.autoLightGroups = 16;
    return level;
}

TEST(FitLights, OneGroupAndLightPerConnectedGlow) {
    World world;
    world.load(glowingWall());
    ASSERT_EQ(world.lightGroups().size(), 3u);
    ASSERT_EQ(world.lights().size(), 3u);
    std::vector<Light> lights;
    world.lights().forEach([&](LightHandle, const Light& light) { lights.push_back(light); });
    std::sort(lights.begin(), lights.end(),
              [](const Light& a, const Light& b) { return a.local.position.x < b.local.position.x; });
    EXPECT_EQ(lights[0].kind, LightKind::Area);
    EXPECT_EQ(lights[1].kind, LightKind::Capsule);
    EXPECT_EQ(lights[2].kind, LightKind::Sphere);
    EXPECT_NEAR(glm::length(lights[0].local.position - glm::dvec3(1.8, 3.8, 0.35)), 0.0, 1e-6);
    EXPECT_NEAR(glm::length(lights[1].local.position - glm::dvec3(3.0, 1.1, 0.3)), 0.0, 1e-6);
    EXPECT_NEAR(std::abs((lights[0].local.rotation * glm::dvec3(0, 0, 1)).z), 1.0, 1e-6)
        << "a panel faces along its thinnest axis";
    EXPECT_NEAR(std::abs((lights[1].local.rotation * glm::dvec3(1, 0, 0)).x), 1.0, 1e-6)
        << "a tube lies along its longest";
    // The mean projected area of a cube of 3 cells is a quarter of its 54 faces.
    EXPECT_NEAR(lights[2].radius, std::sqrt(0.25 * 54 * 0.01 / kPi), 0.02);
    EXPECT_GT(lights[0].color.x, lights[0].color.z);
}

TEST(FitLights, OneGoesOutAndTheOthersStay) {
    World world;
    world.load(glowingWall());
    const FrameChanges changes = world.applyEdits({test::sphereCarve({6.1, 3.1, 0.3}, 0.4)});
    EXPECT_EQ(changes.groupsOut.size(), 1u);
    int lit = 0;
    world.lights().forEach([&](LightHandle, const Light& light) { lit += light.enabled; });
    EXPECT_EQ(lit, 2);
}

TEST(FitLights, IsBoundedAndOff) {
    Level level = glowingWall();
    level.autoLightGroups = 2;
    World world;
    world.load(level);
    EXPECT_EQ(world.lightGroups().size(), 2u);
    level.autoLightGroups = 0;
    world.load(level);
    EXPECT_EQ(world.lightGroups().size(), 0u);
    EXPECT_EQ(world.lights().size(), 0u);
}

TEST(FitLights, TakesNoEntryThatVoxelsHave) {
    Level level = glowingWall();
    fillBox(level.bodies[0].shapes[0].grid, {{0, 0, 0}, {4, 4, 4}}, 255);  // without a material
    fillBox(level.bodies[0].shapes[0].grid, {{4, 0, 0}, {8, 4, 4}}, 253);
    fitLights(level);
    const LevelShape& shape = level.bodies[0].shapes[0];
    for (const int cell : {0, 4}) {
        EXPECT_EQ((*shape.palette)[shape.grid.at({cell, 0, 0})], PaletteEntry{});
    }
    EXPECT_EQ(level.lightGroups.size(), 3u);
}

}  // namespace
}  // namespace rubble
