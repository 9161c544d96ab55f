// Shapes that are linked to the files that they came from: what changes there comes in again, what was changed here
// stays.
#include "editor/core/models.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "editor/core/cells.h"
#include "editor/core/rotation.h"
#include "editor/ui/state/model_watch.h"
#include "tests/editor/model_level.h"

namespace editor {
namespace {

namespace fs = std::filesystem;

TEST(Models, ThatHaveChangedComeInAgain) {
    const ExampleFolder folder;
    writeChair("chair.rubble");
    Editor editor, fresh;
    runAll(editor, {"import chair.rubble 1,2,3 10,20,30", "import chair.rubble -4,0,0"});
    const size_t shapes = editor.world().get_objects(RUBBLE_KIND_SHAPE).size();
    EXPECT_EQ(answerOf(editor, "reload_models"), "chair.rubble: 0 shapes brought up to date, 4 unchanged in the file");
    EXPECT_EQ(editor.document().done().size(), 2u) << "a step that changes nothing is none";
    writeChair("chair.rubble", kChanges);
    const uint64_t before = editor.document().hash();
    EXPECT_EQ(answerOf(editor, "reload_models"), "chair.rubble: 2 shapes brought up to date, 2 unchanged in the file");
    const uint64_t after = editor.document().hash();
    runAll(fresh, {"import chair.rubble 1,2,3 10,20,30", "import chair.rubble -4,0,0"});
    for (const char* name : {"seat", "back"})
        for (size_t i = 0; i < 2; ++i)
            expectEqualShapes(editor, shapesOf(editor, name).at(i), fresh, shapesOf(fresh, name).at(i));
    EXPECT_EQ(editor.world().get_objects(RUBBLE_KIND_SHAPE).size(), shapes) << "none is left of reading";
    EXPECT_EQ(answerOf(editor, "reload_models chair.rubble"),
              "chair.rubble: 0 shapes brought up to date, 4 unchanged in the file");
    runAll(editor, {"undo"});
    EXPECT_EQ(editor.document().hash(), before);
    runAll(editor, {"redo"});
    EXPECT_EQ(editor.document().hash(), after);
    writeChair("chair.rubble");
    EXPECT_EQ(answerOf(editor, "reload_models"), "chair.rubble: 2 shapes brought up to date, 2 unchanged in the file");
    EXPECT_EQ(editor.world().get_voxel_hash(), [&] {
        runAll(editor, {"undo 2"});
        return editor.world().get_voxel_hash();
    }()) << "back to what it was at first";
}

TEST(Models, OfWhichPartsAreMadeAreNoLongerLinked) {
    const ExampleFolder folder;
    Editor file, editor;
    runAll(file, {"create 9,3,3 name=bar", "save bar.rubble"});
    runAll(editor, {"import bar.rubble", "split bar"});
    EXPECT_TRUE(isLinked(editor.world(), shapeOf(editor, "bar"))) << "there is one part";
    runAll(editor, {"box 4,0,0 4,2,2 erase shape=bar"});
    EXPECT_EQ(answerOf(editor, "split bar"), "2 parts unlinked: the file has the whole shape");
    const uint64_t split = editor.document().hash();
    expectRefused(editor, "reload_models revert=yes", "expected shapes that are linked to files, found none");
    runAll(editor, {"undo"});
    EXPECT_TRUE(isLinked(editor.world(), shapeOf(editor, "bar")));
    runAll(editor, {"redo"});
    EXPECT_EQ(editor.document().hash(), split);
    EXPECT_EQ(answerOf(editor, "split bar"), "");
}

TEST(Models, ToWhichOthersAreAddedAreNoLongerLinked) {
    const ExampleFolder folder;
    Editor file, editor;
    runAll(file, {"create 9,3,3 name=bar", "save bar.rubble"});
    runAll(editor, {"import bar.rubble", "add_shape bar 3,3,3 -0.15,0.3,-0.15 name=knob",
                    "add_shape bar 3,3,3 -0.15,3,-0.15 name=far"});
    expectRefused(editor, fmt::format("merge far #{}", shapeOf(editor, "bar")), "merge");
    EXPECT_EQ(answerOf(editor, "merge knob " + fmt::format("#{}", shapeOf(editor, "bar"))),
              "bar unlinked: the file has it without what was added");
    EXPECT_TRUE(linkedFiles(editor.world()).empty());
}

TEST(Models, WhoseFileIsGoneAreToldOfWhenTheLevelIsOpened) {
    const ExampleFolder folder;
    writeChair("chair.rubble");
    writeChair("a,b.rubble");
    Editor editor;
    runAll(editor, {"import chair.rubble", "import a,b.rubble", "lock all", "save level.rubble"});
    fs::remove("a,b.rubble");
    EXPECT_EQ(answerOf(editor, "open level.rubble"),
              "1 linked file cannot be read, so that what came from there stays as it is: a,b.rubble");
    fs::remove("chair.rubble");
    EXPECT_NE(answerOf(editor, "open level.rubble").find("2 linked files cannot be read"), std::string::npos);
}

TEST(Models, OfAFileWithACommaAreFoundByIt) {
    const ExampleFolder folder;
    for (const char* name : {"a.rubble", "a,b.rubble", "a,b,c.rubble"}) writeChair(name);
    Editor editor;
    runAll(editor, {"import a,b.rubble", "import a,b,c.rubble", "create 4,4,4 name=crate"});
    EXPECT_EQ(answerOf(editor, "select tag:model_file=a,b.rubble"), "2 selected");
    EXPECT_EQ(answerOf(editor, "select tag:model_file=a,b.rubble,crate"), "3 selected");
    EXPECT_EQ(answerOf(editor, R"(select "crate,tag:model_file=a,b,c.rubble,tag:model_file=a,b.rubble")"),
              "5 selected");
    expectRefused(editor, "select tag:model_file=a,c.rubble", "found none by 'tag:model_file=a'");
    EXPECT_NE(answerOf(editor, "hide tag:model_file=a,b.rubble").find("2 of 5 shapes hidden"), std::string::npos);
}

TEST(Models, ThatAreNoLongerRoundAreToldOf) {
    const ExampleFolder folder;
    Editor file, editor;
    runAll(file, {"create 3,8,8 form=cylinder_x name=tyre", "save tyre.rubble"});
    runAll(editor, {"create 14,3,28 0,0.3,0 name=car", "import tyre.rubble 0.9,0,0.9", "wheel car tyre"});
    runAll(file, {"box 0,0,0 2,7,7 shape=tyre", "save"});
    EXPECT_EQ(answerOf(editor, "reload_models"),
              "tyre.rubble: 1 shape brought up to date, 1 no longer round, touched as voxels: tyre");
}

TEST(Models, KeepWhatWasChangedInTheLevel) {
    const ExampleFolder folder;
    writeChair("chair.rubble");
    Editor editor;
    runAll(editor, {"import chair.rubble", "place 5,1,2 0,90,0 seat", "name throne seat", "tag king yes throne",
                    "shape throne density=2 strength=3", "create 4,4,4 5,2,2 name=crown",
                    "joint hinge throne crown 5,1.7,2 search=2 name=hinge", "light sphere 0.2,0.2,0.2 shape=throne",
                    "import chair.rubble 0,0,9", "voxel 0,1,0 erase shape=seat"});
    const rubble_shape throne = shapesOf(editor, "throne").at(0);
    const uint64_t edited = shapesOf(editor, "seat").at(0);
    const std::vector<uint8_t> voxels = readCells(editor.world(), edited, gridOf(editor.world(), edited));
    const rubble_shape_state was = editor.world().get_shape_state(throne);
    const uint32_t anchors = editor.world().get_shape_properties(throne).anchor_count;
    writeChair("chair.rubble", kChanges);
    EXPECT_EQ(answerOf(editor, "reload_models"),
              "chair.rubble: 1 shape brought up to date, 2 unchanged in the file, 1 kept as edited here: seat");
    EXPECT_EQ(readCells(editor.world(), edited, gridOf(editor.world(), edited)), voxels);
    const rubble_shape_state now = editor.world().get_shape_state(throne);
    EXPECT_EQ(now.size[0], was.size[0] + 5);
    const glm::dvec3 moved =
        glm::inverse(quaternionOf(was.rotation)) * (vectorOf(now.position) - vectorOf(was.position));
    EXPECT_NEAR(moved.x, -0.3, 1e-6);
    EXPECT_NEAR(moved.y, -0.1, 1e-6);
    EXPECT_STREQ(editor.world().get_tag(throne, "king").data(), "yes");
    EXPECT_EQ(editor.world().get_shape_properties(throne).density, 2.0);
    EXPECT_EQ(editor.world().get_shape_properties(throne).anchor_count, anchors);
    EXPECT_EQ(editor.world().get_joint_states().size(), 1u);
    EXPECT_EQ(editor.world().get_lights().size(), 1u);
    EXPECT_EQ(answerOf(editor, "reload_models what=seat revert=yes"), "chair.rubble: 1 shape brought up to date");
    Editor fresh;
    runAll(fresh, {"import chair.rubble 0,0,9"});
    expectEqualShapes(editor, shapesOf(editor, "seat").at(0), fresh, shapesOf(fresh, "seat").at(0));
}

TEST(Models, ThatAreLockedStayAndAreNamed) {
    const ExampleFolder folder;
    writeChair("chair.rubble");
    Editor editor;
    runAll(editor, {"import chair.rubble", "import chair.rubble 5,0,0", "create 4,4,4 -9,0,0 name=crate"});
    const rubble_shape first = shapesOf(editor, "seat").at(0);
    answerOf(editor, fmt::format("name throne #{}", first));
    runAll(editor, {"lock throne", "lock back"});
    EXPECT_EQ(answerOf(editor, "reload_models"), "chair.rubble: 0 shapes brought up to date, 4 unchanged in the file");
    writeChair("chair.rubble", kChanges);
    EXPECT_EQ(answerOf(editor, "reload_models"),
              "chair.rubble: 1 shape brought up to date, 2 unchanged in the file, 1 kept as locked: throne");
    const uint64_t before = editor.document().hash();
    runAll(editor, {"lock seat"});
    const char* const all =
        "chair.rubble: 0 shapes brought up to date, 3 unchanged in the file, 1 kept as locked: throne";
    EXPECT_EQ(answerOf(editor, "reload_models chair.rubble"), all) << "also where all that are linked are locked";
    EXPECT_EQ(answerOf(editor, "reload_models what=throne revert=yes"),
              "chair.rubble: 0 shapes brought up to date, 1 kept as locked: throne");
    runAll(editor, {"undo"});
    EXPECT_EQ(editor.document().hash(), before) << "no step came of them";
    runAll(editor, {"unlock throne"});
    EXPECT_EQ(answerOf(editor, "reload_models what=throne"), "chair.rubble: 1 shape brought up to date");
}

TEST(Models, AreRevertedWhereTheyWere) {
    const ExampleFolder folder;
    writeChair("chair.rubble");
    Editor editor, fresh;
    runAll(editor, {"import chair.rubble 1,0,0 0,45,0"});
    runAll(fresh, {"import chair.rubble 1,0,0 0,45,0"});
    runAll(editor, {"box -4,0,-2 1,6,1 index=9 shape=seat", "entry 5 color=#ff0000 shape=back"});
    EXPECT_EQ(answerOf(editor, "reload_models"), "chair.rubble: 0 shapes brought up to date, 2 unchanged in the file")
        << "the file has not changed";
    EXPECT_EQ(answerOf(editor, "reload_models revert=yes"), "chair.rubble: 2 shapes brought up to date");
    for (const char* name : {"seat", "back"})
        expectEqualShapes(editor, shapesOf(editor, name).at(0), fresh, shapesOf(fresh, name).at(0));
    runAll(editor, {"resize -2,0,0 12,3,9 seat"});
    writeChair("chair.rubble", kChanges);
    EXPECT_EQ(answerOf(editor, "reload_models"), "chair.rubble: 1 shape brought up to date, 1 unchanged in the file")
        << "room around its voxels is no edit";
}

TEST(Models, KeepTheirJointsWhereAVoxelIsInReach) {
    const ExampleFolder folder;
    writeChair("chair.rubble");
    Editor editor;
    runAll(editor,
           {"import chair.rubble", "create 2,2,2 -0.3,0.6,0 name=cup", "joint ball cup seat -0.3,0.6,0 name=glue",
            "joint ball back seat 0.3,0.6,0.3 name=screw", "tag old yes glue"});
    writeChair("chair.rubble", {"box 0,1,0 7,1,7 erase shape=seat", "box 3,0,0 7,1,7 erase shape=seat"});
    EXPECT_EQ(answerOf(editor, "reload_models"),
              "chair.rubble: 1 shape brought up to date, 1 unchanged in the file, 1 lost of their joints: screw");
    ASSERT_EQ(editor.world().get_joint_states().size(), 1u);
    const rubble_joint glue = editor.world().find_by_name(RUBBLE_KIND_JOINT, "glue").at(0);
    EXPECT_STREQ(editor.world().get_tag(glue, "old").data(), "yes");
}

TEST(Models, ThatAreGoneOrBrokenChangeNothing) {
    const ExampleFolder folder;
    writeChair("chair.rubble");
    writeChair("stool.rubble");
    Editor editor;
    runAll(editor, {"import chair.rubble", "name throne seat"});
    expectRefused(editor, "reload_models other.rubble",
                  "expected one to which shapes are linked, found 'other.rubble'");
    writeChair("chair.rubble", {"name bench seat", "voxel 0,0,0 erase shape=back"});
    EXPECT_EQ(answerOf(editor, "reload_models"),
              "chair.rubble: 1 shape brought up to date, 1 no longer in the file: throne");
    runAll(editor, {"import stool.rubble 4,0,0"});
    const auto size = fs::file_size("chair.rubble");
    fs::resize_file("chair.rubble", size / 2);
    expectRefused(editor, "reload_models chair.rubble", "chair.rubble");
    fs::remove("chair.rubble");
    expectRefused(editor, "reload_models chair.rubble", "cannot open");
    const std::string answer = answerOf(editor, "reload_models");
    EXPECT_NE(answer.find("stool.rubble: 0 shapes brought up to date, 2 unchanged in the file"), std::string::npos)
        << answer;
    EXPECT_NE(answer.find("cannot open"), std::string::npos) << answer;
    runAll(editor, {"unlink_models all"});
    expectRefused(editor, "reload_models", "expected shapes that are linked to files, found none");
    expectRefused(editor, "unlink_models all", "expected shapes that are linked to files, found none");
}

TEST(Models, StayLinkedInFilesAndInOtherFolders) {
    const ExampleFolder folder;
    fs::create_directories("models"), fs::create_directories("levels");
    writeChair("models/chair.rubble");
    Editor editor;
    runAll(editor, {"import models/chair.rubble", "duplicate 2,0,0 1 seat", "save room.rubble"});
    EXPECT_EQ(linkedFiles(editor.world()), std::vector<std::string>{"models/chair.rubble"});
    EXPECT_EQ(editor.document().done().size(), 2u);
    runAll(editor, {"save levels/room.rubble"});
    EXPECT_EQ(linkedFiles(editor.world()), std::vector<std::string>{"../models/chair.rubble"});
    EXPECT_FALSE(editor.run(std::string("save nowhere/room.rubble")).isDone);
    EXPECT_EQ(linkedFiles(editor.world()), std::vector<std::string>{"../models/chair.rubble"});
    writeChair("models/chair.rubble", kChanges);
    Editor again;
    runAll(again, {"open levels/room.rubble"});
    EXPECT_EQ(answerOf(again, "reload_models"),
              "../models/chair.rubble: 2 shapes brought up to date, 1 unchanged in the file")
        << "a duplicate is linked, too";
    fs::current_path("levels");
    runAll(again, {"open room.rubble"});
    EXPECT_EQ(answerOf(again, "reload_models"),
              "../models/chair.rubble: 2 shapes brought up to date, 1 unchanged in the file");
    fs::current_path("..");
}

TEST(Models, OfMagicaVoxelAndMeshesAreLinkedToo) {
    const ExampleFolder folder;
    const auto write = [](const char* more) {
        Editor editor;
        runAll(editor, {"create 6,6,6 name=block", more, "export block.vox", "export block.obj"});
    };
    write("voxel 0,0,0 erase shape=block");
    Editor editor({.vdbTool = RUBBLE_VDB_PROGRAM});
    runAll(editor, {"import block.vox 0,0,0 0,90,0", "import block.obj 3,0,0 voxels=12 shell=2"});
    EXPECT_EQ(linkedFiles(editor.world()), (std::vector<std::string>{"block.obj", "block.vox"}));
    write("box -1,0,0 2,2,2 index=7 shape=block");
    const std::string answer = answerOf(editor, "reload_models");
    EXPECT_NE(answer.find("block.vox: 1 shape brought up to date"), std::string::npos) << answer;
    EXPECT_NE(answer.find("block.obj: 1 shape brought up to date"), std::string::npos) << answer;
    Editor fresh({.vdbTool = RUBBLE_VDB_PROGRAM});
    runAll(fresh, {"import block.vox 0,0,0 0,90,0", "import block.obj 3,0,0 voxels=12 shell=2"});
    const auto all = editor.world().get_objects(RUBBLE_KIND_SHAPE), same = fresh.world().get_objects(RUBBLE_KIND_SHAPE);
    ASSERT_EQ(all.size(), same.size());
    expectEqualShapes(editor, all.at(0), fresh, same.at(0));
    EXPECT_EQ(editor.world().get_voxel_hash(), fresh.world().get_voxel_hash()) << "with the options of the import";
    runAll(editor, {"import block.vox 0,5,0 link=no"});
    EXPECT_EQ(editor.world().find_by_tag(RUBBLE_KIND_SHAPE, kModelTag, "block.vox").size(), 1u);
}

TEST(Models, WhoseFilesHaveChangedAreToldOfWhenALevelIsOpened) {
    const ExampleFolder folder;
    writeChair("chair.rubble"), writeChair("stool.rubble");
    fs::create_directories("levels");
    Editor editor;
    runAll(editor, {"import chair.rubble", "import chair.rubble 3,0,0", "import stool.rubble 9,0,0",
                    "save levels/room.rubble"});
    const auto opened = [&] { return answerOf(editor, "open levels/room.rubble"); };
    EXPECT_EQ(opened(), "");
    writeChair("chair.rubble");
    EXPECT_EQ(opened(), "") << "written again as it was";
    writeChair("chair.rubble", kChanges);
    const char* const one =
        "1 linked file has changed since it was read, which reload_models brings in: ../chair.rubble";
    EXPECT_EQ(opened(), one);
    EXPECT_FALSE(editor.document().isChanged());
    EXPECT_NE(answerOf(editor, "reload_models").find("2 shapes brought up to date"), std::string::npos);
    runAll(editor, {"save"});
    EXPECT_EQ(opened(), "");
    EXPECT_EQ(answerOf(editor, "reload_models"),
              "../chair.rubble: 0 shapes brought up to date, 4 unchanged in the "
              "file\n../stool.rubble: 0 shapes brought up to date, 2 unchanged in "
              "the file");
    EXPECT_FALSE(editor.document().isChanged());
}

TEST(Models, ThatAreLockedOrGoneAreNotToldOfAsChanged) {
    const ExampleFolder folder;
    writeChair("chair.rubble"), writeChair("stool.rubble"), writeChair("bench.rubble");
    Editor editor;
    runAll(editor, {"import chair.rubble", "import stool.rubble 9,0,0", "import bench.rubble -9,0,0",
                    "lock tag:model_file=bench.rubble", "save room.rubble"});
    for (const char* file : {"chair.rubble", "stool.rubble", "bench.rubble"}) writeChair(file, kChanges);
    EXPECT_EQ(answerOf(editor, "open room.rubble"),
              "2 linked files have changed since they were read, which reload_models brings in: chair.rubble, "
              "stool.rubble");
    fs::remove("chair.rubble"), fs::remove("stool.rubble");
    fs::create_directories("stool.rubble");
    EXPECT_EQ(answerOf(editor, "open room.rubble"),
              "2 linked files cannot be read, so that what came from there stays as it is: chair.rubble, stool.rubble");
    Session session(editor);
    fs::remove("stool.rubble");
    writeChair("stool.rubble", kChanges);
    EXPECT_TRUE(session.run(std::string("open room.rubble")));
    std::string told;
    for (const Message& each : session.messages()) told += each.text + "\n";
    EXPECT_NE(told.find("1 linked file has changed since it was read"), std::string::npos) << told;
    EXPECT_NE(told.find("1 linked file cannot be read"), std::string::npos) << told;
}

TEST(Models, OfLevelsThatDoNotKnowTheirFilesAreReadAsBefore) {
    const ExampleFolder folder;
    writeChair("chair.rubble");
    Editor editor;
    runAll(editor, {"import chair.rubble"});
    for (const rubble_shape shape : editor.world().get_objects(RUBBLE_KIND_SHAPE)) {
        std::string link = editor.world().get_tag(shape, "model_link").data();
        link.erase(16, 17);
        EXPECT_EQ(link[16], ' ');
        editor.world().set_tag(shape, "model_link", link.c_str());
    }
    editor.world().apply_edits();
    runAll(editor, {"save room.rubble"});
    writeChair("chair.rubble", kChanges);
    EXPECT_EQ(answerOf(editor, "open room.rubble"), "");
    EXPECT_EQ(answerOf(editor, "reload_models"), "chair.rubble: 1 shape brought up to date, 1 unchanged in the file");
    runAll(editor, {"save"});
    writeChair("chair.rubble");
    EXPECT_NE(answerOf(editor, "open room.rubble"), "");
}

TEST(Models, AreWatchedByTheWindow) {
    const ExampleFolder folder;
    writeChair("chair.rubble");
    Editor editor;
    Session session(editor);
    ModelWatch watch;
    double time = 0.0;
    const auto looks = [&](int times) {
        int done = 0;
        for (int i = 0; i < times; ++i) done += watch.poll(session, time += 1.0);
        return done;
    };
    session.run(std::string("import chair.rubble"));
    EXPECT_EQ(looks(3), 0);
    EXPECT_TRUE(watch.isWatching());
    const uint64_t before = editor.document().hash();
    writeChair("chair.rubble", kChanges);
    EXPECT_EQ(looks(1), 0) << "it may still be written";
    EXPECT_EQ(looks(3), 1);
    EXPECT_EQ(editor.document().done().back(), "reload_models file=chair.rubble");
    EXPECT_NE(editor.document().hash(), before);
    session.run(std::string("undo"));
    EXPECT_EQ(editor.document().hash(), before);
    EXPECT_EQ(looks(3), 0) << "what was taken back stays so until the file changes again";
    fs::resize_file("chair.rubble", 100);
    EXPECT_EQ(looks(5), 1) << "it says once that it cannot be read";
    EXPECT_EQ(session.messages().back().kind, Message::Kind::Error);
    fs::remove("chair.rubble");
    EXPECT_EQ(looks(5), 1);
    EXPECT_NE(session.messages().back().text.find("chair.rubble is gone"), std::string::npos);
    EXPECT_EQ(editor.document().hash(), before);
    session.run(std::string("play"));
    writeChair("chair.rubble", kChanges);
    EXPECT_EQ(looks(5), 0) << "not in play";
    session.run(std::string("stop"));
    EXPECT_EQ(looks(5), 1);
    EXPECT_NE(editor.document().hash(), before);
    session.run(std::string("unlink_models all"));
    looks(1);
    EXPECT_FALSE(watch.isWatching());
}

TEST(Session, AnErrorBringsTheMessagesToTheFront) {
    Editor editor;
    Session session(editor);
    ASSERT_TRUE(session.run("create", {{"size", "4,4,4"}}));
    EXPECT_EQ(session.tabs.bottom, "History");
    EXPECT_FALSE(session.run("save", {{"file", "/nowhere/at/all.rubble"}}));
    EXPECT_EQ(session.tabs.bottom, "Messages");
    EXPECT_TRUE(session.tabs.isAsked);
}

}  // namespace
}  // namespace editor
