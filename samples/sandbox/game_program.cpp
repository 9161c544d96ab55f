#include "samples/sandbox/game_program.h"

#include <unistd.h>

#include <filesystem>
#include <vector>

#include "runtime/assets/assets.h"
#include "runtime/core/log.h"
#include "samples/sandbox/stage.h"

namespace rubble {
namespace {

namespace fs = std::filesystem;

/// The path of the level that the game plays: the town is written once, and again when this program is newer.
Result<std::string> levelFile(const SandboxOptions& options) {
    if (!options.level.empty() && options.time.empty()) return options.level;
    const fs::path folder = fs::path(options.tools).parent_path() / "levels";
    const std::string name = (options.level.empty() ? "town" : fs::path(options.level).stem().string()) + "-" +
                             std::to_string(options.seed) + "-" + (options.time.empty() ? "own" : options.time);
    const fs::path path = folder / (name + ".rubble");
    std::error_code error;
    const auto programTime = fs::last_write_time(fs::path(options.tools) / "sandbox", error);
    const bool isTown = options.level.empty();
    if (isTown && !error && fs::exists(path) && fs::last_write_time(path) > programTime) return path.string();
    Result<SandboxStage> stage = loadStage(options);
    if (!stage) return Error{stage.error()};
    fs::create_directories(folder, error);
    const Result<Done> written = writeRubble(path.string(), stage->level);
    if (!written) return Error{written.error()};
    return path.string();
}

}  // namespace

int playGame(const SandboxOptions& options) {
    const Result<std::string> level = levelFile(options);
    if (!level) return logError(level.error()), 1;
    std::vector<std::string> words = {
        options.tools + "/rubble-game", "--level", *level, "--size", options.size, "--preset", options.preset};
    if (!options.screenshot.empty()) words.insert(words.end(), {"--screenshot", options.screenshot});
    if (options.bot)
        words.insert(words.end(), {"--headless", "--bot", "bot.lua", "--out", options.out + "/bot", "--saves",
                                   options.out + "/bot"});
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    execv(arguments[0], arguments.data());
    return logError(words[0] + ": expected the program of the game beside this one; ./rubble sandbox builds it"), 1;
}

}  // namespace rubble
