#include <cmath>
#include <string>
#include <thread>

#include "tests/abi/abi_fixture.h"
#include "tests/support/temp_folder.h"

namespace rubble {
namespace {

/// What a host hears while a call of the plugin runs.
struct Heard {
    rubble_world world = 0;
    int messages = 0;
    rubble_result inside = RUBBLE_OK, onAnotherThread = RUBBLE_OK, ofTheHost = RUBBLE_ERROR_INTERNAL;
    std::string last;
};

class AbiLog : public Abi {
protected:
    void TearDown() override {
        api()->set_host(nullptr);
        Abi::TearDown();
    }
    void listen(void (*log)(void*, int32_t, const char*), Heard& heard) {
        auto host = sized<rubble_host>();
        host.user = &heard;
        host.log = log;
        heard.world = m_world;
        ASSERT_EQ(api()->set_host(&host), RUBBLE_OK);
    }
    /// A step that logs: there is nothing to undo.
    void stepThatLogs() {
        ASSERT_EQ(api()->undo(m_world), RUBBLE_OK);
        ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    }
};

TEST_F(AbiLog, ACallbackMayLogAndSetTheHost) {
    Heard heard;
    listen(
        [](void* user, int32_t, const char* message) {
            auto& into = *static_cast<Heard*>(user);
            ++into.messages;
            into.last = message;
            const rubble_api* table = nullptr;
            rubble_get_api(99, &table);  // logs
            into.ofTheHost = api()->set_host(nullptr);
        },
        heard);
    testing::internal::CaptureStderr();
    stepThatLogs();
    stepThatLogs();
    EXPECT_EQ(heard.messages, 1) << "it has set another host";
    EXPECT_EQ(heard.ofTheHost, RUBBLE_OK);
    EXPECT_NE(testing::internal::GetCapturedStderr().find("version 99 asked for"), std::string::npos);
}

TEST_F(AbiLog, AWorldInACallAnswersNoOther) {
    Heard heard;
    listen(
        [](void* user, int32_t, const char*) {
            auto& into = *static_cast<Heard*>(user);
            uint32_t count = 0;
            into.inside = api()->get_body_states(into.world, nullptr, 0, &count);
            into.last = api()->get_last_error();
            std::thread([&] { into.onAnotherThread = api()->destroy_world(into.world); }).join();
        },
        heard);
    stepThatLogs();
    EXPECT_EQ(heard.inside, RUBBLE_ERROR_BUSY);
    EXPECT_NE(heard.last.find("get_body_states: world is in another call"), std::string::npos) << heard.last;
    EXPECT_EQ(heard.onAnotherThread, RUBBLE_ERROR_BUSY);
    EXPECT_FALSE(bodies(m_world).empty()) << "after the call it answers again";
}

TEST_F(AbiLog, AWorldThatIsReplacedShowsNothingOfTheOldOne) {
    const rubble_explosion explosion = tableExplosion();
    auto events = sized<rubble_events>();
    ASSERT_EQ(api()->explode(m_world, &explosion), RUBBLE_OK);
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    ASSERT_EQ(api()->explode(m_world, &explosion), RUBBLE_OK);
    ASSERT_EQ(api()->explode(m_world, &explosion), RUBBLE_OK);
    Heard heard;
    listen([](void* user, int32_t, const char* text) { static_cast<Heard*>(user)->last = text; }, heard);
    ASSERT_EQ(api()->load_level(m_world, s_level.c_str(), nullptr), RUBBLE_OK);
    EXPECT_NE(heard.last.find("2 edits that waited"), std::string::npos) << heard.last;
    ASSERT_EQ(api()->get_events(m_world, &events), RUBBLE_OK);
    EXPECT_EQ(events.bodies_created_count + events.split_count, 0u);
}

TEST_F(Abi, HandlesOfASaveAreTranslatedIntoTheWorldThatLoadsIt) {
    const TempFolder folder;
    const std::string save = folder / "game.rubble";
    const rubble_explosion explosion = tableExplosion();
    ASSERT_EQ(api()->explode(m_world, &explosion), RUBBLE_OK);
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    const std::vector<rubble_body_state> saved = bodies(m_world);
    ASSERT_EQ(api()->save_game(m_world, save.c_str()), RUBBLE_OK);
    const rubble_world other = makeWorld();
    ASSERT_EQ(api()->load_game(other, save.c_str()), RUBBLE_OK) << api()->get_last_error();
    for (const rubble_body_state& body : saved) {
        rubble_body here = 0;
        rubble_body_state state = {};
        EXPECT_EQ(api()->get_body_state(other, body.body, &state), RUBBLE_ERROR_STALE);
        ASSERT_EQ(api()->translate_handle(other, body.body, &here), RUBBLE_OK) << api()->get_last_error();
        ASSERT_EQ(api()->get_body_state(other, here, &state), RUBBLE_OK);
        EXPECT_EQ(state.position[1], body.position[1]);
    }
    rubble_body here = 1;
    expectRefused(api()->translate_handle(other, m_world, &here), RUBBLE_ERROR_STALE, "handle");
    expectRefused(api()->translate_handle(other, saved[0].body + 100000, &here), RUBBLE_ERROR_STALE, "handle");
    EXPECT_EQ(here, 0u);
    EXPECT_EQ(api()->destroy_world(other), RUBBLE_OK);
}

TEST_F(Abi, RaysOfAnyLengthOfDirectionHit) {
    for (const double length : {1e-300, 1e-160, 1e-12, 1.0, 1e9}) {
        const double origin[3] = {0.25, 5.0, 0.25}, down[3] = {0.0, -length, 0.0};
        rubble_hit hit = {};
        ASSERT_EQ(api()->cast_ray(m_world, origin, down, 10.0, &hit), RUBBLE_OK);
        EXPECT_EQ(hit.hit, 1u) << length;
        EXPECT_NEAR(hit.distance, 4.0, 1e-6) << length;
    }
    auto sky = sized<rubble_environment>();
    const double short_one[3] = {0.0, 1e-200, 0.0};
    ASSERT_EQ(api()->get_environment(m_world, &sky), RUBBLE_OK);
    ASSERT_EQ(api()->apply_sky_model(&sky, short_one), RUBBLE_OK) << api()->get_last_error();
    EXPECT_NEAR(sky.sun_direction[1], 1.0, 1e-6);
}

TEST_F(Abi, WhatAStepWouldLeaveOutIsRefusedAtOnce) {
    auto joint = sized<rubble_joint_settings>();
    expectRefused(api()->add_joint(m_world, &joint), RUBBLE_ERROR_ARGUMENT, "neither end is on a shape");
    ASSERT_EQ(api()->undo(m_world), RUBBLE_OK);
    expectRefused(api()->undo(m_world), RUBBLE_ERROR_ARGUMENT, "expected one undo or redo in a step");
    expectRefused(api()->redo(m_world), RUBBLE_ERROR_ARGUMENT, "expected one undo or redo in a step");
    EXPECT_EQ(api()->add_undo_mark(m_world), RUBBLE_OK);
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    EXPECT_EQ(api()->redo(m_world), RUBBLE_OK);
    rubble_query_shape region = {};
    uint32_t count = 0;
    region.reserved = 1;
    expectRefused(api()->overlap_bodies(m_world, &region, nullptr, nullptr, 0, &count), RUBBLE_ERROR_ARGUMENT,
                  "reserved is 1");
}

TEST_F(Abi, AMessageNamesTheRowThatIsWrong) {
    rubble_ray rays[3] = {};
    rubble_hit hits[3] = {};
    for (rubble_ray& ray : rays) ray.direction[0] = ray.max_distance = 1.0;
    rays[2].direction[0] = 0.0;
    expectRefused(api()->cast_rays(m_world, rays, 3, nullptr, hits), RUBBLE_ERROR_ARGUMENT,
                  "cast_rays: rays[2].direction is zero");
    rubble_shape_cast casts[2] = {};
    for (rubble_shape_cast& cast : casts) cast.direction[0] = cast.max_distance = 1.0;
    casts[1].max_distance = NAN;
    expectRefused(api()->cast_shapes(m_world, casts, 2, nullptr, hits), RUBBLE_ERROR_ARGUMENT, "casts[1].max_distance");
    expectRefused(api()->load_level(m_world, "", nullptr), RUBBLE_ERROR_FILE, "\"\": expected a name");
}

TEST_F(Abi, PhysicsHasTheThreadsOfTheHostAndTheSameBits) {
    uint64_t hashes[2] = {};
    for (const uint32_t threads : {0u, 3u}) {
        auto settings = sized<rubble_world_settings>();
        settings.flags = RUBBLE_WORLD_NO_RENDERER;
        settings.physics_threads = threads;
        rubble_world world = 0;
        ASSERT_EQ(api()->create_world(&settings, &world), RUBBLE_OK) << api()->get_last_error();
        ASSERT_EQ(api()->load_level(world, s_level.c_str(), nullptr), RUBBLE_OK);
        const rubble_explosion explosion = tableExplosion();
        ASSERT_EQ(api()->explode(world, &explosion), RUBBLE_OK);
        for (int i = 0; i < 60; ++i) ASSERT_EQ(api()->step(world), RUBBLE_OK);
        ASSERT_EQ(api()->get_state_hash(world, &hashes[threads ? 1 : 0]), RUBBLE_OK);
        EXPECT_EQ(api()->destroy_world(world), RUBBLE_OK);
    }
    EXPECT_EQ(hashes[0], hashes[1]);
    auto settings = sized<rubble_world_settings>();
    settings.physics_threads = 65;
    rubble_world world = 0;
    expectRefused(api()->create_world(&settings, &world), RUBBLE_ERROR_ARGUMENT,
                  "settings->physics_threads is 65, expected 0 (the default) or 1 to 64");
}

}  // namespace
}  // namespace rubble
