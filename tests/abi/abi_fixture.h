#pragma once
#include <gtest/gtest.h>
#include <rubble/rubble.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/abi/test_level.h"

namespace rubble {

/// The function table.
inline const rubble_api* api() {
    static const rubble_api* table = [] {
        const rubble_api* found = nullptr;
        EXPECT_EQ(rubble_get_api(RUBBLE_VERSION, &found), RUBBLE_OK);
        return found;
    }();
    return table;
}

/// A struct of the interface with its struct_size and zeros.
template <class T>
T sized() {
    T value = {};
    value.struct_size = sizeof(T);
    return value;
}

/// A world with the test level in it, one step old, and no renderer.
class Abi : public testing::Test {
protected:
    static void SetUpTestSuite() { s_level = writeTestLevel(); }
    static void TearDownTestSuite() { std::filesystem::remove(s_level); }
    void SetUp() override { m_world = makeWorld(); }
    void TearDown() override { api()->destroy_world(m_world); }

    static rubble_world makeWorld() {
        auto settings = sized<rubble_world_settings>();
        settings.flags = RUBBLE_WORLD_NO_RENDERER;
        rubble_world world = 0;
        EXPECT_EQ(api()->create_world(&settings, &world), RUBBLE_OK) << api()->get_last_error();
        EXPECT_EQ(api()->load_level(world, s_level.c_str(), nullptr), RUBBLE_OK) << api()->get_last_error();
        EXPECT_EQ(api()->step(world), RUBBLE_OK);
        return world;
    }
    /// Hits the middle of the table's top, so that its leg no longer holds it.
    static rubble_explosion tableExplosion() {
        auto explosion = sized<rubble_explosion>();
        explosion.position[0] = explosion.position[2] = 0.85;
        explosion.position[1] = 0.95;
        explosion.size = 0.5;
        return explosion;
    }
    static std::vector<rubble_body_state> bodies(rubble_world world) {
        uint32_t count = 0;
        EXPECT_EQ(api()->get_body_states(world, nullptr, 0, &count), RUBBLE_OK);
        std::vector<rubble_body_state> states(count);
        EXPECT_EQ(api()->get_body_states(world, states.data(), count, &count), RUBBLE_OK);
        return states;
    }
    void step(int count = 1) {
        for (int i = 0; i < count; ++i) ASSERT_EQ(api()->step(m_world), RUBBLE_OK) << api()->get_last_error();
    }
    /// All shapes of the world.
    std::vector<rubble_shape_state> shapes() {
        uint32_t count = 0;
        EXPECT_EQ(api()->get_shape_states(m_world, 0, nullptr, 0, &count), RUBBLE_OK);
        std::vector<rubble_shape_state> states(count);
        EXPECT_EQ(api()->get_shape_states(m_world, 0, states.data(), count, &count), RUBBLE_OK);
        return states;
    }
    uint64_t hash() {
        uint64_t out = 0;
        EXPECT_EQ(api()->get_state_hash(m_world, &out), RUBBLE_OK);
        return out;
    }
    /// The last call was refused with this code, and the reason names `word`.
    static void expectRefused(rubble_result result, rubble_result code, const std::string& word) {
        EXPECT_EQ(result, code) << api()->get_last_error();
        EXPECT_NE(std::string(api()->get_last_error()).find(word), std::string::npos) << api()->get_last_error();
    }

    static inline std::string s_level;
    rubble_world m_world = 0;
};

}  // namespace rubble
