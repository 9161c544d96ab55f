#include "runtime/world/history/undo_history.h"

#include <gtest/gtest.h>

#include "runtime/core/log.h"
#include "runtime/core/random.h"
#include "runtime/world/edits/edit_error.h"
#include "tests/runtime/world/journal_check.h"
#include "tests/runtime/world/undo_world.h"
#include "tests/support/allocation_count.h"

namespace rubble {
namespace {

using namespace test;

LightHandle anyLight(const World& world, Random& random) {
    return world.lights().handleAt(random.below(uint32_t(world.lights().slotCount())));
}

/// Edits that add, change and remove lights, and change the weather.
void addRandomLights(const World& world, Random& random, Edits& edits) {
    const auto anyHeight = [&] { return Pose{{0.1, random.unit() * 3.0, 0.1}}; };
    if (random.below(2))
        edits.push_back(
            AddLightEdit{{.shape = random.below(2) ? firstShape(world) : ShapeHandle{}, .local = anyHeight()}});
    if (const LightHandle light = anyLight(world, random); light && random.below(3) == 0) {
        Light changed = world.lights().at(light);
        changed.color.r += 1.0f;
        edits.push_back(SetLightEdit{light, changed});
    }
    if (const LightHandle light = anyLight(world, random); light && random.below(3) == 0)
        edits.push_back(RemoveLightEdit{light});
    if (random.below(3)) return;
    Environment weather = world.environment();
    weather.wetness = float(random.unit());
    edits.push_back(SetEnvironmentEdit{weather});
}

Edits randomEdits(const World& world, Random& random) {
    Edits edits;
    addRandomLights(world, random, edits);
    for (uint32_t i = random.below(3); i-- > 0;) {
        const double x = random.unit() * 7.0, y = random.unit() * 5.0;
        const uint32_t kind = random.below(4);
        if (kind < 2)
            edits.push_back(sphereCarve({x, y, 0.3}, 0.2 + 0.4 * random.unit()));
        else if (kind == 2)
            edits.push_back(PaintEdit{.position = {x, y, 0.3}, .radius = 1.0, .seed = random.next()});
        else
            edits.push_back(ExplodeEdit{.position = {x, y, 0.3}, .size = 1.0});
    }
    return edits;
}

/// The hash of a world that knows only what the journals said.
uint64_t baselineHash(const WorldBaseline& baseline) {
    World world;
    world.setState(baseline.last());
    return resolvedHash(world);
}

void expectShapesSound(const World& world) {
    EXPECT_TRUE(voxelAccounting(world).balances());
    world.shapes().forEach([&](ShapeHandle handle, const Shape& shape) {
        EXPECT_EQ(shape.moments, gridMoments(shape.grid, *shape.palette, world.materials()));
        const std::vector<ShapeHandle>& mates = world.bodies().at(shape.body).shapes;
        EXPECT_EQ(std::count(mates.begin(), mates.end(), handle), 1);
    });
}

TEST(UndoHistory, UndoAndRedoReachEveryMark) {
    for (uint64_t seed = 0; seed < 12; ++seed) {
        Random random(seed);
        World world = smallWorld();
        world.applyEdits({});
        WorldBaseline baseline(world);
        const auto step = [&](Edits edits) {
            const FrameChanges changes = world.applyEdits(edits);
            baseline.update(world, changes);
            expectTrueJournal(changes, world);
            ASSERT_EQ(baselineHash(baseline), resolvedHash(world))
                << "seed " << seed << ": the journal misses something";
        };
        const auto settle = [&](double metres) {
            move(world, metres);
            baseline = WorldBaseline(world);
        };
        std::vector<uint64_t> atMark, atEnd;
        for (int action = 0; action < 12; ++action) {
            atMark.push_back(resolvedHash(world));
            Edits edits = randomEdits(world, random);
            edits.insert(edits.begin(), kMark);
            edits.push_back(sphereCarve({0.4 * action, 1.0 + random.unit(), 0.3}, 0.4));
            step(edits);
            settle(0.01);
            step(randomEdits(world, random));
            settle(0.01);
            atEnd.push_back(resolvedHash(world));
        }
        for (size_t i = atMark.size(); i-- > 0;) {
            step({kUndo});
            EXPECT_EQ(resolvedHash(world), atMark[i]) << "seed " << seed << ", undo of " << i;
            expectShapesSound(world);
            settle(0.003);  // motion between two undos is undone too
        }
        EXPECT_TRUE(world.applyEdits({kUndo}).empty());
        for (size_t i = 0; i < atEnd.size(); ++i) {
            step({kRedo});
            EXPECT_EQ(resolvedHash(world), atEnd[i]) << "seed " << seed << ", redo of " << i;
            settle(0.003);
        }
        EXPECT_TRUE(world.applyEdits({kRedo}).empty());
    }
}

TEST(UndoHistory, TheSameEditsAfterUndoGiveTheSameSlots) {
    World world = smallWorld();
    // Without explosions: the step is the seed of their soot.
    const Edits cut = {kMark, sphereCarve({2.0, 1.2, 0.3}, 0.5), sphereCarve({6.1, 1.5, 0.1}, 0.4),
                       sphereCarve({0.6, 4.6, 0.6}, 0.5)};
    world.applyEdits({sphereCarve({3.0, 1.2, 0.3}, 0.5), sphereCarve({6.1, 0.5, 0.1}, 0.3)});
    world.applyEdits(cut);
    const uint64_t once = voxelHash(world);  // of voxels alone: pieces also have the step in which they were made
    ASSERT_GT(world.data().debris.count(), 1u);
    world.applyEdits({kUndo});
    world.applyEdits(cut);
    EXPECT_EQ(voxelHash(world), once);
}

TEST(UndoHistory, UndoAndRedoCoverLightsAndEnvironment) {
    World world = smallWorld();
    world.applyEdits({});
    const LightHandle bulb = world.lights().handleAt(0);
    Light dim = world.lights().at(bulb);
    dim.color *= 0.25f;
    Environment rain = world.environment();
    rain.wetness = 1.0f;
    rain.gravity = {0.0f, -1.6f, 0.0f};
    rain.sunDirection = {0.3f, 0.2f, -0.7f};
    std::vector<uint64_t> hashes = {resolvedHash(world)};
    const std::vector<Edits> changes = {
        {SetEnvironmentEdit{rain}}, {SetLightEdit{bulb, dim}}, {AddLightEdit{dim}}, {RemoveLightEdit{bulb}}};
    for (const Edits& each : changes) {  // a mark after each, so that none hides a change of another
        Edits edits = each;
        edits.insert(edits.begin(), kMark);
        world.applyEdits(edits);
        hashes.push_back(resolvedHash(world));
        ASSERT_NE(hashes.back(), hashes[hashes.size() - 2]);
    }
    const Environment wet = world.environment();
    ASSERT_EQ(wet.wetness, 1.0f);
    for (size_t i = changes.size(); i-- > 0;) {
        const FrameChanges back = world.applyEdits({kUndo});
        EXPECT_EQ(resolvedHash(world), hashes[i]) << "undo of " << i;
        EXPECT_EQ(back.environmentChanged, i == 0);
        EXPECT_TRUE(i == 0 || !back.lights.empty());
    }
    EXPECT_EQ(world.environment().wetness, 0.0f);
    EXPECT_TRUE(world.lights().find(bulb));
    for (size_t i = 0; i < changes.size(); ++i) {
        world.applyEdits({kRedo});
        EXPECT_EQ(resolvedHash(world), hashes[i + 1]) << "redo of " << i;
    }
    EXPECT_EQ(world.environment(), wet);
    EXPECT_FALSE(world.lights().find(bulb));
}

TEST(UndoHistory, EnvironmentChangesAfterAnUndoAreUndone) {
    World world = smallWorld();
    Environment rain = world.environment(), storm = rain;
    rain.wetness = 0.25f, storm.wetness = 0.75f;
    world.applyEdits({kMark, SetEnvironmentEdit{rain}});
    world.applyEdits({kUndo, SetEnvironmentEdit{storm}});  // both in one step
    EXPECT_EQ(world.environment(), storm);
    world.applyEdits({kRedo});
    EXPECT_EQ(world.environment(), rain);
    world.applyEdits({kUndo});
    EXPECT_EQ(world.environment().wetness, 0.0f);
}

TEST(UndoHistory, LightsTakeTheSameSlotsAfterUndoAndRedo) {
    const auto nextSlot = [](World world) { return world.applyEdits({AddLightEdit{}}).lightsAdded.at(0).slot(); };
    for (const size_t first : {0u, 1u}) {
        World world = smallWorld();
        const std::vector<LightHandle> two = world.applyEdits({AddLightEdit{}, AddLightEdit{}}).lightsAdded;
        const Edits removal = {RemoveLightEdit{two[first]}, RemoveLightEdit{two[1 - first]}};
        world.applyEdits({kMark, removal[0], removal[1]});
        const uint32_t next = nextSlot(world);
        world.applyEdits({kUndo});
        world.applyEdits({kRedo});
        EXPECT_EQ(nextSlot(world), next);
        world.applyEdits({kMark, AddLightEdit{}, AddLightEdit{}});
        world.applyEdits({kUndo});
        EXPECT_EQ(nextSlot(world), next);
    }
}

TEST(UndoHistory, NewChangesEndTheRedo) {
    World world = smallWorld();
    world.applyEdits({kMark, sphereCarve({2.0, 1.2, 0.3}, 0.5)});
    world.applyEdits({kUndo});
    world.applyEdits({});
    world.applyEdits({sphereCarve({1.0, 1.2, 0.3}, 0.2)});
    const uint64_t before = resolvedHash(world);
    EXPECT_TRUE(world.applyEdits({kRedo}).empty());
    EXPECT_EQ(resolvedHash(world), before);
}

/// Two blocks side by side on one body, on a floor, with undo.
World twoBlocks(std::array<ShapeHandle, 2>& blocks) {
    Level level = oneShapeLevel(solidGrid({24, 16, 16}, 1), true);
    level.bodies[0].shapes.push_back(levelShape("second", solidGrid({16, 16, 16}, 2)));
    level.bodies[0].shapes.back().local.position = {2.4, 0.0, 0.0};
    World world;
    world.load(level);
    WorldSettings settings;
    settings.undoMarks = 9;
    world.setSettings(settings);
    world.applyEdits({});
    for (uint32_t i = 0; i < 2; ++i) blocks[i] = world.shapes().handleAt(i);
    return world;
}

TEST(UndoHistory, TheJournalOfAnUndoAndOtherEditsOfItsShapesInOneStepDescribesTheWorldAfterIt) {
    std::array<ShapeHandle, 2> blocks;
    const World start = twoBlocks(blocks);
    const auto [first, second] = blocks;
    const Edit cut = CarveEdit{.kind = BrushKind::Box, .position = {2.1, 0.8, 0.8}, .halfSize = {0.1, 2.0, 2.0}};
    const Edit paint = PaintEdit{.position = {2.3, 1.6, 1.6}, .radius = 1.0, .seed = 5};
    const std::vector<Edits> cases = {
        {ResizeShapeEdit{first, {{0, 0, 0}, {8, 8, 8}}}},
        {ResizeShapeEdit{first, {{-8, -8, -8}, {40, 40, 40}}}},
        {ResizeShapeEdit{second, {{3, 0, 0}, {9, 8, 8}}}, paint},
        {cut, TrimShapeEdit{first}},
        {MergeShapeEdit{first, second}},
        {MergeShapeEdit{second, first}},
        {ResizeShapeEdit{first, {{20, 0, 0}, {24, 8, 8}}}, MergeShapeEdit{first, second}},
        {cut, SplitShapeEdit{first}},
        {cut, SplitShapeEdit{first, true, 5000}},
        {CarveEdit{.kind = BrushKind::Box, .position = {2.0, 0.8, 0.8}, .halfSize = {9.0, 9.0, 9.0}}},
        {paint, cut, spawnFire({2.0, 1.0, 1.0}, 2.0), ExplodeEdit{.position = {2.3, 1.6, 1.6}, .size = 1.0}},
    };
    for (size_t i = 0; i < cases.size(); ++i)
        for (const bool isRedo : {false, true}) {
            SCOPED_TRACE(std::to_string(i) + (isRedo ? ", redo" : ", undo"));
            World world = start;
            WorldBaseline baseline(world);
            const auto step = [&](Edits edits) {
                const FrameChanges changes = world.applyEdits(edits);
                expectTrueJournal(changes, world);
                baseline.update(world, changes);
                EXPECT_EQ(baselineHash(baseline), resolvedHash(world));
                expectShapesSound(world);
            };
            step({kMark, PaintEdit{.position = {2.3, 1.6, 1.6}, .radius = 1.0}, sphereCarve({2.3, 1.6, 1.6}, 0.4)});
            if (isRedo) step({kUndo});
            Edits edits = cases[i];
            edits.insert(edits.begin(), isRedo ? kRedo : kUndo);
            step(edits);
            step({});
        }
}

TEST(UndoHistory, UndoneHandlesAreStaleUntilRedo) {
    World world = smallWorld();
    const FrameChanges cut = world.applyEdits({kMark, sphereCarve({6.15, 1.5, 0.15}, 0.4)});
    ASSERT_FALSE(cut.shapesCreated.empty());
    const ShapeHandle piece = cut.shapesCreated.front();
    const FrameChanges back = world.applyEdits({kUndo});
    EXPECT_FALSE(world.shapes().find(piece));
    EXPECT_EQ(std::count(back.shapesDestroyed.begin(), back.shapesDestroyed.end(), piece), 1);
    const FrameChanges forth = world.applyEdits({kRedo});
    EXPECT_TRUE(world.shapes().find(piece));
    EXPECT_EQ(std::count(forth.shapesCreated.begin(), forth.shapesCreated.end(), piece), 1);
}

TEST(UndoHistory, MarksAndTheirLimitComeBeforeTheOtherEditsOfAStepInTheirOrder) {
    World world = smallWorld();
    WorldSettings settings = world.settings();
    settings.undoMarks = 0;
    world.applyEdits({SettingsEdit{settings}});
    world.applyEdits({});
    std::vector<std::string> lines;
    setLogSink([](void* user, LogLevel,
                  std::string_view line) { static_cast<std::vector<std::string>*>(user)->emplace_back(line); },
               &lines);
    const uint64_t before = voxelHash(world);
    settings.undoMarks = 5;
    world.applyEdits({sphereCarve({1.0, 1.2, 0.3}, 0.3), SettingsEdit{settings}, kMark});
    EXPECT_NE(voxelHash(world), before);
    world.applyEdits({kUndo});
    EXPECT_EQ(voxelHash(world), before) << "the mark was set before the cut of its step";
    world.applyEdits({kMark, sphereCarve({1.0, 1.2, 0.3}, 0.3)});
    world.applyEdits({sphereCarve({3.0, 1.2, 0.3}, 0.3), kUndo});
    EXPECT_NE(voxelHash(world), before) << "the cut of its step came after the undo";
    EXPECT_TRUE(lines.empty()) << lines.front();
    settings.undoMarks = 0;
    world.applyEdits({SettingsEdit{settings}, kMark});
    EXPECT_EQ(lines.size(), 1u) << "no marks are kept any more";
    setLogSink(nullptr, nullptr);
}

TEST(UndoHistory, DropsTheOldestMarksAndCostsNothingWhenOff) {
    World world = smallWorld();
    WorldSettings settings = world.settings();
    settings.undoMarks = 2;
    world.applyEdits({SettingsEdit{settings}});
    std::vector<uint64_t> hashes;
    for (int i = 0; i < 4; ++i) {
        hashes.push_back(resolvedHash(world));
        world.applyEdits({kMark, sphereCarve({0.5 + i, 1.2, 0.3}, 0.2)});
    }
    world.applyEdits({kUndo});
    world.applyEdits({kUndo});
    EXPECT_EQ(resolvedHash(world), hashes[2]);
    EXPECT_TRUE(world.applyEdits({kUndo}).empty());
    settings.undoMarks = 0;
    world.applyEdits({SettingsEdit{settings}});
    EXPECT_TRUE(world.applyEdits({kUndo}).empty());
}

TEST(UndoHistory, AMarkOfALargeShapeCostsWhatChanged) {
    World world;
    world.load(oneShapeLevel(solidGridOfSharedBricks({1024, 128, 1024}), true));
    WorldSettings settings;
    settings.undoMarks = 100;
    world.setSettings(settings);
    const auto dig = [&](int i) {
        world.applyEdits({kMark, sphereCarve({0.4 + 3.2 * (i % 30), 0.4 + 0.8 * (i / 30), 0.4}, 0.1)});
    };
    world.applyEdits({});
    const uint64_t whole = resolvedHash(world);
    for (int i = 0; i < 30; ++i) dig(i);
    const size_t before = allocatedBytes();
    if (before == 0) GTEST_SKIP() << "allocations are not counted";
    for (int i = 30; i < 90; ++i) dig(i);
    EXPECT_LT((allocatedBytes() - before) / 60, 8'000u) << "the directory of the grid has 4,096 nodes, or 32,768 bytes";
    const uint64_t dug = resolvedHash(world);
    for (int i = 0; i < 90; ++i) world.applyEdits({kUndo});
    EXPECT_EQ(resolvedHash(world), whole);
    EXPECT_LT((allocatedBytes() - before) / 60, 8'000u) << "of what can be redone";
    for (int i = 0; i < 90; ++i) world.applyEdits({kRedo});
    EXPECT_EQ(resolvedHash(world), dug);
}

TEST(UndoHistory, WithNothingToUndoOrRedoSaysSo) {
    World world = smallWorld();
    std::vector<std::string> lines;
    setLogSink([](void* user, LogLevel,
                  std::string_view line) { static_cast<std::vector<std::string>*>(user)->emplace_back(line); },
               &lines);
    world.applyEdits({kUndo});
    world.applyEdits({kRedo});
    setLogSink(nullptr, nullptr);
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_EQ(lines[0].rfind("undo: ", 0), 0u) << lines[0];
    EXPECT_EQ(lines[1].rfind("redo: ", 0), 0u) << lines[1];
}

TEST(UndoHistory, ItsJournalNamesABodyThatRestsSinceAnotherStep) {
    World world = smallWorld();
    BodyHandle crate;
    world.bodies().forEach([&](BodyHandle handle, const Body& body) { crate = body.isStatic ? crate : handle; });
    const auto setAsleep = [&](bool asleep) {
        const Body& body = world.bodies().at(crate);
        world.setPoses(std::vector{BodyPose{crate, body.pose, body.velocity, body.angularVelocity, asleep}});
    };
    world.applyEdits({});
    setAsleep(true);
    world.applyEdits({kMark});
    const uint64_t restingSince = world.bodies().at(crate).restingSince;
    setAsleep(false);
    world.applyEdits({sphereCarve({1.0, 1.0, 0.0}, 0.3)});
    setAsleep(true);
    EXPECT_NE(world.bodies().at(crate).restingSince, restingSince);
    const FrameChanges changes = world.applyEdits({kUndo});
    EXPECT_EQ(world.bodies().at(crate).restingSince, restingSince);
    EXPECT_EQ(changes.teleported, std::vector{crate});
}

TEST(UndoHistory, AShapeThatWaitedForItsSplitAtTheMarkIsSplitAfterAnUndo) {
    Level level = oneShapeLevel(solidGrid({400, 8, 8}, 1), true);
    level.bodies[0].shapes[0].anchors = {{{0, 0, 0}, {1, 8, 8}}};
    World world;
    world.load(level);
    WorldSettings settings;
    settings.undoMarks = 5;
    settings.split.partsPerStep = 1;
    world.applyEdits({SettingsEdit{settings}, sphereCarve({0.5, 0.8, 0.8}, 0.2)});
    world.applyEdits({});
    const CarveEdit slit{.kind = BrushKind::Box, .position = {20.0, 0.4, 0.4}, .halfSize = {0.2, 1.0, 1.0}};
    world.applyEdits({slit});
    ASSERT_EQ(world.data().pendingSplits.size(), 1u);
    world.applyEdits({kMark, sphereCarve({30.0, 0.8, 0.8}, 0.5)});
    const auto finish = [&] {
        for (int i = 0; i < 99; ++i) world.applyEdits({});
        EXPECT_EQ(world.shapes().size(), 2u) << "the far half came off";
        EXPECT_TRUE(world.data().pendingSplits.empty());
    };
    finish();
    world.applyEdits({kUndo});
    finish();
}

TEST(UndoHistory, EditsInTheStepOfAnUndoEndTheRedo) {
    const std::vector<Edit> edits = {sphereCarve({1.0, 1.2, 0.3}, 0.2), sphereCarve({2.0, 1.2, 0.3}, 0.5),
                                     PaintEdit{.position = {2.0, 1.2, 0.3}, .radius = 0.5}, AddLightEdit{}};
    for (const Edit& edit : edits) {
        World world = smallWorld();
        world.applyEdits({kMark, sphereCarve({2.0, 1.2, 0.3}, 0.5)});
        world.applyEdits({kUndo, edit});
        const uint64_t after = resolvedHash(world);
        EXPECT_TRUE(world.applyEdits({kRedo}).empty());
        EXPECT_EQ(resolvedHash(world), after) << editName(edit);
    }
    World world = smallWorld();
    world.applyEdits({kMark, sphereCarve({2.0, 1.2, 0.3}, 0.5)});
    const uint64_t cut = voxelHash(world);
    world.applyEdits({kUndo, sphereCarve({90.0, 90.0, 90.0}, 0.5)});
    world.applyEdits({kRedo});
    EXPECT_EQ(voxelHash(world), cut) << "a cut of the air changes nothing";
}

TEST(UndoHistory, VoxelsOfAnotherMaterialAreListedAsCarved) {
    World world = smallWorld();
    world.applyEdits({});
    const ShapeHandle shape = firstShape(world);
    const glm::ivec3 cell = glm::ivec3(0);
    const uint8_t before = world.shapes().at(shape).grid.at(cell);
    ASSERT_NE(before, 0);
    const Palette& palette = *world.shapes().at(shape).palette;
    const uint8_t other = palette[1].material == palette[before].material ? 2 : 1;
    ASSERT_NE(palette[other].material, palette[before].material);
    const auto isCarved = [&](const FrameChanges& changes) {
        return std::count(changes.carved.begin(), changes.carved.end(), shape) == 1;
    };
    EXPECT_TRUE(isCarved(world.applyEdits({kMark, WriteVoxelsEdit{shape, {cell, cell + 1}, {other}}})));
    EXPECT_TRUE(isCarved(world.applyEdits({kUndo}))) << "it weighs as before";
    EXPECT_TRUE(isCarved(world.applyEdits({kRedo})));
    expectShapesSound(world);
}

TEST(UndoHistory, DropsTheDamageOfImpactsThatItUndoes) {
    World world = smallWorld();
    const uint64_t whole = voxelHash(world);
    const Edits damage = {sphereCarve({2.0, 1.2, 0.3}, 0.5)};
    world.applyEdits({kMark}, damage);
    EXPECT_NE(voxelHash(world), whole);
    world.applyEdits({kUndo}, damage);
    EXPECT_EQ(voxelHash(world), whole);
    const uint64_t before = voxelHash(world);
    world.applyEdits({kUndo}, damage);
    EXPECT_NE(voxelHash(world), before) << "there is no mark to go back to, so the impacts happened";
}

TEST(UndoHistory, DoesNotReachBackBeyondADelta) {
    World world = smallWorld(), host = world;
    WorldBaseline baseline(host);
    world.applyEdits({kMark, sphereCarve({2.0, 1.2, 0.3}, 0.5)});
    host.applyEdits({});
    const FrameChanges cut = host.applyEdits({sphereCarve({6.1, 1.5, 0.1}, 0.4)});
    WorldDelta after = baseline.update(host, cut);
    forEachKind(
        [](auto& values, const auto& now) {
            for (auto& [slot, value] : values) {
                value.first = now.handleAt(slot);
                value.second.reset();
                if (value.first) value.second = now.at(value.first);
            }
        },
        after, host.data());
    world.applyDelta(after);
    const uint64_t hash = resolvedHash(world);
    world.applyEdits({kUndo});
    EXPECT_EQ(resolvedHash(world), hash);
}

}  // namespace
}  // namespace rubble
