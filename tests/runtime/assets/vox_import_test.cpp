#include "runtime/assets/vox_import.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "runtime/assets/vox_file.h"
#include "runtime/assets/vox_palette.h"
#include "runtime/world/world.h"
#include "tests/runtime/assets/vox_writer.h"

namespace rubble {
namespace {

using Cell = std::tuple<int, int, int>;

/// The palette index of every voxel by its cell in the world. Fails if voxels overlap or lie between cells.
std::map<Cell, int> worldCells(const Level& level) {
    std::map<Cell, int> cells;
    for (const LevelBody& body : level.bodies)
        for (const LevelShape& shape : body.shapes) {
            const Pose pose = body.pose * shape.local;
            EXPECT_EQ(pose.rotation, glm::dquat(1, 0, 0, 0));
            const glm::dvec3 corner = pose.position / 0.1;
            const glm::ivec3 rounded(glm::round(corner));
            EXPECT_LT(glm::length(corner - glm::dvec3(rounded)), 1e-9);
            shape.grid.forEachBrick([&](glm::ivec3 brick, const BrickRef& content) {
                forEachVoxel(content->occupancy, [&](int i) {
                    const glm::ivec3 c = rounded + brick * kBrickSize + voxelInBrick(i);
                    EXPECT_TRUE(cells.emplace(Cell{c.x, c.y, c.z}, content->at(i)).second) << "overlap";
                });
            });
        }
    return cells;
}

Level import(const VoxWriter& writer, ImportReport* report = nullptr, VoxImportSettings settings = {}) {
    Result<Level> level = importVoxBytes(writer.file(), "test.vox", settings, report);
    if (!level) ADD_FAILURE() << level.error();
    return level ? std::move(*level) : Level{};
}

std::string importError(const VoxWriter& writer) {
    const Result<Level> level = importVoxBytes(writer.file(), "test.vox", {});
    return level ? "no error" : level.error();
}

bool reportHas(const ImportReport& report, const std::string& text) {
    return std::any_of(report.lines.begin(), report.lines.end(),
                       [&](const std::string& line) { return line.find(text) != std::string::npos; });
}

TEST(VoxImport, OneModelStandsOnTheGroundWithYUp) {
    VoxWriter writer;
    writer.model({3, 4, 5}, {{0, 0, 0, 7}, {2, 3, 4, 9}});
    ImportReport report;
    const Level level = import(writer, &report);
    // Pivot (1, 2, 2), raised by half the height: x - 1, z, -(y - 2) - 1.
    const std::map<Cell, int> expected{{{-1, 0, 1}, 7}, {{1, 4, -2}, 9}};
    EXPECT_EQ(worldCells(level), expected);
    EXPECT_EQ(report.voxels, 2u);
    EXPECT_EQ(report.models, 1);
    EXPECT_EQ(report.shapes, 1);
    ASSERT_EQ(level.bodies.size(), 1u);
    EXPECT_TRUE(level.bodies[0].isStatic);
    EXPECT_EQ(level.bodies[0].shapes[0].name, "test");
    EXPECT_EQ(level.bodies[0].shapes[0].grid.size(), glm::ivec3(3, 5, 4));
}

TEST(VoxImport, EveryRotationByteMovesCellCentresByItsMatrix) {
    const glm::ivec3 size(2, 3, 4);
    const std::vector<std::array<uint8_t, 4>> voxels{
        {0, 0, 0, 1}, {1, 0, 0, 2}, {0, 2, 0, 3}, {0, 0, 3, 4}, {1, 2, 3, 5}};
    int valid = 0;
    for (int byte = 0; byte < 128; ++byte) {
        VoxWriter writer;
        writer.model(size, voxels).transform(0, 1, {{{"_r", std::to_string(byte)}, {"_t", "5 -7 11"}}}).shape(1, {0});
        const int first = byte & 3, second = byte >> 2 & 3;
        if (first == 3 || second == 3 || first == second) {
            EXPECT_NE(importError(writer).find("rotation byte"), std::string::npos) << byte;
            continue;
        }
        ++valid;
        double matrix[3][3] = {};
        const int columns[3] = {first, second, 3 - first - second};
        for (int row = 0; row < 3; ++row) matrix[row][columns[row]] = byte >> (4 + row) & 1 ? -1 : 1;
        std::map<Cell, int> expected;
        for (const auto& v : voxels) {
            double in[3], out[3];
            for (int i = 0; i < 3; ++i) in[i] = v[size_t(i)] + 0.5 - size[i] / 2;
            const double offset[3] = {5, -7, 11};
            for (int row = 0; row < 3; ++row)
                out[row] = matrix[row][0] * in[0] + matrix[row][1] * in[1] + matrix[row][2] * in[2] + offset[row];
            expected[{int(std::floor(out[0])), int(std::floor(out[2])), int(std::floor(-out[1]))}] = v[3];
        }
        EXPECT_EQ(worldCells(import(writer)), expected) << "rotation byte " << byte;
    }
    EXPECT_EQ(valid, 48);
}

TEST(VoxImport, NestedTransformsApplyInnermostFirst) {
    VoxWriter writer;
    writer.model({1, 1, 1}, {{0, 0, 0, 3}});
    // Inner: 10 along x. Outer: a quarter turn about z (x -> y): rows (0 -1 0), (1 0 0), (0 0 1), so columns 1 and 0,
    // and the sign bit of row 0.
    writer.transform(0, 1, {{{"_r", std::to_string(1 | 0 << 2 | 1 << 4)}, {"_t", "0 0 2"}}}).group(1, {2});
    writer.transform(2, 3, {{{"_t", "10 0 0"}}}, {{"_name", "arm"}}).shape(3, {0});
    const Level level = import(writer);
    const std::map<Cell, int> expected{{{-1, 2, -11}, 3}};
    EXPECT_EQ(worldCells(level), expected);
    EXPECT_EQ(level.bodies.at(0).shapes.at(0).name, "arm");
}

TEST(VoxImport, LayersHiddenFlagsNamesAndFrames) {
    VoxWriter writer;
    writer.model({1, 1, 1}, {{0, 0, 0, 1}}).model({1, 1, 2}, {{0, 0, 0, 2}, {0, 0, 1, 2}}).model({1, 1, 1}, {});
    writer.transform(0, 1, {{}}).group(1, {2, 4, 6, 8, 10});
    writer.transform(2, 3, {{{"_t", "0 0 0"}}}, {{"_name", "door"}}, 0).shape(3, {0});
    writer.transform(4, 3, {{{"_t", "9 0 0"}}}, {{"_name", "door"}}, 1);  // the same shape again, on a hidden layer
    writer.transform(6, 7, {{{"_t", "20 0 0"}}, {{"_t", "30 0 0"}}}, {{"_hidden", "1"}}, 0).shape(7, {0});
    writer.transform(8, 9, {{{"_t", "40 0 0"}}}, {{"_name", "walker"}}).shape(9, {0, 1});
    writer.transform(10, 11, {{{"_t", "50 0 0"}}}).shape(11, {2});
    writer.described("LAYR", 0, {{"_name", "house"}}).described("LAYR", 1, {{"_name", "cellar"}, {"_hidden", "1"}});
    ImportReport report;
    const Level level = import(writer, &report);
    ASSERT_EQ(level.bodies.size(), 5u);
    const auto shape = [&](size_t i) -> const LevelShape& { return level.bodies[i].shapes.at(0); };
    EXPECT_EQ(shape(0).name, "door");
    EXPECT_EQ(shape(0).tags, std::vector<std::string>{"layer=house"});
    EXPECT_FALSE(shape(0).hidden);
    EXPECT_EQ(shape(1).name, "door 2");
    EXPECT_TRUE(shape(1).hidden);
    EXPECT_TRUE(shape(2).hidden);
    EXPECT_EQ(level.bodies[2].pose.position.x, 2.0);
    EXPECT_FALSE(shape(3).hidden);
    EXPECT_EQ(shape(4).name, "walker frame 1");
    EXPECT_TRUE(shape(4).hidden);
    EXPECT_EQ(shape(4).grid.voxelCount(), 2u);
    EXPECT_TRUE(reportHas(report, "1 later poses"));
    EXPECT_TRUE(reportHas(report, "model 2: no voxels"));

    World world;  // files keep hidden shapes, a World leaves them out
    world.load(level);
    EXPECT_EQ(world.bodies().size(), 2u);
    EXPECT_EQ(voxelAccounting(world).imported, 2u);
}

TEST(VoxImport, OneBodyHoldsAllObjects) {
    VoxWriter writer;
    writer.model({1, 1, 1}, {{0, 0, 0, 1}}).transform(0, 1, {{}}).group(1, {2, 4});
    writer.transform(2, 3, {{{"_t", "0 0 0"}}}).shape(3, {0}).transform(4, 3, {{{"_t", "5 0 0"}}});
    VoxImportSettings settings;
    settings.oneBody = true;
    const Level one = import(writer, nullptr, settings);
    ASSERT_EQ(one.bodies.size(), 1u);
    EXPECT_EQ(one.bodies[0].shapes.size(), 2u);
    EXPECT_EQ(worldCells(one), worldCells(import(writer)));
}

TEST(VoxImport, ColoursShiftByOneAndIndexMapRenumbersThem) {
    std::array<std::array<uint8_t, 4>, 256> colors{};
    for (int i = 0; i < 256; ++i) colors[size_t(i)] = {uint8_t(i), 10, 20, 255};
    VoxWriter plain;
    plain.model({1, 1, 1}, {{0, 0, 0, 8}}).colors(colors);
    EXPECT_EQ(int((*import(plain).bodies.at(0).shapes[0].palette)[8].red), 7);

    VoxWriter::Bytes map;
    for (int i = 0; i < 256; ++i) map.push_back(uint8_t(i + 1));
    std::swap(map[7], map[99]);  // slot 8 shows stored colour 100, slot 100 shows stored colour 8
    plain.chunk("IMAP", map).described("MATL", 8, {{"_type", "_metal"}, {"_metal", "1"}, {"_rough", "0.2"}});
    const Level level = import(plain);
    const LevelShape& shape = level.bodies.at(0).shapes[0];
    EXPECT_EQ(int(shape.grid.at({0, 0, 0})), 100);
    const PaletteEntry& entry = (*shape.palette)[100];
    EXPECT_EQ(int(entry.red), 7);
    EXPECT_EQ(int(entry.metallic), 255);
    EXPECT_EQ(int(entry.roughness), 51);
    EXPECT_EQ(level.materials[entry.material].name, "metal");
    EXPECT_EQ(int((*shape.palette)[8].material), 0) << "unused entries have no material";
}

TEST(VoxImport, MaterialsOfNewAndOldFiles) {
    VoxWriter writer;
    writer.model({4, 1, 1}, {{0, 0, 0, 1}, {1, 0, 0, 2}, {2, 0, 0, 3}, {3, 0, 0, 4}});
    writer.described("MATL", 1, {{"_type", "_glass"}, {"_trans", "0.75"}, {"_ior", "0.5"}, {"_rough", "0"}});
    writer.described("MATL", 2, {{"_type", "_emit"}, {"_emit", "0.5"}, {"_flux", "1"}});
    writer.described("MATL", 3, {{"_type", "_metal"}, {"_weight", "0.6"}, {"_plastic", "1"}});
    VoxWriter::Bytes old;  // MATT: id, metal, weight 0.5, roughness 0.25
    VoxWriter::put(old, 4u), VoxWriter::put(old, 1u), VoxWriter::put(old, 0x3f000000u), VoxWriter::put(old, 2u),
        VoxWriter::put(old, 0x3e800000u);
    writer.chunk("MATT", old);
    const Level level = import(writer);
    const Palette& palette = *level.bodies.at(0).shapes[0].palette;
    EXPECT_EQ(int(palette[1].opacity), 64);
    EXPECT_EQ(int(palette[1].reflectivity), 10);
    EXPECT_EQ(level.materials[palette[1].material].name, "glass");
    EXPECT_FLOAT_EQ(palette[2].emission, 5.0f);
    EXPECT_EQ(palette[2].lightGroup, 1u);
    EXPECT_EQ(int(palette[3].metallic), 0);
    EXPECT_EQ(int(palette[4].metallic), 128);
    EXPECT_EQ(int(palette[4].roughness), 64);
    ASSERT_EQ(level.lights.size(), 1u);
    EXPECT_EQ(level.lights[0].groupName, "test");
    EXPECT_EQ(level.lights[0].shapeName, "test");
    EXPECT_NEAR(level.lights[0].light.local.position.x, 0.15, 1e-12);
    EXPECT_EQ(level.lightGroups.at(0).initialVoxels, 1u);
}

TEST(VoxImport, MaterialsFollowColourWithoutThePresetAndRowsWithIt) {
    const auto guess = [](uint8_t r, uint8_t g, uint8_t b) {
        return defaultMaterials()[guessMaterial({.red = r, .green = g, .blue = b})].name;
    };
    EXPECT_EQ(guess(60, 140, 50), "foliage");
    EXPECT_EQ(guess(120, 80, 40), "wood");
    EXPECT_EQ(guess(150, 60, 50), "brick");
    EXPECT_EQ(guess(128, 128, 128), "concrete");
    EXPECT_EQ(guess(250, 250, 245), "plaster");
    EXPECT_EQ(guess(20, 40, 200), "plastic");
    VoxWriter writer;
    writer.model({2, 1, 1}, {{0, 0, 0, 60}, {1, 0, 0, 100}});
    VoxImportSettings settings;
    settings.teardownPalette = true;
    const Level level = import(writer, nullptr, settings);
    const Palette& palette = *level.bodies.at(0).shapes[0].palette;
    EXPECT_EQ(level.materials[palette[60].material].name, "wood");
    EXPECT_EQ(level.materials[palette[100].material].name, "brick");
}

TEST(VoxImport, DefaultColours) {
    const auto colors = defaultVoxColors();
    using Color = std::array<uint8_t, 4>;
    EXPECT_EQ(colors[1], (Color{255, 255, 255, 255}));
    EXPECT_EQ(colors[2], (Color{255, 255, 204, 255}));
    EXPECT_EQ(colors[7], (Color{255, 204, 255, 255}));
    EXPECT_EQ(colors[37], (Color{204, 255, 255, 255}));
    EXPECT_EQ(colors[215], (Color{0, 0, 51, 255}));
    EXPECT_EQ(colors[216], (Color{238, 0, 0, 255}));
    EXPECT_EQ(colors[226], (Color{0, 238, 0, 255}));
    EXPECT_EQ(colors[255], (Color{17, 17, 17, 255}));
}

TEST(VoxImport, OtherChunksAreReadOrCounted) {
    VoxWriter writer;
    VoxWriter::Bytes two, notes, settings;
    VoxWriter::put(two, 2u);
    VoxWriter::put(notes, 1u), VoxWriter::put(notes, std::string("grass"));
    VoxWriter::put(settings, VoxWriter::Attributes{{"_type", "_inf"}});
    writer.chunk("PACK", two).model({1, 1, 1}, {{0, 0, 0, 1}}).model({2, 1, 1}, {{0, 0, 0, 1}});
    writer.chunk("NOTE", notes)
        .chunk("rOBJ", settings)
        .chunk("zzzz", {1, 2, 3})
        .described("rCAM", 0, {{"_focus", "10 20 30"}});
    ImportReport report;
    const Level level = import(writer, &report);
    EXPECT_TRUE(reportHas(report, "NOTE"));
    EXPECT_TRUE(reportHas(report, "rOBJ"));
    EXPECT_TRUE(reportHas(report, "1 zzzz chunks"));
    ASSERT_EQ(level.locations.size(), 1u);
    EXPECT_EQ(level.locations[0].second.position, glm::dvec3(10, 30, -20) * 0.1);
    EXPECT_EQ(worldCells(level).size(), 2u) << "models without a scene do not overlap";
}

TEST(VoxImport, ErrorsNamePlaceExpectedAndFound) {
    const auto has = [](const std::string& error, std::initializer_list<const char*> parts) {
        for (const char* part : parts) EXPECT_NE(error.find(part), std::string::npos) << error << "\n lacks " << part;
    };
    VoxWriter outside;
    outside.model({2, 2, 2}, {{0, 0, 0, 1}, {1, 2, 0, 1}});
    has(importError(outside),
        {"test.vox", "byte 64", "XYZI", "expected a cell inside the model of 2x2x2", "found cell (1, 2, 0)"});
    VoxWriter huge;
    huge.model({2, 300, 2}, {});
    has(importError(huge), {"byte 36", "0 to 256", "found 300"});
    VoxWriter count;
    count.model({1, 1, 1}, {})
        .chunk("SIZE", {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0})
        .chunk("XYZI", {255, 255, 255, 127, 0, 0, 0, 0});
    has(importError(count), {"expected 2147483647 voxels", "found 4 bytes"});
    VoxWriter child;
    child.model({1, 1, 1}, {}).transform(0, 77, {{}});
    has(importError(child), {"scene node", "found id 77"});
    VoxWriter cycle;
    cycle.model({1, 1, 1}, {}).transform(0, 1, {{}}).group(1, {2}).transform(2, 1, {{}});
    has(importError(cycle), {"cycle"});
    VoxWriter far;
    far.model({1, 1, 1}, {}).transform(0, 1, {{{"_t", "99999999999 0 0"}}}).shape(1, {0});
    has(importError(far), {"translation", "99999999999"});
    VoxWriter noSuchModel;
    noSuchModel.model({1, 1, 1}, {}).transform(0, 1, {{}}).shape(1, {5});
    has(importError(noSuchModel), {"model number below 1", "found 5"});
    EXPECT_NE(std::string(importVoxBytes({}, "empty.vox", {}).error()).find("empty.vox"), std::string::npos);
    EXPECT_NE(importVox("/no/such.vox", {}).error().find("/no/such.vox"), std::string::npos);
}

TEST(VoxImport, AShortFileCannotDescribeAHugeScene) {
    VoxWriter writer;
    writer.model({1, 1, 1}, {{0, 0, 0, 1}});
    writer.transform(0, 1, {{}});
    for (int i = 1; i < 31; ++i) writer.group(i, {i + 1, i + 1});  // 2^30 paths
    writer.shape(31, {0});
    EXPECT_NE(importError(writer).find("at most"), std::string::npos);
}

VoxWriter::Bytes everyChunk() {
    VoxWriter writer;
    VoxWriter::Bytes notes, map, settings, old;
    VoxWriter::put(notes, 1u), VoxWriter::put(notes, std::string("row"));
    VoxWriter::put(settings, VoxWriter::Attributes{{"_type", "_inf"}});
    for (int i = 0; i < 256; ++i) map.push_back(uint8_t(i + 1));
    VoxWriter::put(old, 4u), VoxWriter::put(old, 1u), VoxWriter::put(old, 0x3f000000u), VoxWriter::put(old, 0u);
    writer.model({2, 2, 2}, {{0, 0, 0, 1}, {1, 1, 1, 4}}).transform(0, 1, {{}}).group(1, {2});
    writer.transform(2, 3, {{{"_r", "33"}, {"_t", "1 2 3"}}}, {{"_name", "a"}}, 0)
        .shape(3, {0})
        .described("LAYR", 0, {{"_name", "l"}});
    writer.described("MATL", 1, {{"_type", "_emit"}, {"_emit", "1"}})
        .chunk("MATT", old)
        .chunk("NOTE", notes)
        .chunk("rOBJ", settings);
    writer.described("rCAM", 0, {{"_focus", "1 2 3"}}).chunk("IMAP", map);
    return writer.file();
}

TEST(VoxImport, EveryTruncationIsAnErrorWithAnOffset) {
    const VoxWriter::Bytes whole = everyChunk();
    ASSERT_TRUE(importVoxBytes(whole, "t.vox", {}));
    for (size_t length = 0; length < whole.size(); ++length) {
        const Result<Level> level = importVoxBytes(std::span(whole).first(length), "t.vox", {});
        ASSERT_FALSE(level) << length;
        ASSERT_EQ(level.error().rfind("t.vox: byte ", 0), 0u) << level.error();
    }
}

TEST(VoxImport, EveryBitFlipIsReadOrRefused) {
    VoxWriter::Bytes bytes = everyChunk();
    int refused = 0;
    for (size_t bit = 0; bit < bytes.size() * 8; ++bit) {
        bytes[bit / 8] ^= uint8_t(1u << bit % 8);
        const Result<Level> level = importVoxBytes(bytes, "t.vox", {});
        if (!level) {
            ++refused;
            ASSERT_EQ(level.error().rfind("t.vox: byte ", 0), 0u) << level.error();
        }
        bytes[bit / 8] ^= uint8_t(1u << bit % 8);
    }
    EXPECT_GT(refused, int(bytes.size()));
}

TEST(VoxImport, ModelsOfTeardownAreReadAsThoseOfMagicaVoxel) {
    const glm::ivec3 size(5, 7, 11);
    std::vector<uint8_t> cells(5 * 7 * 11);
    std::vector<std::array<uint8_t, 4>> voxels;
    for (size_t i = 0; i < cells.size(); ++i) {
        cells[i] = i % 3 ? uint8_t(1 + i % 250) : uint8_t(0);
        if (cells[i]) voxels.push_back({uint8_t(i % 5), uint8_t(i / 5 % 7), uint8_t(i / 35), cells[i]});
    }
    std::array<std::array<uint8_t, 4>, 256> colors{};
    for (size_t i = 0; i < 256; ++i) colors[i] = {uint8_t(i), uint8_t(255 - i), 7, 255};
    VoxWriter usual;
    usual.model(size, voxels).colors(colors);
    const uint64_t expected = hashLevel(import(usual));
    for (const bool hasSize : {true, false}) {
        VoxWriter teardown;
        teardown.packedModel(size, cells, hasSize).colors(colors, 255);
        ImportReport report;
        EXPECT_EQ(hashLevel(import(teardown, &report)), expected) << "with a SIZE chunk: " << hasSize;
        EXPECT_TRUE(reportHas(report, "RGBA: expected 256 colours, found 255"));
    }
}

TEST(VoxImport, ShortPalettesKeepTheDefaultColoursOfTheOthers) {
    std::array<std::array<uint8_t, 4>, 256> colors{};
    VoxWriter writer;
    writer.model({2, 1, 1}, {{0, 0, 0, 3}, {1, 0, 0, 4}}).colors(colors, 3);
    ImportReport report;
    const Level level = import(writer, &report);
    const Palette& palette = *level.bodies.at(0).shapes.at(0).palette;
    EXPECT_EQ(palette[3].red, 0);
    EXPECT_EQ(palette[4].green, defaultVoxColors()[4][1]);
    EXPECT_TRUE(reportHas(report, "found 3: the others are MagicaVoxel's default colours"));
}

TEST(VoxImport, DamagedModelsOfTeardownAreRefused) {
    VoxWriter shorter;
    shorter.packedModel({4, 4, 4}, std::vector<uint8_t>(63, 1));
    EXPECT_NE(importError(shorter).find("expected 64 cells of a model of 4x4x4, found 63"), std::string::npos)
        << importError(shorter);
    VoxWriter longer;
    longer.packedModel({4, 4, 4}, std::vector<uint8_t>(99, 1));
    EXPECT_EQ(importError(longer), "no error") << "what follows the last cell does not matter";
    VoxWriter none;
    none.chunk("TDCZ", {4, 0, 0, 0, 4, 0, 0, 0, 4, 0, 0, 0, 'x', 'y', 'z'});
    EXPECT_NE(importError(none).find("found 0: the packed data is damaged"), std::string::npos) << importError(none);
    std::vector<uint8_t> closed{4, 0, 0, 0, 4, 0, 0, 0, 4, 0, 0, 0}, packed(compressBound(64));
    uLongf packedSize = uLongf(packed.size());
    ASSERT_EQ(compress(packed.data(), &packedSize, std::vector<uint8_t>(64, 1).data(), 64), Z_OK);
    closed.insert(closed.end(), packed.begin(), packed.begin() + std::ptrdiff_t(packedSize));
    VoxWriter whole, wrong;
    whole.chunk("TDCZ", closed);
    EXPECT_EQ(importError(whole), "no error") << "a stream that is closed";
    ++closed.back();
    wrong.chunk("TDCZ", closed);
    EXPECT_NE(importError(wrong).find("a wrong checksum"), std::string::npos) << importError(wrong);
    VoxWriter sizes;
    sizes.chunk("SIZE", {5, 0, 0, 0, 4, 0, 0, 0, 4, 0, 0, 0})
        .packedModel({4, 4, 4}, std::vector<uint8_t>(64, 1), false);
    EXPECT_NE(importError(sizes).find("expected 5x4x4, as its SIZE chunk says, found 4x4x4"), std::string::npos)
        << importError(sizes);
}

TEST(VoxImport, NestedMainChunksAreRefused) {
    VoxWriter::Bytes bytes{'V', 'O', 'X', ' ', 150, 0, 0, 0};
    constexpr uint32_t kLevels = 100'000;
    for (uint32_t i = 0; i < kLevels; ++i) {
        bytes.insert(bytes.end(), {'M', 'A', 'I', 'N'});
        VoxWriter::put(bytes, 0u), VoxWriter::put(bytes, (kLevels - 1 - i) * 12);
    }
    const Result<Level> level = importVoxBytes(bytes, "deep.vox", {});
    ASSERT_FALSE(level);
    EXPECT_NE(level.error().find("expected no MAIN chunk inside another"), std::string::npos) << level.error();
}

/// Groups of which each has all 40 objects of the next level as children, 64,000 objects in all.
VoxWriter manyObjects(const std::string& name) {
    VoxWriter writer;
    VoxWriter::Bytes cells(256 * 256 * 256);
    cells.front() = cells.back() = 1;
    writer.packedModel({256, 256, 256}, cells);
    const std::vector<int> fan(40, 1);
    writer.group(0, fan).group(1, std::vector<int>(40, 2)).group(2, std::vector<int>(40, 3));
    writer.transform(3, 4, {{}}, {{"_name", name}}).shape(4, {0});
    return writer;
}

TEST(VoxImport, ObjectsByTheThousandTakeNoMoreMemoryThanTheBudgetOfTheFile) {
    const VoxWriter writer = manyObjects(std::string(100'000, 'n'));
    EXPECT_LT(writer.file().size(), 130'000u);
    EXPECT_NE(importError(writer).find("expected objects that take at most 128 MiB"), std::string::npos)
        << importError(writer);
}

}  // namespace
}  // namespace rubble
