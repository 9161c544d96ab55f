// What is written for other programs holds the voxels: the volume within its faces is theirs.
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "editor/core/mesh_export.h"
#include "tests/editor/editor_level.h"

namespace editor {
namespace {

std::string readFile(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Of the cone from the origin over a triangle; those of a closed mesh add up to its volume.
double volumeOf(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
    return glm::dot(a, glm::cross(b, c)) / 6.0;
}

/// A crate with a bite, and a turned wall with another colour in it: 0.1 m voxels.
void makeModel(Editor& editor) {
    runAll(editor, {"create 10,12,14 1,2,3 name=crate index=5", "sphere 0,0,0 5 erase shape=crate",
                    "create 20,9,3 0,5,0 turn=10,20,30 name=\"a wall\" index=7",
                    "box 3,3,0 9,6,2 paint 9 shape=\"a wall\"", "entry 9 color=#ff8000 shape=\"a wall\""});
}

double voxelVolume(Editor& editor) {
    return double(editor.world().get_voxel_accounting().standing) * 0.001;
}

TEST(Export, AnObjFileHasTheVolumeAndColoursOfTheVoxels) {
    rubble::TempFolder folder;
    Editor editor;
    makeModel(editor);
    runAll(editor, {("export " + (folder / "model.obj")).c_str()});
    std::istringstream in(readFile(folder / "model.obj"));
    std::vector<glm::dvec3> vertices;
    double volume = 0.0;
    int objects = 0, orange = 0;
    for (std::string line, kind; std::getline(in, line);) {
        std::istringstream words(line);
        words >> kind;
        objects += kind == "o";
        if (kind == "v") {
            glm::dvec3 at, color;
            words >> at.x >> at.y >> at.z >> color.x >> color.y >> color.z;
            vertices.push_back(at);
            orange += glm::length(color - glm::dvec3(1.0, 128.0 / 255.0, 0.0)) < 1e-3;
        }
        if (kind != "f") continue;
        std::array<size_t, 4> corner{};
        for (size_t& each : corner) words >> each;
        const auto at = [&](size_t i) { return vertices.at(corner[i] - 1); };
        volume += volumeOf(at(0), at(1), at(2)) + volumeOf(at(0), at(2), at(3));
    }
    EXPECT_EQ(objects, 2);
    EXPECT_GE(orange, 8);
    EXPECT_NEAR(volume, voxelVolume(editor), 1e-4 * volume);
}

TEST(Export, AGlbFileHasTheVolumeOfTheVoxels) {
    rubble::TempFolder folder;
    Editor editor;
    makeModel(editor);
    runAll(editor, {("export " + (folder / "model.glb")).c_str()});
    const std::string bytes = readFile(folder / "model.glb");
    const auto wordAt = [&](size_t at) {
        uint32_t word = 0;
        std::memcpy(&word, bytes.data() + at, sizeof word);
        return word;
    };
    ASSERT_GT(bytes.size(), 28u);
    EXPECT_EQ(bytes.substr(0, 4), "glTF");
    EXPECT_EQ(wordAt(8), bytes.size());
    const uint32_t size = wordAt(12);
    const nlohmann::json json = nlohmann::json::parse(bytes.substr(20, size));
    const size_t buffer = 20 + size + 8;
    EXPECT_EQ(wordAt(20 + size), bytes.size() - buffer);
    EXPECT_EQ(json["nodes"].size(), 2u);
    EXPECT_EQ(json["nodes"][1]["name"], "a wall");
    double volume = 0.0;
    for (const auto& mesh : json["meshes"])
        for (const auto& primitive : mesh["primitives"]) {
            const auto beginOf = [&](size_t accessor) {
                return buffer +
                       json["bufferViews"][json["accessors"][accessor]["bufferView"].get<size_t>()]["byteOffset"]
                           .get<size_t>();
            };
            const size_t points = beginOf(primitive["attributes"]["POSITION"]), first = beginOf(primitive["indices"]);
            const auto vertex = [&](size_t i) {
                float at[3];
                std::memcpy(at, bytes.data() + points + 12 * wordAt(first + 4 * i), sizeof at);
                return glm::dvec3(at[0], at[1], at[2]);
            };
            const size_t count = json["accessors"][primitive["indices"].get<size_t>()]["count"];
            for (size_t i = 0; i < count; i += 3) volume += volumeOf(vertex(i), vertex(i + 1), vertex(i + 2));
        }
    EXPECT_NEAR(volume, voxelVolume(editor), 1e-4 * volume);
}

TEST(Export, AVoxFileIsThatOfTheImport) {
    rubble::TempFolder folder;
    Editor editor, again;
    runAll(editor, {"create 10,12,14 1,2,3 name=crate index=5", "sphere 0,0,0 5 erase shape=crate", "trim crate",
                    ("export " + (folder / "model.vox")).c_str()});
    EXPECT_TRUE(editor.document().isChanged()) << "a copy is no save";
    runAll(again, {("open " + (folder / "model.vox")).c_str()});
    EXPECT_EQ(again.world().get_voxel_accounting().standing, editor.world().get_voxel_accounting().standing);
    const Outcome refused = editor.run("export " + (folder / "model.vox") + " crate");
    EXPECT_FALSE(refused.isDone);
}

TEST(Export, AVoxFileTellsWhatItCannotHold) {
    rubble::TempFolder folder;
    Editor editor;
    const std::string line = "export " + (folder / "l.vox");
    const Outcome empty = editor.run(line);
    EXPECT_FALSE(empty.isDone) << "it could not be opened";
    EXPECT_NE(empty.text.find("expected a shape with voxels, found none"), std::string::npos) << empty.text;
    runAll(editor, {"create 4,4,4 name=c", "light sphere 0,5,0", "tag a b c", "shape c strength=3"});
    const Outcome outcome = editor.run(line);
    EXPECT_TRUE(outcome.isDone);
    for (const char* lost : {"1 light", "1 object: their tags", "1 shape: their strength"})
        EXPECT_NE(outcome.text.find(lost), std::string::npos) << lost << " in: " << outcome.text;
}

TEST(Export, TellsWhereItCannotBeWritten) {
    Editor editor;
    runAll(editor, {"create 4,4,4"});
    const Outcome outcome = editor.run(std::string("export no_such_folder/model.obj"));
    EXPECT_FALSE(outcome.isDone);
    EXPECT_NE(outcome.text.find("no_such_folder/model.obj: cannot open"), outcome.text.npos) << outcome.text;
    EXPECT_FALSE(editor.run(std::string("export model.stl")).isDone);
}

}  // namespace
}  // namespace editor
