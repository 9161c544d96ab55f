#include "runtime/plugin/c_abi/call.h"
#include "runtime/plugin/c_abi/registry.h"
#include "tests/abi/abi_fixture.h"

namespace rubble {
namespace {

class BrokenWorld : public Abi {
protected:
    void SetUp() override {
        Abi::SetUp();
        auto host = sized<rubble_host>();
        host.user = this;
        host.assertion_failed = [](void* user, const char* message) {
            static_cast<BrokenWorld*>(user)->m_heard.emplace_back(message);
        };
        ASSERT_EQ(api()->set_host(&host), RUBBLE_OK);
    }
    void TearDown() override {
        api()->set_host(nullptr);
        Abi::TearDown();
    }
    /// Takes the shapes away that bodies have: a mistake that only this code could make.
    static void spoil(rubble_world world) {
        const abi::Call call("spoil");
        const auto hosted = abi::Registry::instance().findWorld(world);
        auto& data = const_cast<WorldData&>(hosted->loop.world().data());
        const auto shapes = data.shapes;
        shapes.forEach([&](ShapeHandle shape, const Shape&) { data.shapes.erase(shape); });
    }

    std::vector<std::string> m_heard;
};

TEST_F(BrokenWorld, AFailedAssertEndsTheCallAndNotTheHost) {
    spoil(m_world);
    const rubble_explosion explosion = tableExplosion();
    uint32_t count = 0;
    expectRefused(api()->get_shape_states(m_world, bodies(m_world)[0].body, nullptr, 0, &count), RUBBLE_ERROR_BROKEN,
                  "get_shape_states: runtime/core/slot_map.h:");
    ASSERT_EQ(m_heard.size(), 1u);
    EXPECT_NE(m_heard[0].find("stale handle"), std::string::npos) << m_heard[0];
    EXPECT_EQ(api()->explode(m_world, &explosion), RUBBLE_ERROR_BROKEN);
}

TEST_F(BrokenWorld, AnswersNoLaterCallAndIsDestroyed) {
    const rubble_world other = makeWorld();
    spoil(m_world);
    const rubble_explosion explosion = tableExplosion();
    ASSERT_EQ(api()->explode(m_world, &explosion), RUBBLE_OK);
    expectRefused(api()->step(m_world), RUBBLE_ERROR_BROKEN, "assertion failed");
    uint64_t hash = 0;
    expectRefused(api()->step(m_world), RUBBLE_ERROR_BROKEN, "step: the world is broken, destroy it: runtime/");
    expectRefused(api()->get_state_hash(m_world, &hash), RUBBLE_ERROR_BROKEN, "the world is broken");
    expectRefused(api()->load_level(m_world, s_level.c_str(), nullptr), RUBBLE_ERROR_BROKEN, "the world is broken");
    EXPECT_EQ(m_heard.size(), 1u);
    EXPECT_EQ(api()->step(other), RUBBLE_OK) << "others go on";
    EXPECT_EQ(api()->destroy_world(other), RUBBLE_OK);
    EXPECT_EQ(api()->destroy_world(m_world), RUBBLE_OK);
    m_world = makeWorld();
    EXPECT_EQ(api()->step(m_world), RUBBLE_OK);
}

TEST_F(BrokenWorld, AWorldsOwnCallbackHearsOfItsAsserts) {
    std::string heard;
    auto settings = sized<rubble_world_settings>();
    settings.flags = RUBBLE_WORLD_NO_RENDERER;
    settings.user = &heard;
    settings.assertion_failed = [](void* user, const char* message) { *static_cast<std::string*>(user) = message; };
    rubble_world world = 0;
    ASSERT_EQ(api()->create_world(&settings, &world), RUBBLE_OK) << api()->get_last_error();
    ASSERT_EQ(api()->load_level(world, s_level.c_str(), nullptr), RUBBLE_OK);
    spoil(world);
    const rubble_explosion explosion = tableExplosion();
    ASSERT_EQ(api()->explode(world, &explosion), RUBBLE_OK);
    EXPECT_EQ(api()->step(world), RUBBLE_ERROR_BROKEN);
    EXPECT_NE(heard.find("assertion failed"), std::string::npos) << heard;
    EXPECT_TRUE(m_heard.empty()) << "not the host";
    EXPECT_EQ(api()->destroy_world(world), RUBBLE_OK);
}

}  // namespace
}  // namespace rubble
