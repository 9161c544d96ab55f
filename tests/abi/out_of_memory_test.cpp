#include <dlfcn.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>

#include "tests/abi/create_fixture.h"
#include "tests/support/allocation_count.h"
#include "tests/support/temp_folder.h"

namespace {
bool g_streamsFail = false, g_pathsFail = false;

template <class F>
F next(const char* name) {
    return reinterpret_cast<F>(dlsym(RTLD_NEXT, name));
}
}  // namespace

// The library calls these before those of the C library.
extern "C" __attribute__((visibility("default"))) FILE* fdopen(int file, const char* mode) noexcept {
    if (!g_streamsFail) return next<FILE* (*)(int, const char*)>("fdopen")(file, mode);
    errno = ENOMEM;
    return nullptr;
}
extern "C" __attribute__((visibility("default"))) FILE* fopen(const char* path, const char* mode) {
    if (!g_streamsFail) return next<FILE* (*)(const char*, const char*)>("fopen")(path, mode);
    errno = ENOMEM;
    return nullptr;
}
extern "C" __attribute__((visibility("default"))) char* realpath(const char* path, char* out) noexcept {
    if (!g_pathsFail) return next<char* (*)(const char*, char*)>("realpath")(path, out);
    errno = ENOMEM;
    return nullptr;
}

namespace rubble {
namespace {

/// Calls for which there is no memory.
class AbiMemory : public AbiCreate {
protected:
    using Call = std::function<rubble_result(rubble_body table)>;
    void SetUp() override {
        AbiCreate::SetUp();
        if (!allocationCount()) GTEST_SKIP() << "this sanitizer counts no allocations";
    }
    /// Makes the call again and again, each time with memory for one allocation more, until it is done. Before that it
    /// has no effect: afterwards the world is as one in which it was made once.
    void expectNoEffectUntilDone(const char* name, const Call& call) {
        api()->destroy_world(m_world);
        const rubble_world once = m_world = makeWorld(), often = makeWorld();
        ASSERT_EQ(call(bodies(m_world)[0].body), RUBBLE_OK) << name << ": " << api()->get_last_error();
        step();
        const uint64_t expected = hash();
        m_world = often;
        const uint64_t before = hash();
        const rubble_body table = bodies(m_world)[0].body;
        rubble_result result = RUBBLE_ERROR_MEMORY;
        for (size_t allocations = 0; result == RUBBLE_ERROR_MEMORY && allocations < 100'000; ++allocations) {
            {
                const AllocationFailure failure(allocations);
                result = call(table);
            }
            ASSERT_TRUE(result == RUBBLE_OK || hash() == before) << name << " with memory for " << allocations;
        }
        EXPECT_EQ(result, RUBBLE_OK) << name << ": " << api()->get_last_error();
        step();
        EXPECT_EQ(hash(), expected) << name;
        EXPECT_EQ(api()->destroy_world(once), RUBBLE_OK);
    }
};

TEST_F(AbiMemory, WhatMakesThingsHasNoEffectWithoutIt) {
    rubble_body body = 0;
    rubble_shape shape = 0;
    const auto settings = bodyAt(5.0, 1.0, 0);
    expectNoEffectUntilDone("create_body", [&](rubble_body) { return api()->create_body(m_world, &settings, &body); });
    const std::vector<uint8_t> cells(729, 1);
    expectNoEffectUntilDone("create_shape", [&](rubble_body table) {
        auto box = shapeOn(table, RUBBLE_SHAPE_INDICES, 9);
        box.indices = cells.data(), box.count = cells.size();
        return api()->create_shape(m_world, &box, &shape);
    });
    expectNoEffectUntilDone("create_prefab", [&](rubble_body) {
        auto prefab = sized<rubble_prefab>();
        prefab.path = s_level.c_str(), prefab.position[0] = 20.0;
        rubble_prefab_row rows[64];
        uint32_t count = 0;
        return api()->create_prefab(m_world, &prefab, rows, 64, &count);
    });
}

TEST_F(AbiMemory, EditsHaveNoEffectWithoutIt) {
    expectNoEffectUntilDone("explode", [&](rubble_body) {
        const rubble_explosion explosion = tableExplosion();
        return api()->explode(m_world, &explosion);
    });
    expectNoEffectUntilDone("set_tag", [&](rubble_body table) {
        return api()->set_tag(m_world, table, "a tag that is longer than short strings are",
                              "a value that is longer than short strings are");
    });
}

TEST_F(AbiMemory, SavesRecordingsAndDeltasBeginWhenThereIsEnough) {
    const TempFolder folder;
    const std::string path = folder / "game.rubblelog", part = path + ".part";
    std::vector<uint8_t> game(1 << 20);
    uint64_t bytes = 0;
    expectNoEffectUntilDone("save_game_data", [&](rubble_body) {
        return api()->save_game_data(m_world, game.data(), game.size(), &bytes);
    });
    expectNoEffectUntilDone("keep_deltas", [&](rubble_body) { return api()->keep_deltas(m_world, RUBBLE_DELTAS_ALL); });
    expectNoEffectUntilDone("start_recording", [&](rubble_body) {
        const rubble_result result = api()->start_recording(m_world, path.c_str());
        EXPECT_EQ(access(part.c_str(), F_OK) == 0, result == RUBBLE_OK);
        return result == RUBBLE_OK ? api()->stop_recording(m_world) : result;
    });
}

TEST_F(AbiMemory, FilesThatCannotBeOpenedForLackOfItAreNotBlamed) {
    const TempFolder folder;
    const std::string level = folder / "level.rubble", game = folder / "game.rubble", log = folder / "game.rubblelog";
    ASSERT_EQ(api()->save_level(m_world, level.c_str(), nullptr), RUBBLE_OK);
    ASSERT_EQ(api()->save_game(m_world, game.c_str()), RUBBLE_OK);
    const uint64_t before = hash();
    auto prefab = sized<rubble_prefab>();
    prefab.path = level.c_str();
    uint32_t count = 0;
    const auto expectNoMemory = [&](rubble_result result) { expectRefused(result, RUBBLE_ERROR_MEMORY, "memory"); };
    g_streamsFail = true;
    expectNoMemory(api()->load_level(m_world, level.c_str(), nullptr));
    expectNoMemory(api()->create_prefab(m_world, &prefab, nullptr, 0, &count));
    expectNoMemory(api()->load_game(m_world, game.c_str()));
    expectNoMemory(api()->play_recording(m_world, game.c_str(), nullptr));
    for (bool* fails : {&g_streamsFail, &g_pathsFail}) {
        g_streamsFail = g_pathsFail = false;
        *fails = true;
        expectNoMemory(api()->save_level(m_world, level.c_str(), nullptr));
        expectNoMemory(api()->save_game(m_world, game.c_str()));
        expectNoMemory(api()->start_recording(m_world, log.c_str()));
    }
    g_streamsFail = g_pathsFail = false;
    EXPECT_EQ(hash(), before);
    std::error_code none;
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path(), none), {}), 2) << "files are left";
    EXPECT_EQ(api()->load_level(m_world, level.c_str(), nullptr), RUBBLE_OK) << api()->get_last_error();
}

