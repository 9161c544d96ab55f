// Meshes that become voxels: volumes, colours, leaks, and files that are damaged.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>
#include <sstream>

#include "editor/core/cells.h"
#include "editor/core/palette.h"
#include "tests/editor/editor_level.h"
#include "tests/editor/mesh_files.h"

namespace editor {
namespace {

constexpr double kPi = std::numbers::pi;
using rubble::TempFolder;

/// An editor that has imported a file.
struct Imported {
    Editor editor{EditorSettings{.vdbTool = RUBBLE_VDB_PROGRAM}};
    Outcome outcome;
    rubble_shape_state shape{};

    Imported(const std::string& file, const std::string& options) {
        outcome = editor.run(fmt::format("import \"{}\" {}", file, options));
        const auto shapes = editor.world().get_shape_states(0);
        if (shapes.size() == 1) shape = shapes[0];
    }
    bool says(const char* text) const { return outcome.text.find(text) != std::string::npos; }
};

std::string contentOf(const std::string& path) {
    std::ostringstream out;
    out << std::ifstream(path, std::ios::binary).rdbuf();
    return out.str();
}

/// Whether this rubble-vdb reads meshes; it is built without them where their library is missing.
bool readsMeshes() {
    const TempFolder folder;
    writeObj(folder / "cube.obj", cube(1.0, {}));
    return !Imported(folder / "cube.obj", "voxels=4").says("built without Assimp");
}

class MeshImport : public testing::Test {
protected:
    void SetUp() override {
        if (!readsMeshes()) GTEST_SKIP() << "rubble-vdb was built without Assimp";
    }
    TempFolder m_folder;
};

/// A closed mesh, its volume, and the length of its longest side.
struct Solid {
    const char* name;
    TestMesh mesh;
    double volume;
};

std::vector<glm::dvec3> trefoil() {
    std::vector<glm::dvec3> line;
    for (int i = 0; i < 256; ++i) {
        const double t = 2.0 * kPi * i / 256;
        line.emplace_back(std::sin(t) + 2.0 * std::sin(2.0 * t), std::cos(t) - 2.0 * std::cos(2.0 * t),
                          -std::sin(3.0 * t));
    }
    return line;
}

double lengthOf(const std::vector<glm::dvec3>& line) {
    double length = 0.0;
    for (size_t i = 0; i < line.size(); ++i) length += glm::distance(line[i], line[(i + 1) % line.size()]);
    return length;
}

std::vector<Solid> solids() {
    std::vector<glm::dvec2> half;
    for (int i = 0; i <= 64; ++i) half.emplace_back(std::sin(kPi * i / 64), -std::cos(kPi * i / 64));
    const auto ring = [](double u, double v) {
        const double r = 2.0 + 0.7 * std::cos(2.0 * kPi * v);
        return glm::dvec3(r * std::cos(2.0 * kPi * u), 0.7 * std::sin(2.0 * kPi * v), r * std::sin(2.0 * kPi * u));
    };
    return {{"sphere", turned(half, 128), 4.0 / 3.0 * kPi},
            {"torus", closedSurface(128, 64, ring), 2.0 * kPi * kPi * 2.0 * 0.7 * 0.7},
            {"cube", cube(3.0, {0.5, 0.7}), 27.0},
            {"cone", turned({{0, 0}, {1.5, 0}, {0, 4}}, 128), kPi * 1.5 * 1.5 * 4.0 / 3.0},
            {"knot", tube(trefoil(), 0.4, 48), kPi * 0.4 * 0.4 * lengthOf(trefoil())}};
}

double longestSide(const TestMesh& mesh) {
    glm::dvec3 low = mesh.points[0], high = low;
    for (const glm::dvec3& each : mesh.points) low = glm::min(low, each), high = glm::max(high, each);
    return std::max({high.x - low.x, high.y - low.y, high.z - low.z});
}

TEST_F(MeshImport, VolumesOfClosedMeshesAreWithinTwoPercent) {
    for (const Solid& solid : solids()) {
        writeObj(m_folder / "solid.obj", solid.mesh);
        const Imported got(m_folder / "solid.obj", "voxels=128 voxel=0.05");
        ASSERT_TRUE(got.outcome.isDone) << solid.name << ": " << got.outcome.text;
        const double scale = 128 * 0.05 / longestSide(solid.mesh);
        const double wanted = solid.volume * std::pow(scale / 0.05, 3.0);
        EXPECT_NEAR(double(got.shape.voxel_count) / wanted, 1.0, 0.02) << solid.name;
        RecordProperty(solid.name, fmt::format("{:.5f}", double(got.shape.voxel_count) / wanted));
        EXPECT_FALSE(got.says("leak")) << solid.name << ": " << got.outcome.text;
    }
}

TEST_F(MeshImport, SameFileSameVoxels) {
    writeObj(m_folder / "knot.obj", tube(trefoil(), 0.4, 12));
    Imported a(m_folder / "knot.obj", "voxels=48"), b(m_folder / "knot.obj", "voxels=48");
    ASSERT_TRUE(a.outcome.isDone) << a.outcome.text;
    EXPECT_EQ(a.editor.document().hash(), b.editor.document().hash());
}

/// The colour of a cell.
glm::ivec3 colorAt(const Imported& got, glm::ivec3 cell) {
    auto& world = const_cast<Imported&>(got).editor.world();
    const uint8_t index = readCells(world, got.shape.shape, {cell, glm::ivec3(1)})[0];
    const rubble_palette_entry entry = paletteOf(world, got.shape.shape)[index];
    return {entry.color[0], entry.color[1], entry.color[2]};
}

int difference(glm::ivec3 a, glm::ivec3 b) {
    const glm::ivec3 apart = glm::abs(a - b);
    return std::max({apart.x, apart.y, apart.z});
}

/// A texture of 15 x 15 pixels of other colours, rows from above.
std::vector<uint8_t> colorfulPixels() {
    std::vector<uint8_t> pixels;
    for (int i = 0; i < 225; ++i)
        for (const int byte : {i * 7 % 256, 255 - i, i * 31 % 256, 255}) pixels.push_back(uint8_t(byte));
    return pixels;
}

/// All voxels of the face to z of a cube of 60 voxels, but for its edges, against the texture.
void expectTextureOnFace(const Imported& got, const std::vector<uint8_t>& pixels) {
    ASSERT_TRUE(got.outcome.isDone) << got.outcome.text;
    ASSERT_EQ(got.shape.voxel_count, 60u * 60 * 60);
    int worst = 0;
    for (int x = 2; x < 58; ++x)
        for (int y = 2; y < 58; ++y) {
            // Of the face to z, u goes along x and v along y; the grid has an empty cell around the mesh.
            const size_t pixel = (size_t(14 - y / 4) * 15 + size_t(x / 4)) * 4;
            const glm::ivec3 wanted(pixels[pixel], pixels[pixel + 1], pixels[pixel + 2]);
            worst = std::max(worst, difference(colorAt(got, {x + 1, y + 1, 60}), wanted));
        }
    EXPECT_LE(worst, 4);
}

TEST_F(MeshImport, ColoursAreThoseOfTheTexture) {
    const std::vector<uint8_t> pixels = colorfulPixels();
    writePng(m_folder / "skin.png", 15, 15, pixels);
    std::ofstream(m_folder / "cube.mtl") << "newmtl skin\nKd 0.2 0.2 0.2\nmap_Kd skin.png\n";
    writeObj(m_folder / "cube.obj", cube(3.0, {}), "mtllib cube.mtl\nusemtl skin\n");
    expectTextureOnFace(Imported(m_folder / "cube.obj", "voxels=60"), pixels);
}

TEST_F(MeshImport, TexturesInsideOfGlbFilesAreRead) {
    const std::vector<uint8_t> pixels = colorfulPixels();
    writePng(m_folder / "skin.png", 15, 15, pixels);
    writeGlb(m_folder / "cube.glb", cube(3.0, {}), contentOf(m_folder / "skin.png"));
    expectTextureOnFace(Imported(m_folder / "cube.glb", "voxels=60"), pixels);
    const Imported real(m_folder / "cube.glb", "voxels=0 voxel=0.1");
    EXPECT_EQ(real.shape.voxel_count, 60u * 60 * 60) << "its node doubles its 3 m";
}

TEST_F(MeshImport, TexturesOfSixteenBitsAreAsBrightAsOfEight) {
    writeDeepPng(m_folder / "gray.png", 1, 1, 1, {32896});
    writeGlb(m_folder / "cube.glb", cube(1.0, {}), contentOf(m_folder / "gray.png"));
    Imported got(m_folder / "cube.glb", "voxels=4");
    ASSERT_TRUE(got.outcome.isDone) << got.outcome.text;
    EXPECT_EQ(paletteOf(got.editor.world(), got.shape.shape)[1].color[0], 128);
}

TEST_F(MeshImport, ColoursOfVerticesAreMixed) {
    const TestMesh mesh = cube(2.0, {});
    std::vector<std::array<unsigned char, 3>> colors(mesh.points.size(), {200, 100, 40});
    writePly(m_folder / "cube.ply", mesh, colors);
    const Imported got(m_folder / "cube.ply", "voxels=20");
    ASSERT_TRUE(got.outcome.isDone) << got.outcome.text;
    EXPECT_EQ(got.shape.voxel_count, 20u * 20 * 20);
    EXPECT_LE(difference(colorAt(got, {10, 10, 20}), {200, 100, 40}), 1);
    EXPECT_LE(difference(colorAt(got, {10, 10, 10}), {200, 100, 40}), 1) << "what is inside has it as well";
}

TEST_F(MeshImport, ManyColoursAreToldWithTheirError) {
    std::vector<uint8_t> pixels;
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x)
            for (const int byte : {x * 8, y * 8, 128, 255}) pixels.push_back(uint8_t(byte));
    writePng(m_folder / "skin.png", 32, 32, pixels);
    writeGlb(m_folder / "cube.glb", cube(3.0, {}), contentOf(m_folder / "skin.png"));
    const Imported got(m_folder / "cube.glb", "voxels=64");
    EXPECT_TRUE(got.says("1024 colours -> 255 entries of the palette, at most ")) << got.outcome.text;
    const size_t at = got.outcome.text.find("at most ");
    ASSERT_NE(at, std::string::npos);
    // Parting them 254 times leaves 254 groups of 2 x 2 colours and one of 4 x 2, whose ends are 24 apart.
    EXPECT_LE(std::atoi(got.outcome.text.c_str() + at + 8), 12) << got.outcome.text;
}

TEST_F(MeshImport, LeaksAreToldAndTheirSurfaceIsKept) {
    TestMesh mesh = cube(2.0, {});
    mesh.faces.pop_back();
    writeObj(m_folder / "box.obj", mesh);
    const Imported got(m_folder / "box.obj", "voxels=20");
    ASSERT_TRUE(got.outcome.isDone) << got.outcome.text;
    EXPECT_TRUE(got.says("1 of 1 parts leak (4 open edges)")) << got.outcome.text;
    EXPECT_GT(got.shape.voxel_count, 5u * 20 * 20 - 100);
    EXPECT_LT(got.shape.voxel_count, 5u * 2 * 22 * 22);
}

TEST_F(MeshImport, AShellIsHollow) {
    writeObj(m_folder / "cube.obj", cube(2.0, {}));
    const Imported got(m_folder / "cube.obj", "voxels=20 shell=2");
    ASSERT_TRUE(got.outcome.isDone) << got.outcome.text;
    EXPECT_EQ(got.shape.voxel_count, 20u * 20 * 20 - 16u * 16 * 16);
}

TEST_F(MeshImport, FilesOfOtherAxesStandUp) {
    TestMesh mesh = turned({{0, 0}, {1, 0}, {0, 4}}, 16);
    for (glm::dvec3& each : mesh.points) each = {each.x, -each.z, each.y};
    writeObj(m_folder / "cone.obj", mesh);
    const Imported got(m_folder / "cone.obj", "voxels=40 up=z");
    ASSERT_TRUE(got.outcome.isDone) << got.outcome.text;
    EXPECT_EQ(got.shape.size[1], 42);
    EXPECT_LT(got.shape.size[2], 24);
}

/// The import must fail, say `why`, and leave the level as it was.
void expectRefused(const std::string& file, const char* why, const std::string& options = "") {
    const Imported got(file, options);
    EXPECT_FALSE(got.outcome.isDone) << file << ": " << got.outcome.text;
    EXPECT_TRUE(got.says(why)) << file << ": " << got.outcome.text;
    EXPECT_TRUE(const_cast<Imported&>(got).editor.document().done().empty());
}

TEST_F(MeshImport, BrokenAndLyingFilesAreRefused) {
    const auto write = [&](const char* name, const std::string& text) {
        std::ofstream(m_folder / name, std::ios::binary) << text;
        return m_folder / name;
    };
    expectRefused(m_folder / "none.obj", "none.obj");
    expectRefused(write("empty.obj", ""), "empty.obj");
    expectRefused(write("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"), "points.obj");
    expectRefused(write("beyond.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n"), "beyond.obj");
    expectRefused(write("nan.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), "nan.obj");
    expectRefused(write("far.obj", "v 1e30 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), "far.obj: vertex");
    const std::string header =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
    expectRefused(write("beyond.ply", header + "0 0 0\n1 0 0\n0 1 0\n3 0 1 70000\n"), "beyond.ply");
    expectRefused(write("short.ply", header + "0 0 0\n"), "short.ply");
    std::string huge = header;
    huge.replace(huge.find("vertex 3"), 8, "vertex 4000000000");
    expectRefused(write("huge.ply", huge), "expected at least 24000000002 bytes after its header, found 0");
    for (const size_t size : {size_t(3), size_t(20), header.size() - 1})
        expectRefused(write("cut.ply", header.substr(0, size)), "expected a header that ends with 'end_header'");
    std::string strange = header;
    strange.replace(strange.find("float y"), 7, "floor y");
    expectRefused(write("type.ply", strange), "expected a type of numbers in 'property floor y'");
    expectRefused(write("text.glb", "this is no such file"), "text.glb");
    writeObj(m_folder / "cube.obj", cube(2.0, {}));
    expectRefused(m_folder / "cube.obj", "at most 4096 cells", "voxels=0 voxel=0.001 turn=0,0,0 at=0,0,0 shell=1 up=z");
    EXPECT_FALSE(Editor().run(fmt::format("import {}", m_folder / "cube.obj")).isDone) << "without rubble-vdb";
}

TEST_F(MeshImport, NumbersMayBeginOrEndWithTheirPoint) {
    for (const std::string ending : {".obj", ".ply"})
        for (const char* number : {".5", "5.e-1", "+.5", ".05e1", "0.5"}) {
            std::string text = ending == ".obj" ? ""
                                                : "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\n"
                                                  "property float y\nproperty float z\nelement face 4\n"
                                                  "property list uchar int vertex_indices\nend_header\n";
            const bool isObj = ending == ".obj";
            const char* begin = isObj ? "v " : "";
            text += fmt::format("{0}{1} 0 0\n{0}0 {1} 0.\n{0}0 0 {1}\n{0}0. 0 0\n", begin, number);
            text +=
                isObj ? "vn .5 .5 .5\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n" : "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
            std::ofstream(m_folder / ("half" + ending)) << text;
            const Imported got(m_folder / ("half" + ending), "voxels=0 voxel=0.05");
            EXPECT_TRUE(got.outcome.isDone) << ending << " " << number << ": " << got.outcome.text;
            EXPECT_EQ(got.shape.size[1], 12) << number;
        }
}

TEST_F(MeshImport, ListsOfPlyFilesHaveLengths) {
    const auto write = [&](const std::string& format, const std::string& count, const std::string& body) {
        const std::string path = m_folder / "list.ply";
        std::ofstream(path, std::ios::binary)
            << "ply\nformat " << format << " 1.0\nelement vertex 1\nproperty float x\nelement face 1\nproperty list "
            << count << " int vertex_indices\nend_header\n"
            << body;
        return path;
    };
    const std::string zeros(4, '\0');
    expectRefused(write("ascii", "char", "0\n-3 0 1 2\n"), "face 0: expected a list of 0 to 7 numbers, found '-3'");
    expectRefused(write("ascii", "uint", "0\n4000000000 0 1 2\n"), "face 0: expected a list of 0 to 7 numbers");
    expectRefused(write("ascii", "int", "0\nthree 0 1 2\n"), "found 'three'");
    expectRefused(write("binary_little_endian", "char", zeros + "\xfd" + zeros), "0 to 4 numbers, found '-3'");
    expectRefused(write("binary_big_endian", "short", zeros + "\x01" + zeros), "0 to 3 numbers, found '256'");
    expectRefused(write("binary_little_endian", "float", zeros + zeros + "\xff\x7f\x7f\x7f"), "list.ply: ");
}

/// A .glb file of one triangle with these nodes, of which the last has it, and with these indices.
void writeNodes(const std::string& path, const std::vector<std::string>& nodes, const std::string& more = "",
                uint16_t lastIndex = 2) {
    std::string list, bytes(36, '\0');
    for (const std::string& node : nodes) list += (list.empty() ? "{" : ",{") + node + "}";
    const float points[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    const uint16_t indices[4] = {0, 1, lastIndex, 0};
    std::memcpy(bytes.data(), points, sizeof points);
    bytes.append(reinterpret_cast<const char*>(indices), sizeof indices);
    writeGlbParts(path,
                  R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[)" + list + "]" + more +
                      R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"accessors":[
{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
{"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"}],"buffers":[{"byteLength":44}],"bufferViews":[
{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":6}]})",
                  bytes);
}

TEST_F(MeshImport, NodesOfGlbFilesAreTrees) {
    const std::string path = m_folder / "nodes.glb";
    const auto chain = [](int count, int times) {
        std::vector<std::string> nodes;
        for (int i = 1; i < count; ++i)
            nodes.push_back(times == 2 ? fmt::format(R"("children":[{0},{0}])", i)
                                       : fmt::format(R"("children":[{0}])", i));
        nodes.emplace_back(R"("mesh":0)");
        return nodes;
    };
    writeNodes(path, chain(40, 1));
    EXPECT_TRUE(Imported(path, "voxels=8").outcome.isDone);
    writeNodes(path, chain(400, 1));
    expectRefused(path, "nodes.glb: node 257: expected at most 256 nodes above it, found more");
    writeNodes(path, chain(40, 2));
    expectRefused(path, "nodes.glb: node 1: expected one parent, found node 0 and node 0");
    writeNodes(path, {R"("children":[1,2])", R"("children":[3])", R"("children":[3])", R"("mesh":0)"});
    expectRefused(path, "nodes.glb: node 3: expected one parent, found node 1 and node 2");
    writeNodes(path, {R"("children":[1])", R"("children":[0],"mesh":0)"});
    expectRefused(path, "nodes.glb: node 0: expected at most 256 nodes above it, found more: a cycle?");
    writeNodes(path, {R"("children":[7])", R"("mesh":0)"});
    expectRefused(path, "nodes.glb: node 0, children: expected a number below 2, found 7");
}

TEST_F(MeshImport, SaysWhatIsWrongInGlbFiles) {
    const std::string path = m_folder / "wrong.glb";
    writeNodes(path, {R"("mesh":0)"}, "", 9);
    expectRefused(path, "mesh 0, primitive 0: expected indices below 3, its count of vertices, found 9");
    writeNodes(path, {R"("mesh":0)"}, R"(,"extensionsRequired":["KHR_draco_mesh_compression"])");
    expectRefused(path, "expected meshes that are not compressed, found \"KHR_draco_mesh_compression\"");
    writeGlbParts(path, R"({"asset":{"version":"2.0"},)", "");
    expectRefused(path, "wrong.glb: expected glTF in JSON, found other text");
    writeGlbParts(path, R"({"nodes":[{"children":[-1]}]})", "");
    expectRefused(path, "node 0, children: expected a whole number from 0 on, found -1");
}

TEST_F(MeshImport, EndingsMayBeOfCapitals) {
    const TestMesh mesh = cube(2.0, {});
    writePng(m_folder / "skin.png", 15, 15, colorfulPixels());
    writeObj(m_folder / "A.OBJ", mesh);
    writePly(m_folder / "A.Ply", mesh, {mesh.points.size(), {200, 100, 40}});
    writeGlb(m_folder / "A.GLB", mesh, contentOf(m_folder / "skin.png"));
    for (const char* name : {"A.OBJ", "A.Ply", "A.GLB"}) {
        Imported got(m_folder / name, "voxels=10");
        EXPECT_EQ(got.shape.voxel_count, 1000u) << got.outcome.text;
        const std::string out = m_folder / "OUT." + name[2];
        EXPECT_TRUE(got.editor.run("export " + out + (name[2] == 'O' ? "BJ" : "LB")).isDone || name[2] == 'P');
    }
    EXPECT_EQ(contentOf(m_folder / "OUT.GLB").substr(0, 4), "glTF");
    EXPECT_NE(contentOf(m_folder / "OUT.OBJ").find("\nv "), std::string::npos);
}

/// Exports a level's shape, imports it again and expects the same voxels at the same place.
void expectSameAfterImport(Editor& editor, const std::string& file) {
    SCOPED_TRACE(file);
    runAll(editor, {"trim part", fmt::format("export \"{}\"", file).c_str()});
    Imported got(file, "voxels=0");
    ASSERT_TRUE(got.outcome.isDone) << got.outcome.text;
    runAll(got.editor, {"trim"});
    const rubble_shape_state wanted = editor.world().get_shape_states(0).at(0),
                             found = got.editor.world().get_shape_states(0).at(0);
    EXPECT_FALSE(got.says("leak") || got.says("lost")) << got.outcome.text;
    ASSERT_EQ(found.voxel_count, wanted.voxel_count);
    for (size_t a = 0; a < 3; ++a) {
        ASSERT_EQ(found.size[a], wanted.size[a]);
        EXPECT_NEAR(found.position[a], wanted.position[a], 0.005);
    }
    const Cells all{glm::ivec3(0), {found.size[0], found.size[1], found.size[2]}};
    std::vector<uint8_t> before = readCells(editor.world(), wanted.shape, all),
                         after = readCells(got.editor.world(), found.shape, all);
    for (std::vector<uint8_t>* each : {&before, &after})
        for (uint8_t& index : *each) index = index != 0;
    EXPECT_EQ(before, after);
}

TEST_F(MeshImport, WhatIsExportedComesBackEqual) {
    for (const char* size : {"1,1,1", "3,3,3", "2,3,4", "9,5,17", "16,7,1"})
        for (const char* at : {"0,0,0", "0.05,0.03,-0.07", "-123.45,6.78,999.99"})
            for (const char* ending : {".obj", ".glb"}) {
                SCOPED_TRACE(fmt::format("{} at {}", size, at));
                Editor editor;
                runAll(editor, {fmt::format("create {} {} name=part", size, at).c_str()});
                expectSameAfterImport(editor, m_folder / "part" + std::string(ending));
            }
    for (const char* ending : {".obj", ".glb"}) {
        Editor editor;
        runAll(editor, {"create 21,13,9 1.03,2,3 name=part", "sphere 0,0,0 6 erase shape=part",
                        "box 10,3,2 14,9,12 erase shape=part", "box 3,10,4 9,12,4 erase shape=part",
                        "box 17,10,3 19,11,5 erase shape=part", "box 16,2,2 18,8,6 paint 9 shape=part"});
        expectSameAfterImport(editor, m_folder / "part" + std::string(ending));
        runAll(editor,
               {"rotate 20,30,40 what=part", ("export " + (m_folder / "turned") + std::string(ending)).c_str()});
        const Imported turned(m_folder / "turned" + std::string(ending), "voxels=0");
        EXPECT_FALSE(turned.says("leak")) << turned.outcome.text;
        const double before = double(editor.world().get_voxel_accounting().standing);
        EXPECT_NEAR(double(turned.shape.voxel_count), before, 0.03 * before);
    }
}

/// Opaque voxels hide faces of the glass beside them, and glass shows those of the opaque ones.
TEST_F(MeshImport, GlassBesideOtherVoxelsComesBackEqual) {
    for (const char* ending : {".obj", ".glb"})
        for (const char* glass : {"voxel 3,3,3 paint 15 shape=part", "voxel 1,1,1 paint 15 shape=part",
                                  "box 0,2,0 3,2,3 paint 15 shape=part", "box 1,0,2 2,3,3 paint 15 shape=part"}) {
            SCOPED_TRACE(glass);
            Editor editor;
            runAll(editor, {"create 4,4,4 name=part", glass});
            expectSameAfterImport(editor, m_folder / "part" + std::string(ending));
        }
}

TEST_F(MeshImport, SurfacesThroughCentresOfCellsCountThemOnce) {
    for (const double at : {0.0, 0.05}) {
        TestMesh two = cube(0.3, {});
        const TestMesh other = cube(0.3, {});
        for (const glm::dvec3& each : other.points) two.points.push_back(each + glm::dvec3(0.6 + at));
        for (std::vector<int> face : other.faces) {
            for (int& point : face) point += int(other.points.size());
            two.faces.push_back(face);
        }
        two.places.clear();
        writeObj(m_folder / "two.obj", two);
        EXPECT_EQ(Imported(m_folder / "two.obj", "voxels=0").shape.voxel_count, 54u) << at;
    }
}

TEST_F(MeshImport, SaysWhereMeshesAreTooFarAway) {
    TestMesh mesh = cube(2.0, {});
    for (glm::dvec3& each : mesh.points) each.x += 3e8;
    writeObj(m_folder / "far.obj", mesh);
    expectRefused(m_folder / "far.obj",
                  "numbers of 32 bits, which are 32 m apart at the 3e+08 m that the mesh lies away");
    for (glm::dvec3& each : mesh.points) each.x += 4e6 - 3e8;
    writeObj(m_folder / "far.obj", mesh);
    EXPECT_TRUE(Imported(m_folder / "far.obj", "voxels=20").says("which are 0.25 m apart")) << "a voxel is 0.1 m";
    for (glm::dvec3& each : mesh.points) each.x -= 4e6;
    writeObj(m_folder / "near.obj", mesh);
    EXPECT_FALSE(Imported(m_folder / "near.obj", "voxels=20").says("of 32 bits"));
}

TEST_F(MeshImport, DamagedFilesCrashNothing) {
    writePng(m_folder / "skin.png", 15, 15, colorfulPixels());
    const TestMesh mesh = cube(2.0, {});
    writeObj(m_folder / "a.obj", mesh);
    writePly(m_folder / "a.ply", mesh, {mesh.points.size(), {200, 100, 40}});
    writeGlb(m_folder / "a.glb", mesh, contentOf(m_folder / "skin.png"));
    const int inputs = std::getenv("RUBBLE_LONG") ? 1000 : 3;
    std::mt19937 random(24);
    for (const char* ending : {".obj", ".ply", ".glb"})
        for (int i = 0; i < inputs; ++i) {
            std::string bytes = contentOf(m_folder / "a" + ending);
            for (uint32_t n = 1 + random() % 6; n > 0; --n) bytes[random() % bytes.size()] = char(random());
            if (i % 3 == 0) bytes.resize(random() % bytes.size());
            const std::string path = m_folder / "mutated" + ending;
            std::ofstream(path, std::ios::binary) << bytes;
            const Imported got(path, "voxels=8");
            EXPECT_FALSE(got.outcome.text.empty()) << ending << " " << i;
            EXPECT_FALSE(got.says("a process of its own"))
                << "it ended early: " << ending << " " << i << ": " << got.outcome.text;
        }
}

}  // namespace
}  // namespace editor
