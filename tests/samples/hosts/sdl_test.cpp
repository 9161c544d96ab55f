// The host of SDL2 in C99 plays its script without a display.
#include <gtest/gtest.h>

#include "generated/paths.h"
#include "tests/samples/hosts/host_run.h"

namespace rubble {
namespace {

const char kProgram[] = RUBBLE_BINARY_DIR "/bin/host_sdl";
const char kLevel[] = RUBBLE_BINARY_DIR "/hosts/yard.vox";

TEST(HostSdl, PlaysAmongItsOwnTriangles) {
    if (const std::string missing = missingFor(kProgram, "libsdl2-dev"); !missing.empty()) GTEST_SKIP() << missing;
    const std::string folder = hostFolder("sdl").string();
    const HostRun run =
        runHost(std::string(kProgram) + " " + kLevel + " --script " + folder + " --steps 900 --size 320x240");
    expectGoodRun(run, 4);
    if (run.images.size() != 4) return;
    expectDifferent(run.images[0], run.images[1], 0.005);  // a hole
    expectDifferent(run.images[1], run.images[2], 0.05);   // an explosion
}

TEST(HostSdl, SaysWhatIsWrongWithItsArguments) {
    if (const std::string missing = missingFor(kProgram, "libsdl2-dev"); !missing.empty()) GTEST_SKIP() << missing;
    const std::string program = kProgram;
    const HostRun none = runHost(program), size = runHost(program + " " + kLevel + " --size big"),
                  level = runHost(program + " missing.vox --script /tmp"),
                  folder = runHost(program + " " + kLevel + " --script /missing --size 64x48");
    EXPECT_EQ(none.exitCode, 2);
    EXPECT_NE(none.output.find("expected a level"), std::string::npos) << none.output;
    EXPECT_EQ(size.exitCode, 2);
    EXPECT_NE(size.output.find("\"big\""), std::string::npos) << size.output;
    EXPECT_EQ(level.exitCode, 1);
    EXPECT_NE(level.output.find("missing.vox"), std::string::npos) << level.output;
    EXPECT_EQ(folder.exitCode, 2);
    EXPECT_NE(folder.output.find("expected a folder to write images to, found \"/missing\""), std::string::npos)
        << folder.output;
}

TEST(HostLauncher, SaysWhatAHostCanDoWithoutBuildingIt) {
    for (const char* command : {" host --help", " host sdl --help", " host godot -h"}) {
        const HostRun help = runHost(std::string(RUBBLE_SOURCE_DIR "/rubble") + command);
        EXPECT_EQ(help.exitCode, 0) << command;
        EXPECT_EQ(help.output.find("./rubble host NAME [options]"), 0u) << help.output;
        EXPECT_NE(help.output.find("--steps N --size WxH"), std::string::npos) << help.output;
    }
}

}  // namespace
}  // namespace rubble
