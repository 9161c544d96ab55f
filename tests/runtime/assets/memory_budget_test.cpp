#include "runtime/assets/memory_budget.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include "runtime/assets/chunk_file.h"
#include "runtime/assets/recording_file.h"
#include "runtime/assets/rubble_file.h"
#include "runtime/assets/save_file.h"
#include "runtime/assets/vox_import.h"
#include "runtime/world/world.h"
#include "tests/runtime/assets/broken_world.h"
#include "tests/runtime/assets/padding.h"
#include "tests/runtime/assets/vox_writer.h"
#include "tests/support/allocation_count.h"

namespace rubble {
namespace {

using Bytes = std::vector<uint8_t>;

/// A kind of file that takes much memory for few bytes: `make` makes one with so many of something, `read` reads it and
/// returns the error.
struct Bomb {
    std::string name;
    std::function<Bytes(size_t count)> make;
    std::function<std::string(const Bytes&)> read;
};
void PrintTo(const Bomb& bomb, std::ostream* out) {
    *out << bomb.name;
}

template <class Value>
std::string errorOf(const Result<Value>& result) {
    return result ? "" : result.error();
}

/// `change(state, count)` puts so many of something into a saved game.
template <class Change>
Bomb save(const char* name, Change change) {
    const auto make = [=](size_t count) {
        World world(1);
        world.load(test::oneShapeLevel(solidGrid({4, 4, 4}, 1), true));
        SavedGame game{world.state(), {}};
        change(game, count);
        return withoutPadding(gameToBytes(game, 0, nullptr));
    };
    return {std::string("save_") + name, make,
            [](const Bytes& file) { return errorOf(gameFromBytes(file, "bomb", 1)); }};
}

template <class Handle, class T>
void addEmptySlots(SlotMap<Handle, T>& map, size_t count) {
    auto slots = map.slots();
    slots.resize(slots.size() + count);
    map = {1, std::move(slots), {}};
}

template <class Change>
Bomb level(const char* name, Change change) {
    const auto make = [=](size_t count) {
        Level out = test::oneShapeLevel(solidGrid({4, 4, 4}, 1), true);
        change(out, count);
        return withoutPadding(levelToRubble(out));
    };
    return {std::string("level_") + name, make,
            [](const Bytes& file) { return errorOf(levelFromRubble(file, "bomb")); }};
}

template <class Change>
Bomb recording(const char* name, Change change) {
    const auto make = [=](size_t count) {
        const World world = test::brokenWorld();
        ChunkWriter file;
        file.add({'G', 'A', 'M', 'E'}, gameToBytes({world.state(), {}}));
        RecordedStep step{.step = world.step() + 1};
        change(step, count);
        file.add({'S', 'T', 'E', 'P'}, recordedStepToBytes(step));
        return withoutPadding(file.file(0));
    };
    return {std::string("recording_") + name, make,
            [](const Bytes& file) { return errorOf(recordingFromBytes(file, "bomb", 1)); }};
}

template <class Change>
Bomb vox(const char* name, Change change) {
    const auto make = [=](size_t count) {
        VoxWriter writer;
        writer.model({1, 1, 1}, {{0, 0, 0, 1}});
        change(writer, count);
        return writer.file();
    };
    return {std::string("vox_") + name, make,
            [](const Bytes& file) { return errorOf(importVoxBytes(file, "bomb.vox", {})); }};
}

std::vector<Bomb> savesAndRecordings() {
    return {
        save("bodies", [](SavedGame& game, size_t count) { addEmptySlots(game.world.bodies, count); }),
        save("lights", [](SavedGame& game, size_t count) { addEmptySlots(game.world.lights, count); }),
        save("joints", [](SavedGame& game, size_t count) { addEmptySlots(game.world.joints, count); }),
        save("characters",
             [](SavedGame& game, size_t count) {
                 for (size_t i = 0; i < count; ++i) game.world.characters.insert({});
             }),
        save("water",
             [](SavedGame& game, size_t count) {
                 for (size_t i = 0; i < count; ++i)
                     game.world.waters.insert({.outline = {{0, 0}, {1, 0}, {1, 1}}, .depth = 1.0});
             }),
        save("places", [](SavedGame& game, size_t count) { game.world.locations.resize(count); }),
        save("materials", [](SavedGame& game, size_t count) { game.world.materials.materials.resize(count); }),
        save("edits", [](SavedGame& game, size_t count) { game.pending.resize(count, HistoryEdit{}); }),
        save("waiting",
             [](SavedGame& game, size_t count) {
                 game.world.pendingSplits.resize(count, {game.world.shapes.handleAt(0), {}, {}});
             }),
        save("unsettled",
             [](SavedGame& game, size_t count) { game.world.unsettled.resize(count, game.world.bodies.handleAt(0)); }),
        save("heat",
             [](SavedGame& game, size_t count) {
                 game.world.fire.fields = {{game.world.shapes.handleAt(0), std::vector<HotBrick>(count)}};
             }),
        recording("edits", [](RecordedStep& step, size_t count) { step.edits.resize(count, HistoryEdit{}); }),
        recording("poses", [](RecordedStep& step, size_t count) { step.poses.resize(count); }),
        recording("characters", [](RecordedStep& step, size_t count) { step.characters.resize(count); }),
        recording("delta", [](RecordedStep& step, size_t count) { step.delta.resize(count * 64); }),
    };
}

std::vector<Bomb> levelsAndModels() {
    return {
        level("bodies", [](Level& out, size_t count) { out.bodies.resize(count); }),
        level("shapes", [](Level& out, size_t count) { out.bodies[0].shapes.resize(count); }),
        level("grids",
              [](Level& out, size_t count) {
                  const LevelShape shape{.name = "shape", .grid = VoxelGrid({2048, 512, 512}), .hidden = true};
                  out.bodies[0].shapes.resize(count / 64, shape);
              }),
        level("palettes",
              [](Level& out, size_t count) {
                  for (size_t i = 0; i < count / 64; ++i) {
                      auto palette = std::make_shared<Palette>();
                      (*palette)[1].red = uint8_t(i), (*palette)[1].green = uint8_t(i >> 8);
                      out.bodies[0].shapes.push_back({.grid = solidGrid({1, 1, 1}, 1), .palette = palette});
                  }
              }),
        level("lights", [](Level& out, size_t count) { out.lights.resize(count); }),
        level("joints", [](Level& out, size_t count) { out.joints.resize(count); }),
        level("outlines", [](Level& out, size_t count) { out.waters.push_back({.outline = GroundPolygon(count)}); }),
        level("places", [](Level& out, size_t count) { out.locations.resize(count); }),
        vox("frames",
            [](VoxWriter& out, size_t count) { out.transform(0, 1, std::vector<VoxWriter::Attributes>(count)); }),
        vox("groups", [](VoxWriter& out, size_t count) { out.group(0, std::vector<int>(count, 1)); }),
        vox("nodes",
            [](VoxWriter& out, size_t count) {
                for (size_t i = 0; i < count / 8; ++i) out.group(int(i), {});
            }),
        vox("notes",
            [](VoxWriter& out, size_t count) {
                VoxWriter::Bytes notes(4 + 4 * count);
                std::memcpy(notes.data(), &count, 4);
                out.chunk("NOTE", notes);
            }),
        vox("materials",
            [](VoxWriter& out, size_t count) {
                for (size_t i = 0; i < count / 8; ++i) out.described("MATL", int(i), {});
            }),
        vox("attributes",
            [](VoxWriter& out, size_t count) {
                VoxWriter::Attributes attributes;
                for (size_t i = 0; i < count / 2; ++i) attributes[std::to_string(i)] = "";
                out.described("LAYR", 0, attributes);
            }),
        vox("objects",
            [](VoxWriter& out, size_t count) {
                out.transform(0, 1, {{}}, {{"_name", std::string(200, 'n')}});
                out.group(1, std::vector<int>(std::min<size_t>(count / 8, 65'000), 2)).shape(2, {0});
            }),
        vox("objects_of_colour",
            [](VoxWriter& out, size_t count) {
                out.described("MATL", 1, {{"_type", "_emit"}, {"_emit", "0.7"}});
                out.group(0, std::vector<int>(std::min<size_t>(count / 8, 65'000), 1)).shape(1, {0});
            }),
        vox("models",
            [](VoxWriter& out, size_t count) {
                for (size_t i = 0; i < count / 64; ++i)
                    out.packedModel({256, 256, 1}, VoxWriter::Bytes(256 * 256, uint8_t(i | 1)));
            }),
    };
}

class MemoryBudgetOf : public testing::TestWithParam<Bomb> {};

/// Each file has eight times as many as the one before, until the reader refuses one.
TEST_P(MemoryBudgetOf, ReadingNeverTakesMore) {
    const auto& [name, make, read] = GetParam();
    for (size_t count = 2000; count <= 1'024'000; count *= 8) {
        const Bytes file = make(count);
        const size_t before = allocatedBytes();
        countPeakFromNow();
        const std::string error = read(file);
        const size_t peak = peakAllocatedBytes() - before,
                     budget = MemoryBudget::kFree + MemoryBudget::kPerByte * file.size();
        EXPECT_LE(peak, budget) << count << " in a file of " << file.size() << " bytes: " << error;
        RecordProperty("bytes_for_" + std::to_string(file.size()), std::to_string(peak));
        if (error.find("takes at most") != std::string::npos || error.find("take at most") != std::string::npos) return;
    }
}

std::string nameOf(const testing::TestParamInfo<Bomb>& info) {
    return info.param.name;
}
INSTANTIATE_TEST_SUITE_P(Saves, MemoryBudgetOf, testing::ValuesIn(savesAndRecordings()), nameOf);
INSTANTIATE_TEST_SUITE_P(Levels, MemoryBudgetOf, testing::ValuesIn(levelsAndModels()), nameOf);

}  // namespace
}  // namespace rubble
