// What uses no scripts links no Lua.
#include <gtest/gtest.h>

#include "tests/abi/run_command.h"

namespace rubble::script {
namespace {

std::string needed(const std::string& file) {
    int exitCode = 0;
    const std::string text = runCommand("readelf -d " + file + " | grep NEEDED", exitCode);
    EXPECT_EQ(exitCode, 0) << text;
    return text;
}

TEST(Linkage, OnlyScriptsLinkLua) {
    EXPECT_NE(needed(RUBBLE_LUA_PROGRAM).find("lua"), std::string::npos);
    EXPECT_EQ(needed(RUBBLE_LIBRARY).find("lua"), std::string::npos);
    EXPECT_EQ(needed(RUBBLE_RUNTIME).find("lua"), std::string::npos);
    EXPECT_EQ(needed(RUBBLE_RUNTIME).find("freetype"), std::string::npos) << "letters are the renderer's";
}

}  // namespace
}  // namespace rubble::script
