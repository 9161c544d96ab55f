#include "runtime/assets/step_delta.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "runtime/assets/delta_file.h"
#include "runtime/world/history/world_baseline.h"
#include "tests/runtime/assets/broken_world.h"

namespace rubble {
namespace {

using namespace test;

/// The bytes of a step in which the world's journal is `changes`.
std::vector<uint8_t> deltaOf(const World& world, WorldBaseline& baseline, const FrameChanges& changes) {
    PaletteList list;
    return stepDeltaToBytes(baseline.update(world, changes), changes, world, list);
}

void expectRefused(const std::vector<uint8_t>& bytes, const World& start, const char* expected) {
    World world = start;
    std::vector<PaletteRef> palettes;
    const Result<FrameChanges> applied = applyStepDelta(bytes, "t", world, palettes);
    ASSERT_FALSE(applied);
    EXPECT_NE(applied.error().find(expected), std::string::npos) << applied.error();
    EXPECT_EQ(world.hash(), start.hash());
    EXPECT_LT(world.bodies().slotCount(), 1000u);
}

TEST(StepDelta, AShapeWithoutABodyIsRefusedWhenTheBodyInSlot0Goes) {
    Level level = oneShapeLevel(solidGrid({8, 8, 8}, 1), false);
    LevelBody other{.name = "other", .pose = {{5.0, 0.0, 0.0}}, .isStatic = false};
    other.shapes.push_back(levelShape("other", solidGrid({16, 8, 8}, 1)));
    level.bodies.push_back(other);
    World host;
    host.load(level);
    host.applyEdits({});
    const World start = host;
    WorldBaseline baseline(host);
    const BodyHandle second = host.bodies().handleAt(1);
    std::vector<uint8_t> bytes = deltaOf(
        host, baseline, host.applyEdits({sphereCarve({0.4, 0.4, 0.4}, 1.0), sphereCarve({5.0, 0.0, 0.0}, 0.3)}));
    ASSERT_FALSE(host.bodies().handleAt(0));
    const uint64_t name = BodyHandle::make(0, second.generation(), second.slot()).bits, none = 0;
    std::array<uint8_t, 8> was{};
    std::memcpy(was.data(), &name, 8);
    int patches = 0;
    for (auto at = bytes.begin(); (at = std::search(at, bytes.end(), was.begin(), was.end())) != bytes.end(); ++at) {
        std::vector<uint8_t> patch = bytes;
        std::memcpy(&patch[size_t(at - bytes.begin())], &none, 8);
        World world = start;
        std::vector<PaletteRef> palettes;
        EXPECT_FALSE(applyStepDelta(patch, "t", world, palettes));
        ++patches;
    }
    EXPECT_GE(patches, 2) << "the handle of the body, and the body of its shape";
}

/// Else the other body would list it still, and no save of that world could be read.
TEST(StepDelta, AShapeThatAnotherBodyStillListsIsRefused) {
    Level level = oneShapeLevel(solidGrid({8, 8, 8}, 1), false);
    LevelBody other{.name = "other", .pose = {{5.0, 0.0, 0.0}}, .isStatic = false};
    other.shapes.push_back(levelShape("other", solidGrid({8, 8, 8}, 1)));
    level.bodies.push_back(other);
    World start;
    start.load(level);
    start.applyEdits({});
    const BodyHandle taker = start.bodies().handleAt(0);
    const ShapeHandle taken = start.shapes().handleAt(1);
    WorldState state = start.state();
    state.bodies.at(taker).shapes.push_back(taken);
    state.shapes.at(taken).body = taker;
    World host(start.id());
    host.setState(state);
    WorldBaseline baseline(start);
    FrameChanges changes;
    changes.teleported.push_back(taker);
    changes.filters.push_back(taken);
    WorldDelta before = baseline.update(host, changes);
    before.bodies.erase(1);
    PaletteList list;
    expectRefused(stepDeltaToBytes(before, changes, host, list), start, "shapes and bodies that name each other");
}

TEST(StepDelta, AFewBytesCannotNameAHighSlot) {
    World host = brokenWorld();
    const World start = host;
    for (const uint32_t slot : {1000u, 200000u, 0xfffffeu}) {
        host = start;
        WorldBaseline baseline(host);
        std::vector<uint8_t> bytes = deltaOf(host, baseline, host.applyEdits({AddLightEdit{}}));
        const LightHandle light = host.lights().handleAt(1);
        const uint64_t name = LightHandle::make(0, light.generation(), 1).bits,
                       high = LightHandle::make(0, light.generation(), slot).bits;
        std::array<uint8_t, 12> was{}, wanted{};
        const uint32_t one = 1;
        std::memcpy(was.data(), &one, 4), std::memcpy(was.data() + 4, &name, 8);
        std::memcpy(wanted.data(), &slot, 4), std::memcpy(wanted.data() + 4, &high, 8);
        const auto place = std::search(bytes.begin(), bytes.end(), was.begin(), was.end());
        ASSERT_NE(place, bytes.end());
        std::copy(wanted.begin(), wanted.end(), place);
        expectRefused(bytes, start, "slots");
    }
}

TEST(StepDelta, PaintOfColoursThatTheShapeHasNotIsRefused) {
    World start;
    start.load(oneShapeLevel(solidGrid({16, 8, 8}, 1), true));
    start.applyEdits({PaintEdit{.position = {0.4, 0.4, 0.4}, .radius = 3.0, .mode = PaintMode::Layer}});
    const ShapeHandle shape = firstShape(start);
    ASSERT_EQ(start.shapes().at(shape).paintColors->count, 1);
    const auto afterChange = [&](auto&& change) {
        WorldState state = start.state();
        change(state.shapes.at(shape));
        World host(start.id());
        host.setState(state);
        WorldBaseline baseline(start);
        FrameChanges changes;
        changes.palettes.push_back(shape);
        return deltaOf(host, baseline, changes);
    };
    for (const uint8_t paint : {0x2f, 0x05}) {
        BrickIndices indices, layer;
        indices.fill(1), layer.fill(paint);
        expectRefused(afterChange([&](Shape& each) {
                          each.grid.setBrick({1, 0, 0}, makeBrick(indices, &layer));
                      }),
                      start, "expected paint of the 1 colours that the shape has");
    }
    expectRefused(afterChange([](Shape& each) { each.paintColors = nullptr; }), start,
                  "expected paint of the 0 colours that the shape has");
}

TEST(StepDelta, AFollowerWithStressAnalysisGoesOnAsIfLoaded) {
    World host = brokenWorld();
    WorldSettings settings = host.settings();
    settings.stress.on = true;
    host.applyEdits({SettingsEdit{settings}});
    World follower(1);
    follower.setState(host.state());
    WorldBaseline baseline(host);
    PaletteList list;
    std::vector<PaletteRef> palettes;
    for (const Edits& edits : {Edits{sphereCarve({1.0, 2.0, 1.0}, 1.5)}, Edits{sphereCarve({2.0, 2.0, 1.0}, 9.0)}}) {
        const FrameChanges changes = host.applyEdits(edits);
        const std::vector<uint8_t> bytes = stepDeltaToBytes(baseline.update(host, changes), changes, host, list);
        ASSERT_TRUE(applyStepDelta(bytes, "t", follower, palettes));
        World loaded(1), goesOn = follower;
        loaded.setState(follower.state());
        for (int i = 0; i < 3; ++i) {
            goesOn.applyEdits({});
            loaded.applyEdits({});
            EXPECT_EQ(goesOn.hash(), loaded.hash());
        }
    }
}

TEST(StepDelta, TellsOfTheScriptsOfTheLevel) {
    World host = brokenWorld();
    World follower = host;
    WorldBaseline baseline(host);
    std::vector<PaletteRef> palettes;
    for (const std::vector<LevelScript>& scripts : {std::vector<LevelScript>{{"lift.lua", "speed=2"}}, {}}) {
        const auto bytes = deltaOf(host, baseline, host.applyEdits({SetScriptsEdit{scripts}}));
        const Result<FrameChanges> applied = applyStepDelta(bytes, "t", follower, palettes);
        ASSERT_TRUE(applied) << applied.error();
        EXPECT_EQ(follower.data().scripts, scripts);
        EXPECT_EQ(follower.data().scripts, host.data().scripts);
    }
}

TEST(StepEvents, AreReadAsTheyWereAndWithinTheirRanges) {
    const ShapeHandle shape = ShapeHandle::make(3, 7, 9);
    FrameChanges good;
    good.step = 5, good.paintedVoxels = 4;
    good.removed = {{shape, 2, 1, {10, 20, 30}, 77}};
    good.dust = {{{1.0, 2.0, 3.0}, 0.5, {4.0f, 5.0f, 6.0f}, {10, 20, 30}, 1, 77}};
    good.splits = {{shape, {shape}, {{8, 16, 24}}, {}}};
    const auto fileOf = [](const FrameChanges& changes) {
        DeltaWriter deltas(4, DeltaContent::EditsOnly, true);
        deltas.add({.step = 5});
        deltas.addEvents(changes);
        return deltas.file();
    };
    const Result<Deltas> read = deltasFromBytes(fileOf(good), "t", 200);
    ASSERT_TRUE(read) << read.error();
    FrameChanges told;
    addEvents(read->events.at(0), told);
    EXPECT_EQ(told.removed.at(0).shape, ShapeHandle::make(200, 7, 9));
    EXPECT_EQ(told.removed[0].count, 77u);
    EXPECT_EQ(told.dust.at(0).velocity, good.dust[0].velocity);
    EXPECT_EQ(told.splits.at(0).parentOffset, good.splits[0].parentOffset);
    EXPECT_EQ(told.paintedVoxels, 4u);
    EXPECT_FALSE(told.isRestored);
    FrameChanges undone = good;
    undone.isRestored = true;
    const Result<Deltas> again = deltasFromBytes(fileOf(undone), "t", 200);
    ASSERT_TRUE(again) << again.error();
    addEvents(again->events.at(0), told);
    EXPECT_TRUE(told.isRestored);
    std::vector<FrameChanges> bad(7, good);
    bad[0].dust[0].position.y = NAN;
    bad[1].dust[0].radius = -1.0;
    bad[2].blasts = {{{INFINITY, 0.0, 0.0}, 1.0}};
    bad[3].splits[0].parentOffset.clear();
    bad[4].step = 6;
    bad[5].dust[0].count = ~uint64_t(0);
    bad[6].blasts = {{{0.0, 0.0, 0.0}, 1e9}};
    for (size_t i = 0; i < bad.size(); ++i) EXPECT_FALSE(deltasFromBytes(fileOf(bad[i]), "t", 200)) << i;
}

}  // namespace
}  // namespace rubble
