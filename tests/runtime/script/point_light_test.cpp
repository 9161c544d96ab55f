// Lights of PointLight(), which last for one step, also where the world goes back.
#include <gtest/gtest.h>

#include "tests/runtime/script/yard_fixture.h"

namespace rubble::script {
namespace {

class PointLights : public testing::Test {
protected:
    PointLights() {
        m_yard.api().set_undo_limit(m_yard.world(), 4);
        m_yard.host().add("flash.lua",
                          "function update() if GetBool('burns') then PointLight(Vec(0, 3, 0), 1, 1, 1, 5) end end");
        step(2);
        m_before = count();
    }
    void burn(bool isOn) { m_yard.host().shared().registry["burns"] = isOn ? "1" : "0"; }
    void step(int count) {
        for (int i = 0; i < count; ++i) ASSERT_EQ(m_yard.host().step(), RUBBLE_OK);
    }
    uint32_t count() {
        uint32_t lights = 0;
        m_yard.api().get_objects(m_yard.world(), RUBBLE_KIND_LIGHT, nullptr, 0, &lights);
        return lights;
    }

    Yard m_yard;
    uint32_t m_before = 0;
};

/// Counts warnings of the interface while it lives.
class WarningCount {
public:
    explicit WarningCount(const rubble_api& api) : m_api(api) {
        auto host = sized<rubble_host>();
        host.user = &m_count;
        host.log = [](void* user, int32_t level, const char*) {
            *static_cast<int*>(user) += level >= RUBBLE_LOG_WARNING;
        };
        m_api.set_host(&host);
    }
    ~WarningCount() {
        auto host = sized<rubble_host>();
        m_api.set_host(&host);
    }
    WarningCount(const WarningCount&) = delete;
    WarningCount& operator=(const WarningCount&) = delete;
    int count() const { return m_count; }

private:
    const rubble_api& m_api;
    int m_count = 0;
};

TEST_F(PointLights, AnUndoSaysNothingOfThoseThatItTookBack) {
    ASSERT_EQ(m_yard.api().add_undo_mark(m_yard.world()), RUBBLE_OK);
    burn(true);
    step(3);
    EXPECT_EQ(count(), m_before + 1);
    burn(false);
    const WarningCount warnings(m_yard.api());
    ASSERT_EQ(m_yard.api().undo(m_yard.world()), RUBBLE_OK);
    step(2);
    EXPECT_EQ(count(), m_before);
    EXPECT_EQ(warnings.count(), 0);
}

TEST_F(PointLights, ThoseThatAnUndoBringsBackEndAsWell) {
    burn(true);
    step(3);
    ASSERT_EQ(m_yard.api().add_undo_mark(m_yard.world()), RUBBLE_OK);
    step(3);
    burn(false);
    step(10);
    ASSERT_EQ(count(), m_before);
    const WarningCount warnings(m_yard.api());
    ASSERT_EQ(m_yard.api().undo(m_yard.world()), RUBBLE_OK);
    m_yard.host().beforeUndo();
    burn(true);
    step(2);
    EXPECT_EQ(count(), m_before + 1) << "the one of this step";
    burn(false);
    step(2);
    EXPECT_EQ(count(), m_before);
    EXPECT_EQ(warnings.count(), 0);
}

TEST_F(PointLights, ThoseOfASaveEndAsWell) {
    const std::string file = (m_yard.folder() / "game.save").string();
    m_yard.host().add("drawn.lua",
                      "function tick() if GetBool('burns') then PointLight(Vec(0, 4, 0), 1, 1, 1) end end");
    burn(true);
    step(3);
    m_yard.host().tick(1.0 / 60.0);  // its light waits for the next step
    ASSERT_EQ(m_yard.host().save(), RUBBLE_OK);
    ASSERT_EQ(m_yard.api().save_game(m_yard.world(), file.c_str()), RUBBLE_OK);
    step(2);
    ASSERT_EQ(m_yard.api().load_game(m_yard.world(), file.c_str()), RUBBLE_OK);
    const WarningCount warnings(m_yard.api());
    m_yard.host().load();
    burn(false);
    step(2);
    EXPECT_EQ(count(), m_before);
    EXPECT_EQ(warnings.count(), 0);
}

}  // namespace
}  // namespace rubble::script
