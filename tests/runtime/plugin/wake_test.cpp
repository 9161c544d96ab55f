// What rests wakes when an edit takes away what it rests on, in every step: also in one that rebuilds physics.
#include <gtest/gtest.h>

#include <functional>

#include "tests/runtime/plugin/headless_loop.h"
#include "tests/runtime/world/worlds.h"

namespace rubble {
namespace {

using namespace test;

void addShape(Level& level, const char* name, glm::ivec3 size, glm::dvec3 corner, uint8_t entry, bool isStatic) {
    LevelBody body{.name = name, .pose = {corner}, .isStatic = isStatic};
    body.shapes.push_back(levelShape(name, solidGrid(size, entry)));
    level.bodies.push_back(std::move(body));
}

/// A pillar and a plank beside it, both 1 m high, stand on a floor. A cube rests on the pillar, another on the plank,
/// whose far end holds it to the world.
Level restingCubes() {
    Level level;
    level.materials = fiveMaterials();
    addShape(level, "floor", {80, 4, 80}, {0.0, -0.4, 0.0}, 4, true);
    addShape(level, "pillar", {10, 10, 10}, {2.0, 0.0, 2.0}, 1, true);
    addShape(level, "plank", {40, 1, 6}, {2.0, 0.9, 5.0}, 1, true);
    level.bodies.back().shapes[0].anchors = {{{0, 0, 0}, {2, 1, 6}}};
    addShape(level, "cube", {4, 4, 4}, {2.3, 1.0, 2.3}, 2, false);
    addShape(level, "second", {4, 4, 4}, {2.6, 1.0, 5.1}, 2, false);
    return level;
}

BodyHandle bodyNamed(const World& world, const std::string& name) {
    BodyHandle found;
    world.bodies().forEach([&](BodyHandle handle, const Body& body) {
        if (body.name == name && !found) found = handle;
    });
    return found;
}

ShapeHandle shapeNamed(const World& world, const std::string& name) {
    return world.bodies().at(bodyNamed(world, name)).shapes.at(0);
}

glm::dvec3 placeOf(const World& world, const std::string& name) {
    return world.bodies().at(bodyNamed(world, name)).pose.position;
}

CarveEdit boxCarve(const World& world, const char* shape, glm::dvec3 low, glm::dvec3 high) {
    return {.kind = BrushKind::Box,
            .position = 0.5 * (low + high),
            .halfSize = 0.5 * (high - low),
            .shape = shapeNamed(world, shape)};
}

Water pool(double surface) {
    Water water;
    water.outline = {{0.0, 0.0}, {8.0, 0.0}, {8.0, 8.0}, {0.0, 8.0}};
    water.surface = surface;
    water.depth = 4.0;
    water.density = 5000.0;
    return water;
}

/// Fixes the cube to the world.
AddJointEdit fixture(const World& world) {
    Joint joint{.kind = JointKind::Fixed};
    joint.ends[0].shape = shapeNamed(world, "cube");
    joint.ends[0].frame.position = glm::dvec3(0.2);
    joint.ends[1].frame.position = placeOf(world, "cube") + 0.2;
    return {joint};
}

/// Edits that move a body that rests.
struct Case {
    const char* what;
    const char* body = "cube";
    std::function<Edits(const World&)> edits;
    std::function<Edits(const World&)> before = {};  ///< edits before it comes to rest
};

std::vector<Case> allCases() {
    const auto pillar = [](const World& world) { return shapeNamed(world, "pillar"); };
    const auto gone = [](const World& world) { return boxCarve(world, "pillar", {1, -1, 1}, {4, 2, 4}); };
    const auto hole = [](const World& world) { return boxCarve(world, "pillar", {2.1, -1, 2.1}, {2.9, 2, 2.9}); };
    const auto grab = [](const World& world, double up) {
        const glm::dvec3 at = placeOf(world, "cube") + 0.2;
        return GrabEdit{
            .body = bodyNamed(world, "cube"), .point = at, .target = at + glm::dvec3(0, up, 0), .maxForce = 1e6};
    };
    Environment upward;
    upward.gravity = {0.0f, 5.0f, 0.0f};
    using W = const World&;
    return {
        {.what = "a hole is carved", .edits = [=](W w) { return Edits{hole(w)}; }},
        {.what = "the whole pillar is carved", .edits = [=](W w) { return Edits{gone(w)}; }},
        {.what = "resized away",
         .edits =
             [=](W w) {
                 return Edits{ResizeShapeEdit{pillar(w), {{0, 0, 0}, {2, 9, 3}}}};
             }},
        {.what = "a lower pillar",
         .edits =
             [=](W w) {
                 return Edits{ResizeShapeEdit{pillar(w), {{-9, 0, 0}, {10, 7, 10}}}};
             }},
        {.what = "carved, then resized",
         .edits =
             [=](W w) {
                 return Edits{hole(w), ResizeShapeEdit{pillar(w), {{-3, -1, 0}, {12, 12, 12}}}};
             }},
        {.what = "resized, then carved",
         .edits =
             [=](W w) {
                 return Edits{ResizeShapeEdit{pillar(w), {{-3, -1, 0}, {12, 12, 12}}}, hole(w)};
             }},
        {.what = "the floor is resized away",
         .edits =
             [](W w) {
                 return Edits{ResizeShapeEdit{shapeNamed(w, "floor"), {{40, 0, 40}, {80, 4, 80}}}};
             },
         .before = [=](W w) { return Edits{gone(w)}; }},
        {.what = "the anchored end is carved and the rest of the plank falls",
         .body = "second",
         .edits =
             [](W w) {
                 return Edits{boxCarve(w, "plank", {1, 0, 4}, {5, 2, 6})};
             }},
        {.what = "the anchored end is resized away and the rest of the plank falls",
         .body = "second",
         .edits =
             [](W w) {
                 return Edits{ResizeShapeEdit{shapeNamed(w, "plank"), {{30, 0, 0}, {40, 1, 6}}}};
             }},
        {.what = "collision filter",
         .edits =
             [=](W w) {
                 return Edits{SetCollisionFilterEdit{pillar(w), 2, 2}};
             }},
        {.what = "gravity", .edits = [=](W) { return Edits{SetEnvironmentEdit{upward}}; }},
        {.what = "water comes", .edits = [](W) { return Edits{AddWaterEdit{pool(3.0)}}; }},
        {.what = "water goes",
         .edits = [](W w) { return Edits{RemoveWaterEdit{w.waters().handleAt(0)}}; },
         .before = [](W) { return Edits{AddWaterEdit{pool(3.0)}}; }},
        {.what = "a grab", .edits = [=](W w) { return Edits{grab(w, 1.0)}; }},
        {.what = "a release",
         .edits = [](W) { return Edits{ReleaseEdit{}}; },
         .before =
             [=](W w) {
                 return Edits{grab(w, 0.0), gone(w)};
             }},
        {.what = "a joint is removed",
         .edits = [](W w) { return Edits{RemoveJointEdit{w.joints().handleAt(0)}}; },
         .before =
             [=](W w) {
                 return Edits{fixture(w), gone(w)};
             }},
    };
}

/// Lets everything fall by a hair and come to rest.
void rest(FrameLoop& loop, const Case& each) {
    loop.load(restingCubes());
    loop.step();
    Edits edits = each.before ? each.before(loop.world()) : Edits{};
    for (const char* name : {"cube", "second"})
        edits.push_back(ImpulseEdit{.body = bodyNamed(loop.world(), name),
                                    .position = placeOf(loop.world(), name) + 0.2,
                                    .impulse = {0.0, 0.01, 0.0}});
    loop.edits().push(edits);
    for (int step = 0; step < 2000; ++step) loop.step();
    ASSERT_TRUE(loop.world().bodies().at(bodyNamed(loop.world(), each.body)).asleep);
}

TEST(Wake, EditsMoveWhatRestsAlsoInTheStepAfterASaveALoadOrARecordingStarts) {
    for (const Case& each : allCases()) {
        SCOPED_TRACE(each.what);
        FrameLoop plain(headlessSettings()), saved(headlessSettings()), loaded(headlessSettings());
        rest(plain, each);
        rest(saved, each);
        loaded.load(saved.save());
        for (FrameLoop* loop : {&plain, &saved, &loaded}) {
            const glm::dvec3 before = placeOf(loop->world(), each.body);
            loop->edits().push(each.edits(loop->world()));
            for (int step = 0; step < 60; ++step) loop->step();
            const char* name = loop == &plain ? "plain" : loop == &saved ? "saved" : "loaded";
            EXPECT_GT(glm::length(placeOf(loop->world(), each.body) - before), 0.15) << name;
        }
        EXPECT_EQ(saved.world().hash(), loaded.world().hash());
    }
}

TEST(Wake, EditsInTheFirstStepOfALevelMoveWhatBeginsAsleep) {
    for (const Case& each : allCases()) {
        if (each.before) continue;
        SCOPED_TRACE(each.what);
        FrameLoop loop(headlessSettings());
        loop.load(restingCubes());
        const glm::dvec3 before = placeOf(loop.world(), each.body);
        loop.edits().push(each.edits(loop.world()));
        for (int step = 0; step < 60; ++step) loop.step();
        EXPECT_GT(glm::length(placeOf(loop.world(), each.body) - before), 0.15);
    }
}

TEST(Wake, ABodyOfALevelBeginsAsleepInTheAirAndFallsFromAnImpulseOfLengthZeroOrAVelocity) {
    Level level = restingCubes();
    for (const char* name : {"still", "nudged", "moving"})
        addShape(level, name, {4, 4, 4}, {4.0 + 0.1 * double(level.bodies.size()) * 5.0, 2.0, 1.0}, 2, false);
    level.bodies.back().velocity = {0.0f, -0.01f, 0.0f};
    FrameLoop loop(headlessSettings());
    loop.load(level);
    loop.edits().push(ImpulseEdit{.body = bodyNamed(loop.world(), "nudged")});
    for (int step = 0; step < 120; ++step) loop.step();
    EXPECT_EQ(placeOf(loop.world(), "still").y, 2.0);
    EXPECT_NEAR(placeOf(loop.world(), "nudged").y, 0.0, 0.01);
    EXPECT_NEAR(placeOf(loop.world(), "moving").y, 0.0, 0.01);
}

TEST(Wake, AStaticShapeIsSolidWhereAnUndoOrAMergeHasMadeItLarger) {
    for (const bool byUndo : {true, false}) {
        SCOPED_TRACE(byUndo ? "undo" : "merge");
        Level level = restingCubes();
        level.bodies[1].shapes.push_back(levelShape("top", solidGrid({10, 10, 10}, 2)));
        level.bodies[1].shapes.back().local.position = {0.0, 1.0, 0.0};
        addShape(level, "falling", {4, 4, 4}, {2.3, 8.0, 2.3}, 2, false);
        level.bodies.back().velocity = {0.0f, -0.1f, 0.0f};
        FrameLoop loop(headlessSettings());
        loop.load(level);
        WorldSettings settings;
        settings.undoMarks = 2;
        loop.edits().push(SettingsEdit{settings});
        const auto [pillar, top] = std::pair(shapeNamed(loop.world(), "pillar"), loop.world().shapes().handleAt(2));
        ASSERT_EQ(loop.world().shapes().at(top).name, "top");
        // The pillar gets room for the top, which it does not fill yet, and physics is rebuilt from that.
        loop.edits().push(ResizeShapeEdit{pillar, {{0, 0, 0}, {10, 20, 10}}});
        loop.step();
        if (byUndo) {
            loop.edits().push(MergeShapeEdit{top, pillar});
            loop.step();
            loop.edits().push(HistoryEdit{});
            loop.step();
            loop.edits().push(boxCarve(loop.world(), "pillar", {1, 0.8, 1}, {4, 3, 4}));
            loop.step();
        }
        loop.save();
        loop.step();
        loop.edits().push(byUndo ? Edit(HistoryEdit{HistoryAction::Undo}) : Edit(MergeShapeEdit{top, pillar}));
        for (int step = 0; step < 300; ++step) loop.step();
        EXPECT_NEAR(placeOf(loop.world(), "falling").y, 2.0, 0.05);
    }
}

}  // namespace
}  // namespace rubble
