#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "generated/paths.h"
#include "runtime/assets/assets.h"
#include "runtime/assets/file_bytes.h"
#include "runtime/core/constants.h"
#include "tests/runtime/assets/sample_level.h"
#include "tests/runtime/assets/vdb/third_party_vdb.h"
#include "tests/support/file_size_limit.h"
#include "tests/support/models.h"
#include "tests/support/temp_folder.h"

namespace rubble {
namespace {

namespace fs = std::filesystem;
const std::string kTool = RUBBLE_BINARY_DIR "/bin/rubble-vdb";

class VdbFile : public testing::Test {
protected:
    std::string path(const std::string& name) const { return m_folder / name; }

    /// The level of a file as another program writes it; see writeThirdPartyVdb().
    Result<Level> readThirdParty(const std::string& kind, ImportReport* report = nullptr) const {
        writeThirdPartyVdb(kind, path("foreign.vdb"));
        ImportReport unused;
        return readVdb(path("foreign.vdb"), kTool, report ? report : &unused);
    }

    TempFolder m_folder;
};

std::string notes(const ImportReport& report) {
    std::string all;
    for (const std::string& line : report.lines) all += line + "\n";
    return all;
}

TEST_F(VdbFile, RoundTripKeepsTheHash) {
    const Level level = sampleLevel();
    const Result<Done> done = writeVdb(path("a.vdb"), level, kTool);
    ASSERT_TRUE(done) << done.error();
    ImportReport report;
    const Result<Level> back = readVdb(path("a.vdb"), kTool, &report);
    ASSERT_TRUE(back) << back.error();
    EXPECT_EQ(hashLevel(*back), hashLevel(level));
    EXPECT_EQ(notes(report), "");
    EXPECT_EQ(std::distance(fs::directory_iterator(m_folder.path()), fs::directory_iterator()), 1)
        << "no temporary files stay";
}

TEST_F(VdbFile, ShapesWhoseNamesAreAlikeKeepTheirGrids) {
    Level level = sampleLevel();
    const LevelBody body = level.bodies.front();
    for (const char* name : {"shape", "shape 2", "", "shape_2", "", "shape 2"}) {
        level.bodies.push_back(body);
        level.bodies.back().name = name;
        for (LevelShape& shape : level.bodies.back().shapes) shape.name = name;
    }
    const Result<Done> done = writeVdb(path("a.vdb"), level, kTool);
    ASSERT_TRUE(done) << done.error();
    const Result<Level> back = readVdb(path("a.vdb"), kTool);
    ASSERT_TRUE(back) << back.error();
    EXPECT_EQ(hashLevel(*back), hashLevel(level));
}

TEST_F(VdbFile, StrengthAndLoadBearingAreKeptAndHaveDefaults) {
    ASSERT_TRUE(writeVdb(path("a.vdb"), sampleLevel(), kTool));
    const auto lantern = [&] {
        const Result<Level> back = readVdb(path("a.vdb"), kTool);
        EXPECT_TRUE(back) << back.error();
        return back ? back->bodies[0].shapes[1] : LevelShape{};
    };
    EXPECT_EQ(lantern().strength, 0.75f);
    EXPECT_FALSE(lantern().loadBearing);
    removeField(path("a.vdb"), "strength");
    EXPECT_EQ(lantern().strength, 1.0f);
    EXPECT_FALSE(lantern().loadBearing);
    removeField(path("a.vdb"), "bears_load");
    EXPECT_TRUE(lantern().loadBearing);
    EXPECT_EQ(lantern().voxelSize, 0.05f);
    EXPECT_EQ(lantern().anchors, kNoAnchors);
}

TEST_F(VdbFile, RoundTripOfARealScene) {
    const std::string model = modelPath("test_multiple_model_scene.vox");
    RUBBLE_REQUIRE_MODELS(model);
    const Result<Level> level = importVox(model, {});
    ASSERT_TRUE(level) << level.error();
    ASSERT_TRUE(writeVdb(path("scene.vdb"), *level, kTool));
    const Result<Level> back = readLevel(path("scene.vdb"), kTool);
    ASSERT_TRUE(back) << back.error();
    EXPECT_EQ(hashLevel(*back), hashLevel(*level));
}

TEST_F(VdbFile, VdbPrintListsTheGrids) {
    if (std::system("command -v vdb_print >/dev/null") != 0)
        GTEST_SKIP() << "vdb_print is not installed (libopenvdb-tools)";
    ASSERT_TRUE(writeVdb(path("a.vdb"), sampleLevel(), kTool));
    ASSERT_EQ(std::system(("vdb_print " + path("a.vdb") + " > " + path("list.txt")).c_str()), 0);
    const auto bytes = readFileBytes(path("list.txt"), 1 << 20);
    ASSERT_TRUE(bytes);
    const std::string list(bytes->begin(), bytes->end());
    for (const char* grid : {"walls_north.palette_index", "walls_north.density", "walls_north.color",
                             "lantern.emission", "lantern.light_group", "lantern_2.palette_index"})
        EXPECT_NE(list.find(grid), std::string::npos) << grid << " is not in\n" << list;
}

TEST_F(VdbFile, BlenderListsTheGrids) {
    if (std::system("command -v blender >/dev/null") != 0) GTEST_SKIP() << "blender is not installed";
    ASSERT_TRUE(writeVdb(path("a.vdb"), sampleLevel(), kTool));
    std::ofstream(path("list.py"))
        << "import bpy\nv = bpy.data.volumes.new('v')\nv.filepath = r'" << path("a.vdb")
        << "'\nv.grids.load()\nprint('GRIDS', sorted((g.name, g.data_type) for g in v.grids))\n";
    ASSERT_EQ(std::system(
                  ("blender -b --factory-startup -P " + path("list.py") + " > " + path("list.txt") + " 2>&1").c_str()),
              0);
    const auto bytes = readFileBytes(path("list.txt"), 1 << 20);
    ASSERT_TRUE(bytes);
    const std::string list(bytes->begin(), bytes->end());
    EXPECT_NE(list.find("('walls_north.density', 'FLOAT')"), std::string::npos) << list;
    EXPECT_NE(list.find("('walls_north.palette_index', 'INT')"), std::string::npos) << list;
}

/// By Python of the system, which has pyopenvdb where python3-openvdb is installed, or by that of Blender, which has it
/// in the builds of its makers.
TEST_F(VdbFile, ALevelSetByPyOpenVdbIsABall) {
    std::ofstream(path("ball.py")) << "import pyopenvdb as vdb\n"
                                      "ball = vdb.createLevelSetSphere(radius=2.0, center=(0, 5, 0), voxelSize=0.1)\n"
                                      "ball.name = 'ball'\nvdb.write(r'"
                                   << path("ball.vdb") << "', grids=[ball])\n";
    bool isWritten = false;
    for (const std::string python : {"python3 ", "/usr/bin/python3 ", "blender -b --factory-startup -P "})
        if (!isWritten) {
            std::system((python + path("ball.py") + " > " + path("log.txt") + " 2>&1").c_str());
            isWritten = fs::exists(path("ball.vdb"));
        }
    if (!isWritten) GTEST_SKIP() << "neither python3 nor blender has pyopenvdb (python3-openvdb)";
    const Result<Level> level = readLevel(path("ball.vdb"), kTool);
    ASSERT_TRUE(level) << level.error();
    ASSERT_EQ(level->bodies.size(), 1u);
    const LevelShape& shape = level->bodies[0].shapes.at(0);
    EXPECT_EQ(shape.name, "ball");
    EXPECT_NEAR(shape.voxelSize, 0.1f, 1e-6f);
    const double cells = 4.0 / 3.0 * kPi * std::pow(20.0, 3);
    EXPECT_NEAR(double(shape.grid.voxelCount()), cells, 0.01 * cells);
    const Pose corner = level->bodies[0].pose * shape.local;
    const glm::dvec3 middle = corner.position + corner.rotation * (glm::dvec3(shape.grid.size()) * 0.05);
    EXPECT_NEAR(glm::length(middle - glm::dvec3(0.0, 5.0, 0.0)), 0.0, 0.1);
}

TEST_F(VdbFile, BoolGridsAreOccupancy) {
    const Result<Level> level = readThirdParty("bool");
    ASSERT_TRUE(level) << level.error();
    ASSERT_EQ(level->bodies.size(), 1u);
    const LevelShape& shape = level->bodies[0].shapes.at(0);
    EXPECT_EQ(shape.name, "blob");
    EXPECT_EQ(shape.grid.voxelCount(), 3u);
    EXPECT_EQ(shape.grid.size(), glm::ivec3(9, 3, 3));
    EXPECT_EQ(int(shape.grid.at({8, 2, 2})), 1);
    EXPECT_FLOAT_EQ(shape.voxelSize, 0.25f);
    // In OpenVDB cell centres lie at whole indices: the minimum corner of cell -5 is at -5.5.
    EXPECT_EQ(level->bodies[0].pose.position, glm::dvec3(-5.5, -0.5, -0.5) * 0.25);
    EXPECT_NE((*shape.palette)[1].material, 0);
}

TEST_F(VdbFile, GridsOfUnknownTypesAreSkipped) {
    ImportReport report;
    const Result<Level> level = readThirdParty("odd type", &report);
    ASSERT_TRUE(level) << level.error();
    EXPECT_EQ(level->bodies.size(), 1u);
    EXPECT_NE(notes(report).find("'bytes': type Tree_uint8_5_4_3"), std::string::npos) << notes(report);
}

TEST_F(VdbFile, TilesAreExpanded) {
    const Result<Level> level = readThirdParty("mask tile");
    ASSERT_TRUE(level) << level.error();
    EXPECT_EQ(level->bodies.at(0).shapes.at(0).grid.voxelCount(), 128u * 128 * 128);
}

TEST_F(VdbFile, LevelSetsAreFilled) {
    const Result<Level> level = readThirdParty("level set");
    ASSERT_TRUE(level) << level.error();
    const double expected = 4.0 / 3.0 * kPi * 8.0 / 0.001;
    EXPECT_NEAR(double(level->bodies.at(0).shapes.at(0).grid.voxelCount()), expected, expected * 0.01);
}

TEST_F(VdbFile, FogVolumesAreSolidFromHalfDensity) {
    ImportReport report;
    const Result<Level> level = readThirdParty("fog", &report);
    ASSERT_TRUE(level) << level.error();
    ASSERT_EQ(level->bodies.size(), 1u) << "other channels become no shapes";
    const LevelShape& shape = level->bodies[0].shapes.at(0);
    EXPECT_EQ(shape.name, "foreign");
    EXPECT_EQ(shape.grid.voxelCount(), 500u);
    const PaletteEntry &blue = (*shape.palette)[shape.grid.at({1, 0, 0})],
                       &red = (*shape.palette)[shape.grid.at({2, 0, 0})];
    EXPECT_EQ(int(blue.blue), 255);
    EXPECT_EQ(int(blue.red), 0);
    EXPECT_EQ(int(red.red), 255);
    EXPECT_NE(notes(report).find("'temperature'"), std::string::npos) << notes(report);
    EXPECT_NE(notes(report).find("'odd'"), std::string::npos) << notes(report);
}

TEST_F(VdbFile, PaletteIndexWithoutMetadata) {
    const Result<Level> level = readThirdParty("indices");
    ASSERT_TRUE(level) << level.error();
    const LevelShape& shape = level->bodies.at(0).shapes.at(0);
    EXPECT_EQ(shape.name, "door");
    EXPECT_EQ(shape.grid.voxelCount(), 4u);
    EXPECT_EQ(int(shape.grid.at({1, 1, 0})), 255);
}

TEST_F(VdbFile, RotatedGridsKeepTheirPosition) {
    const Result<Level> level = readThirdParty("turned");
    ASSERT_TRUE(level) << level.error();
    const LevelBody& body = level->bodies.at(0);
    // OpenVDB multiplies row vectors: the rotation takes x to (cos, 0, -sin).
    const glm::dvec3 index(3, 2, 1);
    const glm::dvec3 turned(std::cos(0.7) * index.x + std::sin(0.7) * index.z, index.y,
                            -std::sin(0.7) * index.x + std::cos(0.7) * index.z);
    const glm::dvec3 expected = turned * 0.1 + glm::dvec3(5, 6, 7);
    const glm::dvec3 centre =
        body.pose.transformPoint((glm::dvec3(8, 2, 1) + 0.5) * 0.1);  // of the same cell in the shape
    EXPECT_LT(glm::length(centre - expected), 1e-6) << centre.x << " " << centre.y << " " << centre.z;
}

TEST_F(VdbFile, InvalidGridsAreRefusedWithAReason) {
    const auto error = [&](const char* kind) {
        const Result<Level> level = readThirdParty(kind);
        return level ? "no error" : level.error();
    };
    EXPECT_NE(error("stretched").find("cubic cells, found stretched"), std::string::npos) << error("stretched");
    EXPECT_NE(error("far away").find("found 1000000000000"), std::string::npos) << error("far away");
    EXPECT_NE(error("huge box").find("at most 4096 cells on a side"), std::string::npos) << error("huge box");
    EXPECT_NE(error("huge tile").find("voxels"), std::string::npos) << error("huge tile");
    EXPECT_NE(error("wrong index").find("found 300"), std::string::npos) << error("wrong index");
    EXPECT_NE(error("deep list").find("expected at most 64 nested lists and objects, found 100000"), std::string::npos)
        << error("deep list");
}

TEST_F(VdbFile, DamagedFilesCrashAtMostTheChildProcess) {
    ASSERT_TRUE(writeVdb(path("a.vdb"), sampleLevel(), kTool));
    const std::vector<uint8_t> whole = *readFileBytes(path("a.vdb"), 1 << 24);
    const auto read = [&](const std::vector<uint8_t>& bytes) {
        std::ofstream(path("b.vdb"), std::ios::binary)
            .write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
        ImportReport report;
        return readVdb(path("b.vdb"), kTool, &report);
    };
    for (size_t part : {0, 5, 11, 60, 90}) {
        const Result<Level> level = read({whole.begin(), whole.begin() + std::ptrdiff_t(whole.size() * part / 100)});
        ASSERT_FALSE(level) << part;
        EXPECT_NE(level.error().find("b.vdb: byte "), std::string::npos) << level.error();
        EXPECT_NE(level.error().find("expected"), std::string::npos) << level.error();
    }
    EXPECT_FALSE(read(std::vector<uint8_t>(100000, 0xa5)));
    uint32_t state = 1;
    for (int round = 0; round < 25; ++round) {  // the child may crash: the caller gets a level or an error
        std::vector<uint8_t> bytes = whole;
        for (int i = 0; i < 8; ++i) {
            state = state * 1664525u + 1013904223u;
            bytes[200 + (state >> 8) % (bytes.size() - 200)] ^= uint8_t(1u << (state & 7));
        }
        const Result<Level> level = read(bytes);
        if (level) continue;
        EXPECT_NE(level.error().find("b.vdb"), std::string::npos) << level.error();
    }
}

TEST_F(VdbFile, OnAFullDiskTheOldFileStays) {
    const std::vector<uint8_t> before(5000, 7);
    ASSERT_TRUE(writeFileAtomically(path("good.vdb"), before, before.size()));
    ASSERT_TRUE(writeRubble(path("a.rubble"), sampleLevel()));
    const FileSizeLimit limit(1000);
    EXPECT_NE(std::system((kTool + " to-vdb " + path("a.rubble") + " " + path("good.vdb")).c_str()), 0);
    EXPECT_EQ(*readFileBytes(path("good.vdb"), 1 << 24), before);
    EXPECT_EQ(std::distance(fs::directory_iterator(m_folder.path()), fs::directory_iterator()), 2);
}

TEST_F(VdbFile, TheProgramNeverWritesAFileOfTheOtherKind) {
    ASSERT_TRUE(writeRubble(path("a.rubble"), sampleLevel()));
    ASSERT_TRUE(writeVdb(path("a.vdb"), sampleLevel(), kTool));
    for (const auto& [command, file] : {std::pair{"to-vdb", "a.rubble"}, std::pair{"to-rubble", "a.vdb"}}) {
        const std::vector<uint8_t> before = *readFileBytes(path(file), 1 << 24);
        EXPECT_NE(std::system((kTool + " " + command + " " + path(file) + " " + path(file)).c_str()), 0);
        EXPECT_EQ(*readFileBytes(path(file), 1 << 24), before);
    }
}

TEST_F(VdbFile, TheChildProcessIsLimited) {
    const auto script = [&](const char* name, const char* text) {
        std::ofstream(path(name)) << "#!/bin/sh\n" << text << "\n";
        fs::permissions(path(name), fs::perms::owner_all);
        return path(name);
    };
    setenv("RUBBLE_VDB_SECONDS", "1", 1);
    const Result<Level> slow = readVdb(path("a.vdb"), script("slow", "exec sleep 60"));
    unsetenv("RUBBLE_VDB_SECONDS");
    ASSERT_FALSE(slow);
    EXPECT_NE(slow.error().find("stopped after 1 s"), std::string::npos) << slow.error();
    const Result<Level> crash = readVdb(path("a.vdb"), script("crash", "kill -SEGV $$"));
    ASSERT_FALSE(crash);
    EXPECT_NE(crash.error().find("killed by signal 11"), std::string::npos) << crash.error();
    const Result<Level> missing = readVdb(path("a.vdb"), "/no/such/tool");
    ASSERT_FALSE(missing);
    EXPECT_NE(missing.error().find("/no/such/tool"), std::string::npos) << missing.error();
    EXPECT_NE(readVdb("/no/such.vdb", kTool).error().find("/no/such.vdb"), std::string::npos);
}

}  // namespace
}  // namespace rubble
