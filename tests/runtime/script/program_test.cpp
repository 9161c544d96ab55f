// The program behind ./rubble lua.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <string>

#include "tests/support/temp_folder.h"

namespace rubble::script {
namespace {

/// What the program prints, with its errors.
std::string output(const std::string& before, const std::string& arguments) {
    FILE* pipe = popen((before + " " RUBBLE_LUA_PROGRAM " " + arguments + " 2>&1").c_str(), "r");
    std::string text;
    std::array<char, 256> buffer;
    while (pipe && std::fgets(buffer.data(), buffer.size(), pipe)) text += buffer.data();
    if (pipe) pclose(pipe);
    return text;
}

TEST(LuaProgram, CallsWhatALineHasDefined) {
    const std::string text = output("printf 'function tick() print(\"ticks\") end\\n1 + 1\\n' |", "");
    EXPECT_NE(text.find("line: ticks"), std::string::npos) << text;
    EXPECT_NE(text.find("> 2\n"), std::string::npos) << text;
}

TEST(LuaProgram, PrintsVectors) {
    EXPECT_EQ(output("", "--eval 'Vec(1, 2, 3) + Vec(0, 0, 1)'"), "(1.0, 2.0, 4.0)\n");
}

TEST(LuaProgram, SaysWhatEachFunctionHasCost) {
    const TempFolder folder;
    const std::string script = (folder.path() / "mod.lua").string();
    std::ofstream(script) << "function update() GetTime() end";
    const std::string text = output("", script + " --steps 5 --profile");
    EXPECT_NE(text.find(" 5 calls"), std::string::npos) << text;
    EXPECT_NE(text.find("GetTime"), std::string::npos) << text;
    EXPECT_NE(text.find("allocations"), std::string::npos) << text;
}

}  // namespace
}  // namespace rubble::script
