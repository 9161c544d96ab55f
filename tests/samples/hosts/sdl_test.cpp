// The host of SDL2 in C99 plays its script without a display.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>

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

TEST(HostSdl, AShortScriptEndsWithAnImage) {
    if (const std::string missing = missingFor(kProgram, "libsdl2-dev"); !missing.empty()) GTEST_SKIP() << missing;
    const std::string folder = hostFolder("sdl_short").string();
    const HostRun run =
        runHost(std::string(kProgram) + " " + kLevel + " --script " + folder + " --steps 1 --size 64x48");
    EXPECT_EQ(run.exitCode, 0) << run.output;
    EXPECT_TRUE(std::filesystem::exists(folder + "/4_end.png")) << run.output;
}

TEST(HostSdl, SaysWhatIsWrongWithItsArguments) {
    if (const std::string missing = missingFor(kProgram, "libsdl2-dev"); !missing.empty()) GTEST_SKIP() << missing;
    const std::string program = kProgram;
    const HostRun none = runHost(program), size = runHost(program + " " + kLevel + " --size big"),
                  level = runHost(program + " missing.vox --script /tmp"),
                  folder = runHost(program + " " + kLevel + " --script /proc/missing --size 64x48");
    EXPECT_EQ(none.exitCode, 2);
    EXPECT_NE(none.output.find("expected a level"), std::string::npos) << none.output;
    EXPECT_EQ(size.exitCode, 2);
    EXPECT_NE(size.output.find("\"big\""), std::string::npos) << size.output;
    EXPECT_EQ(level.exitCode, 1);
    EXPECT_NE(level.output.find("missing.vox"), std::string::npos) << level.output;
    EXPECT_EQ(folder.exitCode, 2);
    EXPECT_NE(folder.output.find("expected a folder to write images to, found \"/proc/missing\""), std::string::npos)
        << folder.output;
}

TEST(HostSdl, TakesNoNumberThatIsNone) {
    if (const std::string missing = missingFor(kProgram, "libsdl2-dev"); !missing.empty()) GTEST_SKIP() << missing;
    const std::string script = std::string("timeout 20 ") + kProgram + " " + kLevel + " --script ";
    const std::string folder = hostFolder("sdl_refused").string() + "/none";
    for (const std::string options : {"--steps -1", "--steps 0", "--steps 5x", "--steps 99999999999999999999",
                                      "--size 40x40abc", "--size -1x5", "--script -x", "second.vox"}) {
        const HostRun run = runHost(script + folder + " --size 64x48 --steps 3 " + options);
        EXPECT_EQ(run.exitCode, 2) << options << "\n" << run.output;
        EXPECT_NE(run.output.find("host_sdl: expected"), std::string::npos) << run.output;
    }
    EXPECT_FALSE(std::filesystem::exists(folder)) << "a refused call leaves nothing";
}

/// Starts a shell command without a display, sends it a signal once it has made a file, and returns how it ended.
int endBySignal(int number, const std::string& command, const std::filesystem::path& made) {
    const pid_t child = fork();
    if (child == 0) {
        std::signal(number, SIG_DFL);
        unsetenv("DISPLAY"), unsetenv("WAYLAND_DISPLAY");
        execl("/bin/bash", "bash", "-c", command.c_str(), nullptr);
        _exit(127);
    }
    int status = 0;
    while (!std::filesystem::exists(made)) {
        if (waitpid(child, &status, WNOHANG) != 0) return status;
        usleep(10'000);
    }
    kill(child, number);
    waitpid(child, &status, 0);
    return status;
}

TEST(HostSdl, ASignalEndsAScript) {
    if (const std::string missing = missingFor(kProgram, "libsdl2-dev"); !missing.empty()) GTEST_SKIP() << missing;
    for (const int number : {SIGINT, SIGTERM}) {
        const std::filesystem::path folder = hostFolder("sdl_signal");
        const std::string command = std::string("exec ") + kProgram + " " + kLevel + " --steps 3000 --size 64x48";
        const int status = endBySignal(number, command + " --script " + folder.string(), folder / "1_start.png");
        EXPECT_TRUE(WIFSIGNALED(status)) << status;
        EXPECT_EQ(WTERMSIG(status), number);
    }
}

TEST(HostSdl, OpensNoWindowThatNobodySees) {
    if (const std::string missing = missingFor(kProgram, "libsdl2-dev"); !missing.empty()) GTEST_SKIP() << missing;
    const HostRun run = runHost(std::string("DISPLAY=:987 timeout 20 ") + kProgram + " " + kLevel);
    EXPECT_EQ(run.exitCode, 2) << run.output;
    EXPECT_NE(run.output.find("expected a display"), std::string::npos) << run.output;
}

TEST(HostLauncher, LeavesNothingBehindUnderXvfb) {
    if (const std::string missing = missingFor("/usr/bin/xvfb-run", "xvfb"); !missing.empty()) GTEST_SKIP() << missing;
    for (const int number : {SIGINT, SIGTERM}) {
        const std::filesystem::path folder = hostFolder("launcher_signal");
        const std::string written = (folder / "number").string();
        const std::string function = "eval \"$(sed -n '/^underXvfb/,/^}/p' " RUBBLE_SOURCE_DIR "/rubble)\"; underXvfb ";
        const int status = endBySignal(number,
                                       function + "bash -c 'echo $$ >" + written + ".part && mv " + written + ".part " +
                                           written + " && exec sleep 20'",
                                       written);
        EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) > 128) << status;
        pid_t command = 0;
        std::ifstream(written) >> command;
        ASSERT_GT(command, 1);
        EXPECT_NE(kill(command, 0), 0) << "the command still runs";
    }
}

TEST(HostLauncher, RefusesOptionsOfGodotBeforeItBuilds) {
    const std::string folder = hostFolder("godot_refused").string() + "/none";
    for (const std::string options :
         {"--steps 0", "--steps abc", "--steps -1", "--size big", "--script", "--script -x"}) {
        const HostRun run = runHost(RUBBLE_SOURCE_DIR "/rubble host godot --script " + folder + " " + options);
        EXPECT_EQ(run.exitCode, 1) << options;
        EXPECT_NE(run.output.find("rubble: error: host godot: "), std::string::npos) << run.output;
    }
    EXPECT_FALSE(std::filesystem::exists(folder)) << "a refused call leaves nothing";
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
