#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "tests/abi/run_command.h"
#include "tests/abi/test_level.h"

namespace rubble {
namespace {

TEST(Exports, TheLibraryExportsOneSymbol) {
    int exitCode = 0;
    std::istringstream lines(runCommand("nm -D --defined-only --extern-only " RUBBLE_LIBRARY, exitCode));
    ASSERT_EQ(exitCode, 0) << lines.str();
    std::string symbols, address, type, name;
    while (lines >> address >> type >> name) symbols += name + "\n";
    EXPECT_EQ(symbols, "rubble_get_api\n");
}

TEST(Hello, ACHostBreaksALevel) {
    const std::string level = writeTestLevel();
    int exitCode = 0;
    const std::string first = runCommand(RUBBLE_HELLO " " + level, exitCode);
    EXPECT_EQ(exitCode, 0) << first;
    EXPECT_NE(first.find("voxels of colour #c8503c removed"), std::string::npos) << first;
    EXPECT_NE(first.find("pieces came off"), std::string::npos) << first;
    EXPECT_NE(first.find("650 voxels = "), std::string::npos) << first;
    EXPECT_EQ(runCommand(RUBBLE_HELLO " " + level, exitCode), first) << "two runs differ";
    std::filesystem::remove(level);
}

TEST(Hello, SaysWhatIsWrongWithAFile) {
    int exitCode = 0;
    const std::string text = runCommand(RUBBLE_HELLO " no/such/level.rubble", exitCode);
    EXPECT_EQ(exitCode, 1);
    EXPECT_NE(text.find("no/such/level.rubble"), std::string::npos) << text;
}

}  // namespace
}  // namespace rubble
