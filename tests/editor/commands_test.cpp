// The table of commands: each runs as its example says, is undone and redone.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include "editor/core/cells.h"
#include "editor/core/palette.h"
#include "editor/core/places.h"
#include "editor/core/rotation.h"
#include "tests/editor/editor_level.h"
#include "tests/editor/mesh_files.h"
#include "tests/support/temp_folder.h"

namespace editor {
namespace {

class EveryCommand : public testing::TestWithParam<Command> {};

std::string caseName(const testing::TestParamInfo<Command>& info) {
    return std::string(info.param.name);
}

INSTANTIATE_TEST_SUITE_P(Table, EveryCommand, testing::ValuesIn(allCommands().begin(), allCommands().end()), caseName);

/// What an example of undo, redo, play and models needs before it.
void prepare(Editor& editor, std::string_view command) {
    if (command.ends_with("_models")) runAll(editor, {"import model.rubble 0,9,0"});
    if (command == "reload_models") {
        Editor model;
        runAll(model, {"create 5,5,5 name=cube", "save model.rubble force=yes"});
    }
    if (command == "redo") runAll(editor, {"undo"});
    if (command == "step" || command == "stop" || command == "keep" || command == "rewind") runAll(editor, {"play"});
}

TEST_P(EveryCommand, RunsAsItsExampleSaysAndIsUndoneAndRedone) {
    const ExampleFolder folder;
    const bool needsJournal = GetParam().name == "recover" || GetParam().name == "discard";
    if (needsJournal) leaveJournal("crashed");
    Editor editor({.journals = needsJournal ? "crashed" : ""});
    if (!needsJournal) makeTestLevel(editor);
    prepare(editor, GetParam().name);
    Document& document = editor.document();
    const auto hash = [&] { return editor.world().get_resolved_hash(); };  // with motion and settings
    const uint64_t before = hash(), level = document.hash();
    const size_t steps = document.done().size();
    const Outcome outcome = editor.run(std::string(GetParam().example));
    ASSERT_TRUE(outcome.isDone) << GetParam().example << "\n" << outcome.text;
    const uint64_t after = hash();
    if (GetParam().kind == Kind::View) {
        EXPECT_EQ(after, before);
    }
    if (GetParam().kind != Kind::Edit && GetParam().kind != Kind::Tool) return;
    EXPECT_NE(after, before) << "the example changes nothing";
    ASSERT_EQ(document.done().size(), steps + 1);
    runAll(editor, {"undo"});
    EXPECT_EQ(hash(), before);
    EXPECT_EQ(document.hash(), level);
    EXPECT_EQ(document.done().size(), steps);
    runAll(editor, {"redo"});
    EXPECT_EQ(hash(), after);
}

TEST_P(EveryCommand, IsDescribed) {
    const Command& command = GetParam();
    EXPECT_TRUE(command.help.ends_with(".")) << command.help;
    EXPECT_TRUE(command.example.starts_with(command.name));
    std::set<std::string_view> names;
    for (const Parameter& each : command.parameters) {
        EXPECT_TRUE(names.insert(each.name).second) << each.name;
        EXPECT_FALSE(each.help.empty()) << each.name;
        EXPECT_FALSE(each.help.ends_with(".")) << each.name;
        const bool isFile = each.type == Type::Text && each.choices.starts_with('.');
        EXPECT_EQ(each.type == Type::Choice || isFile, !each.choices.empty()) << each.name;
    }
}

TEST_P(EveryCommand, RefusesAParameterThatItDoesNotHave) {
    const auto takesAll = [](const Parameter& each) { return each.type == Type::Pairs; };
    if (std::ranges::any_of(GetParam().parameters, takesAll)) GTEST_SKIP() << "it takes all names";
    Editor editor;
    const Outcome outcome = editor.run(std::string(GetParam().name) + " no_such_parameter=1");
    EXPECT_FALSE(outcome.isDone);
    EXPECT_NE(outcome.text.find(GetParam().name), std::string::npos) << outcome.text;
    EXPECT_NE(outcome.text.find("found 'no_such_parameter'"), std::string::npos) << outcome.text;
}

TEST(Commands, OfAScriptSpeakOnce) {
    const ExampleFolder folder;
    std::ofstream("inner.txt") << "create 4,4,4\nsave inner.rubble\n";
    std::ofstream("outer.txt") << "save outer.rubble\nscript inner.txt\nhide all\n";
    Editor editor;
    const Outcome outcome = editor.run(std::string("script inner.txt"));
    EXPECT_EQ(outcome.text, "saved inner.rubble");
    EXPECT_EQ(editor.run(std::string("script outer.txt")).text,
              "saved outer.rubble\nsaved inner.rubble\n2 of 2 shapes hidden");
}

TEST(Commands, DrawOneEntryUnlessAnotherIsSaid) {
    for (const char* name : {"create", "add_shape", "voxel", "box", "sphere", "line", "face", "flood", "paint_selected",
                             "fill_selected"}) {
        const std::vector<Parameter>& all = findCommand(name)->parameters;
        const auto index = std::ranges::find(all, "index", &Parameter::name);
        ASSERT_NE(index, all.end()) << name;
        EXPECT_EQ(index->otherwise, "5") << name;
    }
}

TEST(Commands, HaveNamesOfTheirOwn) {
    std::set<std::string_view> names;
    for (const Command& command : allCommands()) EXPECT_TRUE(names.insert(command.name).second) << command.name;
    EXPECT_EQ(findCommand("sphere")->name, "sphere");
    EXPECT_EQ(findCommand("nothing"), nullptr);
}

TEST(Commands, SayWhatIsWrong) {
    Editor editor;
    runAll(editor, {"create 8,8,8 name=crate"});
    const uint64_t before = editor.document().hash();
    const std::pair<const char*, const char*> cases[] = {
        {"spere 1,2,3", "spere: expected a command, found 'spere'; did you mean sphere?"},
        {"sphere", "sphere: center: expected three whole numbers x,y,z, each from -4096 to 4096, found none"},
        {"sphere 1,2 3", "sphere: center: expected three whole numbers x,y,z, each from -4096 to 4096, found '1,2'"},
        {"sphere 1,2,3 900", "sphere: radius: expected a number from 0.5 to 256, found '900'"},
        {"sphere 1,2,3 nan", "sphere: radius: expected a number from 0.5 to 256, found 'nan'"},
        {"sphere 1,2,3 do=melt", "sphere: do: expected one of: add erase paint replace, found 'melt'"},
        {"sphere 1,2,3 center=4,5,6", "sphere: center: expected one value, found another: '4,5,6'"},
        {"sphere 1,2,3 shape=house", "sphere: shape: expected a shape, found none by 'house'"},
        {"set_joint what=crate", "set_joint: what: expected a joint, found a body by 'crate'"},
        {"undo 1 2", "undo: expected at most 1 values, found '2' beyond them"},
        {"entry 5 color=red shape=crate", "entry: color: expected a colour #rrggbb, found 'red'"},
        {"entry 5 material=cheese shape=crate", "entry: material: expected a material of the level, found 'cheese'"},
        {"name \"half a quote", "expected a second '\"' in: name \"half a quote"},
        {"redo", "redo: there is no undo to take back"},
        {"stop", "stop: expected play, found none: play first"},
        {"merge crate crate", "merge"},
        {"rope world world 0,0,0 1,1,1", "rope: b: expected a shape at one side at least"},
        {"water 0,0,0 0,0,0", "water: to: expected a corner at another x and z"},
        {"light_group \"\"", "light_group: name: expected a text, found ''"},
        {"trigger \"\" 0,0,0", "trigger: name: expected a text, found ''"},
        {"joint hinge crate world 0,0,0 low=90 high=-90", "joint: high: expected low or more, which is 90, found -90"},
        {"duplicate 1000000,0,0 5 crate", "duplicate: by: expected what stays within 1000000 m of the origin"},
        {"rotate 0,180,0 0,0,-1000000 crate", "rotate: about: expected what stays within 1000000 m"},
        {"save \"\"", "save: file: expected a path, found ''"},
        {"save nofolder/c.rubble", "save: save_level: nofolder/c.rubble: cannot write: No such file or directory"},
        {"export o.ply", "export: file: expected a name that ends in one of: .vox .obj .glb .rubble .vdb .png .json"},
        {"palette_image none.png shape=crate", "palette_image: none.png: No such file or directory"},
        {"name a,b crate", "name: name: expected no comma"},
        {"create 4,4,4 name=selected", "create: name: expected no comma"},
        {"light sphere 0,0,0 name=#1", "light: name: expected no comma"},
        {"open nowhere.rubble", "open: load_level: nowhere.rubble: cannot open: No such file or directory"},
    };
    for (const auto& [line, message] : cases) {
        const Outcome outcome = editor.run(std::string(line));
        EXPECT_FALSE(outcome.isDone) << line;
        EXPECT_EQ(outcome.text.rfind(message, 0), 0u) << "found: " << outcome.text << "\nexpected: " << message;
        EXPECT_EQ(editor.document().hash(), before) << line;
    }
    EXPECT_EQ(editor.document().done().size(), 1u);
}

double heightOf(Editor& editor, const char* name) {
    const uint64_t body = editor.world().find_by_name(RUBBLE_KIND_BODY, name).at(0);
    return editor.world().get_body_state(body).position[1];
}

TEST(Commands, DropRestsOnWhatIsBelow) {
    Editor editor;
    runAll(editor,
           {"create 20,4,20 0,0,0 name=table static=yes", "create 4,4,4 0.55,3,0 name=box",
            "create 4,4,4 1.15,3,0 name=edge", "create 4,4,4 9,3,0 name=alone",
            "create 8,8,8 -0.5,3,0 turn=0,0,45 name=turned", "drop box", "drop edge", "drop alone", "drop turned"});
    EXPECT_NEAR(heightOf(editor, "box"), 0.4, 1e-6);
    EXPECT_NEAR(heightOf(editor, "edge"), 0.4, 1e-6) << "on half of a voxel";
    EXPECT_NEAR(heightOf(editor, "alone"), 0.0, 1e-6) << "nothing is below";
    EXPECT_NEAR(heightOf(editor, "turned"), 0.4 + 0.4 * std::sqrt(0.5), 2e-3) << "on an edge";
    const size_t steps = editor.document().done().size();
    EXPECT_TRUE(editor.run("drop box").isDone);
    EXPECT_EQ(editor.document().done().size(), steps) << "it rests already";
    runAll(editor, {"move 0,1,0 box,alone", "drop box,alone"});
    EXPECT_NEAR(heightOf(editor, "box"), 0.4, 1e-6);
    EXPECT_NEAR(heightOf(editor, "alone"), 0.0, 1e-6) << "both went as far as the first can";
}

TEST(Commands, ScaleRepeatsAndLeavesOutCells) {
    Editor editor;
    runAll(editor,
           {"create 4,4,2 0,0,0 index=5 name=a", "box 2,0,0 3,3,1 paint 7 shape=a", "voxel 0,3,0 erase shape=a"});
    const rubble_shape shape = editor.world().get_objects(RUBBLE_KIND_SHAPE).at(0);
    const glm::dvec3 corner = vectorOf(editor.world().get_shape_state(shape).position);
    const auto at = [&](int x, int y, int z) {
        return int(readCells(editor.world(), shape, {{x, y, z}, glm::ivec3(1)})[0]);
    };
    runAll(editor, {"scale 8,2,6 a"});
    const rubble_shape_state larger = editor.world().get_shape_state(shape);
    EXPECT_EQ(glm::ivec3(larger.size[0], larger.size[1], larger.size[2]), glm::ivec3(8, 2, 6));
    EXPECT_EQ(vectorOf(larger.position), corner);
    for (int z = 0; z < 6; ++z)
        for (int x = 0; x < 8; ++x) EXPECT_EQ(at(x, 1, z), x < 2 && z < 3 ? 0 : x < 4 ? 5 : 7) << x << " " << z;
    runAll(editor, {"scale 4,2,2 a"});
    EXPECT_EQ(editor.world().get_shape_state(shape).voxel_count, 4u * 2 * 2 - 1);
    EXPECT_NE(editor.run("scale 4096,4096,4096 a").text.find("fewer cells"), std::string::npos);
    runAll(editor, {"create 9,9,9 5,0,0 name=hollow", "box 1,1,1 7,7,7 erase shape=hollow"});
    EXPECT_EQ(editor.run("scale 1,1,1 hollow").text,
              "scale: size: expected one that leaves a voxel, found only cells that are empty");
    runAll(editor, {"scale 5,5,5 hollow"});
}

TEST(Commands, LightsMoveAsBodiesDo) {
    Editor editor;
    runAll(editor, {"create 8,8,8 2,0,0 turn=0,90,0 name=crate", "light sphere 0,3,0 name=free",
                    "light sphere 0.1,0.2,0.3 shape=crate name=fixed"});
    const auto at = [&](const char* name) {
        return placeOf(editor.world(), editor.world().find_by_name(RUBBLE_KIND_LIGHT, name).at(0)).position;
    };
    const glm::dvec3 fixed = at("fixed");
    runAll(editor, {"move 0,1,0 free,fixed"});
    EXPECT_NEAR(glm::distance(at("free"), glm::dvec3(0, 4, 0)), 0.0, 1e-9);
    EXPECT_NEAR(glm::distance(at("fixed"), fixed + glm::dvec3(0, 1, 0)), 0.0, 1e-9);
    runAll(editor, {"move 1,0,0 all"});
    EXPECT_NEAR(glm::distance(at("fixed"), fixed + glm::dvec3(1, 1, 0)), 0.0, 1e-9) << "once, with its body";
    runAll(editor, {"rotate 0,0,90 about=1,0,0 what=free"});
    EXPECT_NEAR(glm::distance(at("free"), glm::dvec3(-3, 0, 0)), 0.0, 1e-9);
}

TEST(Commands, DeleteAllSaysNothing) {
    Editor editor;
    makeTestLevel(editor);
    runAll(editor, {"unlock locked", "light sphere 0,4,0 shape=crate name=torch", "water 20,0,0 22,1,2 name=pool"});
    const Outcome outcome = editor.run("delete all");
    EXPECT_TRUE(outcome.isDone);
    EXPECT_EQ(outcome.text, "");
    for (const uint32_t kind : {RUBBLE_KIND_BODY, RUBBLE_KIND_SHAPE, RUBBLE_KIND_LIGHT, RUBBLE_KIND_JOINT})
        EXPECT_TRUE(editor.world().get_objects(kind).empty()) << kind;
}

TEST(Commands, OneOfSeveralIsAskedForByItsHandle) {
    Editor editor;
    runAll(editor, {"create 8,8,8 name=c", "add_shape c 4,4,4 0,0.8,0 name=knob"});
    const Outcome outcome = editor.run("voxel 0,0,0 erase shape=c");
    EXPECT_FALSE(outcome.isDone);
    const size_t at = outcome.text.find("found 2 by 'c': #");
    ASSERT_NE(at, std::string::npos) << outcome.text;
    const std::string handle = outcome.text.substr(at + 16, outcome.text.find(' ', at + 16) - at - 16);
    EXPECT_TRUE(editor.run("voxel 0,0,0 erase shape=" + handle).isDone) << handle;
}

TEST(Commands, WhatIsMadeHasTheColourOfItsMaterial) {
    Editor editor;
    runAll(editor, {"create 4,4,4 index=5 name=wood", "create 4,4,4 2,0,0 index=7 name=brick"});
    const auto redOf = [&](size_t shape, uint32_t entry) {
        return editor.world()
            .get_palette(paletteRange(editor.world().get_objects(RUBBLE_KIND_SHAPE).at(shape), entry, 1))
            .at(0)
            .color[0];
    };
    EXPECT_EQ(redOf(0, 5), 160);
    EXPECT_EQ(redOf(1, 7), 164);
    EXPECT_EQ(redOf(0, 1), 255) << "what is generic stays white";
}

TEST(Commands, AScriptMayBeginWithAByteOrderMark) {
    rubble::TempFolder folder;
    std::ofstream(folder / "marked.txt") << "\xef\xbb\xbf"
                                         << "create 4,4,4 name=a\r\n";
    Editor editor;
    const Outcome outcome = editor.runFile(folder / "marked.txt");
    EXPECT_TRUE(outcome.isDone) << outcome.text;
}

/// What the program prints, errors among it.
std::string printedBy(const std::string& arguments) {
    std::string out;
    FILE* const pipe = popen((std::string(RUBBLE_EDITOR_PROGRAM) + " " + arguments + " 2>&1").c_str(), "r");
    char buffer[256];
    while (fgets(buffer, sizeof buffer, pipe)) out += buffer;
    pclose(pipe);
    return out;
}

TEST(Commands, AnEmptyLevelNeedsNoFile) {
    EXPECT_NE(printedBy("'create 4,4,4 name=a' list").find("a"), std::string::npos);
    const std::string printed = printedBy("'create 4,4,4 name=block' list undo undo");
    const size_t listed = printed.find("block"), failed = printed.find("undo: there is no step");
    ASSERT_NE(listed, std::string::npos) << printed;
    ASSERT_NE(failed, std::string::npos) << printed;
    EXPECT_LT(listed, failed) << "what is said comes in its order";
}

TEST(Commands, FindRubbleVdbBesideTheProgram) {
    const ExampleFolder folder;
    EXPECT_NE(printedBy("'create 4,4,4 name=a' 'save a.vdb'").find("saved a.vdb"), std::string::npos);
    writeObj("cube.obj", cube(1.0, {0, 0}));
    EXPECT_NE(printedBy("a.vdb 'import cube.obj' list").find("cube"), std::string::npos);
    for (const char* line : {"'open a.vdb'", "'import a.vdb'", "'import cube.obj'", "'create 4,4,4' 'save b.vdb'",
                             "'create 4,4,4' 'export b.vdb'"})
        for (const char* tool : {"nowhere/rubble-vdb", "/tmp", "a.vdb"}) {
            const std::string printed = printedBy(fmt::format("--vdb-tool {} {}", tool, line));
            const std::string why =
                fmt::format("expected the program rubble-vdb for it, found no program at '{}': --vdb-tool", tool);
            EXPECT_NE(printed.find(why), std::string::npos) << line << "\n" << printed;
        }
    EXPECT_FALSE(std::filesystem::exists("b.vdb"));
    Editor editor;
    EXPECT_NE(editor.run("open a.vdb").text.find("found none: --vdb-tool"), std::string::npos);
}

TEST(Commands, ScriptsThatCallThemselvesEnd) {
    rubble::TempFolder folder;
    const std::string path = folder / "self.txt";
    std::ofstream(path) << "script " << path << "\n";
    Editor editor;
    const Outcome outcome = editor.runFile(path);
    EXPECT_FALSE(outcome.isDone);
    EXPECT_NE(outcome.text.find("expected at most 16 scripts within each other"), outcome.text.npos) << outcome.text;
    EXPECT_TRUE(editor.run("create 4,4,4").isDone);
}

TEST(Commands, SayThatAScriptIsAFolder) {
    rubble::TempFolder folder;
    const Outcome outcome = Editor().runFile(folder.path());
    EXPECT_FALSE(outcome.isDone);
    EXPECT_NE(outcome.text.find("cannot be read"), outcome.text.npos) << outcome.text;
}

TEST(Commands, TakeNoNamesThatATerminalObeys) {
    Editor editor;
    const Outcome outcome = editor.run("create name=a\x1b[31mred");
    EXPECT_FALSE(outcome.isDone);
    EXPECT_EQ(outcome.text, "create: name: expected no control characters, as of a terminal, found some");
    EXPECT_TRUE(editor.run("create name=\"T\xc3\xbcr 1\"").isDone);
}

TEST(Commands, CountInSingularAndPlural) {
    Editor editor;
    runAll(editor, {"create 2,1,1 name=two", "create 1,1,1 name=one"});
    EXPECT_EQ(editor.run("select_box 0,0,0 0,0,0 one").text, "1 cell selected");
    EXPECT_EQ(editor.run("select_box 0,0,0 1,0,0 two").text, "2 cells selected");
    EXPECT_EQ(editor.run("components one").text.find("1 component: 0 anchored, 1 loose\n  1 voxel from"), 0u);
    EXPECT_EQ(editor.run("merge_entries two").text, "0 entries merged");
}

TEST(Commands, NameAnObjectTwiceAndMeanItOnce) {
    Editor editor;
    runAll(editor, {"create 4,4,4 name=a", "create 4,4,4 2,0,0 name=b", "tag furniture a"});
    for (const char* names : {"a,a", "tag:furniture,a", "all,b"})
        EXPECT_EQ(editor.run(std::string("select ") + names).text.find("found none"), std::string::npos) << names;
    const uint64_t before = editor.document().hash();
    const Outcome undone = editor.run("undo 9");
    EXPECT_FALSE(undone.isDone);
    EXPECT_NE(undone.text.find("expected at most 3, found 9"), undone.text.npos) << undone.text;
    EXPECT_EQ(editor.document().hash(), before) << "what is refused changes nothing";
}

TEST(Commands, TakeNoEmptyNameForAllThatHaveNone) {
    Editor editor;
    runAll(editor, {"create 4,4,4 name=a", "create 4,4,4 8,0,0", "create 4,4,4 16,0,0"});
    const uint64_t before = editor.document().hash();
    for (const char* command : {"delete a,", "move 0,1,0 a,,a", "name zz \"\""}) {
        const Outcome outcome = editor.run(command);
        EXPECT_FALSE(outcome.isDone) << command;
        EXPECT_NE(outcome.text.find("expected names, found an empty one in"), std::string::npos) << outcome.text;
    }
    EXPECT_EQ(editor.document().hash(), before);
}

TEST(Commands, LeaveWhatIsLockedAlone) {
    Editor editor;
    runAll(editor, {"create 4,4,4 name=a", "create 4,4,4 2,0,0 name=b", "layer props a,b", "lock a"});
    const auto heightOf = [&](const char* name) {
        return editor.world().get_body_state(editor.world().find_by_name(RUBBLE_KIND_BODY, name).at(0)).position[1];
    };
    runAll(editor, {"move 0,1,0 all", "move 0,1,0 tag:layer=props"});
    EXPECT_EQ(heightOf("a"), 0.0);
    EXPECT_EQ(heightOf("b"), 2.0);
    for (const char* line : {"move 0,1,0 a", "voxel 0,0,0 erase shape=a", "delete a", "carve 0,0.2,0 0.3",
                             "explode 0,0,0 1", "shatter 0,0.2,0 0.3", "spray 0,0.4,0 #ff0000 0.3"}) {
        const Outcome outcome = editor.run(std::string(line));
        EXPECT_FALSE(outcome.isDone) << line;
        EXPECT_NE(outcome.text.find("found 'a': unlock it first"), outcome.text.npos) << outcome.text;
    }
    EXPECT_NE(editor.run(std::string("delete tag:locked")).text.find("'tag:locked', such as a: unlock"),
              std::string::npos);
    runAll(editor, {"carve 2,2.2,0 0.1", "play", "carve 0,0.2,0 0.1", "stop", "unlock a", "move 0,1,0 a"});
    EXPECT_EQ(heightOf("a"), 1.0);
}

TEST(Commands, DrawInPatterns) {
    Editor editor;
    const auto voxels = [&] { return editor.world().get_voxel_accounting().standing; };
    runAll(editor, {"create 8,8,8 name=a", "box 0,0,0 7,7,7 erase shape=a pattern=checker"});
    EXPECT_EQ(voxels(), 256u);
    runAll(editor, {"undo", "box 0,0,0 7,7,7 erase shape=a pattern=y every=2"});
    EXPECT_EQ(voxels(), 256u);
    const rubble_shape shape = editor.world().get_objects(RUBBLE_KIND_SHAPE).at(0);
    EXPECT_EQ(readCells(editor.world(), shape, between({0, 0, 0}, {0, 7, 0})),
              (std::vector<uint8_t>{0, 0, 5, 5, 0, 0, 5, 5}));
}

TEST(Commands, AreTakenApartAsTyped) {
    const Line line = readLine("  name \"a big crate\"  what=tag:old value=\"x = y\" ");
    EXPECT_EQ(line.command, "name");
    ASSERT_EQ(line.given.size(), 3u);
    EXPECT_EQ(line.given[0].name + "|" + line.given[0].value, "|a big crate");
    EXPECT_EQ(line.given[1].name + "|" + line.given[1].value, "what|tag:old");
    EXPECT_EQ(line.given[2].name + "|" + line.given[2].value, "value|x = y");
    EXPECT_EQ(readLine("name \"6\"\" wide\"").given.at(0).value, "6\" wide");
    EXPECT_EQ(readLine("name \"\"").given.at(0).value, "");
}

TEST(Commands, AreTakenApartAgainAsTheHistoryShowsThem) {
    for (const char* value : {"a", "", "block 1", "6\" wide", "\"", "\"\"", "a=b", "tag:old=3", "tag:a b", " ", "a\tb"})
        for (const char* name : {"", "name"}) {
            const Line line{"name", {{name, value}, {"what", "b c"}}};
            const Line again = readLine(textOf(line));
            ASSERT_EQ(again.given.size(), 2u) << textOf(line);
            EXPECT_EQ(again.command, "name");
            EXPECT_EQ(again.given[0].name, name) << textOf(line);
            EXPECT_EQ(again.given[0].value, value) << textOf(line);
            EXPECT_EQ(again.given[1].value, "b c");
        }
    Editor editor, again;
    runAll(editor, {"create 4,4,4 name=\"a \"\"big\"\" crate\"", "tag \"a b\" \"\" selected"});
    for (const std::string& line : editor.document().done()) ASSERT_TRUE(again.run(line).isDone) << line;
    EXPECT_EQ(again.document().hash(), editor.document().hash());
}

TEST(Commands, ThatFailLeaveNoMessageBehind) {
    Editor editor;
    runAll(editor, {"create 8,8,8 name=a"});
    const Outcome failed = editor.run(std::string("joint hinge a world 5,5,5 name=j"));
    EXPECT_FALSE(failed.isDone);
    EXPECT_EQ(failed.text.find("stale"), failed.text.npos) << failed.text;
    for (const char* line : {"create 4,4,4 3,0,0", "undo", "redo"}) EXPECT_EQ(editor.run(std::string(line)).text, "");
}

}  // namespace
}  // namespace editor
