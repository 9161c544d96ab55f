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

/// Runs the game with options; its exit code, and what it prints in OUT/log.txt.
int runGame(const std::string& options, const fs::path& out) {
    return std::system((RUBBLE_BINARY_DIR "/bin/rubble-game --headless --preset draft --size 160x90 " + options + " >" +
                        (out / "log.txt").string() + " 2>&1")
                           .c_str());
}

constexpr const char* kLevel = RUBBLE_SOURCE_DIR "/samples/lua/mods/car.vox";

/// The exit code of the game, played by a script of a folder.
int playGame(const std::string& bot, const fs::path& out, const std::string& folder,
             const std::string& level = kLevel) {
    return runGame("--level " + level + " --game " + folder + " --bot " + bot + " --saves " + out.string() + " --out " +
                       out.string() + " --wav " + (out / "sound.wav").string(),
                   out);
}

std::string logOf(const fs::path& out) {
    std::ifstream file(out / "log.txt");
    return {std::istreambuf_iterator<char>(file), {}};
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

TEST(Game, ABotPlaysByGamepadBindsKeysPlacesThingsAndTakesPhotos) {
    const fs::path out = freshFolder("menus");
    ASSERT_EQ(playGame("bot_menus.lua", out, RUBBLE_SOURCE_DIR "/samples/sandbox/game"), 0) << logOf(out);
    EXPECT_TRUE(readPng((out / "photo-001.png").string()));
    const Result<Image> still = readPng((out / "photo-002.png").string());
    ASSERT_TRUE(still) << still.error();
    EXPECT_EQ(still->width, 1920);
    EXPECT_EQ(still->height, 1080);
}

TEST(Game, ABotSeesTheLastSecondsAgainAndGoesOn) {
    const fs::path out = freshFolder("replay");
    ASSERT_EQ(playGame("bot_replay.lua", out, RUBBLE_SOURCE_DIR "/samples/sandbox/game"), 0) << logOf(out);
    for (const char* name : {"replay-begin.png", "replay-end.png"}) EXPECT_TRUE(readPng((out / name).string())) << name;
}

TEST(Game, FilesThatAreDroppedArePlacedOrSayWhatIsWrong) {
    const fs::path out = freshFolder("drops"), files = freshFolder("dropped");
    std::string models = "car.vox shed.lua CAR.VOX SHED.Lua";
    for (const char* name : {"car.vox", "CAR.VOX"}) fs::copy_file(kLevel, files / name);
    for (const char* name : {"shed.lua", "SHED.Lua"})
        fs::copy_file(RUBBLE_SOURCE_DIR "/samples/sandbox/game/prefabs/shed.lua", files / name);
    if (fs::exists(RUBBLE_BINARY_DIR "/bin/rubble-editor"))
        for (const std::string name : {"room.rubble", "room.vdb", "ROOM.RUBBLE", "ROOM.VDB"}) {
            const std::string command = RUBBLE_BINARY_DIR "/bin/rubble-editor --vdb-tool " RUBBLE_BINARY_DIR
                                                          "/bin/rubble-vdb 'create 9,9,9' -o ";
            if (std::system((command + (files / name).string() + " >/dev/null").c_str()) == 0) models += " " + name;
        }
    fs::create_directory(files / "folder.vox");
    const auto write = [&](const char* name, const char* text) { std::ofstream(files / name) << text; };
    write("text.txt", "a text");
    write("broken.vox", "VOX and nothing more");
    write("broken.rubble", "nothing");
    write("syntax.lua", "return {");
    write("empty.lua", "");
    write("number.lua", "return 7");
    write("fails.lua", "return {name = 'x', pieces = function() return nil + 1 end}");
    write("acts.lua", "QuitGame() return {name = 'x', pieces = function() return {} end}");
    write("loops.lua", "while true do end");
    write("grows.lua", "return {name = 'x', pieces = function() local t = {} while true do t[#t + 1] = {} end end}");
    write("model.lua", "return {name = 'x', pieces = function() return {{model = 5}} end}");
    write("large.lua",
          "return {name = 'Large', pieces = function() return {{model = {size = {999, 1, 1}, voxel = 0.1, "
          "origin = {0, 0, 0}, palette = {{1, 1, 1}}, boxes = {}}}} end}");
    write("odd.lua",
          "return {name = 'Odd', pieces = function() local function piece(what) return {model = {size = {2, 2, 2}, "
          "voxel = 0.1, origin = {0, 0, 0}, palette = {{1, 1, 1, material = what}}, boxes = {{0, 0, 0, 1, 1, 1, 1}}}} "
          "end return {piece('wood'), piece('jam')} end}");
    std::ofstream(out / "options.txt") << "options.drops=" << files.string() << "\noptions.models=" << models << "\n";
    EXPECT_EQ(playGame("bot_drops.lua", out, RUBBLE_SOURCE_DIR "/samples/sandbox/game"), 0) << logOf(out);
    EXPECT_TRUE(fs::exists(out / "drop-menu.png")) << "no script that was dropped ends the game";
}

/// Plays a bot in the town; `last`: the image that it writes at its end.
void playTown(const std::string& bot, const char* last) {
    const fs::path out = freshFolder(bot);
    const std::string level = (out / "district.rubble").string();
    ASSERT_EQ(std::system((RUBBLE_BINARY_DIR "/bin/sandbox --district --write " + level + " >/dev/null").c_str()), 0);
    EXPECT_EQ(playGame(bot, out, RUBBLE_SOURCE_DIR "/samples/sandbox/game", level), 0) << logOf(out);
    EXPECT_TRUE(fs::exists(out / last)) << "it was played to its end";
}

TEST(Game, WhatIsInTheTownWorks) {
    playTown("bot_town.lua", "pump.png");
}

TEST(Game, TheHouseOfTheHeistIsRobbedByKeysAlone) {
    playTown("bot_heist.lua", "heist-end.png");
}

TEST(Game, ContractsAreWonAndLost) {
    EXPECT_EQ(playGame("bot_contracts.lua", freshFolder("contracts"), RUBBLE_SOURCE_DIR "/samples/sandbox/game"), 0);
}

TEST(Game, ASavedContractGoesOnTheSame) {
    EXPECT_EQ(playGame("bot_saves.lua", freshFolder("saves"), RUBBLE_SOURCE_DIR "/samples/sandbox/game"), 0);
}

TEST(Game, ABotPlaysAllWaysForSomeSeconds) {
    const fs::path out = freshFolder("long");
    std::ofstream(out / "options.txt") << "options.bot.seconds=12\n";
    EXPECT_EQ(playGame("bot_long.lua", out, RUBBLE_SOURCE_DIR "/samples/sandbox/game"), 0);
    for (const char* name : {"long-title.png", "long-brief-heist.png", "long-end.png"})
        EXPECT_TRUE(fs::exists(out / name)) << name;
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

/// A bot that asks for what is refused.
constexpr const char* kRefusedBot = R"(
local at = Transform(Vec(0, 5, 0))
local function model(change)
    local m = {size = {2, 2, 2}, palette = {{1, 0, 0}}, boxes = {{0, 0, 0, 1, 1, 1, 1}}}
    for key, value in pairs(change) do m[key] = value end
    return m
end
local function refuses(says, call, ...)
    local given = table.pack(...)
    local isDone, message = pcall(function() call(table.unpack(given, 1, given.n)) end)
    assert(not isDone, "expected " .. says)
    assert(message:find("^bot.lua:%d+: %a+: "), message)
    assert(message:find(says, 1, true), message .. " does not say " .. says)
end
local nan = 0 / 0
function tick()
    QuitGame()  -- also where something fails
    assert(LoadGame("broken") == false and LoadGame("folder") == false and not HasSave("folder"))
    refuses('model: expected a table, found 7', CreateModel, 7, at)
    refuses('found "colour"', CreateModel, model({colour = 1}), at)
    refuses('size: expected a whole number from 1 to 128, found', CreateModel, model({size = {nan, 2, 2}}), at)
    refuses('size: expected a whole number from 1 to 128, found 500', CreateModel, model({size = {2, 2, 500}}), at)
    refuses('voxel: expected a number from 0.005 to 1, found', CreateModel, model({voxel = nan}), at)
    refuses('boxes: expected a table, found "all"', CreateModel, model({boxes = "all"}), at)
    refuses('boxes: expected a number, found nil', CreateModel, model({boxes = {{0, 0, 0, 1}}}), at)
    refuses('found 256', CreateModel, model({boxes = {{0, 0, 0, 1, 1, 1, 256}}}), at)
    refuses('palette: expected a number from 0 to 1, found 7', CreateModel, model({palette = {{7, 0, 0}}}), at)
    refuses('roughness: expected a number from 0 to 1, found', CreateModel,
        model({palette = {{1, 0, 0, roughness = nan}}}), at)
    refuses('found "rough"', CreateModel, model({palette = {{1, 0, 0, rough = 1}}}), at)
    refuses('a material of the world, found "jam"', CreateModel, model({palette = {{1, 0, 0, material = "jam"}}}), at)
    refuses('width: expected a whole number from 16 to 8192, found 1', Screenshot, "narrow.png", 1, 100)
    refuses('height: expected a whole number from 16 to 8192, found 99999', Screenshot, "high.png", 100, 99999)
    refuses('origin: expected a table, found true', CreateModel, model({origin = true}), at)
    assert(#FindBodies() == bodies, "what was refused has made nothing")
    refuses('air: expected a table, found nothing', SetEnvironment)
    refuses('found "fogDensty"', SetEnvironment, {fogDensty = 1})
    refuses('fogDensity: expected', SetEnvironment, {fogDensity = nan})
    refuses('sunColor: expected', SetEnvironment, {sunColor = Vec(nan, 0, 0)})
    refuses('sun', SetEnvironment, {sun = Vec(nan, 0, 0)})
    refuses('clouds: expected a number, found "none"', SetEnvironment, {clouds = "none"})
    refuses('rules: expected a table, found "x"', SetRules, "x")
    refuses('stress: expected true or false, found 3', SetRules, {stress = 3})
    refuses('found "strenght"', SetRules, {strenght = 3})
    refuses('strength: expected', SetRules, {strength = nan})
    refuses('fireSpread: expected', SetRules, {fireSpread = -1})
    local _, shape = CreateModel(model({}), Transform(Vec(0, 50, 0)), true)
    refuses('min: expected', CreateJoint, "hinge", shape, 0, at, {min = nan})
    refuses('hertz: expected', CreateJoint, "hinge", shape, 0, at, {hertz = -1})
    refuses('breakForce: expected', CreateJoint, "ball", shape, 0, at, {breakForce = -1})
    refuses('transform: expected', CreateJoint, "ball", shape, 0, Transform(Vec(1e30, 0, 0)))
    refuses('length: expected', CreateRope, shape, Vec(0, 50, 0), 0, Vec(0, 52, 0), -1)
    refuses('strength: expected', CreateNail, shape, 0, Vec(0, 50, 0), -1)
    refuses('angle: expected', CreateLight, shape, at, Vec(1, 1, 1), {angle = 50})
    refuses('outline: expected a table, found 7', CreateWater, 7, 1, 1)
    refuses('depth: expected', CreateWater, {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}, 1, -1)
    refuses('finite numbers', SetPlayerVelocity, Vec(0, nan, 0))
    refuses('yaw: expected a number from', SetPlayerLook, nan, 0)
    refuses('finite numbers', SetCameraTransform, Transform(Vec(nan, 0, 0)))
    refuses('volume: expected a number from 0 to 1000, found', PlaySound, LoadSound("click"), nil, nan)
    refuses('pad: expected a table, found nothing', SetGamepad)
    refuses('found "z"', SetGamepad, {z = true})
    refuses('pad: expected a number from -1 to 1, found', SetGamepad, {lx = nan})
    refuses('folder: expected 1 to 100 of', ListFiles, "../saves")
    refuses('action: expected a text, found', BindInput)
    assert(#ListFiles("nowhere") == 0)
    CreateModel(model({muzzle = Vec(1, 1, 1)}), at)
end
function init() bodies = #FindBodies() end
)";

TEST(Game, SaysWhatIsWrongWithSavesOptionsAndTables) {
    const fs::path out = freshFolder("damaged");
    std::ofstream(out / "broken.save") << "RUBBLE, but nothing more";
    fs::create_directory(out / "folder.save");
    fs::create_directory(out / "options.txt");
    std::ofstream(out / "main.lua") << "function tick() end";
    std::ofstream(out / "bot.lua") << kRefusedBot;
    EXPECT_EQ(playGame("bot.lua", out, out.string()), 0) << logOf(out);
    const std::string log = logOf(out);
    EXPECT_NE(log.find("broken.save: "), std::string::npos) << log;
    EXPECT_NE(log.find("options.txt: expected a file that can be read"), std::string::npos) << log;
    EXPECT_NE(log.find("options.txt: expected a file that can be written"), std::string::npos) << log;
    for (const char* name : {"narrow.png", "high.png"}) EXPECT_FALSE(fs::exists(out / name)) << name;
}

TEST(Game, RequiresScriptsWhoseEndingIsInCapitals) {
    const fs::path out = freshFolder("capitals");
    std::ofstream(out / "main.lua") << "function tick() end";
    std::ofstream(out / "LOUD.LUA") << "return 7";
    std::ofstream(out / "bot.lua") << "function tick() QuitGame() assert(require('LOUD.LUA') == 7) end";
    EXPECT_EQ(playGame("bot.lua", out, out.string()), 0) << logOf(out);
}

TEST(Game, FindsTheScriptsOfALevelBesideIt) {
    if (!fs::exists(RUBBLE_BINARY_DIR "/bin/rubble-editor")) GTEST_SKIP() << "the editor was not built";
    const fs::path out = freshFolder("beside"), level = freshFolder("beside_level");
    std::ofstream(out / "main.lua") << "function tick() end";
    std::ofstream(out / "bot.lua") << "function tick() QuitGame() assert(GetInt('answer') == 7) end";
    std::ofstream(level / "door.lua") << "function init() SetInt('answer', GetIntParam('answer', 1)) end";
    ASSERT_EQ(std::system((RUBBLE_BINARY_DIR "/bin/rubble-editor 'create 4,4,4' 'script_add door.lua answer=7' -o " +
                           (level / "room.rubble").string() + " >/dev/null")
                              .c_str()),
              0);
    EXPECT_EQ(playGame("bot.lua", out, out.string(), (level / "room.rubble").string()), 0) << logOf(out);
    fs::rename(level / "room.rubble", out / "room.rubble");
    EXPECT_EQ(
        playGame("bot.lua", out, out.string(), (out / "room.rubble").string() + " --level-folder " + level.string()), 0)
        << logOf(out);
}

TEST(Game, RefusesNumbersAndFoldersBeforeItBegins) {
    const fs::path out = freshFolder("refused");
    const auto refuses = [&](const std::string& options, const std::string& why) {
        EXPECT_NE(runGame("--level " + std::string(kLevel) + " " + options, out), 0) << options;
        EXPECT_NE(logOf(out).find(why), std::string::npos) << options << ": " << logOf(out);
    };
    for (const char* number : {"nan", "inf", "-1", "''"})
        refuses("--film film/film.lua --out " + out.string() + " --seconds " + number,
                "--seconds: expected a number from 0.1 to 3600, found \"");
    refuses("--out /dev/null/x", "--out: expected a folder that can be made, found /dev/null/x");
    refuses("--out /proc", "--out: expected a folder that can be written to, found /proc");
    refuses("--out " + out.string() + " --screenshot /proc/a.png", "--screenshot: expected a folder that can be");
}

}  // namespace
}  // namespace rubble
