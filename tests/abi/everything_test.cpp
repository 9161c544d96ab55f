#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

#include "generated/paths.h"
#include "tests/abi/abi_fixture.h"
#include "tests/abi/run_command.h"
#include "tests/support/temp_folder.h"

namespace rubble {
namespace {

std::string textOf(const char* path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

TEST(Everything, ACHostUsesAllFunctions) {
    const TempFolder folder;
    int exitCode = 0;
    const std::string text = runCommand(RUBBLE_EVERYTHING " " + folder.path().string(), exitCode);
    EXPECT_EQ(exitCode, 0);
    EXPECT_EQ(text, "good\n");
}

/// A function that is new belongs into tests/abi/everything.c or everything_more.c.
TEST(Everything, NoFunctionOfTheTableIsLeftOut) {
    const std::string header = textOf(RUBBLE_SOURCE_DIR "/runtime/plugin/include/rubble/rubble.h");
    const std::string table = header.substr(header.find("typedef struct rubble_api {"));
    const std::string host = textOf(RUBBLE_SOURCE_DIR "/tests/abi/everything.c") +
                             textOf(RUBBLE_SOURCE_DIR "/tests/abi/everything_more.c") +
                             textOf(RUBBLE_SOURCE_DIR "/tests/abi/everything.h");
    const std::regex function("\\(\\*(\\w+)\\)\\(");
    std::vector<std::string> missing;
    size_t count = 0;
    for (std::sregex_iterator it(table.begin(), table.end(), function), end; it != end; ++it, ++count)
        if (host.find("api->" + (*it)[1].str() + "(") == std::string::npos) missing.push_back((*it)[1]);
    EXPECT_EQ(missing, std::vector<std::string>{});
    EXPECT_GT(count, 90u);
}

}  // namespace
}  // namespace rubble
