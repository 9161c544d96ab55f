#include "runtime/frame/shown_palettes.h"

#include <gtest/gtest.h>

#include "tests/runtime/world/worlds.h"
#include "tests/support/grids.h"

namespace rubble {
namespace {

/// Two shapes that share a palette whose first entry glows, its second with a light group.
struct ShownPalettesTest : testing::Test {
    ShownPalettesTest() {
        Level level = test::oneShapeLevel(solidGrid({4, 4, 4}), true);
        auto palette = std::make_shared<Palette>(*level.bodies[0].shapes[0].palette);
        (*palette)[1].emission = (*palette)[2].emission = 3.0f;
        (*palette)[2].lightGroup = 1;
        level.bodies[0].shapes[0].palette = palette;
        level.bodies[0].shapes.push_back(level.bodies[0].shapes[0]);
        level.lightGroups = {{.name = "bulb"}};
        world.load(level);
        step({});
    }
    FrameChanges step(const Edits& edits) {
        const FrameChanges changes = world.applyEdits(edits);
        shown.update(changes, world);
        return changes;
    }
    const Shape& shape(uint32_t slot) const { return world.shapes().at(world.shapes().handleAt(slot)); }

    World world;
    ShownPalettes shown;
};

TEST_F(ShownPalettesTest, AreTheShapesOwnWithoutFactorsAndSwitches) {
    EXPECT_EQ(shown.of(shape(0)), shape(0).palette);
}

TEST_F(ShownPalettesTest, EmissionIsMultipliedByTheFactorOfTheShape) {
    SetShapeEdit brighter{.shape = world.shapes().handleAt(0), .setsEmission = true, .emission = 2.0f};
    EXPECT_EQ(step({brighter}).palettes, std::vector{brighter.shape});
    EXPECT_EQ((*shown.of(shape(0)))[1].emission, 6.0f);
    EXPECT_EQ((*shape(0).palette)[1].emission, 3.0f) << "the world keeps what the entry emits";
    EXPECT_EQ(shown.of(shape(1)), shape(1).palette);
    brighter.shape = world.shapes().handleAt(1);
    step({brighter});
    EXPECT_EQ(shown.of(shape(0)), shown.of(shape(1))) << "one for all that share palette and factor";
}

TEST_F(ShownPalettesTest, AGroupThatIsOffIsDarkUntilItIsOn) {
    SetLightGroupEdit off{.group = world.lightGroups().handleAt(0), .switches = true, .on = false};
    EXPECT_EQ(step({off}).palettes.size(), 2u);
    EXPECT_EQ((*shown.of(shape(0)))[2].emission, 0.0f);
    EXPECT_EQ((*shown.of(shape(0)))[1].emission, 3.0f) << "of no group";
    EXPECT_EQ(shown.of(shape(0)), shown.of(shape(1)));
    EXPECT_TRUE(step({off}).palettes.empty()) << "it is off";
    off.on = true;
    EXPECT_EQ(step({off}).palettes.size(), 2u);
    EXPECT_EQ(shown.of(shape(0)), shape(0).palette);
}

TEST_F(ShownPalettesTest, UndoListsWhatASwitchHadDarkened) {
    WorldSettings settings;
    settings.undoMarks = 1;
    step({SettingsEdit{settings}});
    const SetLightGroupEdit off{.group = world.lightGroups().handleAt(0), .switches = true, .on = false};
    step({HistoryEdit{HistoryAction::Mark}, off});
    ASSERT_NE(shown.of(shape(0)), shape(0).palette);
    EXPECT_EQ(step({HistoryEdit{HistoryAction::Undo}}).palettes.size(), 2u);
    EXPECT_EQ(shown.of(shape(0)), shape(0).palette);
}

}  // namespace
}  // namespace rubble
