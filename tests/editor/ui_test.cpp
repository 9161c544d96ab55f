// The window without a window: what the mouse does comes out as commands.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "editor/core/joints.h"
#include "editor/ui/host/scripted_ui.h"
#include "editor/ui/state/files.h"
#include "editor/ui/state/keys.h"
#include "editor/ui/view/load_probe.h"
#include "tests/editor/editor_level.h"

namespace editor {
namespace {

class Window : public testing::Test {
protected:
    void SetUp() override {
        m_ui = std::make_unique<ScriptedUi>(StageSettings{}, 960, 600);
        play("create 16,16,16 0,0,0 name=crate\nui camera 3,3,4 0,0.8,0");
    }
    /// Runs lines, each of which must work.
    void play(const std::string& lines) { ASSERT_EQ(m_ui->runAll(lines), ""); }
    Document& document() { return m_ui->stage().editor().document(); }
    rubble_shape crate() { return m_ui->stage().editor().world().get_objects(RUBBLE_KIND_SHAPE).at(0); }
    uint64_t voxels() { return m_ui->stage().editor().world().get_shape_state(crate()).voxel_count; }

    /// What the view shows, four bytes a pixel.
    std::vector<uint8_t> viewPixels() {
        const rubble::TempFolder folder;
        const std::string path = folder / "view.png";
        play("export " + path);
        png_image png{};
        png.version = PNG_IMAGE_VERSION;
        EXPECT_TRUE(png_image_begin_read_from_file(&png, path.c_str())) << png.message;
        png.format = PNG_FORMAT_RGBA;
        std::vector<uint8_t> pixels(PNG_IMAGE_SIZE(png));
        EXPECT_TRUE(png_image_finish_read(&png, nullptr, pixels.data(), 0, nullptr)) << png.message;
        return pixels;
    }
    /// The mean of all bytes.
    static double difference(const std::vector<uint8_t>& a, const std::vector<uint8_t>& b) {
        double sum = 0.0;
        for (size_t i = 0; i < std::min(a.size(), b.size()); ++i) sum += std::abs(int(a[i]) - int(b[i]));
        return sum / double(std::max(a.size(), b.size()));
    }

