// Runs the game as a program, played by a bot that fails where a tool or a menu does not do what it is for.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "generated/paths.h"
#include "samples/support/image.h"

namespace rubble {
namespace {

namespace fs = std::filesystem;

/// The exit code of the game, played by a script of a folder.
int playGame(const std::string& bot, const fs::path& out, const std::string& folder) {
    const std::string level = RUBBLE_SOURCE_DIR "/samples/lua/mods/car.vox";
    return std::system((RUBBLE_BINARY_DIR "/bin/rubble-game --headless --preset draft --size 160x90 --level " + level +
                        " --game " + folder + " --bot " + bot + " --saves " + out.string() + " --out " + out.string() +
                        " --wav " + (out / "sound.wav").string() + " >/dev/null 2>&1")
                           .c_str());
}

fs::path freshFolder(const std::string& name) {
    const fs::path folder = fs::temp_directory_path() / ("rubble_game_test_" + name);
    fs::remove_all(folder);
    fs::create_directories(folder);
    return folder;
}

TEST(Game, ABotUsesEachToolAndMenu) {
    const fs::path out = freshFolder("bot");
    ASSERT_EQ(playGame("bot_short.lua", out, RUBBLE_SOURCE_DIR "/samples/sandbox/game"), 0);
    for (const char* name : {"pause.png", "end.png"}) {
        const Result<Image> image = readPng((out / name).string());
        ASSERT_TRUE(image) << image.error();
        std::set<uint32_t> colors;
        for (size_t i = 0; i < image->rgb.size(); i += 3)
            colors.insert(uint32_t(image->rgb[i]) << 16 | uint32_t(image->rgb[i + 1]) << 8 | image->rgb[i + 2]);
        EXPECT_GT(colors.size(), 200u) << name;
    }
    EXPECT_TRUE(fs::exists(out / "options.txt"));
    std::ifstream file(out / "sound.wav", std::ios::binary);
    const std::string sound((std::istreambuf_iterator<char>(file)), {});
    size_t loud = 0;  // samples of 24 bits beyond -42 dB
    for (size_t i = 80; i + 3 <= sound.size(); i += 3) loud += std::abs(int(int8_t(sound[i + 2]))) > 1;
    EXPECT_GT(loud, 4800u) << "a tenth of a second of it at least is heard";
}

TEST(Game, ABotDrivesEachVehicleAndUsesWhatItHas) {
    const fs::path out = freshFolder("vehicles");
    EXPECT_EQ(playGame("bot_vehicles.lua", out, RUBBLE_SOURCE_DIR "/samples/sandbox/game"), 0);
}

TEST(Game, FailsWithoutScriptsAndWithABotThatFails) {
    const fs::path out = freshFolder("wrong");
    EXPECT_NE(playGame("bot.lua", out, out.string()), 0) << "there is no script";
    std::ofstream(out / "main.lua") << "function tick() end";
    std::ofstream(out / "good.lua") << "function tick() QuitGame() end";
    std::ofstream(out / "bad.lua") << "function tick() QuitGame() error('no') end";
    EXPECT_EQ(playGame("good.lua", out, out.string()), 0);
    EXPECT_NE(playGame("bad.lua", out, out.string()), 0);
}

}  // namespace
}  // namespace rubble
