#include "runtime/assets/save_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <filesystem>
#include <thread>

#include "runtime/assets/assets.h"
#include "runtime/assets/chunk_file.h"
#include "runtime/assets/file_bytes.h"
#include "runtime/assets/recording_file.h"
#include "runtime/world/history/world_baseline.h"
#include "tests/runtime/assets/broken_world.h"
#include "tests/support/temp_folder.h"

namespace rubble {
namespace {

using namespace test;

/// A light with a value in every field.
Light screen(const World& world) {
    return {"screen",
            LightKind::Screen,
            firstShape(world),
            {{1.0, 2.0, 3.0}, {0.0, 1.0, 0.0, 0.0}},
            {0.5f, 1.5f, 2.5f},
            0.2f,
            7.0f,
            0.3f,
            0.7f,
            0.9f,
            0.6f,
            true,
            {2, {0x112233, 0x445566}},
            world.lightGroups().handleAt(0),
            false};
}

SavedGame gameOf(const World& world) {
    return {world.state(),
            {sphereCarve({1.0, 2.0, 3.0}, 0.5), ExplodeEdit{}, SettingsEdit{world.settings()},
             SetEnvironmentEdit{world.environment()}, AddLightEdit{screen(world)},
             SetLightEdit{world.lights().handleAt(0), screen(world)}, RemoveLightEdit{world.lights().handleAt(0)}}};
}

TEST(SaveFile, RoundTripKeepsStateSlotsAndPendingEdits) {
    const World world = brokenWorld();
    const std::vector<uint8_t> bytes = gameToBytes(gameOf(world));
    Result<SavedGame> game = gameFromBytes(bytes, "test", 7);
    ASSERT_TRUE(game) << game.error();
    ASSERT_EQ(game->pending.size(), 7u);
    const Light &added = std::get<AddLightEdit>(game->pending[4]).light,
                &set = std::get<SetLightEdit>(game->pending[5]).values;
    EXPECT_EQ(added.hash(), screen(world).hash());
    EXPECT_EQ(set.hash(), screen(world).hash());
    EXPECT_EQ(set.name, "screen");
    EXPECT_EQ(set.group.world(), 7u) << "handles become those of the world that reads";
    EXPECT_EQ(std::get<RemoveLightEdit>(game->pending[6]).light, std::get<SetLightEdit>(game->pending[5]).light);
    EXPECT_EQ(std::get<SetEnvironmentEdit>(game->pending[3]).environment, world.environment());
    EXPECT_EQ(std::get<CarveEdit>(game->pending[0]).position, glm::dvec3(1.0, 2.0, 3.0));
    World back(7);
    back.setState(game->world);
    EXPECT_EQ(back.hash(), world.hash());
    EXPECT_EQ(back.settings().debris.bodies, 77u);
    EXPECT_EQ(back.shapes().freeSlots(), world.shapes().freeSlots());
    EXPECT_TRUE(voxelAccounting(back).balances());
    world.shapes().forEach([&](ShapeHandle handle, const Shape& shape) {
        const Shape* other = back.shapes().find(ShapeHandle::make(7, handle.generation(), handle.slot()));
        ASSERT_TRUE(other);
        EXPECT_EQ(other->moments, shape.moments);
    });
    // Both worlds behave the same from here on.
    World first = world;
    const Edits edits = {sphereCarve({0.2, 2.0, 0.2}, 0.7), ExplodeEdit{.position = {3.0, 1.0, 0.2}}};
    first.applyEdits(edits);
    back.applyEdits(edits);
    EXPECT_EQ(back.hash(), first.hash());
}

/// Reads a save of the game back; says why not if it cannot be read.
std::string readingError(const WorldState& world) {
    const Result<SavedGame> game = gameFromBytes(gameToBytes({world, {}}), "save", 1);
    return game ? "" : game.error();
}

TEST(SaveFile, AnyLevelCanBeSavedAndLoaded) {
    Level level = oneShapeLevel(towerGrid({40, 20, 20}), true);
    level.bodies.push_back({.name = "shapes without voxels"});
    level.bodies.back().shapes = {levelShape("no cells", {}), levelShape("no voxels", VoxelGrid({9, 9, 9}))};
    Palette glowing = fiveEntries();
    glowing[1].emission = 1e6f;
    level.bodies[0].shapes[0].palette = std::make_shared<const Palette>(glowing);
    level.bodies[0].shapes[0].voxelSize = 1000.0f;
    level.autoLightGroups = 5;
    World world;
    world.load(level);
    EXPECT_EQ(world.shapes().size(), 1u);
    EXPECT_EQ(world.bodies().size(), 1u);
    EXPECT_GT(world.lights().size(), 0u);
    EXPECT_EQ(readingError(world.state()), "");
}

TEST(SaveFile, AWorldWithManyEmptySlotsCanBeSavedAndLoaded) {
    WorldState state = brokenWorld().state();
    state.joints = {1, std::vector<SlotMap<JointHandle, Joint>::Slot>(400'000), {}};
    EXPECT_EQ(readingError(state), "");
}

TEST(SaveFile, StatesThatNoWorldCanHaveAreRefused) {
    const WorldState good = brokenWorld().state();
    ASSERT_EQ(readingError(good), "");
    const auto error = [&](auto&& change) {
        WorldState bad = good;
        change(bad);
        return readingError(bad);
    };
    EXPECT_NE(error([](WorldState& world) {
                  const ShapeHandle shape = world.shapes.handleAt(0);
                  world.fire.fields = {{shape, {{.heat = 5}, {.heat = 7}}}};
              }).find("heat of shape"),
              std::string::npos)
        << "a hot brick that is listed twice";
    for (const HotBrick& wrong : {HotBrick{.heat = -1}, HotBrick{.heat = kMaxHeat + 1}, HotBrick{.charred = 255}})
        EXPECT_NE(error([&](WorldState& world) {
                      world.fire.fields = {{world.shapes.handleAt(0), {wrong}}};
                  }).find("rounds of charring, found"),
                  std::string::npos)
            << wrong.heat << " mJ, " << int(wrong.charred);
    EXPECT_NE(error([](WorldState& world) {
                  world.joints.forEach([](JointHandle, Joint& joint) { joint.rope.points = 0, joint.points.clear(); });
              }).find("points of joint"),
              std::string::npos);
    EXPECT_NE(error([](WorldState& world) {
                  Joint joint{.kind = JointKind::Fixed};
                  joint.ends[0].shape = joint.ends[1].shape = world.shapes.handleAt(0);
                  world.joints.insert(joint);
              }).find("both ends are on one body"),
              std::string::npos);
    EXPECT_NE(error([](WorldState& world) { world.settings.impactRadius = 100.0; }).find("impact_radius is 100"),
              std::string::npos);
    EXPECT_NE(error([](WorldState& world) { world.settings.stress.contactTime = 0.0; }).find("contact_time is 0"),
              std::string::npos);
    EXPECT_NE(error([](WorldState& world) {
                  world.waters.insert({.outline = {{0, 0}, {1, 0}, {0, 1}}, .flow = {1e7, 0, 0}});
              }).find("flow[0] is 1e+07"),
              std::string::npos);
    EXPECT_NE(error([](WorldState& world) { world.materials.materials[1].restitution = 5e7f; }).find("restitution is"),
              std::string::npos);
    EXPECT_NE(
        error([](WorldState& world) { world.materials.materials[1].density = 4'000'000'000u; }).find("density is"),
        std::string::npos);
}

TEST(SaveFile, EveryTruncationAndEveryBitFlipIsRefused) {
    std::vector<uint8_t> bytes = gameToBytes(gameOf(brokenWorld()));
    for (size_t length = 0; length < bytes.size(); length += length < 300 ? 1 : 137)
        ASSERT_FALSE(gameFromBytes(std::span(bytes).first(length), "t", 1)) << length;
    for (size_t byte = 0; byte < bytes.size(); byte += byte < 200 ? 1 : 61) {
        bytes[byte] ^= uint8_t(1 << byte % 8);
        const Result<SavedGame> game = gameFromBytes(bytes, "t.rubble", 1);
        ASSERT_FALSE(game) << "byte " << byte;
        ASSERT_EQ(game.error().rfind("t.rubble: byte ", 0), 0u) << game.error();
        bytes[byte] ^= uint8_t(1 << byte % 8);
    }
}

TEST(SaveFile, ANewFieldChangesTheSizesCheckedHere) {
    // A new field changes a size: add the field to level_fields.h, state_fields.h or settings_fields.h, then the size
    // here.
    EXPECT_EQ(sizeof(DebrisSettings), 32u);
    EXPECT_EQ(sizeof(FireSettings), 24u);
    EXPECT_EQ(sizeof(StressSettings), 56u);
    EXPECT_EQ(sizeof(BoundsSettings), 56u);
    EXPECT_EQ(sizeof(WorldSettings), 64 + sizeof(BoundsSettings) + sizeof(DebrisSettings) + sizeof(StressSettings) +
                                         sizeof(FireSettings) + sizeof(SplitSettings) + 8u);
    EXPECT_EQ(sizeof(Joint), 544u);
    EXPECT_EQ(sizeof(Light), 192u);
    EXPECT_EQ(sizeof(Environment), 136u);
    EXPECT_EQ(sizeof(PaintEdit), 80u);
    EXPECT_EQ(sizeof(CarveEdit), 160u);
    EXPECT_EQ(sizeof(AddLightEdit), sizeof(Light));
    EXPECT_EQ(sizeof(SetLightEdit), sizeof(LightHandle) + sizeof(Light));
}

TEST(SaveFile, FilesOfOtherKindsAreRefused) {
    const TempFolder folder;
    const std::string path = folder / "save.rubble";
    ASSERT_TRUE(writeSave(path, gameOf(brokenWorld())));
    EXPECT_TRUE(readSave(path, 1));
    const Result<Level> level = readRubble(path);
    ASSERT_FALSE(level);
    EXPECT_NE(level.error().find("expected a level, found a saved game"), std::string::npos) << level.error();
    EXPECT_FALSE(readRecording(path, 1));
    ASSERT_TRUE(writeRubble(path, oneShapeLevel(towerGrid({16, 16, 16}), true)));
    const Result<SavedGame> save = readSave(path, 1);
    ASSERT_FALSE(save);
    EXPECT_NE(save.error().find("expected a saved game, found a level"), std::string::npos) << save.error();
}

TEST(SaveFile, ThreadsThatWriteOnePathLeaveTheSaveOfOneOfThem) {
    const TempFolder folder;
    const std::string path = folder / "save.rubble";
    const SavedGame games[] = {{World().state(), {}}, gameOf(brokenWorld())};
    std::vector<std::thread> threads;
    std::atomic<int> failures{0};
    for (int i = 0; i < 4; ++i)
        threads.emplace_back([&, i] {
            for (int k = 0; k < 10; ++k) failures += !writeSave(path, games[i % 2]);
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(failures, 0);
    const Result<SavedGame> game = readSave(path, 1);
    EXPECT_TRUE(game) << game.error();
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1) << "a temporary file is left";
}

/// A network host: it sends a snapshot to a client that joins, and the delta of each step to all.
class Host {
public:
    Host() : world(brokenWorld()), m_baseline(world) {}

    void step(const Edits& edits) {
        const FrameChanges changes = world.applyEdits(edits);
        RecordedStep record{.step = changes.step};
        record.delta = stepDeltaToBytes(m_baseline.update(world, changes), changes, world, palettes);
        world.bodies().forEach([&](BodyHandle handle, const Body& body) {
            if (!body.isStatic)
                record.poses.push_back(
                    {handle, {body.pose.position + glm::dvec3(0.01)}, body.velocity, body.angularVelocity, false});
        });
        world.setPoses(record.poses);
        SlotValues<BodyHandle, Body> oldBodies;
        m_baseline.move(world, record.poses, oldBodies);
        record.hash = world.hash();
        record.voxelHash = voxelHash(world);
        record.resolvedHash = resolvedHash(world);
        log.push_back(record);
    }
    /// Two added lights, then both lights of the lowest slots removed: the next light does not take the lowest free
    /// slot.
    void shuffleLightSlots() {
        step({AddLightEdit{}, AddLightEdit{}});
        std::vector<LightHandle> lights;
        world.lights().forEach([&](LightHandle handle, const Light&) { lights.push_back(handle); });
        step({RemoveLightEdit{lights.at(0)}, RemoveLightEdit{lights.at(1)}});
    }

    World world;
    PaletteList palettes;  ///< those that the clients know
    std::vector<RecordedStep> log;

private:
    WorldBaseline m_baseline;
};

Edits randomEdits(const World& world, Random& random) {
    const double x = random.unit() * 4.0, y = random.unit() * 4.0, z = random.unit() * 2.0;
    Edits edits = {sphereCarve({x, y, z}, 0.5)};
    if (random.below(2))
        edits.push_back(PaintEdit{
            .position = {y, x, z}, .radius = 0.8, .mode = random.below(2) ? PaintMode::Layer : PaintMode::Blend});
    if (random.below(3) == 0) edits.push_back(ExplodeEdit{.position = {y, x, z}, .size = 1.5});
    Light light = screen(world);
    light.local.position.x = x;
    if (random.below(2)) edits.push_back(AddLightEdit{light});
    const LightHandle any = world.lights().handleAt(random.below(uint32_t(world.lights().slotCount())));
    if (any && random.below(2))
        edits.push_back(random.below(2) ? Edit(RemoveLightEdit{any}) : Edit(SetLightEdit{any, light}));
    Environment weather = world.environment();
    weather.clouds = float(random.unit());
    if (random.below(3) == 0) edits.push_back(SetEnvironmentEdit{weather});
    return edits;
}

TEST(StepDelta, ALateJoinerCatchesUpFromSnapshotAndLog) {
    Host host;
    Random random(3);
    for (int i = 0; i < 10; ++i) host.step(randomEdits(host.world, random));
    const std::vector<uint8_t> snapshot = gameToBytes({host.world.state(), {}});
    const size_t joined = host.log.size();
    host.palettes = {};  // the client that joins knows none
    for (int i = 0; i < 30; ++i) host.step(i % 4 == 3 ? Edits{} : randomEdits(host.world, random));
    host.shuffleLightSlots();

    World joiner(9);
    Result<SavedGame> game = gameFromBytes(snapshot, "snapshot", 9);
    ASSERT_TRUE(game) << game.error();
    joiner.setState(std::move(game->world));
    std::vector<PaletteRef> palettes;
    size_t bytes = 0;
    for (size_t i = joined; i < host.log.size(); ++i) {
        const RecordedStep& step = host.log[i];
        const Result<RecordedStep> sent = recordedStepFromBytes(recordedStepToBytes(step), "wire", 9);
        ASSERT_TRUE(sent) << sent.error();
        bytes += sent.value().delta.size();
        const Result<FrameChanges> applied = applyStepDelta(sent.value().delta, "wire", joiner, palettes);
        ASSERT_TRUE(applied) << "step " << i << ": " << applied.error();
        ASSERT_EQ(voxelHash(joiner), step.voxelHash) << "step " << i;
        joiner.setPoses(sent.value().poses);
        ASSERT_EQ(joiner.hash(), step.hash) << "step " << i;
    }
    joiner.shapes().forEach([&](ShapeHandle, const Shape& shape) {
        EXPECT_EQ(shape.moments, gridMoments(shape.grid, *shape.palette, joiner.materials()));
    });
    EXPECT_TRUE(voxelAccounting(joiner).balances());
    EXPECT_GT(joiner.shapes().size(), 5u);
    EXPECT_EQ(joiner.environment(), host.world.environment());
    ASSERT_GT(joiner.lights().size(), 3u);
    EXPECT_EQ(joiner.lights().freeSlots(), host.world.lights().freeSlots());
    RecordProperty("bytes_per_step", int(bytes / 30));
}

TEST(SaveFile, NewObjectsGetTheHandlesThatTheSavedWorldWouldGiveThem) {
    World world(1, 9);  // a number that was used before
    world.load(oneShapeLevel(solidGrid({8, 8, 8}, 1), true));
    world.applyEdits({AddLightEdit{}});
    const Result<SavedGame> game = gameFromBytes(gameToBytes({world.state(), {}}), "t", 1);
    ASSERT_TRUE(game) << game.error();
    World back(1);
    back.setState(game->world);
    for (World* each : {&world, &back}) each->applyEdits({AddLightEdit{}});
    EXPECT_EQ(back.lights().handleAt(1).generation(), 9u);
    EXPECT_EQ(back.lights().handleAt(1), world.lights().handleAt(1));
}

TEST(RecordingFile, EditsOfFewBytesTakeNoMoreMemoryThanTheBudgetOfTheFile) {
    const TempFolder folder;
    const World world = brokenWorld();
    Result<RecordingWriter> writer = RecordingWriter::open(folder / "many.rubblelog", gameOf(world));
    ASSERT_TRUE(writer);
    RecordedStep step{.step = world.step() + 1, .edits = Edits(300'000, HistoryEdit{})};
    writer->add(step);
    ASSERT_TRUE(writer->close());
    const Result<Recording> recording = readRecording(folder / "many.rubblelog", 1);
    ASSERT_TRUE(recording) << "what is written can be read: " << recording.error();
    EXPECT_EQ(recording->steps.at(0).edits.size(), 300'000u);

    ChunkWriter bomb;
    bomb.add({'G', 'A', 'M', 'E'}, gameToBytes(gameOf(world)));
    bomb.add({'S', 'T', 'E', 'P'}, recordedStepToBytes(step));
    const Result<Recording> refused = recordingFromBytes(bomb.file(0), "bomb", 1);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().find("takes at most 128 MiB"), std::string::npos) << refused.error();
}

/// What is written replaces regular files alone: never a folder, a pipe or a device.
TEST(FileBytes, WritingFollowsLinksAndReplacesFilesOnly) {
    namespace fs = std::filesystem;
    const TempFolder folder;
    const std::vector<uint8_t> bytes = {1, 2, 3};
    const auto write = [&](const std::string& path) { return writeFileAtomically(path, bytes, 100); };
    ASSERT_TRUE(write(folder / "file"));
    fs::create_directory(folder.path() / "folder");
    ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
    fs::create_symlink("folder/new", folder.path() / "link");
    fs::create_symlink("link", folder.path() / "chain");
    fs::create_symlink("pipe", folder.path() / "to_pipe");
    fs::create_symlink("loop", folder.path() / "loop");
    for (const char* name : {"link", "chain"}) {
        ASSERT_TRUE(write(folder / name)) << name;
        EXPECT_TRUE(fs::is_symlink(folder.path() / name)) << name;
    }
    EXPECT_EQ(fs::file_size(folder.path() / "folder/new"), 3u);
    const World world = brokenWorld();
    for (const char* name : {"folder", "folder/", "pipe", "to_pipe", "loop"}) {
        const auto written = write(folder / name);
        const auto opened = RecordingWriter::open(folder / name, gameOf(world));
        ASSERT_FALSE(written || opened) << name;
        EXPECT_EQ(written.error(), opened.error());
        EXPECT_EQ(written.error().find("expected ") == std::string::npos, std::string(name) == "loop")
            << written.error();
    }
    EXPECT_TRUE(fs::is_fifo(folder.path() / "pipe"));
    EXPECT_TRUE(fs::is_symlink(folder.path() / "to_pipe"));
    for (const std::string& error : {write("").error(), RecordingWriter::open("", gameOf(world)).error()})
        EXPECT_EQ(error, "\"\": expected the name of a file");
    ASSERT_EQ(mkfifo((folder / "r.part").c_str(), 0600), 0);
    EXPECT_FALSE(RecordingWriter::open(folder / "r", gameOf(world))) << "it would wait for a reader of the pipe";
}

TEST(StepDelta, DamagedStepsAreRefusedAndChangeNothing) {
    World host = brokenWorld();
    const World start = host;
    WorldBaseline baseline(host);
    PaletteList list;
    const FrameChanges changes =
        host.applyEdits({sphereCarve({0.2, 2.0, 0.2}, 0.7), PaintEdit{.position = {0.2, 1.0, 0.2}, .radius = 1.0}});
    std::vector<uint8_t> bytes = stepDeltaToBytes(baseline.update(host, changes), changes, host, list);
    Random random(5);
    int refused = 0;
    for (size_t length = 1; length < bytes.size(); length += 97) {
        World world = start;
        std::vector<PaletteRef> palettes;
        EXPECT_FALSE(applyStepDelta(std::span(bytes).first(length), "t", world, palettes));
        EXPECT_EQ(world.hash(), start.hash());
    }
    for (int i = 0; i < 400; ++i) {  // deltas have no checksums, so some flips give another valid step
        std::vector<uint8_t> other = bytes;
        other[random.below(uint32_t(other.size()))] ^= uint8_t(1 + random.below(255));
        World world = start;
        std::vector<PaletteRef> palettes;
        if (const Result<FrameChanges> applied = applyStepDelta(other, "t", world, palettes); !applied) {
            ++refused;
            EXPECT_EQ(world.hash(), start.hash());
        } else {
            world.applyEdits({sphereCarve({1.0, 2.0, 1.0}, 0.7)});
        }
    }
    EXPECT_GT(refused, 3);
}

TEST(StepDelta, InvalidLightsAndWeatherAreRefused) {
    World host = brokenWorld();
    const World start = host;
    Light light = screen(host);
    light.reach = 777.0f;
    Environment weather = host.environment();
    weather.fogHeight = 555.0f;
    for (const auto& [edit, number] :
         {std::pair{Edit(AddLightEdit{light}), 777.0f}, std::pair{Edit(SetEnvironmentEdit{weather}), 555.0f}}) {
        host = start;
        WorldBaseline baseline(host);
        PaletteList list;
        const FrameChanges changes = host.applyEdits({edit});
        std::vector<uint8_t> bytes = stepDeltaToBytes(baseline.update(host, changes), changes, host, list);
        World world = start;
        std::vector<PaletteRef> palettes;
        ASSERT_TRUE(applyStepDelta(bytes, "t", world, palettes));
        EXPECT_EQ(world.hash(), host.hash());
        std::array<uint8_t, 4> was{}, none{};
        const float negative = -1.0f;
        std::memcpy(was.data(), &number, 4), std::memcpy(none.data(), &negative, 4);
        const auto place = std::search(bytes.begin(), bytes.end(), was.begin(), was.end());
        ASSERT_NE(place, bytes.end());
        std::copy(none.begin(), none.end(), place);
        world = start;
        const Result<FrameChanges> applied = applyStepDelta(bytes, "t", world, palettes);
        ASSERT_FALSE(applied);
        EXPECT_NE(applied.error().find("lights, weather and settings within their ranges"), std::string::npos)
            << applied.error();
        EXPECT_EQ(world.hash(), start.hash());
    }
}

}  // namespace
}  // namespace rubble
