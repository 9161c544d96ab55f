#include <gtest/gtest.h>

#include <sstream>

#include "generated/paths.h"
#include "tests/runtime/script/yard_fixture.h"

namespace rubble::script {
namespace {

/// Plays a mod of samples/lua/mods for some seconds.
void play(Yard& yard, const std::string& name, int seconds) {
    std::ostringstream text;
    text << std::ifstream(RUBBLE_SOURCE_DIR "/samples/lua/mods/" + name).rdbuf();
    EXPECT_EQ(yard.host().add(name, text.str()).error(), "");
    for (int i = 0; i < seconds * 60; ++i) {
        yard.host().tick(1.0 / 60.0);
        ASSERT_EQ(yard.host().step(), RUBBLE_OK);
    }
    EXPECT_EQ(yard.logged(RUBBLE_LOG_WARNING), "");
}

TEST(Mod, TheGravityGunThrowsTheCrate) {
    Yard yard;
    play(yard, "gravity_gun.lua", 3);
    EXPECT_NE(yard.logged(0).find("thrown"), std::string::npos) << yard.logged(0);
    EXPECT_GE(std::stoi(yard.host().shared().registry["gravitygun.speed"]), 8);
}

TEST(Mod, TheNukeBreaksTheYard) {
    Yard yard;
    play(yard, "nuke.lua", 3);
    EXPECT_GT(std::stoi(yard.host().shared().registry["nuke.removed"]), 500);
}

TEST(Mod, TheCleanerDeletesSmallPieces) {
    Yard yard;
    play(yard, "debris_cleaner.lua", 8);
    EXPECT_GT(std::stoi(yard.host().shared().registry["cleaner.deleted"]), 0);
}

}  // namespace
}  // namespace rubble::script
