// Shapes whose files have grown: they stand where a fresh import puts them, and wheels turn about their middle.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "editor/core/joints.h"
#include "editor/core/models.h"
#include "editor/core/rotation.h"
#include "tests/editor/mesh_files.h"
#include "tests/editor/model_level.h"
#include "tests/runtime/assets/vox_writer.h"

namespace editor {
namespace {

using Voxels = std::vector<std::array<uint8_t, 4>>;

void writeBytes(const char* file, const rubble::VoxWriter::Bytes& bytes) {
    std::ofstream(file, std::ios::binary).write(reinterpret_cast<const char*>(bytes.data()), long(bytes.size()));
}

/// A disc about x, in the axes of MagicaVoxel, whose z is up.
Voxels discOf(int thick, int across) {
    Voxels voxels;
    for (int z = 0; z < across; ++z)
        for (int y = 0; y < across; ++y)
            for (int x = 0; x < thick; ++x)
                if (std::hypot(y + 0.5 - across * 0.5, z + 0.5 - across * 0.5) < across * 0.5)
                    voxels.push_back({uint8_t(x), uint8_t(y), uint8_t(z), 9});
    return voxels;
}

/// A file of one model without nodes: it stands on its origin.
void writeDisc(const char* file, int thick, int across) {
    writeBytes(file, rubble::VoxWriter().model({thick, across, across}, discOf(thick, across)).file());
}

/// Two models in nodes, which are about their places; the second one is turned by a right angle.
void writePair(const char* file, int first, int second) {
    rubble::VoxWriter out;
    for (const int across : {first, second}) out.model({3, across, across}, discOf(3, across));
    out.transform(0, 1, {{}}).group(1, {2, 4});
    out.transform(2, 3, {{{"_t", "0 0 20"}}}, {{"_name", "one"}}).shape(3, {0});
    out.transform(4, 5, {{{"_t", "-9 30 7"}, {"_r", "17"}}}, {{"_name", "two"}}).shape(5, {1});
    writeBytes(file, out.file());
}

/// All shapes of a level equal those of another one, in their order.
void expectEqualLevels(Editor& a, Editor& b) {
    const auto shapes = a.world().get_objects(RUBBLE_KIND_SHAPE), others = b.world().get_objects(RUBBLE_KIND_SHAPE);
    ASSERT_EQ(shapes.size(), others.size());
    for (size_t i = 0; i < shapes.size(); ++i) expectEqualShapes(a, shapes[i], b, others[i]);
}

/// Imports, in any place and turn, and moves what has come in.
void importAndMove(Editor& editor, const char* file, const char* name) {
    const std::string import = fmt::format("import {} ", file);
    for (const char* place : {"0,0,0", "1,2,3 30,40,50", "-7,1,0 0,90,0"}) answerOf(editor, import + place);
    answerOf(editor, import + "4,0,9 0,0,45");
    for (const char* move : {"move 0.33,1,-2 ", "rotate 20,0,70 about=1,1,1 what="})
        answerOf(editor, move + std::string(name));
}

TEST(ModelSizes, PutVoxelModelsWhereAFreshImportDoes) {
    const ExampleFolder folder;
    for (const int size : {12, 11, 5, 1}) {
        writeDisc("disc.vox", 3, 8), writePair("pair.vox", 8, 7);
        Editor editor, fresh;
        importAndMove(editor, "disc.vox", "selected"), importAndMove(editor, "pair.vox", "selected");
        runAll(editor, {"duplicate 0,5,0 2 selected"});
        const uint64_t before = editor.document().hash();
        writeDisc("disc.vox", 3, size), writePair("pair.vox", size, size + 5);
        answerOf(editor, "reload_models");
        importAndMove(fresh, "disc.vox", "selected"), importAndMove(fresh, "pair.vox", "selected");
        runAll(fresh, {"duplicate 0,5,0 2 selected"});
        expectEqualLevels(editor, fresh);
        runAll(editor, {"undo"});
        EXPECT_EQ(editor.document().hash(), before);
    }
}

TEST(ModelSizes, PutMeshesWithinHalfACellWithoutDrift) {
    const ExampleFolder folder;
    const auto write = [](double low) {
        writeObj(
            "block.obj",
            {{{low, low, 0}, {1, low, 0}, {1, 1, 0}, {low, 1, 0}, {low, low, 1}, {1, low, 1}, {1, 1, 1}, {low, 1, 1}},
             {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 4, 7, 3}, {1, 2, 6, 5}},
             {}});
    };
    write(0.0);
    const char* const import = "import block.obj 5,0,0 0,30,0 voxels=0";
    Editor editor({.vdbTool = RUBBLE_VDB_PROGRAM});
    runAll(editor, {import});
    for (int i = 1; i <= 8; ++i) {
        write(-0.04 * i);
        answerOf(editor, "reload_models");
        Editor fresh({.vdbTool = RUBBLE_VDB_PROGRAM});
        runAll(fresh, {import});
        const auto cornerOf = [](Editor& level) {
            return vectorOf(level.world().get_shape_state(level.world().get_objects(RUBBLE_KIND_SHAPE).at(0)).position);
        };
        const glm::dvec3 off = glm::inverse(rotationOf({0, 30, 0})) * (cornerOf(editor) - cornerOf(fresh));
        for (int a = 0; a < 3; ++a) EXPECT_LT(std::abs(off[a]), 0.051) << i;
        EXPECT_EQ(editor.world().get_voxel_hash(), fresh.world().get_voxel_hash());
    }
}

/// A car on wheels from a file, which may be turned as a whole; the last line comes before the wheels are put on.
void makeLinkedCar(Editor& editor, const char* before) {
    runAll(editor, {"create 200,2,400 0,-0.2,0 index=6 name=ground static=yes", "create 14,3,28 0,0.3,0 name=car"});
    int number = 0;
    for (const char* place : {"0.9,0,0.9", "-0.9,0,0.9", "0.9,0,-0.9", "-0.9,0,-0.9"}) {
        const std::string name = fmt::format("w{}", ++number);
        answerOf(editor, fmt::format("import disc.vox {}", place));
        answerOf(editor, fmt::format("name {} selected", name));
        answerOf(editor, "hold no");
    }
    runAll(editor, {before});
    for (int i = 1; i <= 4; ++i) {
        answerOf(editor, fmt::format("wheel car w{} steer=20 name=axle{}", i, i));
        answerOf(editor, fmt::format("tag side {} axle{}", i, i));
    }
}

/// How far an axle passes its wheel's middle, in metres.
double axleOffset(Editor& editor, const char* joint, const char* wheel) {
    const rubble::World& world = editor.world();
    const rubble_joint handle = world.find_by_name(RUBBLE_KIND_JOINT, joint).at(0);
    const rubble_shape_state shape = world.get_shape_state(shapeOf(editor, wheel));
    const Cells solid = solidOf(world, shape.shape);
    const glm::dvec3 middle = vectorOf(shape.position) + quaternionOf(shape.rotation) *
                                                             (glm::dvec3(2 * solid.low + solid.size) * 0.5) *
                                                             shape.voxel_size;
    const rubble_joint_settings settings = settingsOf(world, handle);
    const glm::dvec3 axis = quaternionOf(settings.rotation) * glm::dvec3(1, 0, 0);
    return glm::length(glm::cross(axis, vectorOf(settings.position) - middle));
}

TEST(ModelSizes, LetWheelsTurnAboutTheirMiddle) {
    const ExampleFolder folder;
    const auto drive = [](Editor& editor) {
        runAll(editor, {"play", "step 30", "drive 0.5 what=car", "step 90"});
        const rubble_body car = editor.world().find_by_name(RUBBLE_KIND_BODY, "car").at(0);
        const glm::dvec3 place = vectorOf(editor.world().get_body_state(car).position);
        runAll(editor, {"stop"});
        return place;
    };
    for (const int size : {12, 11, 24, 5}) {
        writeDisc("disc.vox", 3, 8);
        Editor editor, fresh;
        makeLinkedCar(editor, "select all");
        runAll(editor, {"select axle1"});
        const uint64_t before = editor.document().hash();
        writeDisc("disc.vox", 4, size);
        EXPECT_EQ(answerOf(editor, "reload_models"), "disc.vox: 4 shapes brought up to date");
        const uint64_t after = editor.document().hash();
        EXPECT_EQ(editor.world().get_joint_states().size(), 4u);
        for (int i = 1; i <= 4; ++i)
            EXPECT_LT(axleOffset(editor, fmt::format("axle{}", i).c_str(), fmt::format("w{}", i).c_str()), 1e-6);
        const rubble_joint axle = editor.world().find_by_name(RUBBLE_KIND_JOINT, "axle3").at(0);
        EXPECT_STREQ(editor.world().get_tag(axle, "side").data(), "3");
        EXPECT_EQ(editor.selection().objects, editor.world().find_by_name(RUBBLE_KIND_JOINT, "axle1"));
        if (size < 20) {  // a fresh axle would look for its voxels in a smaller ball
            makeLinkedCar(fresh, "select all");
            EXPECT_LT(glm::length(drive(editor) - drive(fresh)), 0.05) << size;
        }
        EXPECT_EQ(editor.document().hash(), after);
        runAll(editor, {"undo"});
        EXPECT_EQ(editor.document().hash(), before);
        runAll(editor, {"redo"});
        EXPECT_EQ(editor.document().hash(), after);
    }
}

TEST(ModelSizes, LeaveAxlesAloneThatAreBesideTheMiddle) {
    const ExampleFolder folder;
    writeDisc("disc.vox", 3, 8);
    Editor editor;
    makeLinkedCar(editor, "wheel car w1 at=0.9,0.6,0.9 name=crank");
    runAll(editor, {"rotate 10,60,20 about=0,0,0 what=car,w1,w2,w3,w4"});
    const glm::dvec3 before =
        vectorOf(settingsOf(editor.world(), editor.world().find_by_name(RUBBLE_KIND_JOINT, "crank").at(0)).position);
    writeDisc("disc.vox", 3, 12);
    answerOf(editor, "reload_models");
    const glm::dvec3 after =
        vectorOf(settingsOf(editor.world(), editor.world().find_by_name(RUBBLE_KIND_JOINT, "crank").at(0)).position);
    EXPECT_LT(glm::length(after - before), 1e-6);
    EXPECT_LT(axleOffset(editor, "axle1", "w1"), 1e-6);
}

TEST(ModelSizes, CountVoxelsNotTheGridWhereAWheelHasItsAxle) {
    Editor editor;
    runAll(editor, {"create 14,3,28 0,0.3,0 name=car", "create 3,8,8 0.9,0,0.9 form=cylinder_x name=disc",
                    "resize 0,0,-5 3,12,13 disc", "wheel car disc name=axle"});
    EXPECT_LT(axleOffset(editor, "axle", "disc"), 1e-6) << "it rolls about the middle of its voxels";
}

}  // namespace
}  // namespace editor
