#include "samples/sandbox/game_program.h"

#include <unistd.h>

#include <filesystem>
#include <utility>
#include <vector>

#include "runtime/assets/assets.h"
#include "runtime/core/log.h"
#include "samples/sandbox/stage.h"
#include "samples/scenes/film_town.h"

namespace rubble {
namespace {

namespace fs = std::filesystem;

/// Where a level of a name is kept, and whether it is newer than this program.
fs::path keptLevel(const SandboxOptions& options, const std::string& name, bool& isFresh) {
    const fs::path path = fs::path(options.tools).parent_path() / "levels" / (name + ".rubble");
    std::error_code error;
    const auto programTime = fs::last_write_time(fs::path(options.tools) / "sandbox", error);
    isFresh = !error && fs::exists(path) && fs::last_write_time(path) > programTime;
    fs::create_directories(path.parent_path(), error);
    return path;
}

/// The path of the level that the game plays: the town of four blocks is written once, and again when this program is
/// newer.
Result<std::string> levelFile(const SandboxOptions& options) {
    if (!options.level.empty() && options.time.empty()) return options.level;
    const std::string own = options.yard ? "yard" : "district";
    const std::string name = (options.level.empty() ? own : fs::path(options.level).stem().string()) + "-" +
                             std::to_string(options.seed) + "-" + (options.time.empty() ? "own" : options.time);
    bool isFresh = false;
    const fs::path path = keptLevel(options, name, isFresh);
    if (options.level.empty() && isFresh) return path.string();
    SandboxOptions staged = options;
    staged.district = options.level.empty() && options.model.empty() && options.scene.empty() && !options.yard;
    Result<SandboxStage> stage = loadStage(staged);
    if (!stage) return Error{stage.error()};
    const Result<Done> written = writeRubble(path.string(), stage->level);
    if (!written) return Error{written.error()};
    return path.string();
}

/// The path of the film's level, likewise.
Result<std::string> filmLevelFile(const SandboxOptions& options) {
    bool isFresh = false;
    const fs::path path = keptLevel(options, "film-" + std::to_string(options.seed), isFresh);
    if (isFresh) return path.string();
    const Result<Done> written = writeRubble(path.string(), makeFilmTown(options.seed));
    if (!written) return Error{written.error()};
    return path.string();
}

/// Becomes the program of the game; an exit code where it cannot.
int become(std::vector<std::string> words) {
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    execv(arguments[0], arguments.data());
    return logError(words[0] + ": expected the program of the game beside this one; ./rubble sandbox builds it"), 1;
}

}  // namespace

int playGame(const SandboxOptions& options) {
    const Result<std::string> level = levelFile(options);
    if (!level) return logError(level.error()), 1;
    std::vector<std::string> words = {
        options.tools + "/rubble-game", "--level", *level, "--size", options.size, "--preset", options.preset};
    if (!options.level.empty())  // which is elsewhere with another time of day
        words.insert(words.end(), {"--level-folder", fs::absolute(options.level).parent_path().string()});
    if (!options.screenshot.empty()) words.insert(words.end(), {"--screenshot", options.screenshot});
    if (options.bot)
        words.insert(words.end(), {"--headless", "--bot", "bot.lua", "--out", options.out + "/bot", "--saves",
                                   options.out + "/bot"});
    return become(std::move(words));
}

int playFilm(const SandboxOptions& options) {
    const Result<std::string> level = filmLevelFile(options);
    if (!level) return logError(level.error()), 1;
    const std::string& tools = options.tools;
    std::vector<std::string> words = {tools + "/rubble-game", "--headless", "--film",
                                      "film/film.lua",        "--level",    *level};
    words.insert(words.end(), {"--size", options.size, "--preset", options.preset, "--out", options.out});
    if (options.fps) words.insert(words.end(), {"--fps", std::to_string(options.fps)});
    if (options.seconds > 0.0) words.insert(words.end(), {"--seconds", std::to_string(options.seconds)});
    if (!options.shot.empty()) words.insert(words.end(), {"--shot", options.shot});
    return become(std::move(words));
}

}  // namespace rubble