TEST_F(AbiMemory, AStepWithoutItBreaksItsWorldAlone) {
    const rubble_world other = makeWorld();
    const rubble_explosion explosion = tableExplosion();
    ASSERT_EQ(api()->explode(m_world, &explosion), RUBBLE_OK);
    {
        const AllocationFailure failure(20);
        EXPECT_EQ(api()->step(m_world), RUBBLE_ERROR_MEMORY);
    }
    expectRefused(api()->step(m_world), RUBBLE_ERROR_BROKEN, "the world is broken, destroy it");
    EXPECT_EQ(api()->step(other), RUBBLE_OK);
    EXPECT_EQ(api()->destroy_world(other), RUBBLE_OK);
}

TEST_F(AbiMemory, ThreadsOfTheLibraryOutliveIt) {
    auto settings = sized<rubble_world_settings>();
    settings.flags = RUBBLE_WORLD_SHADOW_DATA | RUBBLE_WORLD_WAIT_FOR_SHADOW;
    settings.physics_threads = 2;
    std::array<char, 200> heard{};
    auto host = sized<rubble_host>();
    host.user = &heard;
    host.log = [](void* user, int32_t, const char* message) {
        std::snprintf(static_cast<char*>(user), sizeof heard, "%s", message);
    };
    ASSERT_EQ(api()->set_host(&host), RUBBLE_OK);
    rubble_world world = 0;
    ASSERT_EQ(api()->create_world(&settings, &world), RUBBLE_OK) << api()->get_last_error();
    ASSERT_EQ(api()->load_level(world, s_level.c_str(), nullptr), RUBBLE_OK);
    {
        const AllocationFailure failure(0, AllocationFailure::Threads::Others);
        EXPECT_EQ(api()->step(world), RUBBLE_OK) << api()->get_last_error();
        EXPECT_TRUE(failure.hasHappened());
    }
    EXPECT_NE(std::string(heard.data()).find("shadow volume"), std::string::npos) << heard.data();
    EXPECT_EQ(api()->step(world), RUBBLE_OK);
    ASSERT_EQ(api()->start_loading(world, s_level.c_str(), nullptr), RUBBLE_OK);
    EXPECT_EQ(api()->finish_loading(world), RUBBLE_OK) << api()->get_last_error();
    {
        const AllocationFailure failure(0, AllocationFailure::Threads::Others);
        ASSERT_EQ(api()->start_loading(world, s_level.c_str(), nullptr), RUBBLE_OK);
        EXPECT_NE(api()->finish_loading(world), RUBBLE_OK);
    }
    EXPECT_EQ(api()->step(world), RUBBLE_OK) << "the world plays on";
    EXPECT_EQ(api()->set_host(nullptr), RUBBLE_OK);
    EXPECT_EQ(api()->destroy_world(world), RUBBLE_OK);
}

}  // namespace
}  // namespace rubble
