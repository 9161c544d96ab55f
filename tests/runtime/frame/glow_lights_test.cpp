// Voxels that glow without a light group light what is around them, when and wherever a host makes them.
#include "runtime/frame/glow_lights.h"

#include <gtest/gtest.h>

#include "runtime/frame/snapshots.h"
#include "tests/runtime/world/worlds.h"
#include "tests/support/allocation_count.h"

namespace rubble {
namespace {

constexpr uint8_t kGlow = 6, kGrouped = 7;

PaletteRef glowingPalette(float emission = 4.0f) {
    auto palette = std::make_shared<Palette>(test::fiveEntries());
    (*palette)[kGlow] = {.red = 255, .green = 200, .blue = 100, .material = 1, .emission = emission};
    (*palette)[kGrouped] = (*palette)[kGlow];
    (*palette)[kGrouped].lightGroup = 1;
    return palette;
}

/// A wall of 80x60x4 voxels without glow.
Level wall() {
    Level level = test::oneShapeLevel(solidGrid({80, 60, 4}), true);
    level.bodies[0].shapes[0].palette = glowingPalette();
    level.lightGroups.push_back({.name = "group"});
    return level;
}

struct GlowingWorld {
    World world;
    Snapshots snapshots;
    std::vector<SnapshotLight> lights;  ///< as drawn
    bool changed = false;               ///< the last step listed them

