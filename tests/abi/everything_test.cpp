#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/abi/run_command.h"
#include "tests/abi/test_level.h"
#include "tests/support/temp_folder.h"

namespace rubble {
namespace {

/// That no function is without an example is said by runtime/plugin/bindings/generate.py --check.
TEST(Everything, AllExamplesOfTheReferenceComeOut) {
    const TempFolder folder;
    std::filesystem::rename(writeTestLevel(), folder.path() / "level.rubble");
    int exitCode = 0;
    const std::string text = runCommand("cd " + folder.path().string() + " && " RUBBLE_EVERYTHING, exitCode);
    EXPECT_EQ(exitCode, 0) << text;
    EXPECT_TRUE(text.ends_with("\ngood\n")) << text;
}

}  // namespace
}  // namespace rubble
