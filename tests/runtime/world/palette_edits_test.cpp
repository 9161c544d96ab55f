#include <gtest/gtest.h>

#include <algorithm>

#include "tests/runtime/world/worlds.h"
#include "tests/support/grids.h"

namespace rubble {
namespace {

/// A free cube of material 1, and a standing one beside it with an equal palette of its own.
struct TwoCubes {
    TwoCubes() {
        Level level = test::oneShapeLevel(solidGrid({8, 8, 8}), false);
        level.bodies.push_back({.name = "standing", .pose = {{5.0, 0.0, 0.0}}});
        level.bodies[1].shapes.push_back(test::levelShape("standing", solidGrid({8, 8, 8})));
        level.lightGroups = {{.name = "bulb", .threshold = 0.5f}, {.name = "burnt out", .out = true}};
        world.load(level);
        world.applyEdits({});
    }
    FrameChanges set(PaletteEntry entry, bool all = false) {
        return world.applyEdits({SetPaletteEdit{first, all, 1, {entry}}});
    }
    PaletteEntry entryOf(ShapeHandle shape) const { return (*world.shapes().at(shape).palette)[1]; }
    double massOf(ShapeHandle shape) const { return bodyMass(world.data(), world.shapes().at(shape).body).mass; }

    World world;
    ShapeHandle first = ShapeHandle(), second = ShapeHandle();
};

struct PaletteEdits : testing::Test, TwoCubes {
    void SetUp() override { first = world.shapes().handleAt(0), second = world.shapes().handleAt(1); }
};

TEST_F(PaletteEdits, MassAndJournalFollowTheMaterial) {
    const double before = massOf(first);
    const FrameChanges changes = set({.red = 1, .material = 2});
    EXPECT_NEAR(massOf(first), before * 1700.0 / 1000.0, 1e-9 * before);
    EXPECT_EQ(changes.palettes, std::vector{first});
    EXPECT_EQ(changes.carved, std::vector{first}) << "physics takes mass and contacts over";
    EXPECT_TRUE(changes.bricks.empty());
    EXPECT_EQ(entryOf(second).material, 1) << "it has a palette of its own";
    EXPECT_FALSE(world.bodies().at(world.shapes().at(first).body).asleep);
    EXPECT_EQ(world.shapes().at(first).moments,
              gridMoments(world.shapes().at(first).grid, *world.shapes().at(first).palette, world.materials()));
}

TEST_F(PaletteEdits, OtherColoursAreNoOtherMatter) {
    const FrameChanges changes = set({.red = 1, .material = 1});
    EXPECT_EQ(changes.palettes, std::vector{first});
    EXPECT_TRUE(changes.carved.empty());
    EXPECT_TRUE(set({.red = 1, .material = 1}).palettes.empty()) << "nothing changes";
}

TEST_F(PaletteEdits, OneEditReachesAllThatHaveTheSameEntries) {
    set({.red = 9, .material = 3}, true);
    EXPECT_EQ(entryOf(first), entryOf(second));
    EXPECT_EQ(entryOf(second).red, 9);
    EXPECT_EQ(world.shapes().at(first).palette, world.shapes().at(second).palette) << "one copy for all";
}

TEST_F(PaletteEdits, WhatIsNotThereIsRefused) {
    EXPECT_TRUE(set({.material = 6}).palettes.empty());
    EXPECT_TRUE(set({.material = 1, .lightGroup = 3}).palettes.empty());
    EXPECT_TRUE(set({.material = 1, .emission = -1.0f}).palettes.empty());
    EXPECT_TRUE(world.applyEdits({SetPaletteEdit{first, false, 250, std::vector<PaletteEntry>(7)}}).palettes.empty());
    EXPECT_EQ(entryOf(first).material, 1);
}

TEST_F(PaletteEdits, VoxelsCountInTheirNewLightGroupAndPutItOut) {
    set({.material = 1, .emission = 5.0f, .lightGroup = 1});
    const LightGroupHandle bulb = world.lightGroups().handleAt(0);
    EXPECT_EQ(world.lightGroups().at(bulb).initialVoxels, 512u);
    CarveEdit half{.kind = BrushKind::Box, .position = {0.4, 0.2, 0.4}, .halfSize = {1.0, 0.31, 1.0}};
    half.radii.fill(1.0);
    world.applyEdits({half});
    EXPECT_TRUE(world.lightGroups().at(bulb).out);
    EXPECT_EQ(entryOf(first).emission, 0.0f);
    set({.material = 1, .emission = 5.0f, .lightGroup = 2});
    EXPECT_EQ(entryOf(first).emission, 0.0f) << "of a group that is out";
    EXPECT_EQ(world.lightGroups().at(bulb).initialVoxels, world.lightGroups().at(bulb).removedVoxels);
}

TEST_F(PaletteEdits, AreUndoneAndRedoneWithTheirMass) {
    WorldSettings settings;
    settings.undoMarks = 2;
    world.applyEdits({SettingsEdit{settings}});
    const double before = massOf(first);
    world.applyEdits({HistoryEdit{HistoryAction::Mark}, SetPaletteEdit{first, false, 1, {{.material = 4}}}});
    const uint64_t changed = resolvedHash(world.state());
    const double after = massOf(first);
    ASSERT_NE(after, before);
    const FrameChanges undone = world.applyEdits({HistoryEdit{HistoryAction::Undo}});
    EXPECT_EQ(undone.carved, std::vector{first});
    EXPECT_EQ(massOf(first), before);
    EXPECT_EQ(entryOf(first).material, 1);
    world.applyEdits({HistoryEdit{HistoryAction::Redo}});
    EXPECT_EQ(resolvedHash(world.state()), changed);
    EXPECT_EQ(massOf(first), after);
}

TEST(MaterialPalette, BeginsWithWhatIsOpaqueAndBreaksAsMostThingsDo) {
    const PaletteRef palette = materialPalette(defaultMaterials());
    const auto nameOf = [&](size_t entry) { return defaultMaterials()[(*palette)[entry].material].name; };
    EXPECT_EQ(nameOf(1), "generic");
    EXPECT_EQ(nameOf(6), "concrete");
    EXPECT_EQ(nameOf(15), "glass");
    EXPECT_EQ(nameOf(255), "rubber");
    MaterialTable own = test::fiveMaterials();
    EXPECT_EQ((*materialPalette(own))[1].material, 1) << "a level's first material";
}

}  // namespace
}  // namespace rubble
