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
    /// The last call was refused with this code, and the reason names `word`.
    static void expectRefused(rubble_result result, rubble_result code, const std::string& word) {
        EXPECT_EQ(result, code) << api()->get_last_error();
        EXPECT_NE(std::string(api()->get_last_error()).find(word), std::string::npos) << api()->get_last_error();
    }

    static inline std::string s_level;
    rubble_world m_world = 0;
};

}  // namespace rubble
