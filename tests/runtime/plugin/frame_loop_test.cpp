#include "runtime/plugin/frame_loop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>

#include "runtime/core/log.h"
#include "tests/runtime/plugin/headless_loop.h"
#include "tests/runtime/world/worlds.h"
#include "tests/support/temp_folder.h"

namespace rubble {
namespace {

using namespace test;

Level tower() {
    Level level = oneShapeLevel(towerGrid({40, 60, 40}), true);
    level.materials.materials[1].tensileStrength = 1e9f;
    LevelBody ground{.name = "ground", .pose = {{-4.0, -0.8, -4.0}}};
    ground.shapes.push_back(levelShape("ground", solidGrid({120, 8, 120}, 4)));
    level.bodies.push_back(std::move(ground));
    return level;
}

Edits destructionScript(int step) {
    if (step == 2) return {sphereCarve({0.2, 0.5, 0.2}, 0.4), sphereCarve({1.8, 0.5, 0.2}, 0.4)};
    if (step == 10) return {ExplodeEdit{.position = {2.0, 2.0, 2.0}, .size = 2.0}};
    if (step == 30)
        return {sphereCarve({0.2, 0.5, 1.8}, 0.5), sphereCarve({3.4, 0.5, 3.4}, 0.5),
                PaintEdit{.position = {1.0, 1.0, 0.0}}};
    if (step == 45) return {ExplodeEdit{.position = {1.0, 3.0, 1.0}, .size = 2.0}};
    return {};
}

/// Edits that add, change and remove lights, and change the weather.
Edits lightScript(const World& world, int step) {
    Environment weather = world.environment();
    weather.wetness = 0.01f * float(step);
    weather.gravity.y = -9.0f;
    Light light{.local = {{0.1 * step, 2.0, 0.0}}};
    if (step == 8 || step == 35)
        return {AddLightEdit{light}, AddLightEdit{{.shape = firstShape(world), .local = light.local}}, AddLightEdit{}};
    if (step == 20 || step == 70)
        return {RemoveLightEdit{world.lights().handleAt(2)}, RemoveLightEdit{world.lights().handleAt(0)}};
    if (step == 40) return {SetLightEdit{world.lights().handleAt(1), light}, SetEnvironmentEdit{weather}};
    if (step == 46) return {AddLightEdit{light}, SetEnvironmentEdit{weather}};  // between a mark and its undo
    if (step == 80) return {AddLightEdit{light}};
    return {};
}

TEST(FrameLoop, ContinuingAfterASaveEqualsLoadingIt) {
    FrameLoop loop(headlessSettings());
    loop.load(tower());
    SavedGame saved;
    for (int step = 0; step < 100; ++step) {
        if (step == 25) saved = loop.save();
        loop.edits().push(destructionScript(step));
        loop.edits().push(lightScript(loop.world(), step));
        loop.step();
    }
    ASSERT_GT(loop.world().bodies().size(), 3u);
    ASSERT_EQ(loop.world().lights().size(), 4u);
    // Load it into a new world, and into the one that has played on.
    FrameLoop fresh(headlessSettings());
    for (FrameLoop* other : {&fresh, &loop}) {
        const uint64_t expected = other == &fresh ? loop.world().hash() : fresh.world().hash();
        Result<SavedGame> read = gameFromBytes(gameToBytes(saved), "save", other->world().id());
        ASSERT_TRUE(read) << read.error();
        other->load(std::move(*read));
        for (int step = 25; step < 100; ++step) {
            other->edits().push(destructionScript(step));
            other->edits().push(lightScript(other->world(), step));
            other->step();
        }
        EXPECT_EQ(other->world().hash(), expected);
    }
}

TEST(FrameLoop, ARecordingReplaysToTheSameHashes) {
    const TempFolder folder;
    const std::string path = folder / "recording.rubblelog";
    FrameLoop loop(headlessSettings());
    loop.load(tower());
    for (int step = 0; step < 5; ++step) loop.edits().push(destructionScript(step)), loop.step();
    ASSERT_TRUE(loop.startRecording(path));
    for (int step = 5; step < 100; ++step) {
        if (step == 20) loop.save();
        WorldSettings settings = loop.world().settings();
        settings.undoMarks = 4;
        if (step == 12) loop.edits().push(Edits{SettingsEdit{settings}});
        if (step == 29 || step == 44) loop.edits().push(Edits{HistoryEdit{}});
        if (step == 50) loop.edits().push(Edits{HistoryEdit{HistoryAction::Undo}});
        if (step == 55) loop.edits().push(Edits{HistoryEdit{HistoryAction::Redo}});
        loop.edits().push(destructionScript(step));
        loop.edits().push(lightScript(loop.world(), step));
        loop.step();
    }
    ASSERT_TRUE(loop.stopRecording());
    FrameLoop second(headlessSettings());
    Result<Recording> recording = readRecording(path, second.world().id());
    ASSERT_TRUE(recording) << recording.error();
    ASSERT_EQ(recording->steps.size(), 95u);
    World follower(second.world().id());
    follower.setState(recording->start.world);
    second.load(recording->start);
    std::vector<PaletteRef> palettes;
    for (const RecordedStep& step : recording->steps) {
        second.replay(step);
        ASSERT_EQ(second.world().hash(), step.hash) << "step " << step.step;
        const Result<FrameChanges> applied = applyStepDelta(step.delta, path, follower, palettes);
        ASSERT_TRUE(applied) << applied.error();
        ASSERT_EQ(voxelHash(follower), step.voxelHash) << "step " << step.step;
        follower.setPoses(step.poses);
        follower.setCharacters(step.characters);
        ASSERT_EQ(resolvedHash(follower), step.resolvedHash) << "step " << step.step;
    }
    EXPECT_EQ(second.world().hash(), loop.world().hash());
    EXPECT_FALSE(std::filesystem::exists(path + ".part"));

    std::ifstream in(path, std::ios::binary);
    std::vector<uint8_t> bytes((std::istreambuf_iterator<char>(in)), {});
    for (size_t length = 0; length < bytes.size(); length += 9973)
        EXPECT_FALSE(recordingFromBytes(std::span(bytes).first(length), "t", 1));
    for (size_t byte = 0; byte < bytes.size(); byte += 9973) {
        bytes[byte] ^= 16;
        const Result<Recording> damaged = recordingFromBytes(bytes, "t.rubblelog", 1);
        EXPECT_FALSE(damaged);
        EXPECT_EQ(damaged.error().rfind("t.rubblelog: byte ", 0), 0u) << damaged.error();
        bytes[byte] ^= 16;
    }
}

TEST(FrameLoop, UndoRestoresTheTowerWhileItFalls) {
    FrameLoop loop(headlessSettings());
    loop.load(tower());
    WorldSettings settings;
    settings.undoMarks = 2;
    loop.edits().push(Edits{SettingsEdit{settings}});
    loop.step();
    const uint64_t voxels = voxelHash(loop.world());
    loop.edits().push(
        Edits{HistoryEdit{}, sphereCarve({0.2, 0.5, 0.2}, 0.4), ExplodeEdit{.position = {2.0, 2.0, 2.0}, .size = 2.0}});
    for (int step = 0; step < 40; ++step) loop.step();
    EXPECT_NE(voxelHash(loop.world()), voxels);
    loop.edits().push(HistoryEdit{HistoryAction::Undo});
    loop.step();
    EXPECT_EQ(voxelHash(loop.world()), voxels);
    for (int step = 0; step < 20; ++step) loop.step();
    EXPECT_EQ(voxelHash(loop.world()), voxels);
    EXPECT_EQ(loop.physics()->stats().bodies, 0);
}

/// How pieces move, by their handles: velocities and poses.
std::map<uint64_t, std::array<glm::dvec3, 3>> motionOf(const World& world) {
    std::map<uint64_t, std::array<glm::dvec3, 3>> motion;
    world.bodies().forEach([&](BodyHandle handle, const Body& body) {
        if (!body.isStatic) motion[handle.bits] = {body.velocity, body.angularVelocity, body.pose.position};
    });
    return motion;
}

TEST(FrameLoop, UndoOfAnotherThingLetsPiecesFlyOnAsTheyDidAtTheMark) {
    FrameLoop loop(headlessSettings());
    loop.load(tower());
    WorldSettings settings;
    settings.undoMarks = 2;
    loop.edits().push(Edits{SettingsEdit{settings}, ExplodeEdit{.position = {2.0, 3.0, 2.0}, .size = 2.0}});
    for (int step = 0; step < 20; ++step) loop.step();
    const auto atMark = motionOf(loop.world());
    loop.edits().push(Edits{HistoryEdit{}});
    loop.step();
    const auto after = motionOf(loop.world());
    loop.edits().push(Edits{sphereCarve({3.6, 0.6, 3.6}, 0.5)});  // another thing
    for (int step = 0; step < 8; ++step) loop.step();
    loop.edits().push(HistoryEdit{HistoryAction::Undo});
    loop.step();
    const auto again = motionOf(loop.world());
    ASSERT_EQ(again.size(), atMark.size());
    const glm::dvec3 fall(0.0, -9.81 / 60.0, 0.0);
    int flying = 0, moving = 0, same = 0;
    for (const auto& [body, motion] : atMark) {
        if (glm::length(motion[0]) < 1.0) continue;
        ++moving;
        ASSERT_TRUE(again.contains(body) && after.contains(body));
        EXPECT_GT(glm::length(again.at(body)[0]), 0.1) << "it lies still: " << body;
        if (glm::length(after.at(body)[0] - motion[0] - fall) > 1e-6) continue;  // contacts are found again
        ++flying;
        double apart = 0.0;
        for (size_t i = 0; i < 3; ++i) apart = std::max(apart, glm::length(again.at(body)[i] - after.at(body)[i]));
        same += apart < 1e-9;
    }
    EXPECT_GT(flying, 10);
    EXPECT_GT(moving, flying);
    EXPECT_GE(same, flying * 9 / 10) << "of " << flying << ": some may meet others a step sooner";
}

/// Boxes that tumble on a floor and on each other, and come to rest.
Level tumblingBoxes(int turn) {
    Level level = oneShapeLevel(solidGrid({80, 3, 80}, 1), true);
    for (int i = 0; i < 4; ++i) {
        LevelBody box{.pose = {{4.0 + 0.2 * i, 0.6 + 0.7 * i, 4.0},
                               glm::angleAxis(0.7 * (i + 1) + turn, glm::normalize(glm::dvec3(1, i, 0.3 * turn)))}};
        box.isStatic = false;
        box.velocity = {0.2, 0.0, 0.1};  // so that it is awake
        box.shapes.push_back(levelShape("box", solidGrid({6, 5, 4 + i}, 4)));
        level.bodies.push_back(std::move(box));
    }
    return level;
}

TEST(FrameLoop, WhatFollowsAnUndoIsTheSameWheneverItComes) {
    for (int turn = 0; turn < 6; ++turn)
        for (int before = 20; before < 160; before += 10) {
            FrameLoop loop(headlessSettings());
            loop.load(tumblingBoxes(turn));
            WorldSettings settings;
            settings.undoMarks = 2;
            settings.impactThreshold = 1e9;  // nothing breaks
            loop.edits().push(Edits{SettingsEdit{settings}});
            for (int step = 0; step < before; ++step) loop.step();
            loop.edits().push(Edits{HistoryEdit{}});
            loop.step();
            Environment weather = loop.world().environment();
            std::map<uint64_t, std::array<glm::dvec3, 3>> first;
            for (int later = 0; later < 4; ++later) {
                weather.wetness = 0.1f * float(later + 1);
                if (later > 0) loop.edits().push(Edits{SetEnvironmentEdit{weather}});  // it returns to the same mark
                for (int step = 0; step < later * later; ++step) loop.step();
                loop.edits().push(HistoryEdit{HistoryAction::Undo});
                loop.step();
                if (later == 0) first = motionOf(loop.world());
                EXPECT_EQ(motionOf(loop.world()), first) << turn << " " << before << ", after " << later * later;
            }
        }
}

TEST(FrameLoop, ARecordingThatCannotBeWrittenIsAnError) {
    FrameLoop loop(headlessSettings());
    loop.load(tower());
    const Result<Done> started = loop.startRecording("/no/such/folder/x.rubblelog");
    ASSERT_FALSE(started);
    EXPECT_NE(started.error().find("/no/such/folder"), std::string::npos);
    EXPECT_TRUE(loop.stopRecording());
}

TEST(FrameLoop, ARecordingThatFailedDoesNotStopTheNext) {
    const TempFolder folder;
    FrameLoop loop(headlessSettings());
    loop.load(tower());
    std::filesystem::create_directory(folder.path() / "first");
    ASSERT_TRUE(loop.startRecording(folder / "first/game.rubblelog"));
    loop.step();
    std::filesystem::remove_all(folder.path() / "first");  // it cannot get its name
    int lines = 0;
    setLogSink([](void* count, LogLevel, std::string_view) { ++*static_cast<int*>(count); }, &lines);
    const Result<Done> second = loop.startRecording(folder / "second.rubblelog");
    setLogSink(nullptr, nullptr);
    ASSERT_TRUE(second) << second.error();
    EXPECT_EQ(lines, 1) << "the log says that the first is lost";
    loop.step();
    EXPECT_TRUE(loop.stopRecording());
    EXPECT_TRUE(readRecording(folder / "second.rubblelog", loop.world().id()));
}

/// A loop with the tower, sliced splits and undo.
FrameLoop& loadSliced(FrameLoop& loop) {
    loop.load(tower());
    WorldSettings settings;
    settings.split.partsPerStep = 1;
    settings.undoMarks = 9;
    loop.edits().push(SettingsEdit{settings});
    for (int step = 0; step < 3; ++step) loop.edits().push(destructionScript(step)), loop.step();
    for (int step = 0; step < 40; ++step) loop.step();
    return loop;
}

/// Cuts the tower through, and steps until its split waits.
void cutThrough(FrameLoop& loop) {
    loop.edits().push(CarveEdit{.kind = BrushKind::Box, .position = {2.0, 3.0, 2.0}, .halfSize = {3.0, 0.2, 3.0}});
    loop.step();
    ASSERT_FALSE(loop.world().data().pendingSplits.empty());
}

TEST(FrameLoop, ASplitThatWaitsSurvivesSavesAndRecordings) {
    const TempFolder folder;
    FrameLoop loop(headlessSettings()), loaded(headlessSettings()), replayed(headlessSettings());
    cutThrough(loadSliced(loop));
    const size_t before = loop.world().bodies().size();
    ASSERT_TRUE(saveTo(folder / "game.rubble", loop));
    ASSERT_TRUE(loop.startRecording(folder / "game.rubblelog"));
    EXPECT_FALSE(loop.world().data().pendingSplits.empty());
    Result<SavedGame> game = readSave(folder / "game.rubble", loaded.world().id());
    ASSERT_TRUE(game) << game.error();
    loaded.load(std::move(*game));
    EXPECT_EQ(loaded.world().hash(), loop.world().hash());
    for (int step = 0; step < 60; ++step) {
        loop.step();
        loaded.step();
        ASSERT_EQ(loaded.world().hash(), loop.world().hash()) << step;
    }
    EXPECT_GT(loop.world().bodies().size(), before) << "the upper part came off";
    ASSERT_TRUE(loop.stopRecording());
    expectReplay(replayed, folder / "game.rubblelog");
    if (HasFatalFailure()) return;
}

TEST(FrameLoop, WhatLeavesTheLevelIsSavedAndReplayedUnderEveryRule) {
    const TempFolder folder;
    for (const BoundsRule rule : {BoundsRule::Dust, BoundsRule::Keep, BoundsRule::Ground}) {
        FrameLoop loop(headlessSettings()), loaded(headlessSettings()), replayed(headlessSettings());
        Level level = oneShapeLevel(solidGrid({40, 8, 40}), true, {{0.0, -0.8, 0.0}});
        for (int i = 0; i < 6; ++i) {
            LevelBody cube{.name = "cube " + std::to_string(i),
                           .pose = {{3.0 + 0.7 * i, 0.5, 2.0}},
                           .isStatic = false,
                           .velocity = {3.0 + 2.5 * i, 2.0, 0.3 * i}};
            cube.shapes.push_back(levelShape(cube.name, solidGrid({5, 4, 6})));
            level.bodies.push_back(std::move(cube));
        }
        loop.load(level);
        loop.edits().push(SetBoundsEdit{{rule, {-4.0, -6.0, -4.0}, {12.0, 10.0, 8.0}}});
        const auto nudge = [&](BodyHandle body, const Body& of) {
            if (!of.isStatic) loop.edits().push(ImpulseEdit{body, of.pose.position, {1.0, 1.0, 0.0}});
        };
        loop.world().bodies().forEach(nudge);
        for (int step = 0; step < 20; ++step) loop.step();
        ASSERT_TRUE(saveTo(folder / "game.rubble", loop));
        ASSERT_TRUE(loop.startRecording(folder / "game.rubblelog"));
        Result<SavedGame> game = readSave(folder / "game.rubble", loaded.world().id());
        ASSERT_TRUE(game) << game.error();
        loaded.load(std::move(*game));
        for (int step = 0; step < 200; ++step) {
            loop.step();
            loaded.step();
            ASSERT_EQ(loaded.world().hash(), loop.world().hash()) << step;
        }
        ASSERT_TRUE(loop.stopRecording());
        expectReplay(replayed, folder / "game.rubblelog");
        if (HasFatalFailure()) return;
        const size_t left = loop.world().bodies().size();
        EXPECT_EQ(left < 7, rule != BoundsRule::Keep) << "some are dust";
        EXPECT_TRUE(rule != BoundsRule::Ground || left > 1) << "and some rest on the ground";
        const VoxelAccounting voxels = voxelAccounting(loop.world().data());
        EXPECT_EQ(voxels.imported, voxels.standing + voxels.inPieces + voxels.removed) << "none is lost";
    }
}

/// Replays a recording; the number of steps with the recorded hash.
size_t replaySteps(const std::string& path, size_t& recorded) {
    FrameLoop loop(headlessSettings());
    Result<Recording> recording = readRecording(path, loop.world().id());
    EXPECT_TRUE(recording) << recording.error();
    recorded = recording->steps.size();
    loop.load(recording->start);
    size_t equal = 0;
    for (const RecordedStep& step : recording->steps) {
        loop.replay(step);
        equal += loop.world().hash() == step.hash;
    }
    return equal;
}

TEST(FrameLoop, ARecordingGoesOnWhereAnotherCannotBegin) {
    const TempFolder folder;
    const std::string path = folder / "game.rubblelog";
    FrameLoop loop(headlessSettings());
    loop.load(tower());
    ASSERT_TRUE(loop.startRecording(path));
    loop.step();
    EXPECT_FALSE(loop.startRecording("/no/such/folder/x.rubblelog"));
    loop.step();
    const Result<Done> same = loop.startRecording(path);
    ASSERT_FALSE(same);
    EXPECT_NE(same.error().find("that a recording is being written to"), std::string::npos) << same.error();
    loop.step();
    ASSERT_TRUE(loop.stopRecording());
    size_t steps = 0;
    EXPECT_EQ(replaySteps(path, steps), 3u);
    EXPECT_EQ(steps, 3u);
    ASSERT_TRUE(loop.startRecording(path)) << "the file is free again";
}

TEST(FrameLoop, ARecordingIsCompletedWithItsWorld) {
    const TempFolder folder;
    const std::string path = folder / "game.rubblelog";
    {
        FrameLoop loop(headlessSettings());
        loop.load(tower());
        ASSERT_TRUE(loop.startRecording(path));
        for (int i = 0; i < 3; ++i) loop.step();
    }
    size_t steps = 0;
    EXPECT_EQ(replaySteps(path, steps), 3u);
    EXPECT_FALSE(std::filesystem::exists(path + ".part"));
}

TEST(FrameLoop, UndoDoesNotReachBackBeyondTheBeginningOfARecording) {
    const TempFolder folder;
    const std::string path = folder / "game.rubblelog";
    const Edit mark = HistoryEdit{}, undo = HistoryEdit{HistoryAction::Undo}, redo = HistoryEdit{HistoryAction::Redo};
    const Edit blast = ExplodeEdit{.position = {2.0, 2.0, 2.0}, .size = 1.5};
    const std::vector<std::pair<Edits, Edits>> cases = {{{mark, blast}, {undo}},
                                                        {{mark}, {blast, undo}},
                                                        {{mark, blast, undo}, {redo}},
                                                        {{mark, blast}, {mark, blast, undo, undo, redo, redo}},
                                                        {{}, {mark, blast, undo, redo, undo}}};
    for (const auto& [before, after] : cases) {
        FrameLoop loop(headlessSettings());
        loadSliced(loop);
        for (const Edit& edit : before) loop.edits().push(edit), loop.step();
        ASSERT_TRUE(loop.startRecording(path));
        for (const Edit& edit : after) loop.edits().push(edit), loop.step(), loop.step();
        ASSERT_TRUE(loop.stopRecording());
        size_t recorded = 0;
        EXPECT_EQ(replaySteps(path, recorded), 2 * after.size());
        EXPECT_EQ(recorded, 2 * after.size());
    }
}

TEST(FrameLoop, EditsThatWaitWhileTheGameIsSavedAreRecordedOnce) {
    const TempFolder folder;
    const std::string path = folder / "game.rubblelog";
    FrameLoop loop(headlessSettings());
    loop.load(tower());
    loop.step();
    loop.edits().push(ExplodeEdit{.position = {2.0, 2.0, 2.0}, .size = 1.5});
    ASSERT_TRUE(loop.startRecording(path));
    loop.step();
    loop.edits().push(sphereCarve({0.2, 0.5, 0.2}, 0.4));
    const SavedGame saved = loop.save();
    EXPECT_EQ(loop.save().pending.size(), saved.pending.size()) << "nothing is added twice";
    loop.edits().push(sphereCarve({1.8, 0.5, 0.2}, 0.4));
    loop.step();
    FrameLoop loaded(headlessSettings());
    loaded.load(saved);
    loaded.edits().push(sphereCarve({1.8, 0.5, 0.2}, 0.4));
    loaded.step();
    EXPECT_EQ(loaded.world().hash(), loop.world().hash());
    ASSERT_TRUE(loop.stopRecording());
    size_t recorded = 0;
    EXPECT_EQ(replaySteps(path, recorded), 2u);
}

TEST(FrameLoop, AFileThatCannotBeWrittenChangesNothing) {
    FrameLoop loop(headlessSettings()), other(headlessSettings());
    for (FrameLoop* each : {&loop, &other}) {
        loadSliced(*each).edits().push(Edits{HistoryEdit{}});
        cutThrough(*each);
        each->edits().push(ExplodeEdit{.position = {2.0, 5.0, 2.0}, .size = 1.0});
        for (int step = 0; step < 30; ++step) {
            if (each == &other) {
                EXPECT_FALSE(saveTo("/no/such/folder/x.rubble", *each));
                EXPECT_FALSE(each->startRecording("/no/such/folder/x.rubblelog"));
            }
            each->step();
        }
        each->edits().push(Edits{HistoryEdit{HistoryAction::Undo}});
        each->step();
    }
    EXPECT_EQ(loop.world().hash(), other.world().hash());
    EXPECT_EQ(loop.physics()->stats().contacts, other.physics()->stats().contacts);
}

}  // namespace
}  // namespace rubble
