// The host of Ogre 1.12 loads the plugin and plays its script.
#include <gtest/gtest.h>

#include "generated/paths.h"
#include "tests/samples/hosts/host_run.h"

namespace rubble {
namespace {

const std::string kProgram = RUBBLE_BINARY_DIR "/bin/host_ogre";
const std::string kPlugin = RUBBLE_BINARY_DIR "/hosts/ogre/Plugin_Rubble.so";
const std::string kLevel = RUBBLE_BINARY_DIR "/hosts/yard.vox";

std::string missing() {
    const std::string program = missingFor(kProgram, "libogre-1.12-dev");
    return program.empty() ? missingFor("/usr/bin/xvfb-run", "xvfb") : program;
}

TEST(HostOgre, PlaysAmongOgresMeshes) {
    if (const std::string why = missing(); !why.empty()) GTEST_SKIP() << why;
    const std::string folder = hostFolder("ogre").string();
    const HostRun run = runHost("xvfb-run -a -s '-screen 0 640x480x24' " + kProgram + " " + kPlugin + " " + kLevel +
                                " --script " + folder + " --steps 900 --size 320x240");
    expectGoodRun(run, 4);
    if (run.images.size() != 4) return;
    expectDifferent(run.images[0], run.images[1], 0.005);  // a hole
    expectDifferent(run.images[1], run.images[2], 0.05);   // an explosion
}

TEST(HostOgre, SaysWhatIsMissing) {
    if (const std::string why = missing(); !why.empty()) GTEST_SKIP() << why;
    const HostRun none = runHost(kProgram), display = runHost(kProgram + " " + kPlugin + " " + kLevel);
    EXPECT_EQ(none.exitCode, 2);
    EXPECT_NE(none.output.find("expected a plugin and a level"), std::string::npos) << none.output;
    EXPECT_EQ(display.exitCode, 2);
    EXPECT_NE(display.output.find("expected an X display"), std::string::npos) << display.output;
}

}  // namespace
}  // namespace rubble
