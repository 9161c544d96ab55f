#include <gtest/gtest.h>

#include "runtime/world/history/undo_history.h"
#include "tests/runtime/world/worlds.h"
#include "tests/support/grids.h"

namespace rubble {
namespace {

using namespace test;

TEST(UndoHeat, HeatIsAsItWasAtTheMarkIfNothingElseChangedBefore) {
    World world;
    world.load(oneShapeLevel(solidGrid({16, 16, 16}, 1), true));
    world.applyEdits({});
    UndoHistory history(world);
    const auto step = [&](const Edits& edits) { history.recordStep(world, world.applyEdits(edits), false); };
    step({HeatEdit{.position = {0.8, 0.8, 0.0}, .radius = 0.5, .joules = 1e5}});
    step({ExtinguishEdit{{0.8, 0.8, 0.0}, 0.5, 10.0}});
    ASSERT_TRUE(world.data().fire.isActive());
    const uint64_t atMark = world.data().fire.hash();
    history.mark(4);
    step({sphereCarve({0.8, 0.8, 0.0}, 0.3)});
    WorldData data = world;
    FrameChanges changes;
    ASSERT_TRUE(history.undo(data, changes));
    EXPECT_EQ(data.fire.hash(), atMark);
}

TEST(UndoHeat, AnIntervalInWhichOnlyHeatChangedIsUndoneByItself) {
    World world;
    world.load(oneShapeLevel(solidGrid({16, 16, 16}, 1), true));
    WorldSettings settings;
    settings.undoMarks = 9;
    world.setSettings(settings);
    world.applyEdits({});
    std::vector<uint32_t> hot;  // bricks at each mark; how hot they are goes on in the step of the undo
    for (int i = 0; i < 3; ++i) {
        hot.push_back(world.data().fire.hotBricks);
        const glm::dvec3 place(0.4 + 0.8 * (i & 1), 0.4 + 0.8 * (i >> 1), 0.0);  // in a brick of its own
        const HeatEdit warm{.position = place, .radius = 0.2, .joules = 3e4};    // too little to burn
        EXPECT_TRUE(world.applyEdits({HistoryEdit{HistoryAction::Mark}, warm}).empty());
        ASSERT_GT(world.data().fire.hotBricks, hot.back());
    }
    for (; !hot.empty(); hot.pop_back()) {
        world.applyEdits({HistoryEdit{HistoryAction::Undo}});
        EXPECT_EQ(world.data().fire.hotBricks, hot.back()) << "mark " << hot.size();
    }
}

}  // namespace
}  // namespace rubble
