// Scripts that a level names, while the list of them changes.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "generated/paths.h"
#include "tests/runtime/script/yard_fixture.h"

namespace rubble::script {
namespace {

class LevelScripts : public testing::Test {
protected:
    LevelScripts() {
        for (const char* name : {"lift", "door"})
            std::ofstream(m_yard.folder() / (std::string(name) + ".lua"))
                << "function init() print('begins', GetIntParam('speed', 1)) end function destroy() print('ends') end";
    }
    void name(std::vector<rubble_level_script> scripts) {
        ASSERT_EQ(m_yard.api().set_level_scripts(m_yard.world(), scripts.data(), uint32_t(scripts.size())), RUBBLE_OK)
            << m_yard.api().get_last_error();
        ASSERT_EQ(m_yard.host().step(), RUBBLE_OK);
    }
    /// What was logged since the last call.
    std::string news() {
        const std::string all = m_yard.logged(0), fresh = all.substr(m_known);
        m_known = all.size();
        return fresh;
    }

    Yard m_yard;

private:
    size_t m_known = 0;
};

TEST_F(LevelScripts, BeginAndEndAsTheLevelNamesThem) {
    m_yard.host().addLevelScripts();
    name({{"lift.lua", "speed=2"}});
    EXPECT_EQ(news(), "lift.lua: begins\t2\n");
    name({{"door.lua", nullptr}, {"lift.lua", "speed=2"}});
    EXPECT_EQ(news(), "door.lua: begins\t1\n");
    name({{"door.lua", nullptr}, {"lift.lua", "speed=3"}});
    EXPECT_EQ(news(), "lift.lua: ends\nlift.lua: begins\t3\n");
    name({});
    EXPECT_EQ(news(), "door.lua: ends\nlift.lua: ends\n");
}

TEST_F(LevelScripts, FollowUndoAndRedo) {
    ASSERT_EQ(m_yard.api().set_undo_limit(m_yard.world(), 4), RUBBLE_OK);
    m_yard.host().addLevelScripts();
    ASSERT_EQ(m_yard.host().step(), RUBBLE_OK);
    ASSERT_EQ(m_yard.api().add_undo_mark(m_yard.world()), RUBBLE_OK);
    name({{"lift.lua", "speed=2"}, {"lift.lua", "speed=2"}});
    EXPECT_EQ(news(), "lift.lua: begins\t2\nlift.lua#2: begins\t2\n");
    ASSERT_EQ(m_yard.api().undo(m_yard.world()), RUBBLE_OK);
    ASSERT_EQ(m_yard.host().step(), RUBBLE_OK);
    EXPECT_EQ(news(), "lift.lua#2: ends\nlift.lua: ends\n");
    EXPECT_TRUE(m_yard.host().scripts().empty());
    ASSERT_EQ(m_yard.api().redo(m_yard.world()), RUBBLE_OK);
    ASSERT_EQ(m_yard.host().step(), RUBBLE_OK);
    EXPECT_EQ(news(), "lift.lua: begins\t2\nlift.lua#2: begins\t2\n");
}

TEST_F(LevelScripts, AreLeftAloneByAHostThatDoesNotRunThem) {
    name({{"lift.lua", "speed=2"}});
    EXPECT_EQ(news(), "");
}

TEST_F(LevelScripts, MayBeNamedAsModsNameThem) {
    std::ofstream(m_yard.folder() / "mod.lua") << "x = 1";
    m_yard.host().addLevelScripts();
    name({{"MOD/mod.lua", nullptr}});
    EXPECT_EQ(m_yard.host().scripts().size(), 1u);
    EXPECT_EQ(news(), "");
}

TEST_F(LevelScripts, ThatCannotBeReadAreToldOnce) {
    m_yard.host().addLevelScripts();
    name({{"none.lua", nullptr}});
    name({{"none.lua", nullptr}});
    name({});
    const std::string told = news();
    EXPECT_NE(told.find("none.lua"), std::string::npos);
    EXPECT_EQ(told.find("none.lua"), told.rfind("none.lua"));
}

TEST_F(LevelScripts, AreLimitedInNumberAndToldOnce) {
    std::ofstream(m_yard.folder() / "bomb.lua") << "x = 1";
    m_yard.host().addLevelScripts();
    name(std::vector<rubble_level_script>(1002, {"bomb.lua", nullptr}));
    name(std::vector<rubble_level_script>(1003, {"bomb.lua", nullptr}));
    EXPECT_EQ(m_yard.host().scripts().size(), 1000u);
    EXPECT_EQ(news(),
              "the level names the script \"bomb.lua\" and others: expected at most 1000 scripts, found more, "
              "which do not run\n");
    name({});
    EXPECT_TRUE(m_yard.host().scripts().empty());
}

TEST_F(LevelScripts, HaveTheirLimitsInTheDocumentOfRanges) {
    std::ostringstream document;
    document << std::ifstream(RUBBLE_SOURCE_DIR "/docs/ranges.md").rdbuf();
    const size_t memory = SharedMemory::kScripts * SandboxLimits{}.memory;
    for (const std::string& row : {"| RunningScripts | 0 | " + std::to_string(ScriptHost::kMaxScripts) + " |",
                                   "| ScriptsMemory | 0 | " + std::to_string(memory) + " |"})
        EXPECT_NE(document.str().find(row), std::string::npos) << row;
}

TEST_F(LevelScripts, HaveAMemoryTogether) {
    SandboxLimits limits;
    limits.memory = 1 << 20;
    Yard yard(limits);
    std::ofstream(yard.folder() / "large.lua") << "t = {} for i = 1, 20000 do t[i] = i end";
    yard.host().addLevelScripts();
    const std::vector<rubble_level_script> scripts(60, {"large.lua", nullptr});
    ASSERT_EQ(yard.api().set_level_scripts(yard.world(), scripts.data(), 60), RUBBLE_OK);
    ASSERT_EQ(yard.host().step(), RUBBLE_OK);
    EXPECT_LE(yard.host().shared().memory.used, 16u << 20);
    EXPECT_LT(yard.host().scripts().size(), 30u);
    EXPECT_EQ(yard.logged(RUBBLE_LOG_ERROR),
              "the level names the script \"large.lua\": expected scripts that hold at most 16777216 bytes together, "
              "found more: it does not run\n");
    yard.host().scripts().clear();
    EXPECT_EQ(yard.host().shared().memory.used, 0u);
}

}  // namespace
}  // namespace rubble::script
