// A level that is edited: no time passes but in play, and play leaves nothing behind.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "editor/core/rotation.h"
#include "tests/editor/editor_level.h"
#include "tests/editor/random_commands.h"

namespace editor {
namespace {

rubble_body bodyOf(Editor& editor, const char* name) {
    return editor.world().find_by_name(RUBBLE_KIND_BODY, name).at(0);
}

TEST(Document, NothingFallsBurnsOrComesOffWhileItIsEdited) {
    Editor editor;
    runAll(editor, {"create 8,8,8 0,5,0 name=crate", "create 4,20,4 3,0,0 static=yes name=post",
                    "box 0,5,0 3,5,3 erase shape=post", "move 1,0,0 crate"});
    const rubble_body_state crate = editor.world().get_body_state(bodyOf(editor, "crate"));
    EXPECT_EQ(crate.position[1], 5.0);
    EXPECT_EQ(editor.world().get_body_states().size(), 2u) << "the upper half of the post came off";
}

TEST(Document, VoxelsThatAreErasedPutNoLightGroupOut) {
    Editor editor;
    runAll(editor, {"create 8,8,8 name=bulb", "light_group street", "entry 5 glow=4 group=street shape=bulb",
                    "box 0,0,0 7,6,7 erase shape=bulb"});
    const rubble_light_group street = editor.world().find_by_name(RUBBLE_KIND_LIGHT_GROUP, "street").at(0);
    const rubble_light_group_state state = editor.world().get_light_group(street);
    EXPECT_EQ(state.voxels, 64u);
    EXPECT_EQ(state.removed_voxels, 0u);
    EXPECT_EQ(state.flags, uint32_t(RUBBLE_GROUP_ON));
    runAll(editor, {"play", "carve 0,0.75,0 0.5", "step 60"});
    EXPECT_TRUE(editor.world().get_light_group(street).flags & RUBBLE_GROUP_OUT) << "a hit puts it out";
}

TEST(Document, NoEditPassesWhileStepsAreRecorded) {
    const ExampleFolder folder;
    Editor editor;
    runAll(editor, {"create 8,8,8 name=crate"});
    editor.world().start_recording("game.rubblelog");
    const Outcome outcome = editor.run(std::string("move 1,0,0 crate"));
    EXPECT_FALSE(outcome.isDone);
    EXPECT_NE(outcome.text.find("a recording runs"), std::string::npos) << outcome.text;
    editor.world().stop_recording();
}

TEST(Document, AWorldThatFollowsKnowsEditsWithoutTime) {
    Editor editor;
    makeTestLevel(editor);
    rubble_world_settings settings{};
    settings.flags = RUBBLE_WORLD_NO_RENDERER;
    rubble::World follower(settings);
    const std::vector<uint8_t> game = editor.world().save_game_data();
    follower.load_game_data(game.data(), game.size());
    editor.world().keep_deltas(RUBBLE_DELTAS_ALL);
    runAll(editor, {"move 0,3,0 crate", "sphere 20,12,1 5 erase shape=wall", "play", "step 30", "stop", "undo"});
    const std::vector<uint8_t> deltas = editor.world().take_deltas();
    follower.apply_deltas(deltas.data(), deltas.size());
    EXPECT_EQ(follower.get_level_hash(), editor.document().hash());
}

TEST(Document, PlayMovesThingsAndStopBringsAllBack) {
    Editor editor;
    makeTestLevel(editor);
    runAll(editor, {"move 0,3,0 crate"});
    const uint64_t before = editor.document().hash();
    const size_t bodies = editor.world().get_body_states().size();
    runAll(editor, {"play", "explode 0,1,2 2", "step 90"});
    const uint64_t ruin = editor.document().hash();
    EXPECT_GT(editor.world().get_body_states().size(), bodies) << "nothing broke";
    runAll(editor, {"stop"});
    EXPECT_EQ(editor.document().hash(), before);
    runAll(editor, {"redo"});
    EXPECT_EQ(editor.document().hash(), ruin) << "redo brings the ruin of a play that was stopped";
    runAll(editor, {"undo"});
    EXPECT_EQ(editor.document().hash(), before);
    runAll(editor, {"undo", "redo"});
    EXPECT_EQ(editor.document().hash(), before) << "the steps before play are still there";
}

TEST(Document, PlaysTwiceTheSame) {
    Editor editor;
    makeTestLevel(editor);
    runAll(editor, {"place 0,3,1.5 10,20,30 crate"});
    uint64_t ruins[2] = {};  // of voxels: pieces also know the number of the step in which they came off
    glm::dvec3 places[2] = {};
    for (int i = 0; i < 2; ++i) {
        runAll(editor, {"play", "carve 0,1,2 0.7", "step 90"});
        ruins[i] = editor.world().get_voxel_hash();
        for (const rubble_body_state& body : editor.world().get_body_states()) places[i] += vectorOf(body.position);
        runAll(editor, {"stop"});
    }
    EXPECT_EQ(ruins[0], ruins[1]);
    EXPECT_EQ(places[0], places[1]);
}

TEST(Document, PlayGoesBackAndOnFromThere) {
    Editor editor;
    makeTestLevel(editor);
    runAll(editor, {"place 0,3,1.5 10,20,30 crate"});
    const uint64_t before = editor.document().hash();
    runAll(editor, {"play", "step 60"});
    const uint64_t second = editor.document().hash();
    runAll(editor, {"explode 0,1,2 2", "step 75", "rewind 70"});
    EXPECT_EQ(editor.document().playedSteps(), 60u) << "at the half second before";
    EXPECT_EQ(editor.document().hash(), second);
    runAll(editor, {"step 10", "rewind 5"});
    EXPECT_EQ(editor.document().hash(), second) << "again, after nothing but motion";
    runAll(editor, {"rewind 1000000"});
    EXPECT_EQ(editor.document().playedSteps(), 0u);
    runAll(editor, {"step 40", "stop"});
    EXPECT_EQ(editor.document().hash(), before);
    runAll(editor, {"play", "carve 0,1,2 0.7", "step 100", "rewind 20", "step 20"});
    const uint64_t ruin = editor.document().hash();
    runAll(editor, {"stop"});
    EXPECT_EQ(editor.document().hash(), before);
    runAll(editor, {"redo"});
    EXPECT_EQ(editor.document().hash(), ruin) << "a step of the history, of several marks";
    runAll(editor, {"undo", "undo", "redo", "redo"});
    EXPECT_EQ(editor.document().hash(), ruin);
    runAll(editor, {"undo"});
    EXPECT_EQ(editor.document().hash(), before);
    EXPECT_FALSE(editor.run(std::string("rewind")).isDone) << "without play";
}

TEST(Document, CanKeepTheRuin) {
    Editor editor;
    makeTestLevel(editor);
    const uint64_t before = editor.document().hash();
    runAll(editor, {"play", "explode 0,1,2 2", "step 60", "keep"});
    const uint64_t ruin = editor.document().hash();
    EXPECT_EQ(editor.document().done().back(), "play 60 steps");
    runAll(editor, {"create 3,3,3 0,9,0", "undo", "undo"});
    EXPECT_EQ(editor.document().hash(), before);
    runAll(editor, {"redo"});
    EXPECT_EQ(editor.document().hash(), ruin);
}

TEST(Document, RefusesEditsDuringPlay) {
    Editor editor;
    runAll(editor, {"create 8,8,8 name=crate", "play", "step"});
    const Outcome outcome = editor.run(std::string("move 1,0,0 crate"));
    EXPECT_FALSE(outcome.isDone);
    EXPECT_NE(outcome.text.find("stop or keep it first"), std::string::npos) << outcome.text;
    EXPECT_FALSE(editor.run(std::string("undo")).isDone);
    EXPECT_FALSE(editor.run(std::string("save x.rubble")).isDone);
    runAll(editor, {"stop", "move 1,0,0 crate"});
}

TEST(Document, AnEditThatChangesNothingIsNoStep) {
    Editor editor;
    runAll(editor, {"create 8,8,8 name=crate", "move 1,0,0 crate"});
    const uint64_t before = editor.document().hash();
    runAll(editor, {"box 20,20,20 30,30,30 erase shape=crate", "move 0,0,0 crate", "voxel 0,0,0 paint 5 shape=crate"});
    EXPECT_EQ(editor.document().done().size(), 2u);
    EXPECT_EQ(editor.document().hash(), before);
    runAll(editor, {"undo"});
    EXPECT_EQ(editor.world().get_body_state(bodyOf(editor, "crate")).position[0], 0.0);
}

TEST(Document, WhatIsSavedIsThereAgain) {
    const ExampleFolder folder;
    Editor editor;
    makeTestLevel(editor);
    runAll(editor, {"name knob door", "tag furniture oak knob", "save saved.rubble"});
    EXPECT_FALSE(editor.document().isChanged());
    Editor again;
    runAll(again, {"open saved.rubble"});
    EXPECT_EQ(again.world().get_voxel_hash(), editor.world().get_voxel_hash());
    EXPECT_EQ(again.world().find_by_tag(RUBBLE_KIND_BODY, "furniture", "oak").size(), 1u);
    EXPECT_EQ(again.world().find_by_name(RUBBLE_KIND_BODY, "knob").size(), 1u);
    EXPECT_EQ(again.world().get_joint_states().size(), 2u) << "its shape has no name of its own";
    EXPECT_EQ(again.world().find_by_name(RUBBLE_KIND_SHAPE, "shape").size(), 0u) << "and has got none";
    EXPECT_EQ(again.world().find_by_name(RUBBLE_KIND_JOINT, "door_hinge").size(), 1u);
    runAll(again, {"move 0,1,0 knob"});
    EXPECT_TRUE(again.document().isChanged());
}

TEST(Document, RunsScriptsInLua) {
    Editor editor;
    const Outcome made = editor.runLua("room.lua", R"(
        for i = 1, 3 do
            Command("create", {size = {4, 4, 4}, at = {i, 0, 0}, name = "block " .. i})
        end
        Command("sphere", {center = {2, 2, 2}, radius = 1, ["do"] = "erase", shape = "block 2"})
        print(#FindBodies("block 3"))
    )");
    EXPECT_TRUE(made.isDone) << made.text;
    EXPECT_EQ(editor.document().done().size(), 4u);
    const Outcome wrong = editor.runLua("bad.lua", "\nCommand('create', {size = {4, 4}})");
    EXPECT_FALSE(wrong.isDone);
    EXPECT_EQ(wrong.text, "bad.lua:2: Command: create: size: expected a text, a number, true or false, or {x, y, z}");
    EXPECT_EQ(editor.document().done().size(), 4u);
}

/// With settings, which levels do not hold.
uint64_t stateOf(Editor& editor) {
    return editor.world().get_resolved_hash();
}

/// What a level comes to that has gone through random commands, undo, redo and play, and one that has done without what
/// was undone.
TEST(Document, RandomCommandsWithUndoAndRedoEqualAStraightReplay) {
    const int commands = std::getenv("RUBBLE_LONG") ? 10'000 : 300;
    RandomCommands random(24);
    Editor editor;
    const std::vector<std::string> first = RandomCommands::first();
    for (const std::string& line : first) runAll(editor, {line.c_str()});
    int done = 0;
    std::vector<uint64_t> hashes;  // after each step that is done
    for (int i = 0; i < commands; ++i) {
        hashes.resize(editor.document().done().size(), stateOf(editor));
        const int what = random.below(16);
        if (what < 3) {
            if (editor.document().done().size() > first.size()) runAll(editor, {"undo"});
        } else if (what < 5) {
            editor.run(std::string("redo"));
        } else if (what == 5 && i % 10 == 0) {
            runAll(editor, {"play", "explode 0,0.5,0 1", "step 3", "stop"});
            runAll(editor, {fmt::format("exposure {}", i / 10 % 900 + 2).c_str()});  // or redo would bring the ruin
        } else {
            const bool isFull = editor.world().get_body_states().size() > 40;
            const std::string line = isFull ? "delete block" : random.next();
            const uint64_t before = stateOf(editor);
            const size_t steps = editor.document().done().size();
            done += editor.run(line).isDone;
            ASSERT_EQ(editor.document().done().size() != steps, stateOf(editor) != before) << line;
        }
    }
    EXPECT_GT(done, commands / 4);
    hashes.resize(editor.document().done().size(), stateOf(editor));
    Editor straight;
    for (size_t i = 0; i < hashes.size(); ++i) {
        const std::string& line = editor.document().done()[i];
        const Outcome outcome = straight.run(line);
        ASSERT_TRUE(outcome.isDone) << line << "\n" << outcome.text;
        if (i < first.size()) continue;
        ASSERT_EQ(stateOf(straight), hashes[i]) << "step " << i << ": " << line;
    }
    EXPECT_EQ(stateOf(straight), stateOf(editor));
}

/// A file keeps the hash, and so does another one of what was opened.
void expectSameHashAfterOpening(Editor& editor) {
    const rubble::TempFolder folder;
    const uint64_t written = editor.document().hash();
    for (const char* name : {"first.rubble", "second.vdb", "third.rubble"}) {
        const std::string path = folder / name;
        runAll(editor, {fmt::format("save {}", path).c_str(), fmt::format("open {}", path).c_str()});
        ASSERT_EQ(editor.document().hash(), written) << name;
    }
}

TEST(Document, WhatIsSavedAndOpenedHasTheSameHash) {
    for (const std::initializer_list<const char*> lines : {
             std::initializer_list<const char*>{},
             {"create 4,4,4"},
             {"create 4,4,4 0,9,0 static=yes"},
             {"create 4,4,4 name=a", "create 4,4,4 1,0,0 name=b", "joint ball a world 0,0,0", "name a b"},
             {"create 4,4,4 name=a", "box 0,0,0 1,1,1 erase shape=a", "rotate 0,33,10"},
             {"create 4,4,4 name=bulb", "light_group g", "entry 5 glow=3 group=g shape=bulb",
              "create 4,4,4 3,0,0 name=plug", "set_light_group g supply=plug cell=1,2,3", "play", "step 5", "stop"},
         }) {
        Editor editor({.vdbTool = RUBBLE_VDB_PROGRAM});
        runAll(editor, lines);
        expectSameHashAfterOpening(editor);
    }
    Editor all({.vdbTool = RUBBLE_VDB_PROGRAM});
    makeTestLevel(all);
    expectSameHashAfterOpening(all);
}

TEST(Document, RandomLevelsHaveTheSameHashAfterOpening) {
    const uint32_t levels = std::getenv("RUBBLE_LONG") ? 1000 : 12;
    for (uint32_t seed = 0; seed < levels; ++seed) {
        SCOPED_TRACE(seed);
        RandomCommands random(seed);
        Editor editor({.vdbTool = RUBBLE_VDB_PROGRAM});
        for (const std::string& line : RandomCommands::first()) runAll(editor, {line.c_str()});
        for (int i = 0; i < 40; ++i) editor.run(random.below(8) ? random.next() : "undo");
        expectSameHashAfterOpening(editor);
        if (HasFatalFailure()) return;
    }
}

TEST(Document, TheProgramEditsAFileAndListsItsCommands) {
    const ExampleFolder folder;
    const std::string program = RUBBLE_EDITOR_PROGRAM;
    ASSERT_EQ(std::system((program + " model.rubble 'box 0,0,0 1,1,1 erase shape=cube' -o out.rubble > said").c_str()),
              0);
    Editor editor;
    runAll(editor, {"open out.rubble"});
    EXPECT_EQ(editor.world().get_voxel_accounting().standing, 64u - 8u);
    EXPECT_NE(std::system((program + " model.rubble 'bax 0,0,0' 2> said").c_str()), 0);
    ASSERT_EQ(std::system((program + " --list > said").c_str()), 0);
    std::ifstream file("said");
    const std::string said((std::istreambuf_iterator<char>(file)), {});
    for (const Command& command : allCommands())
        EXPECT_NE(said.find("  " + std::string(command.name) + " "), std::string::npos) << command.name;
}

TEST(Document, TheProgramSaysWhatItsOptionsTake) {
    const ExampleFolder folder;
    const std::pair<const char*, const char*> cases[] = {
        {"--journal model.rubble list", "--journal: expected a folder that can be made, found model.rubble"},
        {"--screenshots out --size 99999x99999", "--size: expected WIDTHxHEIGHT from 640x400 to 8192x8192"},
        {"--screenshots out --size 800x600x", "found 800x600x"},
        {"--screenshots model.rubble", "--screenshots: expected a folder"},
    };
    for (const auto& [options, message] : cases) {
        const std::string line = std::string(RUBBLE_EDITOR_PROGRAM) + " " + options + " > said 2>&1";
        EXPECT_NE(std::system(line.c_str()), 0) << options;
        std::ifstream file("said");
        const std::string said((std::istreambuf_iterator<char>(file)), {});
        EXPECT_NE(said.find(message), said.npos) << options << ": " << said;
    }
}

/// A roof on a wall that bears it, unless stress is on.
TEST(Document, SettingsThatNoLevelHoldsEndWithTheLevel) {
    const ExampleFolder folder;
    Editor editor;
    runAll(editor, {"create 3,30,3 index=7 static=yes name=wall", "box 3,27,0 60,29,2 index=7 shape=wall"});
    const auto bodiesAfterPlay = [&] {
        runAll(editor, {"play", "step 60"});
        const size_t bodies = editor.world().get_objects(RUBBLE_KIND_BODY).size();
        runAll(editor, {"stop"});
        return bodies;
    };
    EXPECT_EQ(bodiesAfterPlay(), 1u);
    const Outcome outcome = editor.run(std::string("stress yes 0.05"));
    EXPECT_EQ(outcome.text, "no level holds this: it lasts until another level is opened");
    EXPECT_GT(bodiesAfterPlay(), 1u);
    runAll(editor, {"save level.rubble"});
    EXPECT_GT(bodiesAfterPlay(), 1u) << "it is the same level still";
    runAll(editor, {"open level.rubble"});
    EXPECT_EQ(bodiesAfterPlay(), 1u) << "as in an editor that has just begun";
}

TEST(Document, ForceOnTheCommandLineHoldsForSave) {
    const ExampleFolder folder;
    {
        Editor crashed({.journals = "living"});
        runAll(crashed, {"open model.rubble", "create 3,3,3 2,0,0"});
        std::filesystem::copy("living", "left", std::filesystem::copy_options::recursive);
    }
    Editor other;
    runAll(other, {"create 5,5,5", "save model.rubble"});
    const std::string line = std::string(RUBBLE_EDITOR_PROGRAM) + " model.rubble --journal left --recover save";
    EXPECT_NE(std::system((line + " > said 2>&1").c_str()), 0) << "another program has written it";
    EXPECT_EQ(std::system((line + " --force > said 2>&1").c_str()), 0);
    runAll(other, {"open model.rubble"});
    EXPECT_EQ(other.world().get_voxel_accounting().standing, 64u + 27u);
}

}  // namespace
}  // namespace editor
