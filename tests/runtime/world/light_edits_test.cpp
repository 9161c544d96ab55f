#include <gtest/gtest.h>

#include <limits>

#include "tests/runtime/world/worlds.h"

namespace rubble {
namespace {

/// A lamp post of entry 1 with a head of entry 6 that glows, and a light inside the head; at 1 m per 10 cells.
Level lampPost() {
    VoxelGrid grid({8, 40, 8});
    {
        GridWriter writer(grid);
        for (int y = 0; y < 40; ++y)
            for (int i = 0; i < 16; ++i) writer.set({2 + i % 4, y, 2 + i / 4}, y < 34 ? 1 : 6);
    }
    Level level = test::oneShapeLevel(std::move(grid), true);
    Palette palette = test::fiveEntries();
    palette[6] = {.material = 1, .emission = 4.0f, .lightGroup = 1};
    level.bodies[0].shapes[0].palette = std::make_shared<const Palette>(palette);
    level.lightGroups.push_back({.name = "lamp", .threshold = 0.4f});
    level.lights.push_back({.light = {.name = "bulb", .local = {{0.4, 3.7, 0.4}}}, .shapeName = "shape", .groupName = "lamp"});
    return level;
}

const Light& firstLight(const World& world) {
    const Light* first = nullptr;
    world.lights().forEach([&](LightHandle, const Light& light) { first = &light; });
    return *first;
}

bool anyGlow(const World& world) {
    bool glows = false;
    world.shapes().forEach([&](ShapeHandle, const Shape& shape) {
        for (const PaletteEntry& entry : *shape.palette) glows = glows || (entry.lightGroup == 1 && entry.emission > 0.0f);
    });
    return glows;
}

TEST(LightEdits, ALightFallsWithThePieceThatHoldsIt) {
    World world;
    world.load(lampPost());
    const glm::dvec3 before = world.lightToWorld(firstLight(world)).position;
    const FrameChanges changes = world.applyEdits({test::sphereCarve({0.4, 1.5, 0.4}, 0.4)});
    ASSERT_EQ(changes.splits.size(), 1u);
    EXPECT_EQ(changes.lights.size(), 1u);
    EXPECT_EQ(firstLight(world).shape, changes.splits[0].children[0]);
    EXPECT_LT(glm::length(world.lightToWorld(firstLight(world)).position - before), 1e-6);
    EXPECT_TRUE(firstLight(world).enabled);
    EXPECT_TRUE(changes.groupsOut.empty());
}

TEST(LightEdits, AGroupGoesOutWhenEnoughOfItIsGone) {
    World world;
    world.load(lampPost());
    // Half a head is more than the threshold; a corner of it is less.
    const FrameChanges corner = world.applyEdits({test::sphereCarve({0.2, 4.0, 0.2}, 0.15)});
    EXPECT_TRUE(corner.groupsOut.empty());
    EXPECT_TRUE(anyGlow(world));
    CarveEdit half{.kind = BrushKind::Box, .position = {0.4, 3.85, 0.4}, .halfSize = {1.0, 0.16, 1.0}};
    const FrameChanges changes = world.applyEdits({half});
    ASSERT_EQ(changes.groupsOut.size(), 1u);
    EXPECT_TRUE(world.lightGroups().at(changes.groupsOut[0]).out);
    EXPECT_FALSE(firstLight(world).enabled);
    EXPECT_EQ(changes.lights.size(), 1u);
    EXPECT_FALSE(changes.palettes.empty());
    EXPECT_FALSE(anyGlow(world));
    EXPECT_TRUE(world.applyEdits({half}).groupsOut.empty()) << "it goes out once";
}

TEST(LightEdits, PiecesOfAGroupGoDarkWithIt) {
    World world;
    world.load(lampPost());
    // The head is cut off in two pieces, then half of it is destroyed in another place.
    world.applyEdits({test::sphereCarve({0.4, 1.5, 0.4}, 0.4)});
    world.applyEdits({CarveEdit{.kind = BrushKind::Box, .position = {0.4, 3.65, 0.4}, .halfSize = {1.0, 0.06, 1.0}}});
    EXPECT_EQ(world.shapes().size(), 3u);
    EXPECT_TRUE(anyGlow(world));
    const FrameChanges changes = world.applyEdits({CarveEdit{.kind = BrushKind::Box, .position = {0.4, 3.95, 0.4}, .halfSize = {1.0, 0.11, 1.0}}});
    EXPECT_EQ(changes.groupsOut.size(), 1u);
    EXPECT_EQ(changes.palettes.size(), world.shapes().size());
    EXPECT_FALSE(anyGlow(world));
}

TEST(LightEdits, PaintSurvivesASplit) {
    World world;
    world.load(lampPost());
    for (int i = 0; i < 20; ++i) world.applyEdits({PaintEdit{.position = {0.2, 2.8, 0.4}, .radius = 0.25, .color = {1, 2, 250}}});
    const auto blueVoxels = [&] {
        int count = 0;
        world.shapes().forEach([&](ShapeHandle, const Shape& shape) {
            shape.grid.forEachBrick([&](glm::ivec3, const BrickRef& brick) {
                forEachVoxel(brick->occupancy, [&](int i) {
                    const PaletteEntry& entry = (*shape.palette)[brick->at(i)];
                    count += entry.red == 1 && entry.green == 2 && entry.blue == 250;
                });
            });
        });
        return count;
    };
    const int painted = blueVoxels();
    EXPECT_GT(painted, 5);
    const FrameChanges changes = world.applyEdits({test::sphereCarve({0.4, 1.5, 0.4}, 0.4)});
    ASSERT_EQ(changes.splits.size(), 1u);
    EXPECT_EQ(blueVoxels(), painted);
}

/// A wall with a lamp at the top and a wire that winds up to it from a socket at the bottom.
Level wiredLamp(uint32_t flickerSteps) {
    VoxelGrid grid = test::solidGrid({24, 40, 6});
    {
        GridWriter writer(grid);
        for (int y = 4; y <= 20; ++y) writer.set({4, y, 5}, 7);
        for (int x = 4; x <= 18; ++x) writer.set({x, 20, 5}, 7);
        for (int y = 20; y < 34; ++y) writer.set({18, y, 5}, 7);
        for (int y = 34; y < 38; ++y)
            for (int x = 16; x < 20; ++x) writer.set({x, y, 5}, 6);
    }
    Level level = test::oneShapeLevel(std::move(grid), true);
    level.materials.materials.push_back({.name = "wire", .hardness = Hardness::Soft});
    Palette palette = test::fiveEntries();
    palette[6] = {.material = 1, .emission = 4.0f, .lightGroup = 1};
    palette[7] = {.material = 6};
    level.bodies[0].shapes[0].palette = std::make_shared<const Palette>(palette);
    level.lightGroups.push_back({.name = "lamp", .supplyShape = "shape", .supplyCell = {4, 4, 5}, .flickerSteps = flickerSteps});
    level.lights.push_back({.light = {.name = "bulb", .local = {{1.8, 3.6, 0.6}}}, .shapeName = "shape", .groupName = "lamp"});
    return level;
}

TEST(LightEdits, CuttingTheWirePutsTheLampOut) {
    World world;
    world.load(wiredLamp(0));
    EXPECT_TRUE(world.applyEdits({test::sphereCarve({1.0, 1.0, 0.6}, 0.35)}).groupsOut.empty()) << "beside the wire";
    EXPECT_TRUE(anyGlow(world));
    EXPECT_TRUE(world.applyEdits({test::sphereCarve({0.4, 3.0, 0.6}, 0.35)}).groupsOut.empty()) << "above where it turns";
    const FrameChanges cut = world.applyEdits({test::sphereCarve({1.2, 2.05, 0.6}, 0.2)});
    EXPECT_EQ(cut.groupsOut.size(), 1u);
    EXPECT_FALSE(anyGlow(world));
    EXPECT_FALSE(firstLight(world).enabled);
}

TEST(LightEdits, ALampThatFallsOffItsWireGoesOut) {
    World world;
    world.load(wiredLamp(0));
    // Cuts the top off the wall, wire and all, but leaves wire at both sides of the cut.
    CarveEdit saw{.kind = BrushKind::Box, .position = {1.2, 3.0, 0.3}, .halfSize = {2.0, 0.05, 1.0}};
    const FrameChanges cut = world.applyEdits({saw});
    EXPECT_EQ(cut.splits.size(), 1u);
    EXPECT_EQ(cut.groupsOut.size(), 1u);
    EXPECT_FALSE(anyGlow(world));
}

TEST(LightEdits, ItFlickersTheSameEveryTimeBeforeItIsOut) {
    std::vector<bool> first;
    for (int run = 0; run < 2; ++run) {
        World world;
        world.load(wiredLamp(30));
        world.applyEdits({test::sphereCarve({1.2, 2.05, 0.6}, 0.2)});
        std::vector<bool> dark;
        int steps = 1;
        for (; anyGlow(world) && steps < 100; ++steps) {
            const FrameChanges changes = world.applyEdits({});
            world.lightGroups().forEach([&](LightGroupHandle, const LightGroup& group) { dark.push_back(group.dark); });
            const bool switched = dark.size() > 1 && dark.back() != dark[dark.size() - 2] && anyGlow(world);
            EXPECT_FALSE(switched && changes.lights.empty());
        }
        EXPECT_EQ(steps, 31);
        EXPECT_TRUE(world.applyEdits({}).empty()) << "and then it is quiet";
        EXPECT_GE(std::count(dark.begin(), dark.end(), true), 3);
        if (run == 0) first = dark;
        EXPECT_EQ(dark, first);
    }
}

TEST(LightEdits, ASupplyThatLeadsNowhereIsNone) {
    Level level = wiredLamp(0);
    level.lightGroups[0].supplyCell = {10, 30, 2};
    World world;
    world.load(level);
    EXPECT_TRUE(world.applyEdits({test::sphereCarve({1.2, 2.05, 0.6}, 0.2)}).groupsOut.empty());
    EXPECT_TRUE(anyGlow(world));
}

LightHandle firstHandle(const World& world) {
    LightHandle first;
    world.lights().forEach([&](LightHandle handle, const Light&) { first = handle; });
    return first;
}

TEST(LightEdits, ALightIsSetAndTheJournalNamesIt) {
    World world;
    world.load(lampPost());
    SetLightEdit edit(firstHandle(world), firstLight(world));
    edit.color = {1.0f, 0.5f, 0.25f};
    edit.local.position.y = 2.0;
    edit.enabled = false;
    const FrameChanges changes = world.applyEdits({edit});
    EXPECT_EQ(changes.lights, std::vector<LightHandle>{edit.light});
    EXPECT_EQ(firstLight(world).color, edit.color);
    EXPECT_EQ(firstLight(world).local.position.y, 2.0);
    EXPECT_FALSE(firstLight(world).enabled);
    EXPECT_EQ(firstLight(world).name, "bulb");
}

TEST(LightEdits, ALightOfADeadGroupStaysDark) {
    World world;
    world.load(lampPost());
    const CarveEdit half{.kind = BrushKind::Box, .position = {0.4, 3.85, 0.4}, .halfSize = {1.0, 0.16, 1.0}};
    ASSERT_EQ(world.applyEdits({half}).groupsOut.size(), 1u);
    SetLightEdit edit(firstHandle(world), firstLight(world));
    edit.enabled = true;
    world.applyEdits({edit});
    EXPECT_FALSE(firstLight(world).enabled);
}

TEST(LightEdits, WhatIsNoLightOrWeatherChangesNothing) {
    World world;
    world.load(lampPost());
    const Environment before = world.environment();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    SetLightEdit light(firstHandle(world), firstLight(world));
    light.color.g = nan;
    SetEnvironmentEdit sky{world.environment()}, still{world.environment()};
    sky.environment.fogForward = 1.0f;
    still.environment.sunDirection = glm::vec3(0.0f);
    EXPECT_TRUE(world.applyEdits({light, SetLightEdit({}, firstLight(world)), sky, still}).lights.empty());
    EXPECT_EQ(firstLight(world).color, glm::vec3(1.0f));
    EXPECT_EQ(world.environment(), before);
}

TEST(LightEdits, TheWeatherIsAnEditLikeAnyOther) {
    World world;
    world.load(lampPost());
    SetEnvironmentEdit edit{world.environment()};
    edit.environment.wetness = 0.5f;
    edit.environment.sunDirection = {0.0f, 3.0f, 0.0f};
    world.applyEdits({edit});
    EXPECT_EQ(world.environment().wetness, 0.5f);
    EXPECT_EQ(world.environment().sunDirection, glm::vec3(0.0f, 1.0f, 0.0f));
}

}  // namespace
}  // namespace rubble