    std::unique_ptr<ScriptedUi> m_ui;
};

TEST_F(Window, AClickOfABrushIsACommandThatUndoTakesBack) {
    const uint64_t before = document().hash(), count = voxels();
    const size_t steps = document().done().size();
    play("ui brush voxel add index=7\nui hover 0.05,1.6,0.05");
    EXPECT_EQ(document().hash(), before) << "the ghost is only shown";
    play("ui click");
    ASSERT_EQ(document().done().size(), steps + 1);
    EXPECT_EQ(document().done().back(), "voxel cell=8,16,8 do=add index=7 shape=crate");
    EXPECT_EQ(voxels(), count + 1);
    play("undo");
    EXPECT_EQ(document().hash(), before);
}

TEST_F(Window, ADragOfABrushIsOneStep) {
    const uint64_t count = voxels();
    const size_t steps = document().done().size();
    play("ui brush sphere erase size=2\nui hover 0.05,1.6,0.05\nui press\nui by 60 0\nui by 60 0\nui release");
    ASSERT_EQ(document().done().size(), steps + 1);
    EXPECT_TRUE(document().done().back().starts_with("line from=8,15,8 to=")) << document().done().back();
    EXPECT_LT(voxels() + 60, count);
}

TEST_F(Window, AClickSelectsAndAnArrowMoves) {
    const rubble_body body = m_ui->stage().editor().world().get_objects(RUBBLE_KIND_BODY).at(0);
    play("deselect\nui mode select\nui hover 0.05,1.6,0.05\nui click");
    EXPECT_EQ(m_ui->stage().editor().selection().objects, std::vector<uint64_t>{body});
    play("ui mode move\nui hover 0.3,0.8,0\nui press\nui by 30 10\nui by 30 10\nui release");
    ASSERT_TRUE(document().done().back().starts_with("move by=")) << document().done().back();
    const rubble_body_state moved = m_ui->stage().editor().world().get_body_state(body);
    EXPECT_GT(moved.position[0], -0.8);
    EXPECT_NEAR(moved.position[0] * 10.0, std::round(moved.position[0] * 10.0), 1e-9) << "it snaps to a voxel";
    EXPECT_EQ(moved.position[1], 0.0);
}

TEST_F(Window, ADragOfAFieldIsOneCommand) {
    const size_t steps = document().done().size();
    play("ui tab Properties\nui at 850 232\nui press\nui by 20 0\nui by 20 0");
    EXPECT_EQ(document().done().size(), steps) << "it is dragged still";
    play("ui release");
    ASSERT_EQ(document().done().size(), steps + 1);
    EXPECT_EQ(document().done().back(), "body gravity=1.4 what=crate");
}

TEST_F(Window, AFormChoosesAndRuns) {
    play("ui form create size=4,4,4 name=block");
    EXPECT_TRUE(m_ui->stage().ui().commands().isOpen());
    const uint64_t before = document().hash();
    play("ui at 148 471\nui click");
    EXPECT_NE(document().hash(), before);
    EXPECT_EQ(document().done().back(), "create size=4,4,4 name=block");
    EXPECT_FALSE(m_ui->stage().ui().commands().isOpen());
}

TEST_F(Window, AFormListsTheFilesThatItTakes) {
    const rubble::TempFolder folder;
    play("save " + (folder / "Crate.rubble"));
    std::filesystem::create_directory(folder / "models");
    for (const char* other : {"a.png", ".hidden.rubble", "b.VOX"}) std::ofstream(folder / other) << "no level";
    const auto names = [&](const std::string& path) {
        std::string all;
        for (const FileEntry& each : listFiles(folder / "", ".rubble .vox", path))
            all += each.name + (each.isFolder ? "/ " : " ");
        return all;
    };
    EXPECT_EQ(names(folder / ""), "models/ b.VOX Crate.rubble ");
    EXPECT_EQ(names(folder / "cra"), "Crate.rubble ");
    EXPECT_EQ(names(folder / "other"), "models/ b.VOX Crate.rubble ") << "a new name";
    EXPECT_TRUE(listFiles(folder / "none/", ".vox", "").empty());
    EXPECT_EQ(folderOf("models/car.vox", "./"), "models/");
    EXPECT_EQ(folderOf("car.vox", "./"), "./");
    play("new\nui form open file=" + (folder / "") + "\nui at 200 213\nui click\nui at 148 471\nui click");
    EXPECT_EQ(document().path(), folder / "Crate.rubble");
    EXPECT_EQ(voxels(), 4096u);
}

TEST_F(Window, PlayLeavesNothingBehind) {
    play("move 0,3,0 crate");
    const uint64_t before = document().hash();
    play("ui breaker explode 0.8\nui play 30");
    EXPECT_EQ(document().playedSteps(), 30u);
    EXPECT_NE(document().hash(), before);
    const uint64_t ruin = document().hash();
    play("stop");
    EXPECT_EQ(document().hash(), before);
    Replay& replay = m_ui->stage().session().replay;
    ASSERT_EQ(replay.size(), 30u);
    const auto heightAt = [&](size_t step) {
        replay.seek(step);
        return replay.world()->get_body_states().at(0).position[1];
    };
    const double last = heightAt(30), tenth = heightAt(10);
    EXPECT_LT(last, tenth) << "it falls";
    EXPECT_EQ(heightAt(30), last) << "again, after a step back";
    EXPECT_EQ(replay.world()->get_level_hash(), ruin);
    EXPECT_EQ(document().hash(), before) << "the replay is not the level";
}

TEST_F(Window, ReplayAndJournalDoNotTakeEachOthersSteps) {
    const rubble::TempFolder folder;
    m_ui.reset();
    uint64_t hash = 0;
    {
        ScriptedUi ui({.journals = folder / "living"}, 960, 600);
        ASSERT_EQ(ui.runAll("create 8,8,8 0,5,0 name=crate\nplay\nstep 30\nexplode 0,4,0 1\nstep 30\nui replay 45"),
                  "");
        EXPECT_EQ(ui.stage().session().replay.size(), 60u) << "of the step, each";
        EXPECT_NE(ui.run("ui replay 61").find("expected a step from 1 to 60, found 61"), std::string::npos);
        ASSERT_EQ(ui.runAll("rewind 20\nstep 15\nui replay 45"), "");
        EXPECT_EQ(ui.stage().session().replay.size(), 45u) << "it knows what was played again";
        EXPECT_EQ(ui.stage().session().replay.world()->get_level_hash(), ui.stage().editor().document().hash());
        ASSERT_EQ(ui.runAll("ui replay 20\nui replay 45\nstop\nmove 0,1,0 crate"), "");
        hash = ui.stage().editor().document().hash();
        std::filesystem::copy(folder / "living", folder / "crashed", std::filesystem::copy_options::recursive);
    }
    Editor editor({.journals = folder / "crashed"});
    runAll(editor, {"recover"});
    EXPECT_EQ(editor.document().hash(), hash) << "what was done after a play is kept as well";
}

TEST_F(Window, KeysOfTheUserComeFirst) {
    const rubble::TempFolder folder;
    const std::string path = folder / "keys.txt";
    std::ofstream(path) << "-- mine\nCtrl+D duplicate 3,0,0\nShift+F5 lock\nF6 tag\n";
    const auto bodies = [&] { return m_ui->stage().editor().world().get_objects(RUBBLE_KIND_BODY).size(); };
    ASSERT_EQ(loadKeys(path), "");
    EXPECT_EQ(keyOf("duplicate"), "Ctrl+D");
    EXPECT_EQ(keyOf("undo"), "Ctrl+Z") << "the others stay";
    play("select crate\nui key Ctrl+D");
    EXPECT_EQ(bodies(), 2u);
    play("ui key F6");
    EXPECT_TRUE(m_ui->stage().ui().commands().isOpen()) << "it needs a tag";
    play("ui close");
    for (const char* wrong : {"Ctrl+Foo lock", "F5 melt", "F5 duplicate x,y", "F5"}) {
        std::ofstream(path) << wrong << "\n";
        EXPECT_NE(loadKeys(path).find("keys.txt:1: "), std::string::npos) << wrong;
    }
    std::ofstream(path) << "F5 lock\nF6 melt\n\nCtrl+Foo lock\nF7 unlock\n";
    const std::string errors = loadKeys(path);
    EXPECT_NE(errors.find("keys.txt:2: expected a command, found 'melt'\n"), errors.npos) << errors;
    EXPECT_NE(errors.find("keys.txt:4: expected keys"), errors.npos) << errors;
    EXPECT_EQ(keyOf("lock") + keyOf("unlock"), "F5F7") << "the other lines hold";
    EXPECT_EQ(loadKeys(folder / "none.txt"), "");
    EXPECT_EQ(keyOf("duplicate"), "Shift+D");
}

TEST_F(Window, AFilmHasAnImageOfEachStep) {
    const rubble::TempFolder folder;
    m_ui->setFolder(folder.path());
    EXPECT_NE(m_ui->run("ui film images").find("expected steps that were played, found none"), std::string::npos);
    play("move 0,2,0 crate\nplay\nstep 8\nstop\nui film images");
    const auto bytesOf = [&](const char* name) {
        std::ostringstream out;
        out << std::ifstream(folder / "images/" + name, std::ios::binary).rdbuf();
        return out.str();
    };
    EXPECT_GT(bytesOf("000001.png").size(), 1000u);
    EXPECT_NE(bytesOf("000001.png"), bytesOf("000008.png")) << "it falls";
    EXPECT_FALSE(std::filesystem::exists(folder / "images/000009.png"));
    if (std::system("ffmpeg -version >/dev/null 2>&1") != 0) GTEST_SKIP() << "without ffmpeg";
    play("ui film fall.mp4");
    EXPECT_GT(std::filesystem::file_size(folder / "fall.mp4"), 1000u);
}

TEST_F(Window, TheTourHasFiveSteps) {
    const std::vector<uint64_t> selected = m_ui->stage().editor().selection().objects;
    play("ui mode select\nui tour 1");
    for (const int next : {2, 3, 4, 5, 0}) {
        play("ui at 275 369\nui click");
        EXPECT_EQ(m_ui->stage().session().tour, next);
    }
    EXPECT_EQ(m_ui->stage().editor().selection().objects, selected) << "its clicks are its own";
}

TEST_F(Window, TheViewIsExportedAsAnImage) {
    const rubble::TempFolder folder;
    play("export " + (folder / "view.png"));
    EXPECT_GT(std::filesystem::file_size(folder / "view.png"), 5000u);
    EXPECT_NE(m_ui->run("export " + (folder / "none/view.png")).find("view.png"), std::string::npos);
    Editor editor;
    EXPECT_NE(editor.run("export view.png").text.find("only the window has a view"), std::string::npos);
}

TEST_F(Window, TimesAreExportedAsATrace) {
    const rubble::TempFolder folder;
    m_ui->setFolder(folder.path());
    play("move 0,2,0 crate\nui play 10\nui overlay grid\nui screenshot window.png\nexport " + (folder / "trace.json"));
    std::ostringstream text;
    text << std::ifstream(folder / "trace.json").rdbuf();
    const std::string trace = text.str();
    const auto count = [&](const std::string& part) {
        size_t found = 0;
        for (size_t at = trace.find(part); at != trace.npos; at = trace.find(part, at + 1)) ++found;
        return found;
    };
    EXPECT_TRUE(trace.starts_with("{\"displayTimeUnit\":\"ms\",\"traceEvents\":["));
    EXPECT_GE(count("\"name\":\"draw\""), 10u) << "frames";
    EXPECT_GE(count("\"name\":\"physics\""), 10u);
    EXPECT_LE(count("\"name\":\"physics\""), 11u) << "each step once, also where more frames were drawn";
    EXPECT_EQ(std::ranges::count(trace, '{'), std::ranges::count(trace, '}'));
    Editor editor;
    EXPECT_NE(editor.run("export trace.json").text.find("only the window measures its frames"), std::string::npos);
}

TEST_F(Window, AMiddleIsDraggedOntoWhatIsUnderTheMouse) {
    play("create 20,2,20 3,0,0 name=table static=yes\nselect crate\nui camera 2,6,7 1.5,0.5,0\nui mode move");
    play("ui hover 0,0.8,0\nui press\nui hover 3,0.2,0.5\nui release");
    ASSERT_TRUE(document().done().back().starts_with("move by=")) << document().done().back();
    const rubble_body_state body = m_ui->stage().editor().world().get_body_states().at(0);
    EXPECT_NEAR(body.position[0], 3.0, 0.11);
    EXPECT_NEAR(body.position[1], 0.2, 1e-4) << "it lies on the table";
    EXPECT_NEAR(body.position[2], 0.5, 0.11);
}

TEST_F(Window, AnArrowScalesAShape) {
    play(
        "place 0,0,0 0,90,0 crate\nselect crate\nui mode scale\nui hover 0,0.8,-0.3\nui press\nui by 30 -10\nui by 20 "
        "-8");
    const size_t steps = document().done().size();
    play("ui release");
    ASSERT_EQ(document().done().size(), steps + 1);
    ASSERT_TRUE(document().done().back().starts_with("scale size=")) << document().done().back();
    const rubble_shape_state shape = m_ui->stage().editor().world().get_shape_state(crate());
    EXPECT_GT(shape.size[0], 16) << "x of its grid points to -z";
    EXPECT_EQ(shape.size[1], 16);
    EXPECT_EQ(shape.size[2], 16);
}

TEST_F(Window, ALightHasHandles) {
    play("light sphere 0,2.4,0 name=torch\nui mode move\nui camera 3,3,6 0,1.5,0");
    const rubble_light torch = m_ui->stage().editor().world().get_lights().at(0);
    play("ui hover 0.3,2.4,0\nui press\nui by 40 0\nui by 40 0\nui release");
    ASSERT_TRUE(document().done().back().starts_with("move by=")) << document().done().back();
    const rubble_light_settings light = m_ui->stage().editor().world().get_light_settings(torch);
    EXPECT_GT(light.position[0], 0.15);
    EXPECT_EQ(light.position[1], 2.4);
}

TEST_F(Window, AClickGoesThroughWhatIsHiddenAndTheImageShowsWhatIsBehind) {
    play("create 80,40,2 0,0,-2 index=7 name=wall static=yes\ndeselect\nui mode select\nui pass albedo");
    const std::vector<uint8_t> whole = viewPixels();
    play("hide crate");
    const double hidden = difference(viewPixels(), whole);
    EXPECT_GT(hidden, 1.5);
    Editor& editor = m_ui->stage().editor();
    const auto bodyOf = [&](const char* name) { return editor.world().find_by_name(RUBBLE_KIND_BODY, name); };
    play("ui hover 0,1.5,0.7\nui click");
    EXPECT_EQ(editor.selection().objects, bodyOf("wall"));
    play("show crate");
    EXPECT_LT(difference(viewPixels(), whole), hidden / 4.0) << "it is there again";
    play("ui leave\nui hover 0,1.5,0.7\nui click");
    EXPECT_EQ(editor.selection().objects, bodyOf("crate"));
}

TEST_F(Window, KeysHideWhatIsSelectedAndShowAll) {
    play("create 8,8,8 3,0,0 name=other\nselect crate\nui key H");
    const std::vector<rubble_shape>& hidden = m_ui->stage().editor().view().hidden;
    EXPECT_EQ(hidden, std::vector<rubble_shape>{crate()});
    play("ui key Shift+H");
    ASSERT_EQ(hidden.size(), 1u);
    EXPECT_NE(hidden.front(), crate()) << "the others";
    play("ui key Ctrl+H");
    EXPECT_TRUE(hidden.empty());
}

TEST_F(Window, TheEyeOfALayerHidesAllThatIsInIt) {
    play("create 8,8,8 3,0,0 name=other\nlayer upper crate\nlayer upper other\nui at 216 110\nui click");
    EXPECT_EQ(document().done().back(), "layer upper other");
    EXPECT_EQ(m_ui->stage().editor().view().hidden.size(), 2u) << "the first row is the layer";
    play("ui click");
    EXPECT_TRUE(m_ui->stage().editor().view().hidden.empty());
}

TEST_F(Window, AReplayLeavesOutWhatIsHidden) {
    play("deselect\nui pass albedo\nplay\nstep 8\nstop\nui replay 4");
    const std::vector<uint8_t> whole = viewPixels();
    play("hide crate");
    EXPECT_GT(difference(viewPixels(), whole), 1.5);
}

TEST_F(Window, AJointHasHandles) {
    play(
        "create 4,20,4 -1,0,0 name=post static=yes\njoint hinge crate post -0.8,1,0 0,1,0 low=-30 high=60 search=0.5 "
        "name=pivot\nui camera 0,5,4 0,0.5,0\nui mode move\nselect pivot");
    const auto joint = [&] {
        rubble::World& world = m_ui->stage().editor().world();
        return settingsOf(world, world.find_by_name(RUBBLE_KIND_JOINT, "pivot").at(0));
    };
    play("ui hover -0.8,1.7,0\nui press\nui by 0 -8\nui by 0 -8\nui release");
    ASSERT_TRUE(document().done().back().starts_with("move by=0,")) << document().done().back();
    EXPECT_GT(joint().position[1], 1.05);
    EXPECT_EQ(joint().position[0], -0.8);
    const std::string height = std::to_string(joint().position[1]);
    // The crate is the first side, so that a limit of 60 degrees is a turn of it by -60 about y; it lies towards x.
    const double x = -0.8 + 0.8 * 0.5, z = 0.8 * std::sqrt(0.75);
    play("ui hover " + std::to_string(x) + "," + height + "," + std::to_string(z) +
         "\nui press\nui by 0 12\nui hover -0.8," + height + ",0.8\nui release");
    ASSERT_TRUE(document().done().back().starts_with("set_joint high=90")) << document().done().back();
    EXPECT_NEAR(joint().upper_limit, 1.5708, 1e-3);
    EXPECT_NEAR(joint().lower_limit, -0.5236, 1e-3);
}

TEST_F(Window, TheSuspensionOfAWheelHasHandles) {
    play(
        "create 3,8,8 -2,0,0 form=cylinder_x name=tyre\ncreate 4,4,8 -1.65,0.2,0 name=chassis\n"
        "wheel chassis tyre drive=300 name=axle\nui camera -5,0.6,0.4 -2,0.4,0\nui mode select\nselect axle");
    const auto wheel = [&] {
        rubble::World& world = m_ui->stage().editor().world();
        return settingsOf(world, world.find_by_name(RUBBLE_KIND_JOINT, "axle").at(0));
    };
    play("ui hover -2,0.52,0\nui press\nui by 0 -12\nui hover -2,0.71,0\nui release");
    ASSERT_EQ(document().done().back().substr(0, 18), "set_joint high=0.3") << document().done().back();
    EXPECT_NEAR(wheel().upper_limit, 0.3, 1e-6);
    EXPECT_NEAR(wheel().lower_limit, -0.12, 1e-6);
    EXPECT_EQ(wheel().drive_torque, 300.0);
}

TEST_F(Window, APaletteOfCommandsHasThemAllWithTheirForms) {
    for (const Command& command : allCommands()) {
        const std::vector<const Command*> found = CommandPalette::find(std::string(command.name));
        ASSERT_FALSE(found.empty()) << command.name;
        EXPECT_EQ(found.front(), &command);
        EXPECT_EQ(m_ui->run("ui form " + std::string(command.name)), "");
    }
    EXPECT_EQ(CommandPalette::find("").size(), allCommands().size());
    EXPECT_TRUE(CommandPalette::find("no such words").empty());
    EXPECT_GE(CommandPalette::find("brush").size(), 6u);
}

TEST_F(Window, AWrongLineOfAScriptSaysWhatIsExpected) {
    EXPECT_NE(m_ui->run("ui replay 5").find("expected steps that were played, found none"), std::string::npos);
    EXPECT_NE(m_ui->run("ui jump").find("expected one of these, found 'jump'"), std::string::npos);
    EXPECT_NE(m_ui->run("ui hover 0,0,1000").find("expected a point that the view shows"), std::string::npos);
    EXPECT_EQ(m_ui->runAll("\nui brush cube").find("line 2: ui brush cube: expected one of: voxel box"), 0u);
    EXPECT_EQ(m_ui->runAll("\nui brush cube", "a.txt").find("a.txt:2: ui brush cube: expected one of"), 0u);
}

TEST_F(Window, AnImageShowsTheLevelAndThePanels) {
    const rubble::TempFolder folder;
    m_ui->setFolder(folder.path());
    play("ui tab Palette\nui screenshot window.png");
    EXPECT_GT(std::filesystem::file_size(std::filesystem::path(folder.path()) / "window.png"), 20000u);
}

TEST_F(Window, ClosesAtOnceWhereNothingIsLostElseAtTheSecondTime) {
    const rubble::TempFolder folder;
    Session& session = m_ui->stage().session();
    EXPECT_FALSE(session.mayClose()) << "a crate is not saved";
    EXPECT_TRUE(session.mayClose());
    play("save " + (folder / "level.rubble"));
    EXPECT_TRUE(session.mayClose());
    play("move 1,0,0 crate");
    EXPECT_FALSE(session.mayClose()) << "what was said of other changes long ago does not count";
    play("select crate");
    EXPECT_FALSE(session.mayClose());
    EXPECT_TRUE(session.mayClose());
    play("save\nundo 2");
    EXPECT_FALSE(session.mayClose()) << "the file has what was undone";
    play("new");
    EXPECT_TRUE(session.mayClose());
}

TEST_F(Window, TheShowcaseOfALevelLeavesItAsItIs) {
    const rubble::TempFolder folder;
    for (const char* lines : {"create 8,8,8 2,1,0 name=ball form=sphere", "new"}) {
        play(lines);
        const uint64_t before = document().hash();
        const size_t steps = document().done().size();
        m_ui->setFolder(folder.path().string());
        play(kLevelShowcase);
        EXPECT_EQ(document().hash(), before);
        EXPECT_EQ(document().done().size(), steps);
        EXPECT_TRUE(std::filesystem::exists(folder / "07_commands.png"));
    }
}

TEST(Load, ABeamIsWeakestAtItsRoot) {
    Editor editor;
    runAll(editor, {"create 40,3,6 0,2,0 index=5 name=beam static=yes", "box 0,-16,0 5,-1,5 index=5 shape=beam",
                    "anchor beam"});
    const rubble_shape beam = editor.world().get_objects(RUBBLE_KIND_SHAPE).at(0);
    const uint64_t before = editor.document().hash();
    const LoadProbe weak = LoadProbe::of(editor.world(), beam);
    EXPECT_EQ(editor.document().hash(), before) << "a copy is tried, not the level";
    ASSERT_EQ(weak.weakest, 0);
    for (const LoadProbe::Cell& each : weak.cells) {
        if (each.level > 0) break;
        EXPECT_NEAR(each.cell.x, 5, 3) << "the beam leaves its post here";
    }
    runAll(editor, {"shape beam strength=12"});
    const LoadProbe strong = LoadProbe::of(editor.world(), beam);
    EXPECT_GE(strong.weakest, 3) << "12 times as strong: 8 times the load at least";
}

TEST(WindowRecovery, AsksWhatBecomesOfChangesThatACrashLeft) {
    const rubble::TempFolder folder;
    const std::string journals = folder / "journals", left = folder / "left";
    {
        Editor crashed({.journals = journals});
        ASSERT_TRUE(crashed.run("create 8,8,8 0,0,0 name=crate").isDone);
        std::filesystem::copy(journals, left, std::filesystem::copy_options::recursive);
    }
    ScriptedUi ui(StageSettings{.journals = left}, 960, 600);
    Document& document = ui.stage().editor().document();
    ASSERT_TRUE(document.recovery());
    ui.frames(2);
    EXPECT_EQ(ui.runAll("ui at 281 326\nui click"), "");
    EXPECT_FALSE(document.recovery());
    EXPECT_EQ(document.world().get_objects(RUBBLE_KIND_SHAPE).size(), 1u);
}

}  // namespace
}  // namespace editor
