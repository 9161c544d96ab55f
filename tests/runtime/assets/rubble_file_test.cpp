#include "runtime/assets/rubble_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "runtime/assets/chunk_file.h"
#include "runtime/core/hash.h"
#include "runtime/core/ranges.h"
#include "runtime/world/world.h"
#include "tests/runtime/assets/padding.h"
#include "tests/runtime/assets/sample_level.h"
#include "tests/support/grids.h"
#include "tests/support/temp_folder.h"

namespace rubble {
namespace {

namespace fs = std::filesystem;

TEST(RubbleFile, RoundTripKeepsTheHash) {
    const Level level = sampleLevel();
    const std::vector<uint8_t> bytes = levelToRubble(level);
    const Result<Level> back = levelFromRubble(bytes, "sample.rubble");
    ASSERT_TRUE(back) << back.error();
    EXPECT_EQ(hashLevel(*back), hashLevel(level));
    EXPECT_EQ(levelToRubble(*back), bytes);
    EXPECT_EQ(back->bodies[0].shapes[0].palette, back->bodies[1].shapes[0].palette) << "shared palettes stay shared";
    EXPECT_EQ(back->bodies[0].shapes[0].grid.voxelCount(), level.bodies[0].shapes[0].grid.voxelCount());
}

/// As files have always had it: no boxes, or boxes with cells. Only a box without cells means that none hold the shape.
TEST(RubbleFile, AStaticShapeWithoutBoxesOfAnchorsIsHeldByItsLowestLayer) {
    const CellBox top{{0, 5, 0}, {6, 6, 6}}, lowest{{0, 0, 0}, {6, 1, 6}};
    using Boxes = std::vector<CellBox>;
    for (const auto& [written, loaded] :
         {std::pair<Boxes, Boxes>{{}, {lowest}}, {{top}, {top}}, {kNoAnchors, {}}, {{top, CellBox{}}, {top}}}) {
        Level level;
        LevelBody& body = level.bodies.emplace_back();
        body.isStatic = true;
        LevelShape& shape = body.shapes.emplace_back();
        shape.grid = solidGrid({6, 6, 6}, 1);
        shape.anchors = written;
        const Result<Level> back = levelFromRubble(levelToRubble(level), "level");
        ASSERT_TRUE(back) << back.error();
        EXPECT_EQ(back->bodies[0].shapes[0].anchors, written);
        World world;
        world.load(*back);
        EXPECT_EQ(world.shapes().at(world.shapes().handleAt(0)).anchors, loaded);
    }
}

TEST(RubbleFile, TheHashSeesEveryField) {
    const uint64_t original = hashLevel(sampleLevel());
    const std::vector<std::function<void(Level&)>> changes = {
        [](Level& l) { l.name += "x"; },
        [](Level& l) { l.materials.materials[3].burnTime += 1; },
        [](Level& l) { l.environment.fogDistance += 1; },
        [](Level& l) { l.environment.wetness += 0.25f; },
        [](Level& l) { l.locations[0].second.position.x += 1e-12; },
        [](Level& l) { l.scripts[0].parameters += "x"; },
        [](Level& l) { l.bodies[0].tags.pop_back(); },
        [](Level& l) { l.bodies[0].isStatic = false; },
        [](Level& l) { l.bodies[1].velocity.z = 0; },
        [](Level& l) { l.bodies[1].gravityScale = 1.0; },
        [](Level& l) { l.bodies[1].linearDamping = 0.0; },
        [](Level& l) { l.bodies[1].angularDamping = 0.0; },
        [](Level& l) { l.bodies[1].pose.rotation = glm::dquat(1, 0, 0, 0); },
        [](Level& l) { l.bodies[0].shapes[0].anchors[1].high.x += 1; },
        [](Level& l) { l.bodies[1].shapes[0].hidden = false; },
        [](Level& l) { l.bodies[0].shapes[1].voxelSize = 0.1f; },
        [](Level& l) { l.bodies[0].shapes[1].strength = 1.0f; },
        [](Level& l) { l.bodies[0].shapes[1].loadBearing = true; },
        [](Level& l) { l.bodies[0].shapes[1].collisionMask = 13; },
        [](Level& l) { l.bodies[0].shapes[1].collisionShape = CollisionShape::Sphere; },
        [](Level& l) { l.waters[0].outline[1].z = 0.5; },
        [](Level& l) { l.waters[0].waves.speed = 2.0f; },
        [](Level& l) { l.triggers[0].kind = TriggerKind::Box; },
        [](Level& l) { l.triggers[0].tags.clear(); },
        [](Level& l) { l.characters[0].maxSlope = 0.9; },
        [](Level& l) { l.characters[0].grounded = false; },
        [](Level& l) {
            auto palette = std::make_shared<Palette>(*l.bodies[0].shapes[0].palette);
            (*palette)[200].blue = 9;
            l.bodies[0].shapes[0].palette = palette;
        },
        [](Level& l) {
            GridWriter(l.bodies[0].shapes[0].grid).set({19, 8, 32}, 77);
        },
        [](Level& l) {
            auto colors = std::make_shared<PaintColors>(*l.bodies[0].shapes[0].paintColors);
            colors->colors[1][2] += 1;
            l.bodies[0].shapes[0].paintColors = colors;
        },
        [](Level& l) {
            l.bodies[0].shapes[0].grid.setBrick({0, 0, 0},
                                                makeBrick(*l.bodies[0].shapes[0].grid.brickAt({0, 0, 0})->paint));
        },
        [](Level& l) { l.lights[0].light.coneOuter = 0.7f; },
        [](Level& l) { l.lights[0].groupName = "unused"; },
        [](Level& l) { l.lightGroups[1].out = false; },
    };
    for (size_t i = 0; i < changes.size(); ++i) {
        Level level = sampleLevel();
        changes[i](level);
        EXPECT_NE(hashLevel(level), original) << "change " << i;
    }
}

TEST(RubbleFile, EveryTruncationAndEveryBitFlipIsRefused) {
    std::vector<uint8_t> bytes = levelToRubble(sampleLevel());
    for (size_t length = 0; length < bytes.size(); length += length < 400 ? 1 : 37)
        ASSERT_FALSE(levelFromRubble(std::span(bytes).first(length), "t")) << length;
    for (size_t byte = 0; byte < bytes.size(); byte += byte < 400 ? 1 : 7)
        for (int bit = 0; bit < 8; ++bit) {
            bytes[byte] ^= uint8_t(1 << bit);
            const Result<Level> level = levelFromRubble(bytes, "t.rubble");
            ASSERT_FALSE(level) << "byte " << byte << " bit " << bit;
            ASSERT_EQ(level.error().rfind("t.rubble: byte ", 0), 0u) << level.error();
            bytes[byte] ^= uint8_t(1 << bit);
        }
}

/// The file with one value of its first chunk header changed and all checksums recomputed.
std::vector<uint8_t> withForgedHeader(std::vector<uint8_t> bytes, size_t offsetInHeader, uint64_t value) {
    std::memcpy(bytes.data() + 32 + offsetInHeader, &value, 8);
    uint64_t stored;
    std::memcpy(&stored, bytes.data() + 32 + 16, 8);
    const uint64_t hash = hashBytes(bytes.data() + 64, size_t(stored), hashBytes(bytes.data() + 32, 24));
    std::memcpy(bytes.data() + 32 + 24, &hash, 8);
    return bytes;
}

TEST(RubbleFile, WrongSizesWithValidChecksumsAreRefused) {
    const std::vector<uint8_t> bytes = levelToRubble(sampleLevel());
    const Result<Level> bomb = levelFromRubble(withForgedHeader(bytes, 8, uint64_t(1) << 28), "t");
    ASSERT_FALSE(bomb);
    EXPECT_NE(bomb.error().find("possible size"), std::string::npos) << bomb.error();
    ASSERT_FALSE(levelFromRubble(withForgedHeader(bytes, 8, 5000), "t"));
}

/// Recordings and edits check the squared length: what they take must be readable in the saves that follow.
TEST(RubbleFile, ARotationIsWhatEditsTakeForOne) {
    const TempFolder folder;
    for (const double length2 : {ranges::kRotationLength2.low + 1e-7, ranges::kRotationLength2.high - 1e-7}) {
        Level level = sampleLevel();
        level.bodies[0].pose.rotation = glm::dquat(std::sqrt(length2), 0, 0, 0);
        EXPECT_TRUE(writeRubble(folder / "level.rubble", level)) << length2;
        const Result<Level> read = readRubble(folder / "level.rubble");
        EXPECT_TRUE(read) << read.error();
    }
}

TEST(RubbleFile, InvalidLevelsAreNotWritten) {
    const TempFolder folder;
    const std::string path = folder / "senseless.rubble";
    const auto error = [&](const std::function<void(Level&)>& change) {
        Level level = sampleLevel();
        change(level);
        const Result<Done> done = writeRubble(path, level);
        return done ? "written" : done.error();
    };
    EXPECT_NE(error([](Level& l) {
                  l.bodies[1].pose.position.y = std::numeric_limits<double>::quiet_NaN();
              }).find("bodies[1]: expected a valid body, found pose.position[1] is "),
              std::string::npos);
    EXPECT_NE(error([](Level& l) { l.bodies[0].shapes[1].voxelSize = 0; }).find("voxel_size is 0"), std::string::npos);
    EXPECT_NE(error([](Level& l) { l.bodies[0].shapes[1].strength = -1.0f; }).find("strength is -1"),
              std::string::npos);
    EXPECT_NE(error([](Level& l) {
                  l.lights[0].light.name = "\xff";
              }).find("lights[0]: expected a valid light, found name is no text in UTF-8"),
              std::string::npos);
    EXPECT_NE(error([](Level& l) {
                  l.lights[0].light.reach = -1.0f;
              }).find("lights[0]: expected a valid light, found reach is -1"),
              std::string::npos);
    EXPECT_NE(error([](Level& l) {
                  l.environment.clouds = 2.0f;
              }).find("environment: expected a valid environment, found clouds is 2"),
              std::string::npos);
    EXPECT_NE(error([](Level& l) { l.lightGroups.pop_back(); }).find("light group"), std::string::npos);
    EXPECT_NE(error([](Level& l) { l.bodies[0].pose.rotation = glm::dquat(2, 0, 0, 0); }).find("rotation"),
              std::string::npos);
    EXPECT_FALSE(fs::exists(path));
}

TEST(RubbleFile, WhatIsNoFileIsRefusedAndNeverWaitedFor) {
    const TempFolder folder;
    ASSERT_EQ(mkfifo((folder / "pipe.rubble").c_str(), 0600), 0);
    const Result<Level> pipe = readLevel(folder / "pipe.rubble", "");
    ASSERT_FALSE(pipe);
    EXPECT_NE(pipe.error().find("expected a file, found something else"), std::string::npos) << pipe.error();
    EXPECT_FALSE(readRubble(folder.path().string()));
}

/// A level whose one shape is large and has no voxels: many bytes of memory from few.
Level largeEmptyGrids(int count) {
    Level level;
    for (int i = 0; i < count; ++i) {
        LevelBody& body = level.bodies.emplace_back();
        body.shapes.push_back({.name = "shape", .grid = VoxelGrid({2048, 512, 512}), .hidden = true});
    }
    return level;
}

TEST(RubbleFile, ReadingTakesNoMoreMemoryThanTheBudgetOfTheFile) {
    const Level level = largeEmptyGrids(300);  // 300 directories of 16,384 nodes
    const std::vector<uint8_t> bytes = levelToRubble(level);
    EXPECT_TRUE(levelFromRubble(bytes, "t")) << "what is written can be read";
    const std::vector<uint8_t> bomb = withoutPadding(bytes);
    EXPECT_LT(bomb.size(), bytes.size());
    EXPECT_LT(bomb.size(), 20'000u);
    const Result<Level> refused = levelFromRubble(bomb, "t");
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().find("expected what takes at most 128 MiB"), std::string::npos) << refused.error();
}

TEST(RubbleFile, FilesAreReplacedWhole) {
    const TempFolder folder;
    const std::string path = folder / "level.rubble";
    ASSERT_TRUE(writeRubble(path, sampleLevel()));
    Level second = sampleLevel();
    second.name = "second";
    ASSERT_TRUE(writeRubble(path, second));
    const Result<Level> back = readLevel(path, "");
    ASSERT_TRUE(back) << back.error();
    EXPECT_EQ(back->name, "second");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1)
        << "no temporary files stay";
    EXPECT_NE(writeRubble("/no/such/folder/x.rubble", second).error().find("/no/such/folder"), std::string::npos);
}

}  // namespace
}  // namespace rubble
