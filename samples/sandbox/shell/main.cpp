// The game: a shell over rubble.h that runs the scripts of samples/sandbox/game in a window, or for a bot in memory.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>

#include "samples/sandbox/shell/game.h"
#include "samples/support/image_size.h"
#include "samples/support/number_option.h"
#include "samples/support/out_folder.h"

namespace sandbox {
namespace {

namespace fs = std::filesystem;
constexpr int kScreenshotFrames = 12;  ///< that --screenshot lets pass

struct Options {
    GameSettings game;
    std::string size = "1280x720", screenshot;
    bool isHeadless = false;
};

/// Frames as fast as they come, each of them a step long: the same for every machine.
void playBot(Game& game) {
    while (game.frame(1.0 / 60.0)) {
    }
}

void playWindow(Game& game, int frames) {
    auto last = std::chrono::steady_clock::now();
    for (int i = 0; frames == 0 || i < frames; ++i) {
        const auto now = std::chrono::steady_clock::now();
        const double seconds = std::min(std::chrono::duration<double>(now - last).count(), 0.25);
        last = now;
        if (!game.frame(seconds)) return;
    }
}

int run(const Options& options) {
    glm::ivec2 size(0);
    std::string error = rubble::readImageSize(options.size, size.x, size.y);
    const rubble_api* api = nullptr;
    if (error.empty() && rubble_get_api(RUBBLE_VERSION, &api) != RUBBLE_OK)
        error = "this library is of another version";
    if (error.empty() && !(error = rubble::makeOutFolder(options.game.out)).empty()) error = "--out: " + error;
    if (error.empty() && !options.screenshot.empty() && !(error = rubble::makeFolderOf(options.screenshot)).empty())
        error = "--screenshot: " + error;
    using rubble::Display;
    auto display = !error.empty()       ? rubble::Error{error}
                   : options.isHeadless ? Display::inMemory(size)
                                        : Display::openWindow(size, "Rubble");
    if (!display) error = display.error();
    if (display) {
        Game game(*api, **display, options.game);
        game.drawAlways(!options.isHeadless || !options.game.film.script.empty());
        error = game.begin();
        const bool wantsImage = !options.screenshot.empty();
        const bool isFilm = !options.game.film.script.empty();
        if (error.empty() && isFilm) error = game.shootFilm();
        if (error.empty() && !options.game.bot.empty()) playBot(game);
        if (error.empty() && options.game.bot.empty() && !isFilm) playWindow(game, wantsImage ? kScreenshotFrames : 0);
        if (error.empty() && wantsImage) error = game.writeImage(fs::absolute(options.screenshot).string());
        if (error.empty()) return game.hasFailed() ? 1 : 0;
    }
    fmt::print(stderr, "sandbox: {}\n", error);
    return 1;
}

int main(int argc, char** argv) {
    Options options;
    GameSettings& game = options.game;
    const fs::path programs = fs::weakly_canonical(fs::path(argv[0])).parent_path();
    game.vdbTool = (programs / "rubble-vdb").string();
    game.programs = (programs.parent_path() / "programs").string();
    game.folder = RUBBLE_GAME_DIR;
    game.saves = "out/sandbox";
    game.out = "out/sandbox";
    CLI::App app{"The sandbox as a game in a window: F1 in it lists the keys."};
    app.add_option("--level", game.level, "a .rubble, .vox or .vdb file")->check(CLI::ExistingFile)->required();
    app.add_option("--level-folder", game.levelFolder, "folder of the level's scripts (default: that of its file)")
        ->check(CLI::ExistingDirectory);
    app.add_option("--game", game.folder, "folder of the scripts: main.lua")->check(CLI::ExistingDirectory);
    app.add_option("--bot", game.bot, "a script of that folder that plays; ends when it says so");
    app.add_option("--film", game.film.script,
                   "a script of that folder that directs a film in place of the game: in OUT");
    app.add_option("--shot", game.film.shot, "film only this shot");
    app.add_option("--seconds", game.film.seconds, "of the film (default: as long as its shots are)")
        ->check(rubble::numberFrom(0.1, 3600.0));
    app.add_option("--fps", game.film.fps, "frames a second of the film")
        ->capture_default_str()
        ->check(CLI::Range(1, 60));
    app.add_option("--size", options.size, "of the image, WIDTHxHEIGHT")->capture_default_str();
    app.add_option("--preset", game.preset, "draft, fast, balanced or accurate")
        ->capture_default_str()
        ->check(CLI::IsMember({"draft", "fast", "balanced", "accurate"}));
    app.add_option("--saves", game.saves, "folder of saved games and options")->capture_default_str();
    app.add_option("--out", game.out, "folder of images")->capture_default_str();
    app.add_option("--screenshot", options.screenshot, "write this PNG after a few frames and leave");
    app.add_option("--wav", game.wav, "write what is heard into this file, in place of a sound card");
    app.add_flag("--headless", options.isHeadless, "draw in memory: for bots, and for images without a display");
    CLI11_PARSE(app, argc, argv);
    game.isSilent = options.isHeadless;
    if (!game.film.script.empty() && game.wav.empty()) game.wav = Film::soundFile(game.out);
    return run(options);
}

}  // namespace
}  // namespace sandbox

int main(int argc, char** argv) {
    return sandbox::main(argc, argv);
}
