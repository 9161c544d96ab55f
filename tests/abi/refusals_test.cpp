#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <string>

#include "tests/abi/abi_fixture.h"

namespace rubble {
namespace {

TEST_F(Abi, WrongVersionsAreRefused) {
    const rubble_api* table = api();
    testing::internal::CaptureStderr();
    EXPECT_EQ(rubble_get_api(RUBBLE_VERSION + 1, &table), RUBBLE_ERROR_VERSION);
    EXPECT_NE(testing::internal::GetCapturedStderr().find("version 2 asked for"), std::string::npos);
    EXPECT_EQ(table, nullptr);
    EXPECT_EQ(rubble_get_api(RUBBLE_VERSION, nullptr), RUBBLE_ERROR_NULL);
    EXPECT_EQ(api()->struct_size, sizeof(rubble_api));
    EXPECT_EQ(api()->version, RUBBLE_VERSION);
}

TEST_F(Abi, EveryFunctionOfTheTableIsSet) {
    const auto* bytes = reinterpret_cast<const unsigned char*>(api());
    for (size_t at = offsetof(rubble_api, get_last_error); at < sizeof(rubble_api); at += sizeof(void*)) {
        void* function = nullptr;
        std::memcpy(&function, bytes + at, sizeof function);
        EXPECT_NE(function, nullptr) << "at byte " << at;
    }
}

TEST_F(Abi, NullPointersAreRefused) {
    const double axis[3] = {1, 0, 0};
    rubble_hit hit = {};
    rubble_renderer renderer = 1;
    expectRefused(api()->create_world(nullptr, nullptr), RUBBLE_ERROR_NULL, "out");
    expectRefused(api()->load_level(m_world, nullptr, nullptr), RUBBLE_ERROR_NULL, "path");
    expectRefused(api()->carve(m_world, nullptr), RUBBLE_ERROR_NULL, "carve");
    expectRefused(api()->explode(m_world, nullptr), RUBBLE_ERROR_NULL, "explode");
    expectRefused(api()->paint(m_world, nullptr), RUBBLE_ERROR_NULL, "paint");
    expectRefused(api()->apply_impulse(m_world, nullptr), RUBBLE_ERROR_NULL, "apply_impulse");
    expectRefused(api()->get_events(m_world, nullptr), RUBBLE_ERROR_NULL, "out");
    expectRefused(api()->get_body_states(m_world, nullptr, 0, nullptr), RUBBLE_ERROR_NULL, "count");
    uint32_t count = 0;
    expectRefused(api()->get_body_states(m_world, nullptr, 5, &count), RUBBLE_ERROR_NULL, "out");
    expectRefused(api()->get_body_state(m_world, bodies(m_world)[0].body, nullptr), RUBBLE_ERROR_NULL, "out");
    expectRefused(api()->get_shape_states(m_world, 0, nullptr, 5, &count), RUBBLE_ERROR_NULL, "out");
    expectRefused(api()->cast_ray(m_world, nullptr, axis, 1, &hit), RUBBLE_ERROR_NULL, "origin");
    expectRefused(api()->cast_ray(m_world, axis, nullptr, 1, &hit), RUBBLE_ERROR_NULL, "direction");
    expectRefused(api()->cast_ray(m_world, axis, axis, 1, nullptr), RUBBLE_ERROR_NULL, "out");
    expectRefused(api()->get_state_hash(m_world, nullptr), RUBBLE_ERROR_NULL, "out");
    expectRefused(api()->get_voxel_accounting(m_world, nullptr), RUBBLE_ERROR_NULL, "out");
    expectRefused(api()->get_step_stats(m_world, nullptr), RUBBLE_ERROR_NULL, "out");
    expectRefused(api()->create_renderer(m_world, nullptr, &renderer), RUBBLE_ERROR_NULL, "settings");
    EXPECT_EQ(renderer, 0u);
}

TEST_F(Abi, NumbersBeyondTheirRangesAreRefused) {
    const double corners[8] = {-10, -10, 10, -10, 10, 10, -10, 10};
    auto water = sized<rubble_water_settings>();
    water.outline = corners, water.outline_count = 4, water.depth = 5;
    water.flow[0] = 1e4;
    expectRefused(api()->add_water(m_world, &water), RUBBLE_ERROR_ARGUMENT, "flow[0] is 10000, expected -100 to 100");
    auto joint = sized<rubble_joint_settings>();
    joint.flags = 64;
    expectRefused(api()->add_joint(m_world, &joint), RUBBLE_ERROR_ARGUMENT, "flags has unknown bits: 0x40");
    auto character = sized<rubble_character_settings>();
    character.radius = 2.0;
    expectRefused(api()->add_character(m_world, &character), RUBBLE_ERROR_ARGUMENT, "height is 1.8, expected 4 to 100");
    auto impulse = sized<rubble_impulse>();
    impulse.body = bodies(m_world)[0].body;
    impulse.impulse[2] = std::numeric_limits<double>::infinity();
    expectRefused(api()->apply_impulse(m_world, &impulse), RUBBLE_ERROR_ARGUMENT, "impulse[2] is inf");
    auto grab = sized<rubble_grab>();
    grab.body = impulse.body, grab.hand = 0xffffffffu;
    expectRefused(api()->grab_body(m_world, &grab), RUBBLE_ERROR_ARGUMENT, "hand is");
}

TEST_F(Abi, WrongStructSizesAreRefused) {
    auto explosion = tableExplosion();
    for (const uint32_t size : {0u, 4u, uint32_t(sizeof explosion) - 1, 1u << 30}) {
        explosion.struct_size = size;
        expectRefused(api()->explode(m_world, &explosion), RUBBLE_ERROR_STRUCT_SIZE, "struct_size");
    }
    auto voxels = sized<rubble_voxel_accounting>();
    voxels.struct_size = 8;
    expectRefused(api()->get_voxel_accounting(m_world, &voxels), RUBBLE_ERROR_STRUCT_SIZE, "struct_size");
}

TEST_F(Abi, ALongerStructIsAcceptedIfItsNewFieldsAreZero) {
    struct Grown {
        rubble_explosion known;
        uint64_t added;
    } grown = {tableExplosion(), 0};
    grown.known.struct_size = sizeof grown;
    EXPECT_EQ(api()->explode(m_world, &grown.known), RUBBLE_OK) << api()->get_last_error();
    grown.added = 1;
    expectRefused(api()->explode(m_world, &grown.known), RUBBLE_ERROR_STRUCT_SIZE, "does not know");
}

TEST_F(Abi, StaleHandlesAreReported) {
    const rubble_world gone = makeWorld();
    const rubble_body itsBody = bodies(gone)[0].body;
    rubble_body_state state = {};
    expectRefused(api()->get_body_state(m_world, itsBody, &state), RUBBLE_ERROR_STALE, "body");  // of another world
    EXPECT_EQ(api()->destroy_world(gone), RUBBLE_OK);
    expectRefused(api()->destroy_world(gone), RUBBLE_ERROR_STALE, "world");
    expectRefused(api()->step(gone), RUBBLE_ERROR_STALE, "world");
    expectRefused(api()->step(0), RUBBLE_ERROR_STALE, "world");
    expectRefused(api()->step(~0ull), RUBBLE_ERROR_STALE, "world");
    expectRefused(api()->step(itsBody), RUBBLE_ERROR_STALE, "type");
    expectRefused(api()->get_body_state(m_world, m_world, &state), RUBBLE_ERROR_STALE, "type");
    auto explosion = tableExplosion();
    expectRefused(api()->explode(gone, &explosion), RUBBLE_ERROR_STALE, "world");
    auto impulse = sized<rubble_impulse>();
    expectRefused(api()->apply_impulse(m_world, &impulse), RUBBLE_ERROR_STALE, "body");
    auto carve = sized<rubble_carve>();
    carve.radii[0] = 1.0;
    carve.shape = bodies(m_world)[0].body;
    expectRefused(api()->carve(m_world, &carve), RUBBLE_ERROR_STALE, "type");
    expectRefused(api()->destroy_renderer(0), RUBBLE_ERROR_STALE, "renderer");

    const rubble_world next = makeWorld();  // takes the slot of the destroyed world
    EXPECT_NE(next, gone);
    expectRefused(api()->step(gone), RUBBLE_ERROR_STALE, "world");
    EXPECT_EQ(api()->destroy_world(next), RUBBLE_OK);
}

TEST_F(Abi, ABodyThatALevelReplacedIsStale) {
    const rubble_body body = bodies(m_world)[0].body;
    ASSERT_EQ(api()->load_level(m_world, s_level.c_str(), nullptr), RUBBLE_OK);
    rubble_body_state state = {};
    expectRefused(api()->get_body_state(m_world, body, &state), RUBBLE_ERROR_STALE, "body");
}

TEST_F(Abi, NonFiniteAndOutOfRangeNumbersAreRefused) {
    auto explosion = tableExplosion();
    explosion.position[1] = std::numeric_limits<double>::quiet_NaN();
    expectRefused(api()->explode(m_world, &explosion), RUBBLE_ERROR_ARGUMENT, "position[1]");
    explosion = tableExplosion();
    explosion.size = 1e9;
    expectRefused(api()->explode(m_world, &explosion), RUBBLE_ERROR_ARGUMENT, "size");
    auto carve = sized<rubble_carve>();
    expectRefused(api()->carve(m_world, &carve), RUBBLE_ERROR_ARGUMENT, "radii");
    carve.radii[0] = 0.5, carve.radii[1] = 1.0;
    expectRefused(api()->carve(m_world, &carve), RUBBLE_ERROR_ARGUMENT, "radii");
    carve.brush = 7;
    expectRefused(api()->carve(m_world, &carve), RUBBLE_ERROR_ARGUMENT, "brush");
    const double origin[3] = {0, 0, 0}, nowhere[3] = {0, 0, 0};
    rubble_hit hit = {};
    expectRefused(api()->cast_ray(m_world, origin, nowhere, 1, &hit), RUBBLE_ERROR_ARGUMENT, "direction");
    auto settings = sized<rubble_world_settings>();
    settings.flags = 1u << 31;
    rubble_world world = 0;
    expectRefused(api()->create_world(&settings, &world), RUBBLE_ERROR_ARGUMENT, "flags");
}

TEST_F(Abi, AShortArrayGetsTheRowsThatFit) {
    const rubble_explosion explosion = tableExplosion();
    ASSERT_EQ(api()->explode(m_world, &explosion), RUBBLE_OK);
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    ASSERT_GE(bodies(m_world).size(), 2u);
    rubble_body_state rows[2] = {};
    uint32_t count = 0;
    expectRefused(api()->get_body_states(m_world, rows, 1, &count), RUBBLE_ERROR_CAPACITY, "holds 1");
    EXPECT_EQ(count, bodies(m_world).size());
    EXPECT_NE(rows[0].body, 0u);
    EXPECT_EQ(rows[1].body, 0u);
}

TEST_F(Abi, AFailedLoadLeavesTheWorldUnchanged) {
    uint64_t before = 0, after = 1;
    ASSERT_EQ(api()->get_state_hash(m_world, &before), RUBBLE_OK);
    expectRefused(api()->load_level(m_world, "no/such/file.rubble", nullptr), RUBBLE_ERROR_FILE, "no/such/file.rubble");
    expectRefused(api()->load_level(m_world, RUBBLE_LIBRARY, nullptr), RUBBLE_ERROR_FILE, "librubble");
    ASSERT_EQ(api()->get_state_hash(m_world, &after), RUBBLE_OK);
    EXPECT_EQ(before, after);
}

TEST_F(Abi, ARendererNeedsTheHostsGl) {
    rubble_world world = 0;
    ASSERT_EQ(api()->create_world(nullptr, &world), RUBBLE_OK);
    auto settings = sized<rubble_renderer_settings>();
    rubble_renderer renderer = 0;
    expectRefused(api()->create_renderer(world, &settings, &renderer), RUBBLE_ERROR_GL, "gl_get_proc_address");
    settings.flags = 4;
    expectRefused(api()->create_renderer(world, &settings, &renderer), RUBBLE_ERROR_ARGUMENT, "flags");
    settings.flags = 0;
    settings.preset = "shiny";
    expectRefused(api()->create_renderer(world, &settings, &renderer), RUBBLE_ERROR_ARGUMENT, "shiny");
    EXPECT_EQ(api()->destroy_world(world), RUBBLE_OK);
}

TEST_F(Abi, HandlesOfADestroyedWorldNameNothingInALaterOne) {
    rubble_world world = makeWorld();
    const std::vector<rubble_body_state> old = bodies(world);
    ASSERT_FALSE(old.empty());
    for (int round = 0; round < 3; ++round) {
        ASSERT_EQ(api()->destroy_world(world), RUBBLE_OK);
        world = makeWorld();
        const std::vector<rubble_body_state> now = bodies(world);
        ASSERT_EQ(now.size(), old.size());
        uint32_t count = 0;
        for (const rubble_body_state& body : old) {
            EXPECT_EQ(body.body >> 48, now[0].body >> 48) << "the number is used again";
            EXPECT_EQ(api()->get_shape_states(world, body.body, nullptr, 0, &count), RUBBLE_ERROR_STALE);
        }
    }
    EXPECT_EQ(api()->destroy_world(world), RUBBLE_OK);
}

}  // namespace
}  // namespace rubble
