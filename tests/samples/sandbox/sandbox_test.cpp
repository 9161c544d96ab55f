// Runs the sandbox as a user does, as a program, and reads its files.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "generated/paths.h"
#include "samples/support/image.h"

namespace rubble {
namespace {

namespace fs = std::filesystem;

fs::path outFolder(const std::string& name) {
    const fs::path folder = fs::temp_directory_path() / ("rubble_sandbox_test_" + name);
    fs::remove_all(folder);
    return folder;
}

int runSandbox(const std::string& arguments, const std::string& prefix = "env -u DISPLAY -u WAYLAND_DISPLAY") {
    return std::system((prefix + " " RUBBLE_BINARY_DIR "/bin/sandbox " + arguments + " >/dev/null").c_str());
}

nlohmann::json figuresOf(const fs::path& folder) {
    std::ifstream file(folder / "figures.json");
    return nlohmann::json::parse(file, nullptr, false);
}

size_t colorsIn(const Image& image) {
    std::set<uint32_t> colors;
    for (size_t i = 0; i < image.rgb.size(); i += 3)
        colors.insert(uint32_t(image.rgb[i]) << 16 | uint32_t(image.rgb[i + 1]) << 8 | image.rgb[i + 2]);
    return colors.size();
}

/// Each shot of the film with two frames of it.
TEST(Sandbox, WithoutADisplayMakesAFilm) {
    const fs::path out = outFolder("film");
    ASSERT_EQ(runSandbox("--seconds 0.5 --fps 20 --size 96x54 --preset draft --out " + out.string()), 0);
    size_t sheets = 0;
    for (const auto& entry : fs::directory_iterator(out))
        if (entry.path().filename().string().starts_with("shot_")) {
            ++sheets;
            const Result<Image> sheet = readPng(entry.path().string());
            ASSERT_TRUE(sheet) << sheet.error();
            EXPECT_GT(colorsIn(*sheet), 200u) << entry.path();
        }
    EXPECT_EQ(sheets, 5u);
    EXPECT_TRUE(readPng((out / "frames" / "0009.png").string())) << "expected two frames of each shot";
    EXPECT_TRUE(readPng((out / "contact_sheet.png").string()));
    const bool hasVideo = std::system("command -v ffmpeg >/dev/null 2>&1") != 0 || fs::exists(out / "film.mp4");
    EXPECT_TRUE(hasVideo);
    std::ifstream file(out / "figures.txt");
    const std::string figures{std::istreambuf_iterator<char>(file), {}};
    for (const char* row : {"step, ms", "allocations a step", "shadow age", "longest steps", "state hash"})
        EXPECT_NE(figures.find(row), std::string::npos) << row;
}

TEST(Sandbox, RefusesAShotThatIsNotThere) {
    const fs::path out = outFolder("shot");
    EXPECT_NE(runSandbox("--shot nonsense --fps 1 --size 64x36 --preset draft --out " + out.string() + " 2>/dev/null"),
              0);
}

TEST(Sandbox, ASceneWritesFramesAndFigures) {
    const fs::path out = outFolder("headless");
    ASSERT_EQ(runSandbox("--scene pane --seconds 0.2 --fps 10 --size 160x90 --preset fast --out " + out.string()), 0);
    const Result<Image> frame = readPng((out / "frames" / "0001.png").string());
    ASSERT_TRUE(frame) << frame.error();
    EXPECT_EQ(frame->width, 160);
    EXPECT_GT(colorsIn(*frame), 1000u) << "expected many colours in a lit scene";
    EXPECT_TRUE(readPng((out / "contact_sheet.png").string()));
    const nlohmann::json figures = figuresOf(out);
    ASSERT_FALSE(figures.is_discarded());
    EXPECT_EQ(figures["state_hash"].size(), 12u);
    EXPECT_LE(figures["series"]["draw calls for bodies"]["max"].get<double>(), 16.0);
    const auto& voxels = figures["voxels"];
    EXPECT_EQ(
        voxels["imported"].get<uint64_t>(),
        voxels["standing"].get<uint64_t>() + voxels["in_pieces"].get<uint64_t>() + voxels["removed"].get<uint64_t>());
}

TEST(Sandbox, SameSeedSameStateWithTheWorkerOnOrOff) {
    const fs::path threaded = outFolder("threaded"), inlined = outFolder("inlined");
    ASSERT_EQ(runSandbox("--no-render --seconds 2.5 --out " + threaded.string()), 0);
    ASSERT_EQ(runSandbox("--no-render --inline-shadow --seconds 2.5 --out " + inlined.string()), 0);
    const nlohmann::json a = figuresOf(threaded), b = figuresOf(inlined);
    ASSERT_EQ(a["state_hash"].size(), 150u);
    EXPECT_EQ(a["state_hash"], b["state_hash"]);
    EXPECT_NE(a["state_hash"].front(), a["state_hash"].back()) << "expected the demolition to change the state";
    EXPECT_GT(a["voxels_removed"].get<uint64_t>(), 0u);
}

TEST(Sandbox, RefusesNumbersThatMeanNothing) {
    for (const char* arguments : {"--seconds nan", "--seconds inf", "--seconds 0", "--seed -1", "--frames 0"})
        EXPECT_NE(runSandbox("--no-render " + std::string(arguments) + " 2>/dev/null"), 0) << arguments;
}

TEST(Sandbox, RefusesWhatItCannotDo) {
    EXPECT_NE(runSandbox("--size 5x5 2>/dev/null"), 0);
    EXPECT_NE(runSandbox("--model /no/such/file.vox 2>/dev/null"), 0);
    EXPECT_NE(runSandbox("--seconds 0.1 --size 64x36 --pass nonsense 2>/dev/null"), 0);
}

TEST(Sandbox, ALevelFileBreaksAsTheSceneItWasWrittenFrom) {
    const fs::path built = outFolder("built"), opened = outFolder("opened");
    ASSERT_EQ(runSandbox("--no-render --seconds 1 --out " + built.string()), 0);
    const std::string level = RUBBLE_BINARY_DIR "/levels/town-1.vdb";
    ASSERT_TRUE(fs::exists(level)) << "expected the sandbox to write the town to this file";
    ASSERT_EQ(runSandbox("--no-render --seconds 1 --level " + level + " --out " + opened.string()), 0);
    EXPECT_EQ(figuresOf(built)["state_hash"], figuresOf(opened)["state_hash"]);
}

TEST(Sandbox, HelpNamesEveryOption) {
    const fs::path out = outFolder("help");
    fs::create_directories(out);
    const std::string text = (out / "help.txt").string();
    ASSERT_EQ(std::system((RUBBLE_BINARY_DIR "/bin/sandbox --help >" + text).c_str()), 0);
    std::ifstream file(text);
    const std::string help{std::istreambuf_iterator<char>(file), {}};
    for (const char* option : {"--model", "--level", "--out", "--size", "--fps", "--frames", "--seconds", "--preset",
                               "--seed", "--pass", "--headless", "--no-render", "--shot"})
        EXPECT_NE(help.find(option), std::string::npos) << option;
}

TEST(Launcher, HelpNamesEveryCommandAndAWrongOneFails) {
    const fs::path out = outFolder("launcher");
    fs::create_directories(out);
    const std::string text = (out / "help.txt").string(), launcher = RUBBLE_SOURCE_DIR "/rubble";
    ASSERT_EQ(std::system((launcher + " help >" + text).c_str()), 0);
    std::ifstream file(text);
    const std::string help{std::istreambuf_iterator<char>(file), {}};
    for (const std::string command : {"sandbox", "demolish", "animation", "sheets", "test", "bench", "stress",
                                      "determinism", "tradeoff", "import", "install", "help"})
        EXPECT_NE(help.find("./rubble " + command), std::string::npos) << command;
    EXPECT_NE(std::system((launcher + " demolisch >/dev/null 2>&1").c_str()), 0);
}

TEST(Sandbox, OpensItsWindowUnderXvfb) {
    if (std::system("command -v xvfb-run >/dev/null 2>&1") != 0) GTEST_SKIP() << "xvfb-run is not installed";
    const fs::path out = outFolder("window");
    fs::create_directories(out);
    const std::string screenshot = (out / "window.png").string();
    ASSERT_EQ(
        runSandbox("--size 320x180 --preset fast --screenshot " + screenshot, "xvfb-run -a -s '-screen 0 640x480x24'"),
        0);
    const Result<Image> image = readPng(screenshot);
    ASSERT_TRUE(image) << image.error();
    EXPECT_EQ(image->width, 320);
    EXPECT_GT(colorsIn(*image), 1000u);
}

}  // namespace
}  // namespace rubble
