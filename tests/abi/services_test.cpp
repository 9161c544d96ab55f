#include <algorithm>
#include <atomic>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "tests/abi/abi_fixture.h"
#include "tests/support/temp_folder.h"

namespace rubble {
namespace {

/// A host whose files are in memory.
struct MemoryFiles {
    std::map<std::string, std::vector<uint8_t>> files;
    bool canRead = true, canWrite = true;
    int reads = 0;

    static uint64_t size(void* user, const char* path) {
        const auto& files = static_cast<MemoryFiles*>(user)->files;
        const auto found = files.find(path);
        return found == files.end() ? RUBBLE_FILE_ON_DISK : found->second.size();
    }
    static int32_t read(void* user, const char* path, void* out, uint64_t size) {
        auto& self = *static_cast<MemoryFiles*>(user);
        ++self.reads;
        if (self.canRead) std::memcpy(out, self.files.at(path).data(), size);
        return self.canRead;
    }
    static int32_t write(void* user, const char* path, const void* bytes, uint64_t size) {
        auto& self = *static_cast<MemoryFiles*>(user);
        if (std::string(path).find("disk") == 0) return -1;
        const auto* from = static_cast<const uint8_t*>(bytes);
        if (self.canWrite) self.files[path].assign(from, from + size);
        return self.canWrite;
    }
};

std::vector<uint8_t> bytesOf(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

class Services : public Abi {
protected:
    void TearDown() override {
        api()->set_host(nullptr);
        Abi::TearDown();
    }
    void breakTable() {
        const rubble_explosion explosion = tableExplosion();
        ASSERT_EQ(api()->explode(m_world, &explosion), RUBBLE_OK);
        step(10);
    }
    std::vector<uint8_t> saveData() {
        uint64_t size = 0;
        EXPECT_EQ(api()->save_game_data(m_world, nullptr, 0, &size), RUBBLE_OK) << api()->get_last_error();
        std::vector<uint8_t> out(size);
        EXPECT_EQ(api()->save_game_data(m_world, out.data(), size, &size), RUBBLE_OK) << api()->get_last_error();
        EXPECT_EQ(size, out.size());
        return out;
    }
    rubble_world makeWith(const rubble_world_settings& settings) {
        rubble_world world = 0;
        EXPECT_EQ(api()->create_world(&settings, &world), RUBBLE_OK) << api()->get_last_error();
        return world;
    }
};

TEST_F(Services, AGameGoesThroughMemoryAsThroughAFile) {
    const TempFolder folder;
    const std::string path = folder.path() / "game.rubble";
    breakTable();
    const uint64_t saved = hash();
    const std::vector<uint8_t> data = saveData();
    ASSERT_EQ(api()->save_game(m_world, path.c_str()), RUBBLE_OK);
    EXPECT_EQ(bytesOf(path), data);
    step(5);
    const uint64_t played = hash();
    ASSERT_EQ(api()->load_game_data(m_world, data.data(), data.size()), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(hash(), saved);
    step(5);
    EXPECT_EQ(hash(), played);
}

TEST_F(Services, AskingForTheSizeOfASaveChangesNothing) {
    breakTable();
    const rubble_world other = m_world;
    uint64_t size = 0;
    std::vector<uint8_t> small(10);
    EXPECT_EQ(api()->save_game_data(other, nullptr, 0, &size), RUBBLE_OK);
    EXPECT_GT(size, 100u);
    expectRefused(api()->save_game_data(other, small.data(), small.size(), &size), RUBBLE_ERROR_CAPACITY,
                  "the array holds 10");
    expectRefused(api()->save_game_data(other, nullptr, 10, &size), RUBBLE_ERROR_NULL, "out");
    expectRefused(api()->save_game_data(other, small.data(), 10, nullptr), RUBBLE_ERROR_NULL, "count");
}

TEST_F(Services, ALevelComesFromMemory) {
    const std::vector<uint8_t> data = bytesOf(s_level);
    ASSERT_EQ(api()->load_level(m_world, s_level.c_str(), nullptr), RUBBLE_OK);
    step();
    const auto shapesBefore = shapes();
    ASSERT_EQ(api()->load_level_data(m_world, data.data(), data.size()), RUBBLE_OK) << api()->get_last_error();
    step();
    ASSERT_EQ(shapes().size(), shapesBefore.size());
    EXPECT_EQ(shapes()[0].voxel_count, shapesBefore[0].voxel_count);
}

TEST_F(Services, WrongBytesAreRefusedAndChangeNothing) {
    breakTable();
    const std::vector<uint8_t> good = saveData();
    const uint64_t before = hash();
    expectRefused(api()->load_level_data(m_world, nullptr, 4), RUBBLE_ERROR_NULL, "data");
    expectRefused(api()->load_game_data(m_world, good.data(), 3), RUBBLE_ERROR_FILE, "data: ");
    expectRefused(api()->load_level_data(m_world, good.data(), good.size()), RUBBLE_ERROR_FILE, "data: ");
    uint64_t steps = 7;
    expectRefused(api()->play_recording_data(m_world, good.data(), good.size(), &steps), RUBBLE_ERROR_FILE, "data: ");
    EXPECT_EQ(steps, 0u);
    for (size_t at = 0; at < good.size(); at += 1 + good.size() / 97) {
        std::vector<uint8_t> bad = good;
        bad[at] ^= 0x10;
        EXPECT_EQ(api()->load_game_data(m_world, bad.data(), bad.size()), RUBBLE_ERROR_FILE) << at;
    }
    EXPECT_EQ(hash(), before);
}

TEST_F(Services, TheHostsFilesTakeThePlaceOfTheDisk) {
    MemoryFiles memory;
    auto host = sized<rubble_host>();
    host.user = &memory;
    host.file_size = MemoryFiles::size, host.read_file = MemoryFiles::read, host.write_file = MemoryFiles::write;
    ASSERT_EQ(api()->set_host(&host), RUBBLE_OK) << api()->get_last_error();
    memory.files["in/archive.rubble"] = bytesOf(s_level);
    ASSERT_EQ(api()->load_level(m_world, "in/archive.rubble", nullptr), RUBBLE_OK) << api()->get_last_error();
    step();
    ASSERT_EQ(api()->start_recording(m_world, "in/log.rubblelog"), RUBBLE_OK) << api()->get_last_error();
    breakTable();
    const uint64_t played = hash();
    ASSERT_EQ(api()->stop_recording(m_world), RUBBLE_OK) << api()->get_last_error();
    ASSERT_EQ(api()->save_game(m_world, "in/game.rubble"), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(memory.files.size(), 3u);
    EXPECT_FALSE(std::filesystem::exists("in")) << "nothing is on the disk";
    uint64_t steps = 0;
    ASSERT_EQ(api()->play_recording(m_world, "in/log.rubblelog", &steps), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(steps, 10u);
    EXPECT_EQ(hash(), played);
    ASSERT_EQ(api()->load_game(m_world, "in/game.rubble"), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(hash(), played);
    const std::vector<uint8_t>& log = memory.files["in/log.rubblelog"];
    ASSERT_EQ(api()->play_recording_data(m_world, log.data(), log.size(), &steps), RUBBLE_OK);
    EXPECT_EQ(steps, 10u);
}

TEST_F(Services, APrefabReadsItsFileOnce) {
    MemoryFiles memory;
    auto host = sized<rubble_host>();
    host.user = &memory;
    host.file_size = MemoryFiles::size, host.read_file = MemoryFiles::read, host.write_file = MemoryFiles::write;
    ASSERT_EQ(api()->set_host(&host), RUBBLE_OK) << api()->get_last_error();
    ASSERT_EQ(api()->save_level(m_world, "table.rubble", nullptr), RUBBLE_OK) << api()->get_last_error();
    ASSERT_EQ(api()->save_level(m_world, "table.vox", nullptr), RUBBLE_OK) << api()->get_last_error();
    for (const char* path : {"table.rubble", "table.vox"}) {
        auto prefab = sized<rubble_prefab>();
        prefab.path = path;
        uint32_t count = 0;
        memory.reads = 0;
        ASSERT_EQ(api()->create_prefab(m_world, &prefab, nullptr, 0, &count), RUBBLE_OK) << api()->get_last_error();
        EXPECT_GT(count, 0u);
        EXPECT_EQ(memory.reads, 1) << path;
    }
}

TEST_F(Services, WhatTheHostCannotReadOrWriteIsAnErrorOfTheFile) {
    MemoryFiles memory;
    auto host = sized<rubble_host>();
    host.user = &memory;
    host.file_size = MemoryFiles::size;
    expectRefused(api()->set_host(&host), RUBBLE_ERROR_NULL, "read_file");
    host.read_file = MemoryFiles::read, host.write_file = MemoryFiles::write;
    ASSERT_EQ(api()->set_host(&host), RUBBLE_OK);
    memory.canRead = memory.canWrite = false;
    memory.files["a.rubble"] = {1, 2, 3};
    expectRefused(api()->load_game(m_world, "a.rubble"), RUBBLE_ERROR_FILE, "a.rubble: cannot read: the host's");
    expectRefused(api()->save_game(m_world, "b.rubble"), RUBBLE_ERROR_FILE, "b.rubble: cannot write: the host's");
    expectRefused(api()->load_game(m_world, "not/there.rubble"), RUBBLE_ERROR_FILE, "not/there.rubble: cannot open");
    expectRefused(api()->save_game(m_world, "disk/not/there/b.rubble"), RUBBLE_ERROR_FILE, "cannot write");
    ASSERT_EQ(api()->start_recording(m_world, "c.rubblelog"), RUBBLE_OK);
    step();
    expectRefused(api()->stop_recording(m_world), RUBBLE_ERROR_FILE, "c.rubblelog: cannot write: the host's");
}

/// Messages of a world, one a line.
void addLine(void* user, int32_t, const char* message) {
    *static_cast<std::string*>(user) += std::string(message) + "\n";
}

TEST_F(Services, EachWorldHasItsOwnLog) {
    std::string lines[3];
    auto host = sized<rubble_host>();
    host.user = &lines[2], host.log = addLine;
    ASSERT_EQ(api()->set_host(&host), RUBBLE_OK);
    auto settings = sized<rubble_world_settings>();
    settings.flags = RUBBLE_WORLD_NO_RENDERER;
    settings.log = addLine, settings.user = &lines[0];
    const rubble_world first = makeWith(settings);
    settings.user = &lines[1];
    const rubble_world second = makeWith(settings);
    for (const rubble_world world : {first, second, m_world}) {
        ASSERT_EQ(api()->undo(world), RUBBLE_OK);  // which step() cannot do, and logs
        ASSERT_EQ(api()->step(world), RUBBLE_OK);
        EXPECT_EQ(lines[1].empty(), world == first);
    }
    for (const std::string& each : lines)
        EXPECT_EQ(each, "undo: no marks are kept; call set_undo_limit() with more than 0 first\n");
    EXPECT_EQ(api()->destroy_world(first), RUBBLE_OK);
    EXPECT_EQ(api()->destroy_world(second), RUBBLE_OK);
}

TEST_F(Services, TheLogSaysWhichRoundShapesAreTouchedAsVoxels) {
    std::string lines;
    auto settings = sized<rubble_world_settings>();
    settings.flags = RUBBLE_WORLD_NO_RENDERER, settings.log = addLine, settings.user = &lines;
    const rubble_world world = makeWith(settings);
    const auto makeRound = [&](uint32_t source) {
        const auto free = sized<rubble_body_settings>();
        auto shape = sized<rubble_shape_settings>();
        shape.source = source, std::fill_n(shape.size, 3, 8);
        auto round = sized<rubble_collision_shape>();
        round.kind = RUBBLE_COLLISION_SPHERE;
        ASSERT_EQ(api()->create_body(world, &free, &shape.body), RUBBLE_OK);
        ASSERT_EQ(api()->create_shape(world, &shape, &round.shape), RUBBLE_OK);
        ASSERT_EQ(api()->set_collision_shape(world, &round), RUBBLE_OK);
        ASSERT_EQ(api()->step(world), RUBBLE_OK);
    };
    makeRound(RUBBLE_SHAPE_SPHERE);
    EXPECT_EQ(lines, "");
    makeRound(RUBBLE_SHAPE_BOX);
    EXPECT_NE(lines.find("is touched as voxels"), std::string::npos) << lines;
    EXPECT_EQ(api()->destroy_world(world), RUBBLE_OK);
}

/// A job system of the host's: as many threads as there are jobs, three at most.
struct Jobs {
    std::atomic<int> calls = 0;
    bool leavesOneOut = false;

    static void run(void* user, uint32_t count, void (*job)(void* context, uint32_t index), void* context) {
        auto& self = *static_cast<Jobs*>(user);
        ++self.calls;
        std::atomic<uint32_t> next = self.leavesOneOut ? 1 : 0;
        const auto work = [&] {
            for (uint32_t i = next++; i < count; i = next++) job(context, i);
        };
        std::thread other(work);
        work();
        other.join();
    }
};

TEST_F(Services, TheHostsJobSystemGivesTheSameBits) {
    Jobs jobs;
    auto settings = sized<rubble_world_settings>();
    settings.flags = RUBBLE_WORLD_NO_RENDERER;
    settings.user = &jobs, settings.parallel_for = Jobs::run;
    const auto play = [&] {
        EXPECT_EQ(api()->load_level(m_world, s_level.c_str(), nullptr), RUBBLE_OK);
        breakTable();
        step(20);
        return hash();
    };
    const uint64_t alone = play();
    EXPECT_EQ(api()->destroy_world(m_world), RUBBLE_OK);
    m_world = makeWith(settings);
    EXPECT_EQ(play(), alone);
    EXPECT_GT(jobs.calls, 0);
}

TEST_F(Services, AJobThatIsLeftOutBreaksTheWorldAndNotTheHost) {
    Jobs jobs;
    auto settings = sized<rubble_world_settings>();
    settings.flags = RUBBLE_WORLD_NO_RENDERER;
    settings.user = &jobs, settings.parallel_for = Jobs::run;
    const rubble_world world = makeWith(settings);
    ASSERT_EQ(api()->load_level(world, s_level.c_str(), nullptr), RUBBLE_OK);
    const rubble_explosion explosion = tableExplosion();
    ASSERT_EQ(api()->explode(world, &explosion), RUBBLE_OK);
    jobs.leavesOneOut = true;
    rubble_result result = RUBBLE_OK;
    for (int i = 0; i < 120 && result == RUBBLE_OK; ++i) result = api()->step(world);
    expectRefused(result, RUBBLE_ERROR_INTERNAL, "parallel_for: expected");
    EXPECT_EQ(api()->step(world), RUBBLE_ERROR_BROKEN);
    EXPECT_EQ(api()->destroy_world(world), RUBBLE_OK);
}

TEST_F(Services, AWorldOfOneThreadReportsAnother) {
    auto settings = sized<rubble_world_settings>();
    settings.flags = RUBBLE_WORLD_NO_RENDERER | RUBBLE_WORLD_ONE_THREAD;
    const rubble_world world = makeWith(settings);
    rubble_result stepped = RUBBLE_OK, destroyed = RUBBLE_OK, other = RUBBLE_ERROR_NULL;
    std::string text;
    std::thread([&] {
        stepped = api()->step(world);
        text = api()->get_last_error();
        destroyed = api()->destroy_world(world);
        other = api()->step(m_world);
    }).join();
    EXPECT_EQ(stepped, RUBBLE_ERROR_THREAD);
    EXPECT_EQ(text,
              "step: world was made with RUBBLE_WORLD_ONE_THREAD: expected the thread of create_world(), found "
              "another");
    EXPECT_EQ(destroyed, RUBBLE_ERROR_THREAD);
    EXPECT_EQ(other, RUBBLE_OK) << "a world without the flag";
    EXPECT_EQ(api()->step(world), RUBBLE_OK);
    EXPECT_EQ(api()->destroy_world(world), RUBBLE_OK);
}

TEST_F(Services, ALevelIsReadWhileTheWorldPlaysOn) {
    double progress = -1.0;
    expectRefused(api()->get_loading_progress(m_world, &progress), RUBBLE_ERROR_ARGUMENT, "start_loading() first");
    expectRefused(api()->finish_loading(m_world), RUBBLE_ERROR_ARGUMENT, "start_loading() first");
    ASSERT_EQ(api()->load_level(m_world, s_level.c_str(), nullptr), RUBBLE_OK);
    step();
    const uint64_t expected = hash();
    breakTable();
    ASSERT_EQ(api()->start_loading(m_world, s_level.c_str(), nullptr), RUBBLE_OK) << api()->get_last_error();
    do {
        step();
        ASSERT_EQ(api()->get_loading_progress(m_world, &progress), RUBBLE_OK);
        ASSERT_TRUE(progress >= 0.0 && progress <= 1.0) << progress;
    } while (progress < 1.0);
    ASSERT_EQ(api()->finish_loading(m_world), RUBBLE_OK) << api()->get_last_error();
    step();
    EXPECT_EQ(hash(), expected);
}

TEST_F(Services, ALevelThatCannotBeReadInTheBackgroundLeavesTheWorld) {
    const uint64_t before = hash();
    ASSERT_EQ(api()->start_loading(m_world, "no/such.rubble", nullptr), RUBBLE_OK);
    expectRefused(api()->finish_loading(m_world), RUBBLE_ERROR_FILE, "no/such.rubble: cannot open");
    expectRefused(api()->finish_loading(m_world), RUBBLE_ERROR_ARGUMENT, "no level is being read");
    expectRefused(api()->start_loading(m_world, nullptr, nullptr), RUBBLE_ERROR_NULL, "path");
    EXPECT_EQ(hash(), before);
    for (int i = 0; i < 3; ++i) ASSERT_EQ(api()->start_loading(m_world, s_level.c_str(), nullptr), RUBBLE_OK);
    EXPECT_EQ(api()->destroy_world(m_world), RUBBLE_OK) << "while it is read";
    m_world = makeWorld();
}

TEST_F(Services, WorldsPlayOnSeveralThreadsAtOnce) {
    constexpr int kThreads = 4;
    std::vector<uint64_t> hashes(kThreads);
    std::vector<std::thread> threads;
    for (int i = 0; i < kThreads; ++i)
        threads.emplace_back([&, i] {
            const rubble_world world = makeWorld();
            const rubble_explosion explosion = tableExplosion();
            bool good = api()->explode(world, &explosion) == RUBBLE_OK;
            for (int k = 0; k < 30; ++k) good = good && api()->step(world) == RUBBLE_OK;
            uint64_t size = 0;
            std::vector<uint8_t> data(1 << 20);
            good = good && api()->save_game_data(world, data.data(), data.size(), &size) == RUBBLE_OK;
            good = good && api()->load_game_data(world, data.data(), size) == RUBBLE_OK;
            if (good) api()->get_state_hash(world, &hashes[size_t(i)]);
            api()->destroy_world(world);
        });
    for (std::thread& thread : threads) thread.join();
    for (const uint64_t each : hashes) EXPECT_EQ(each, hashes[0]);
    EXPECT_NE(hashes[0], 0u);
}

}  // namespace
}  // namespace rubble