    explicit GlowingWorld(const Level& level) {
        world.load(level);
        step();
    }
    void step(const Edits& edits = {}, std::vector<BodyPose> moved = {}) {
        const FrameChanges changes = world.applyEdits(edits);
        world.setPoses(moved);
        snapshots.publishWithoutShadow(changes, moved, world);
        const auto snapshot = snapshots.take();
        changed = snapshot && snapshot->lightsChanged;
        if (changed) lights = snapshot->lights;
    }
    /// Fills cells of the first shape.
    void fill(CellBox box, uint8_t entry) {
        const glm::ivec3 size = box.high - box.low;
        WriteVoxelsEdit edit{.shape = test::firstShape(world), .box = box};
        edit.entries.assign(size_t(size.x) * size_t(size.y) * size_t(size.z), entry);
        step({edit});
    }
};

TEST(GlowLights, VoxelsThatAreMadeToGlowLightTheirSurroundings) {
    GlowingWorld glowing(wall());
    EXPECT_TRUE(glowing.lights.empty());
    glowing.fill({{10, 10, 3}, {26, 26, 4}}, kGlow);
    ASSERT_EQ(glowing.lights.size(), 1u);
    const SnapshotLight panel = glowing.lights[0];
    EXPECT_EQ(panel.kind, LightKind::Area);
    EXPECT_FALSE(panel.twoSided) << "the wall is behind it";
    EXPECT_NEAR(panel.direction.z, 1.0f, 1e-5f) << "away from the wall";
    EXPECT_NEAR(glm::distance(panel.position, glm::dvec3(1.8, 1.8, 0.4)), 0.0, 1e-6);
    // A radiance of 4 over the open faces, 1.6 m on a side.
    EXPECT_NEAR(panel.color.x, 4.0f * 1.6f * 1.6f, 1e-3f);
    glowing.step({test::sphereCarve({1.8, 1.8, 0.35}, 2.0)});
    EXPECT_TRUE(glowing.lights.empty()) << "it is gone";
}

/// The flux of a rectangle is pi times its radiance and area.
TEST(GlowLights, RectanglesHaveTheFluxOfTheOpenFaces) {
    Level level = wall();
    LevelShape& shape = level.bodies[0].shapes[0];
    shape.grid = VoxelGrid({64, 64, 64});
    double faces = 0.0;
    for (int i = 0; i < 32 * 32 * 32; ++i) {
        const glm::ivec3 cell(i % 32, i / 32 % 32, i / 1024);
        const glm::dvec3 away = glm::dvec3(cell) - 15.5;
        if (glm::length(away) < 9.0) fillBox(shape.grid, {cell, cell + 1}, kGlow);
    }
    for (int i = 0; i < 32 * 32 * 32; ++i) {
        const glm::ivec3 cell(i % 32, i / 32 % 32, i / 1024);
        for (const glm::ivec3 side : kFaceOffsets) faces += shape.grid.at(cell) && !shape.grid.at(cell + side);
    }
    const GlowingWorld glowing(level);
    ASSERT_EQ(glowing.lights.size(), 6u) << "a ball";
    double intensity = 0.0;
    for (const SnapshotLight& light : glowing.lights) {
        intensity += double(light.color.x);
        EXPECT_NEAR(light.width, light.height, 1e-4f);
        EXPECT_NEAR(light.color.x, 4.0f * light.width * light.height, 1e-3f);
        EXPECT_NEAR(glm::dot(glm::dvec3(light.direction), light.position - glm::dvec3(1.6)), 0.9, 1e-5);
    }
    EXPECT_NEAR(intensity, 4.0 * 0.01 * faces, 1e-3);
}

TEST(GlowLights, APaletteThatBeginsToGlowOrStopsCounts) {
    Level level = wall();
    fillBox(level.bodies[0].shapes[0].grid, {{10, 10, 0}, {14, 14, 4}}, kGlow);
    GlowingWorld glowing(level);
    ASSERT_EQ(glowing.lights.size(), 2u) << "one on each side of the wall";
    const float before = glowing.lights[0].color.x;
    const auto set = [&](float emission) {
        PaletteEntry entry = (*glowingPalette())[kGlow];
        entry.emission = emission;
        glowing.step({SetPaletteEdit{
            .shape = test::firstShape(glowing.world), .first = kGlow, .entries = std::vector<PaletteEntry>{entry}}});
    };
    set(8.0f);
    ASSERT_EQ(glowing.lights.size(), 2u);
    EXPECT_FLOAT_EQ(glowing.lights[0].color.x, 2.0f * before);
    set(0.0f);
    EXPECT_TRUE(glowing.lights.empty());
}

TEST(GlowLights, GroupedFaintAndCoveredVoxelsHaveNone) {
    Level level = wall();
    VoxelGrid& grid = level.bodies[0].shapes[0].grid;
    fillBox(grid, {{10, 10, 3}, {26, 26, 4}}, kGrouped);
    fillBox(grid, {{40, 10, 1}, {44, 14, 3}}, kGlow);
    EXPECT_TRUE(GlowingWorld(level).lights.empty()) << "of a group; inside the wall";
    fillBox(grid, {{60, 10, 0}, {61, 11, 1}}, kGlow);
    level.bodies[0].shapes[0].palette = glowingPalette(0.5f);
    EXPECT_TRUE(GlowingWorld(level).lights.empty()) << "a dim voxel lights nothing that is seen";
}

TEST(GlowLights, ALightOfTheWorldTakesTheirPlace) {
    Level level = wall();
    fillBox(level.bodies[0].shapes[0].grid, {{10, 10, 0}, {14, 14, 4}}, kGlow);
    GlowingWorld glowing(level);
    ASSERT_EQ(glowing.lights.size(), 2u);
    const uint32_t generation = glowing.lights[0].light.generation();
    EXPECT_EQ(generation, 0u);
    Light own;
    own.local.position = {1.2, 1.2, 0.7};
    glowing.step({AddLightEdit{.light = own}});
    ASSERT_EQ(glowing.lights.size(), 1u);
    EXPECT_NE(glowing.lights[0].light.generation(), 0u);
    own.local.position.z = 2.0;
    const LightHandle handle = glowing.lights[0].light;
    glowing.step({SetLightEdit{.light = handle, .values = own}});
    EXPECT_EQ(glowing.lights.size(), 3u) << "it is far from them now";
}

TEST(GlowLights, KeepTheirNumberWhenAPartGoesAndMoveWithTheirBody) {
    Level level = wall();
    level.bodies[0].isStatic = false;
    fillBox(level.bodies[0].shapes[0].grid, {{10, 10, 0}, {14, 14, 4}}, kGlow);
    GlowingWorld glowing(level);
    ASSERT_EQ(glowing.lights.size(), 2u);
    const SnapshotLight before = glowing.lights[0];
    glowing.fill({{10, 10, 0}, {11, 14, 4}}, 0);
    ASSERT_EQ(glowing.lights.size(), 3u) << "a side of it is open now";
    EXPECT_EQ(std::count_if(glowing.lights.begin(), glowing.lights.end(),
                            [&](const SnapshotLight& light) { return light.light == before.light; }),
              1);
    BodyPose up;
    glowing.world.bodies().forEach([&](BodyHandle handle, const Body& body) { up = {handle, body.pose}; });
    const glm::dvec3 last = glowing.lights[0].position;
    up.pose.position.y += 2.0;
    glowing.step({}, {up});
    ASSERT_TRUE(glowing.changed);
    EXPECT_NEAR(glowing.lights[0].position.y, last.y + 2.0, 1e-9);
    glowing.step();
    EXPECT_FALSE(glowing.changed);
}

TEST(GlowLights, AreAtMostSoManyTheBrightestOnes) {
    Level level = wall();
    LevelShape& shape = level.bodies[0].shapes[0];
    shape.grid = VoxelGrid({200, 200, 4});
    for (int x = 0; x < 25; ++x)
        for (int y = 0; y < 25; ++y)
            fillBox(shape.grid, {{8 * x, 8 * y, 0}, {8 * x + 2, 8 * y + (y == 12 ? 3 : 2), 2}}, kGlow);
    const GlowingWorld glowing(level);
    ASSERT_EQ(glowing.lights.size(), GlowLights::kMaxLights);
    EXPECT_EQ(std::count_if(glowing.lights.begin(), glowing.lights.end(),
                            [](const SnapshotLight& light) { return std::abs(light.position.y - 9.75) < 0.01; }),
              100)
        << "four sides of 25";
}

TEST(GlowLights, CostNothingWhereNothingGlows) {
    Level level = wall();
    level.bodies[0].shapes[0].palette = std::make_shared<const Palette>(test::fiveEntries());
    World world;
    world.load(level);
    GlowLights lights;
    ShownPalettes palettes;
    lights.update(world.applyEdits({}), world, palettes);
    const FrameChanges changes = world.applyEdits({test::sphereCarve({1.8, 1.8, 0.35}, 0.5)});
    const size_t before = allocationCount();
    EXPECT_FALSE(lights.update(changes, world, palettes));
    EXPECT_EQ(allocationCount(), before);
}

}  // namespace
}  // namespace rubble
