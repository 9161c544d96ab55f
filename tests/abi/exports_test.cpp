#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdio>
#include <filesystem>
#include <sstream>

#include "tests/abi/test_level.h"

namespace rubble {
namespace {

/// Runs a command and returns what it wrote to both outputs; exitCode -1 if it did not end by itself.
std::string run(const std::string& command, int& exitCode) {
    std::FILE* pipe = popen((command + " 2>&1").c_str(), "r");
    std::string text;
    char part[4096];
    while (const size_t size = std::fread(part, 1, sizeof part, pipe)) text.append(part, size);
    const int status = pclose(pipe);
    exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return text;
}

TEST(Exports, TheLibraryExportsOneSymbol) {
    int exitCode = 0;
    std::istringstream lines(run("nm -D --defined-only --extern-only " RUBBLE_LIBRARY, exitCode));
    ASSERT_EQ(exitCode, 0) << lines.str();
    std::string symbols, address, type, name;
    while (lines >> address >> type >> name) symbols += name + "\n";
    EXPECT_EQ(symbols, "rubble_get_api\n");
}

TEST(Hello, ACHostBreaksALevel) {
    const std::string level = writeTestLevel();
    int exitCode = 0;
    const std::string first = run(RUBBLE_HELLO " " + level, exitCode);
    EXPECT_EQ(exitCode, 0) << first;
    EXPECT_NE(first.find("voxels of colour #c8503c removed"), std::string::npos) << first;
    EXPECT_NE(first.find("pieces came off"), std::string::npos) << first;
    EXPECT_NE(first.find("650 voxels = "), std::string::npos) << first;
    EXPECT_EQ(run(RUBBLE_HELLO " " + level, exitCode), first) << "two runs differ";
    std::filesystem::remove(level);
}

TEST(Hello, SaysWhatIsWrongWithAFile) {
    int exitCode = 0;
    const std::string text = run(RUBBLE_HELLO " no/such/level.rubble", exitCode);
    EXPECT_EQ(exitCode, 1);
    EXPECT_NE(text.find("no/such/level.rubble"), std::string::npos) << text;
}

}  // namespace
}  // namespace rubble
