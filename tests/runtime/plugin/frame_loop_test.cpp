#include "runtime/plugin/frame_loop.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/runtime/world/worlds.h"
#include "tests/support/temp_folder.h"

namespace rubble {
namespace {

using namespace test;

FrameLoopSettings headlessSettings() {
    FrameLoopSettings settings;
    settings.shadowVolume = settings.publish = false;
    return settings;
}

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
    EXPECT_EQ(loop.physics().stats().bodies, 0);
}

TEST(FrameLoop, ARecordingThatCannotBeWrittenIsAnError) {
    FrameLoop loop(headlessSettings());
    loop.load(tower());
    const Result<Done> started = loop.startRecording("/no/such/folder/x.rubblelog");
    ASSERT_FALSE(started);
    EXPECT_NE(started.error().find("/no/such/folder"), std::string::npos);
    EXPECT_TRUE(loop.stopRecording());
}

}  // namespace
}  // namespace rubble
