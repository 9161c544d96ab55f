// Scripts in Lua that use functions of scripts beside commands.
#include <gtest/gtest.h>

#include <string>

#include "tests/editor/editor_level.h"

namespace editor {
namespace {

constexpr const char* kHole = "MakeHole({0.4, 0.4, 0.4}, 0.3, 0.3, 0.3) ";

uint64_t voxels(Editor& editor) {
    return editor.world().get_voxel_accounting().standing;
}

/// Runs a script that must work.
void runLua(Editor& editor, const std::string& text) {
    const Outcome outcome = editor.runLua("test.lua", text);
    ASSERT_TRUE(outcome.isDone) << outcome.text;
}

TEST(EditorLua, EditsOfPlayEndWithIt) {
    Editor editor;
    runAll(editor, {"create 8,8,8 name=crate"});
    const uint64_t before = editor.document().hash();
    runLua(editor, "Command('play') " + std::string(kHole) + "Command('stop')");
    EXPECT_EQ(editor.document().hash(), before);
    runLua(editor, "Command('play', {wake = false}) " + std::string(kHole));
    runAll(editor, {"stop"});
    EXPECT_EQ(editor.document().hash(), before);
    runAll(editor, {"redo"});
    EXPECT_LT(voxels(editor), 512u) << "the ruin of that play has the hole";
}

TEST(EditorLua, CommandsComeAfterWhatWasQueuedBefore) {
    const ExampleFolder folder;
    Editor editor;
    runAll(editor, {"create 8,8,8 name=crate"});
    runLua(editor, kHole + std::string("Command('save', {file = 'holed.rubble'})"));
    Editor again;
    runAll(again, {"open holed.rubble"});
    EXPECT_LT(voxels(again), 512u);
    EXPECT_EQ(voxels(again), voxels(editor));
    EXPECT_FALSE(editor.document().isChanged());
}

TEST(EditorLua, StepsOfTheCommandAreTime) {
    Editor editor;
    runAll(editor, {"create 8,8,8 name=crate"});
    runLua(editor,
           "Command('play') wait(0.5) local before = GetTime() Command('step', {count = 60}) "
           "assert(math.abs(GetTime() - before - 1) < 1e-9) wait(0.5) "
           "assert(math.abs(GetTime() - before - 1.5) < 1e-9) "
           "before = GetTime() Command('stop') assert(GetTime() == before)");
}

TEST(EditorLua, HistoryHasWhatWasQueued) {
    Editor editor;
    runAll(editor, {"create 8,8,8 name=crate"});
    const uint64_t before = editor.document().hash();
    runLua(editor, kHole + std::string("Command('create', {size = {2, 2, 2}, at = {3, 0, 0}}) ") + kHole +
                       "DrawShapeBox(FindShape(), 0, 0, 0, 0, 0, 0)");
    EXPECT_EQ(editor.document().done().size(), 4u);
    runAll(editor, {"undo 3"});
    EXPECT_EQ(editor.document().hash(), before);
    runLua(editor,
           "Command('redo') local n = GetShapeVoxelCount(FindShape()) Command('undo') "
           "assert(GetShapeVoxelCount(FindShape()) == 512) Command('redo') "
           "assert(GetShapeVoxelCount(FindShape()) == n and n < 512) Command('undo') " +
               std::string(kHole) + "Command('undo')");
    EXPECT_EQ(editor.document().hash(), before) << "an edit after an undo is a step of its own";
    EXPECT_EQ(editor.document().undone().size(), 1u);
    runAll(editor, {"undo"});
    EXPECT_EQ(voxels(editor), 0u);
}

TEST(EditorLua, WaitsPlay) {
    Editor editor;
    runAll(editor, {"create 8,8,8 0,5,0 name=crate"});
    runLua(editor,
           "Command('play') local crate = FindBody('crate') wait(0.5) "
           "assert(GetBodyTransform(crate).pos.y < 4.5, 'it has not fallen') assert(GetTime() > 0.4) "
           "Command('stop') assert(GetBodyTransform(crate).pos.y == 5) print('done')");
    EXPECT_EQ(editor.runLua("edit.lua", "\nwait(1) print('never')").text,
              "edit.lua:2: wait: expected a world in which time passes, found one that stands still: play first");
    const Outcome ended = editor.runLua("ended.lua",
                                        "Command('play') start(function() wait(9) end) wait(0.1) "
                                        "Command('stop')");
    EXPECT_FALSE(ended.isDone);
    EXPECT_EQ(ended.text, "ended.lua: the script waits for a time that does not come: its play has ended");
}

TEST(EditorLua, ShapesAreSplitWithoutTime) {
    Editor editor;
    runAll(editor, {"create 12,4,4 name=parts", "box 4,0,0 7,3,3 erase shape=parts"});
    runLua(editor,
           "local pieces = SplitShape(FindShape()) assert(#pieces == 1, #pieces) "
           "assert(GetShapeVoxelCount(pieces[1]) == 64) assert(GetBodyTransform(FindBody()).pos.y == 0)");
    EXPECT_EQ(editor.document().done().size(), 3u);
}

TEST(EditorLua, EndlessLoopsEnd) {
    Editor editor;
    const Outcome outcome = editor.runLua("loop.lua", "while true do end");
    EXPECT_FALSE(outcome.isDone);
    EXPECT_NE(outcome.text.find("loop.lua:1: the script wanted more than its 100000000 instructions"),
              std::string::npos)
        << outcome.text;
}

TEST(EditorLua, FindsWhatCommandsHaveNamed) {
    Editor editor;
    runAll(editor, {"trigger gate 0,1,0", "light sphere 0,3,-2 name=spot"});
    runLua(editor, "assert(FindTrigger('gate') ~= 0 and FindLight('spot') ~= 0)");
}

TEST(EditorLua, TagsNameObjectsOfAllKinds) {
    Editor editor;
    runAll(editor, {"trigger gate 0,1,0", "tag exit x gate", "name door tag:exit"});
    EXPECT_EQ(editor.world().find_by_name(RUBBLE_KIND_TRIGGER, "door").size(), 1u);
}

}  // namespace
}  // namespace editor
