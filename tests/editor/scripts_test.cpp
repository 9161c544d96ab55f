// Scripts that a level names: put there by commands, saved with it, and run by a game that loads it.
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "generated/paths.h"
#include "runtime/script/script_host.h"
#include "tests/editor/editor_level.h"

namespace editor {
namespace {

std::string say(Editor& editor, const std::string& line) {
    const Outcome outcome = editor.run(line);
    return (outcome.isDone ? "" : "refused: ") + outcome.text;
}

TEST(EditorScripts, AreListedUndoneAndRefused) {
    Editor editor;
    runAll(editor, {"create 4,4,4", "script_add lift.lua speed=2 title=\"The lift\"", "script_add door.lua",
                    "script_add lift.lua parameters=\"speed=3 height=6\""});
    const std::string all = "   1 lift.lua speed=2 title=The lift\n   2 door.lua\n   3 lift.lua speed=3 height=6";
    EXPECT_EQ(say(editor, "scripts"), all);
    runAll(editor, {"script_remove lift.lua"});
    EXPECT_EQ(say(editor, "scripts"), "   1 door.lua");
    runAll(editor, {"undo", "script_remove lift.lua number=1"});
    EXPECT_EQ(say(editor, "scripts"), "   1 door.lua\n   2 lift.lua speed=3 height=6");
    runAll(editor, {"undo"});
    EXPECT_EQ(say(editor, "scripts"), all);
    runAll(editor, {"redo", "undo"});
    const uint64_t before = editor.document().hash();
    EXPECT_EQ(say(editor, "script_remove none.lua"),
              "refused: script_remove: file: expected a script that the level names, found 'none.lua'");
    EXPECT_EQ(say(editor, "script_remove door.lua number=1").find("refused: script_remove: number: expected"), 0u);
    EXPECT_EQ(say(editor, "script_add /etc/lift.lua").find("refused: script_add: file: expected a path"), 0u);
    EXPECT_EQ(say(editor, "script_add ../lift.lua").find("refused: script_add: file: expected a path"), 0u);
    EXPECT_EQ(say(editor, "script_add lift.txt"),
              "refused: script_add: file: expected a name of one line that ends in .lua, found 'lift.txt'");
    EXPECT_EQ(say(editor, "script_add \"a\nb.lua\"").find("refused: script_add: file: expected a name"), 0u);
    EXPECT_EQ(say(editor, "script_add lift.lua fast"),
              "refused: script_add: parameters: expected NAME=VALUE, with spaces between several, found 'fast'");
    EXPECT_EQ(editor.document().hash(), before);
    EXPECT_EQ(say(editor, "scripts"), all);
}

TEST(EditorScripts, RunInAGameThatLoadsTheLevel) {
    const ExampleFolder folder;
    std::ofstream("lift.lua") << "function init() SetInt('speed', GetIntParam('speed', 1)) "
                                 "SetBool('slow', GetBoolParam('slow', true)) end";
    Editor editor;
    runAll(editor, {"create 4,4,4 name=lift", "save hall.rubble"});
    EXPECT_EQ(say(editor, "script_add none.lua"), "there is no none.lua beside hall.rubble yet");
    runAll(editor, {"undo"});
    const Outcome made =
        editor.runLua("test.lua", "Command('script_add', {file = 'lift.lua', speed = 4, slow = false})");
    ASSERT_TRUE(made.isDone) << made.text;
    EXPECT_EQ(say(editor, "scripts"), "   1 lift.lua slow=no speed=4");
    runAll(editor, {"save hall.rubble"});
    rubble::World world({.flags = RUBBLE_WORLD_NO_RENDERER});
    world.load_level("hall.rubble", nullptr);
    rubble::script::ScriptHost host(rubble::api(), world.handle(), {.folder = "."});
    host.addLevelScripts();
    EXPECT_EQ(host.shared().registry["speed"], "4");
    EXPECT_EQ(host.shared().registry["slow"], "0");
}

TEST(EditorScripts, AreMadeAsTheDocumentSays) {
    const ExampleFolder folder;
    std::ofstream("lift.lua") << "function init() SetInt('speed', GetIntParam('speed', 1)) end";
    Editor editor;
    runAll(editor, {"create 4,4,4 name=lift", "save room.rubble"});
    std::ifstream document(RUBBLE_SOURCE_DIR "/docs/scripting.md");
    const std::string begin = "./rubble edit room.rubble '";
    std::string said;
    for (std::string line; std::getline(document, line);) {
        if (!line.starts_with(begin)) continue;
        const size_t end = line.find('\'', begin.size()), output = line.find("-o ", end);
        runAll(editor, {"open room.rubble"});
        const Outcome outcome = editor.run(line.substr(begin.size(), end - begin.size()));
        EXPECT_TRUE(outcome.isDone) << line << "\n" << outcome.text;
        said += outcome.text;
        if (output != line.npos) runAll(editor, {("save " + line.substr(output + 3)).c_str()});
    }
    EXPECT_EQ(said, "   1 lift.lua speed=2 height=6");
    EXPECT_EQ(say(editor, "scripts"), "") << "it was taken out again";
    EXPECT_EQ(std::filesystem::exists("bare.rubble"), true);
    rubble::World world({.flags = RUBBLE_WORLD_NO_RENDERER});
    world.load_level("room.rubble", nullptr);
    rubble::script::ScriptHost host(rubble::api(), world.handle(), {.folder = "."});
    host.addLevelScripts();
    EXPECT_EQ(host.shared().registry["speed"], "2");
}

}  // namespace
}  // namespace editor
