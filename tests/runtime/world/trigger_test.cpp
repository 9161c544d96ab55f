#include "runtime/world/objects/trigger.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "runtime/world/state/world_state.h"
#include "tests/runtime/world/worlds.h"

namespace rubble {
namespace {

using namespace test;

/// Free cubes of half a metre in a row along x, a static one, and triggers.
struct Region {
    Region() {
        level = oneShapeLevel(VoxelGrid({1, 1, 1}), true);
        level.bodies.clear();
        for (int i = 0; i < 4; ++i) addCube({2.0 * i, 0.0, 0.0}, i == 0);
    }
    void addCube(glm::dvec3 at, bool isStatic) {
        VoxelGrid grid({5, 5, 5});
        {
            GridWriter writer(grid);
            for (int i = 0; i < 125; ++i) writer.set({i % 5, i / 5 % 5, i / 25}, 1);
        }
        LevelBody body{.name = "cube", .pose = {at}, .isStatic = isStatic};
        body.shapes.push_back(levelShape("cube", std::move(grid)));
        level.bodies.push_back(std::move(body));
    }
    void move(int index, glm::dvec3 to) {
        const BodyHandle handle = world.bodies().handleAt(uint32_t(index));
        const BodyPose pose{handle, {to}, {}, {}, false};
        world.setPoses(std::span(&pose, 1));
    }
    /// The events of the next step as text: "+2" entered, "-2" left, by slot of the body, of each trigger.
    std::string events(const Edits& edits = {}) {
        std::string text;
        for (const TriggerEvent& event : world.applyEdits(edits).triggerEvents)
            text += std::to_string(event.trigger.slot()) + (event.entered ? "+" : "-") +
                    std::to_string(event.body.slot()) + " ";
        return text;
    }
    Level level;
    World world;
};

TEST(Trigger, ReportsWhoEntersAndLeavesInSlotOrder) {
    Region region;
    region.level.triggers.push_back({.name = "box", .pose = {{4.25, 0.25, 0.25}}, .halfSize = {2.3, 1.0, 1.0}});
    region.level.triggers.push_back(
        {.name = "ball", .kind = TriggerKind::Sphere, .pose = {{6.25, 0.25, 0.25}}, .radius = 0.5});
    region.world.load(region.level);
    EXPECT_EQ(region.events(), "0+1 0+2 0+3 1+3 ") << "those that a level brings, but nothing static";
    EXPECT_EQ(region.events(), "");
    region.move(1, {9.0, 0.0, 0.0});
    region.move(3, {6.3, 0.0, 0.0});
    EXPECT_EQ(region.events(), "0-1 ");
    region.move(1, {6.2, 0.3, 0.0});
    region.move(3, {20.0, 0.0, 0.0});
    EXPECT_EQ(region.events(), "0+1 0-3 1+1 1-3 ");
    EXPECT_EQ(region.world.triggers().at(region.world.triggers().handleAt(0)).inside.size(), 2u);
}

TEST(Trigger, CountsVoxelsAndNotBounds) {
    Region region;
    region.level.triggers.push_back({.kind = TriggerKind::Sphere, .pose = {{2.6, 0.6, 0.6}}, .radius = 0.16});
    region.level.triggers.push_back({.kind = TriggerKind::Sphere, .pose = {{2.6, 0.6, 0.6}}, .radius = 0.18});
    region.world.load(region.level);
    EXPECT_EQ(region.events(), "1+1 ") << "the corner is sqrt(3) x 0.1 m away: bounds of both meet the cube's";
    EXPECT_EQ(region.events({sphereCarve({2.5, 0.5, 0.5}, 0.09)}), "1-1 ") << "the corner is gone";
}

/// Nothing moves it. A loaded game looks at all bodies, so its hash would be another one.
TEST(Trigger, ABodyLeavesWithTheShapeThatWasInside) {
    Region region;
    LevelShape arm = region.level.bodies[1].shapes[0];
    arm.name = "arm";
    arm.local.position = {0.0, 0.5, 0.0};
    region.level.bodies[1].shapes.push_back(arm);
    region.level.triggers.push_back({.pose = {{2.25, 0.8, 0.25}}, .halfSize = {0.1, 0.1, 0.1}});
    region.world.load(region.level);
    EXPECT_EQ(region.events(), "0+1 ");
    const std::vector<ShapeHandle> shapes = region.world.bodies().at(region.world.bodies().handleAt(1)).shapes;
    ASSERT_EQ(shapes.size(), 2u);
    EXPECT_EQ(region.events({DestroyShapeEdit{shapes[1]}}), "0-1 ");
}

TEST(Trigger, PolygonsHaveAHeight) {
    Region region;
    region.level.triggers.push_back(
        {.kind = TriggerKind::Polygon,
         .pose = {{2.0, 0.0, 0.0}},
         .outline = {{-1.0, -1.0}, {3.0, -1.0}, {-1.0, 3.0}},  // a triangle: the cube at 4 m is outside
         .height = 1.0});
    region.world.load(region.level);
    EXPECT_EQ(region.events(), "0+1 ");
    region.move(1, {2.0, 1.0, 0.0});
    EXPECT_EQ(region.events(), "0-1 ");
}

TEST(Trigger, EditsAddAndRemoveThemAndLayersFilter) {
    Region region;
    region.level.bodies[2].shapes[0].collisionLayer = 2;
    region.world.load(region.level);
    EXPECT_EQ(region.events(), "");
    Trigger trigger{.pose = {{3.0, 0.0, 0.0}}, .halfSize = {2.0, 1.0, 1.0}};
    EXPECT_EQ(region.events({AddTriggerEdit{trigger}}), "0+1 0+2 ");
    trigger.layerMask = 2;
    EXPECT_EQ(region.events({AddTriggerEdit{trigger}}), "1+2 ");
    EXPECT_EQ(region.events({SetCollisionFilterEdit{
                  region.world.bodies().at(region.world.bodies().handleAt(2)).shapes[0], 1, 255}}),
              "1-2 ");
    EXPECT_EQ(region.events({RemoveTriggerEdit{region.world.triggers().handleAt(0)}}), "0-1 0-2 ");
    EXPECT_EQ(region.world.triggers().size(), 1u);
    trigger.halfSize = {0.0, 1.0, 1.0};
    region.world.applyEdits({AddTriggerEdit{trigger}, RemoveTriggerEdit{}, AddWaterEdit{}, RemoveWaterEdit{},
                             MoveCharacterEdit{}, SetCollisionFilterEdit{}});
    EXPECT_EQ(region.world.triggers().size(), 1u) << "nonsense is refused";
}

TEST(Trigger, UndoAndRedoReportWhoLeavesAndEnters) {
    Region region;
    region.level.triggers.push_back({.name = "box", .pose = {{2.25, 0.25, 0.25}}, .halfSize = {1.0, 1.0, 1.0}});
    region.world.load(region.level);
    WorldSettings settings;
    settings.undoMarks = 2;
    EXPECT_EQ(region.events({SettingsEdit{settings}}), "0+1 ");
    EXPECT_EQ(region.events({HistoryEdit{HistoryAction::Mark}}), "");
    EXPECT_EQ(region.events({DestroyBodyEdit{region.world.bodies().handleAt(1)}}), "0-1 ");
    EXPECT_EQ(region.events({HistoryEdit{HistoryAction::Undo}}), "0+1 ");
    EXPECT_EQ(region.events({HistoryEdit{HistoryAction::Redo}}), "0-1 ");
    EXPECT_EQ(region.events(), "");
}

TEST(Trigger, OneThatGoesIsLeftAndOneThatComesBackIsEntered) {
    Region region;
    region.world.load(region.level);
    WorldSettings settings;
    settings.undoMarks = 3;
    region.events({SettingsEdit{settings}});
    const Trigger around{.pose = {{2.25, 0.25, 0.25}}, .halfSize = {1.0, 1.0, 1.0}};
    EXPECT_EQ(region.events({HistoryEdit{HistoryAction::Mark}, AddTriggerEdit{around}}), "0+1 ");
    EXPECT_EQ(region.events({HistoryEdit{HistoryAction::Undo}}), "0-1 ");
    EXPECT_EQ(region.events({HistoryEdit{HistoryAction::Redo}}), "0+1 ");
    const TriggerHandle trigger = region.world.triggers().handleAt(0);
    EXPECT_EQ(region.events({HistoryEdit{HistoryAction::Mark}, RemoveTriggerEdit{trigger}}), "0-1 ");
    EXPECT_EQ(region.events({HistoryEdit{HistoryAction::Undo}}), "0+1 ");
    EXPECT_EQ(region.events({DestroyBodyEdit{region.world.bodies().handleAt(1)}}), "0-1 ");
}

TEST(Trigger, SavesAndUndoAgree) {
    Region region;
    region.level.triggers.push_back({.pose = {{4.25, 0.25, 0.25}}, .halfSize = {1.0, 1.0, 1.0}});
    region.level.characters.emplace_back();
    region.level.waters.push_back({.outline = {{0, 0}, {1, 0}, {0, 1}}});
    region.world.load(region.level);
    WorldSettings settings;
    settings.undoMarks = 4;
    region.world.setSettings(settings);
    region.events();
    region.events({HistoryEdit{HistoryAction::Mark}});
    const uint64_t marked = resolvedHash(region.world);
    const CharacterHandle who = region.world.characters().handleAt(0);
    Trigger other{.kind = TriggerKind::Sphere, .pose = {{2.0, 0.0, 0.0}}};
    region.events({AddTriggerEdit{other}, RemoveWaterEdit{region.world.waters().handleAt(0)},
                   MoveCharacterEdit{who, {1.0, 0.0, 0.0}}});
    const CharacterMove move{who, {1.0, 2.0, 3.0}, {0.0, 1.0, 0.0}, {}, true, false, false, {}};
    region.world.setCharacters(std::span(&move, 1));
    region.move(2, {0.0, 5.0, 0.0});

    World loaded(1);
    loaded.setState(region.world.state());
    EXPECT_EQ(loaded.hash(), region.world.hash());
    loaded.applyEdits({});
    EXPECT_EQ(region.events(), "0-2 ");
    EXPECT_EQ(resolvedHash(loaded), resolvedHash(region.world));
    const uint64_t done = resolvedHash(region.world);
    EXPECT_NE(done, marked);
    region.events({HistoryEdit{HistoryAction::Undo}});
    EXPECT_EQ(resolvedHash(region.world), marked);
    EXPECT_EQ(region.world.waters().size(), 1u);
    region.events({HistoryEdit{HistoryAction::Redo}});
    EXPECT_EQ(resolvedHash(region.world), done);
    World back(2);
    back.load(toLevel(region.world));
    EXPECT_EQ(back.triggers().size(), 2u);
    EXPECT_EQ(back.characters().size(), 1u);
}

}  // namespace
}  // namespace rubble
