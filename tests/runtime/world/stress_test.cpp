#include <gtest/gtest.h>

#include "tests/runtime/world/worlds.h"
#include "tests/support/allocation_count.h"
#include "tests/support/grids.h"

namespace rubble {
namespace {

/// A beam of concrete clamped in a wall at x < 4.
Level cantilever(int length, int depth, float voxelSize = 0.1f) {
    Level level;
    Palette palette{};
    palette[1].material = level.materials.find("concrete");
    LevelShape shape{.name = "beam",
                     .voxelSize = voxelSize,
                     .grid = solidGrid({4 + length, depth, depth}),
                     .palette = std::make_shared<const Palette>(palette)};
    shape.anchors = {{{0, 0, 0}, {4, depth, depth}}};
    LevelBody body{.name = "wall", .isStatic = true};
    body.shapes.push_back(std::move(shape));
    level.bodies.push_back(std::move(body));
    return level;
}

/// Stress over strength at the wall under its own weight, by beam theory.
double shareAtWall(int length, int depth, double voxelSize, double strengthScale) {
    return 2400.0 * 9.81 * 3.0 * length * length * voxelSize / depth / (2.6e6 * strengthScale);
}

WorldSettings stressOn(double strengthScale) {
    WorldSettings settings;
    settings.stress.on = true;
    settings.stress.strengthScale = strengthScale;
    return settings;
}

TEST(Stress, CantileverSnapsAtTheWall) {
    for (const float voxelSize : {0.05f, 0.1f, 0.25f}) {
        const double scale = shareAtWall(80, 8, voxelSize, 1.0);
        for (const double overload : {0.95, 1.05}) {
            World world;
            world.setSettings(stressOn(scale / overload));
            world.load(cantilever(80, 8, voxelSize));
            std::vector<CrackOpened> cracks;
            size_t pieces = 0;
            for (int step = 0; step < 60; ++step) {
                const FrameChanges changes = world.applyEdits({});
                cracks.insert(cracks.end(), changes.cracks.begin(), changes.cracks.end());
                pieces += changes.shapesCreated.size();
            }
            EXPECT_EQ(pieces, overload > 1.0 ? 1u : 0u) << voxelSize;
            EXPECT_EQ(cracks.empty(), overload < 1.0);
            if (!cracks.empty()) {
                EXPECT_NEAR(cracks[0].position.x, 4 * voxelSize, 1e-6);
                EXPECT_EQ(cracks[0].cause, FailureMode::Tension);
            }
            EXPECT_TRUE(voxelAccounting(world).balances());
        }
    }
}

TEST(Stress, CostsNothingWhenOff) {
    World world;
    world.load(cantilever(80, 8));
    world.applyEdits({});
    EXPECT_FALSE(world.data().stress);
    const size_t before = allocationCount();
    for (int step = 0; step < 100; ++step) world.applyEdits({});
    EXPECT_EQ(allocationCount(), before);
}

TEST(Stress, AtRestItCostsNoAllocation) {
    World world;
    world.setSettings(stressOn(1.0));
    world.load(cantilever(80, 8));
    for (int step = 0; step < 60; ++step) world.applyEdits({});
    ASSERT_TRUE(world.data().stress);
    EXPECT_FALSE(world.data().stress->isBusy());
    const size_t before = allocationCount();
    for (int step = 0; step < 100; ++step) world.applyEdits({});
    EXPECT_EQ(allocationCount(), before);
}

TEST(Stress, ShapesCanOptOut) {
    Level level = cantilever(80, 8);
    level.bodies[0].shapes[0].loadBearing = false;
    World world;
    world.setSettings(stressOn(1e-4));
    world.load(level);
    for (int step = 0; step < 60; ++step) EXPECT_TRUE(world.applyEdits({}).cracks.empty());
}

TEST(Stress, CutsTriggerANewAnalysis) {
    World world;
    world.setSettings(stressOn(1.5 * shareAtWall(80, 8, 0.1, 1.0)));
    world.load(cantilever(80, 8));
    for (int step = 0; step < 60; ++step) EXPECT_TRUE(world.applyEdits({}).cracks.empty());
    // Cuts three of eight layers in the middle: the section modulus falls to (5/8)^2, the moment is a quarter of that
    // at the wall.
    CarveEdit saw{.kind = BrushKind::Box, .position = {4.4, 0.65, 0.4}, .halfSize = {0.1, 0.15, 0.5}};
    world.applyEdits({saw});
    for (int step = 0; step < 60; ++step) EXPECT_TRUE(world.applyEdits({}).cracks.empty()) << step;
    // The same at the wall: a strength reserve of 1.5 is less than the rise of stress by (8/5)^2 = 2.6.
    saw.position.x = 0.6;
    world.applyEdits({saw});
    std::vector<CrackOpened> cracks;
    for (int step = 0; step < 60; ++step) {
        const FrameChanges changes = world.applyEdits({});
        cracks.insert(cracks.end(), changes.cracks.begin(), changes.cracks.end());
    }
    ASSERT_FALSE(cracks.empty());
    EXPECT_NEAR(cracks[0].position.x, 0.6, 0.11);
}

/// Also of a beam far from breaking that something has touched before.
TEST(Stress, OtherMaterialsTriggerANewAnalysis) {
    for (const bool byPalette : {false, true}) {
        World world;
        world.setSettings(stressOn(1.0));
        Level level = cantilever(40, 4);
        Material& concrete = level.materials.materials[level.materials.find("concrete")];
        concrete.tensileStrength = concrete.compressiveStrength = concrete.shearStrength = 1e9f;
        world.load(level);
        CarveEdit touch{.kind = BrushKind::Box, .position = {4.35, 0.05, 0.05}, .halfSize = {0.04, 0.04, 0.04}};
        world.applyEdits({touch});
        for (int step = 0; step < 120; ++step) EXPECT_TRUE(world.applyEdits({}).cracks.empty());
        Material weak = concrete;
        weak.tensileStrength = weak.compressiveStrength = weak.shearStrength = 1e3f;
        if (byPalette) weak.name = "weak concrete";
        const auto row = uint8_t(byPalette ? level.materials.materials.size() : level.materials.find("concrete"));
        ShapeHandle beam;
        world.shapes().forEach([&](ShapeHandle handle, const Shape&) { beam = handle; });
        Edits edits{SetMaterialsEdit{row, {weak}}};
        if (byPalette) edits.push_back(SetPaletteEdit{beam, false, 1, {{.material = row}}});
        size_t cracks = world.applyEdits(edits).cracks.size();
        for (int step = 0; step < 60; ++step) cracks += world.applyEdits({}).cracks.size();
        EXPECT_GT(cracks, 0u) << (byPalette ? "by its palette" : "by the table");
    }
}

TEST(Stress, TheSameEditsGiveTheSameHashes) {
    World first, second;
    for (World* world : {&first, &second}) {
        world->setSettings(stressOn(shareAtWall(80, 8, 0.1, 1.0) / 1.05));
        world->load(cantilever(80, 8));
    }
    for (int step = 0; step < 60; ++step) {
        first.applyEdits({});
        second.applyEdits({});
        ASSERT_EQ(first.hash(), second.hash()) << step;
    }
}

TEST(Stress, ResetCachesMatchesASavedAndLoadedWorld) {
    const WorldSettings settings = stressOn(shareAtWall(80, 8, 0.1, 1.0) / 1.05);
    World running;
    running.setSettings(settings);
    running.load(cantilever(80, 8));
    running.applyEdits({});
    running.resetCaches();
    World loaded;
    loaded.setSettings(settings);
    loaded.load(toLevel(running));
    for (int step = 0; step < 60; ++step) {
        running.applyEdits({});
        loaded.applyEdits({});
        ASSERT_EQ(voxelAccounting(running).standing, voxelAccounting(loaded).standing) << step;
    }
    EXPECT_GT(voxelAccounting(running).removed, 0u);
}

}  // namespace
}  // namespace rubble
