// The sandbox: a town corner to take apart. With a display it is a game; without one it makes a film of a demolition.
// Scripted scenes and models are demolished here, in a window or as frames and figures.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "runtime/assets/assets.h"
#include "runtime/core/log.h"
#include "samples/sandbox/game_program.h"
#include "samples/sandbox/headless.h"
#include "samples/sandbox/options.h"
#include "samples/sandbox/stage.h"
#include "samples/sandbox/window.h"
#include "samples/scenes/scene.h"
#include "samples/support/image_size.h"
#include "samples/support/number_option.h"
#include "samples/support/out_folder.h"
#include "samples/support/window.h"

namespace rubble {

bool SandboxOptions::wantsWindow() const {
    return !headless && !noRender && Window::hasDisplay();
}

bool SandboxOptions::wantsFilm() const {
    const bool isTown = scene.empty() && model.empty() && level.empty() && time.empty() && !yard && !district;
    return isTown && !wantsWindow() && !noRender && !allPasses && !map && !frames && pass == "final";
}

namespace {

int listScenes() {
    for (const Scene& scene : allScenes()) std::printf("%-10s %s\n", scene.name.data(), scene.description.data());
    return 0;
}

/// Runs every scene into a folder of its own; the worst exit code.
int runAllScenes(const SandboxOptions& options) {
    int worst = 0;
    for (const Scene& scene : allScenes()) {
        SandboxOptions each = options;
        each.scene = scene.name;
        each.out = options.out + "/" + each.scene;
        std::printf("%s: %s\n", scene.name.data(), scene.description.data());
        worst = std::max(worst, runHeadless(each));
    }
    return worst;
}

int writeLevel(const SandboxOptions& options) {
    const Result<SandboxStage> stage = loadStage(options);
    const Result<Done> written = stage ? writeRubble(options.write, stage->level) : Result<Done>(Error{stage.error()});
    if (!written) std::fprintf(stderr, "sandbox: %s\n", written.error().c_str());
    return written ? 0 : 1;
}

constexpr const char* kFilmSize = "480x270";  ///< by default: some minutes on two processors without a GPU

constexpr const char* kHelp =
    "Rubble sandbox: a town corner to take apart.\n"
    "With a display: a game whose scripts are in samples/sandbox/game; F1 in it lists the keys, Esc opens its menu.\n"
    "Without one: a film of a demolition, directed by the scripts in samples/sandbox/game/film, with contact sheets "
    "and "
    "figures.\n"
    "With --scene, --model or --pass a plain window: WASD and mouse fly, Space/Shift up and down, 1 hammer, 2 "
    "explosive, "
    "3 spray can, left click uses it, G held grabs (with a click on letting go: throws), F fly or walk, T torch, R "
    "resets, P next pass, Esc leaves.";

void addSceneOptions(CLI::App& app, SandboxOptions& options) {
    app.add_option("--model", options.model, "put this .vox, .vdb or .rubble on the street and demolish it")
        ->check(CLI::ExistingFile);
    app.add_option("--level", options.level, "open this level instead of the town")->check(CLI::ExistingFile);
    app.add_flag("--district", options.district,
                 "the town of four blocks that the game has, not its first block alone");
    app.add_flag("--yard", options.yard, "a yard with vehicles to drive instead of the town");
    app.add_option("--scene", options.scene, "a scripted scene instead of the town; all: one after the other");
    app.add_option("--write", options.write, "write the level to this .rubble file, and play nothing");
    app.add_option("--time", options.time, "time of day: noon, afternoon, dusk, night or rain")
        ->check(CLI::IsMember({"noon", "afternoon", "dusk", "night", "rain"}));
    app.add_option("--seconds", options.seconds, "game time (default: as long as the scene or the film is, or 10)")
        ->check(numberFrom(0.1, 3600.0));
    app.add_option("--seed", options.seed, "seed of everything random")
        ->capture_default_str()
        ->check(CLI::NonNegativeNumber);
}

void addFrameOptions(CLI::App& app, SandboxOptions& options) {
    app.add_option("--frames", options.frames, "draw only this many frames, evenly over the run; no MP4")
        ->check(CLI::Range(1, 1000));
    app.add_option("--out", options.out, "folder for frames and figures")->capture_default_str();
    app.add_option("--size", options.size, "frame size, WIDTHxHEIGHT; of the film 480x270")->capture_default_str();
    app.add_option("--fps", options.fps,
                   "frames per second of game time, a divisor of 60 (default: 30; of the film 20)")
        ->check(CLI::IsMember({1, 2, 3, 4, 5, 6, 10, 12, 15, 20, 30, 60}));
    app.add_flag("--bot", options.bot, "a script plays the game with all tools, without a window: images in OUT/bot");
    app.add_option("--shot", options.shot, "of the film: only the shot of this name");
    app.add_flag("--headless", options.headless, "no window even where there is a display");
    app.add_flag("--no-render", options.noRender, "no frames: state hashes and figures only");
    app.add_flag("--all-passes", options.allPasses, "write every pass for the frames of the contact sheet");
    app.add_flag("--map", options.map, "without a window: the whole level from above, without haze");
    app.add_option("--screenshot", options.screenshot, "window: write this PNG after a few frames and leave");
}

void addRenderOptions(CLI::App& app, SandboxOptions& options) {
    app.add_option("--preset", options.preset, "draft, fast, balanced or accurate")
        ->capture_default_str()
        ->check(CLI::IsMember({"draft", "fast", "balanced", "accurate"}));
    app.add_option("--fullscreen", options.fullscreen,
                   "what draws full-screen passes: fragment, compute, fastest (measured) or auto")
        ->capture_default_str()
        ->check(CLI::IsMember({"auto", "fragment", "compute", "fastest"}));
    app.add_option("--pass", options.pass, "show this target of the renderer (an unknown name lists them)")
        ->capture_default_str();
    app.add_flag("--inline-shadow", options.inlineShadow, "shadow volume on the main thread instead of the worker");
    app.add_option("--gl", options.gl, "without a window: auto, osmesa, egl or egl-es (OpenGL ES 3.0)")
        ->capture_default_str()
        ->check(CLI::IsMember({"auto", "osmesa", "egl", "egl-es"}));
    app.add_option("--shaders", options.shaders, "folder of the shaders")->capture_default_str();
}

/// Reads the size of the image; throws what CLI11 reports as an error of --size.
void parseSize(SandboxOptions& options) {
    const std::string error = readImageSize(options.size, options.width, options.height);
    if (!error.empty()) throw CLI::ValidationError("--size", error);
}

int run(int argc, char** argv) {
    SandboxOptions options;
    bool list = false;
    options.shaders = RUBBLE_SHADER_DIR;
    options.tools = std::filesystem::weakly_canonical(std::filesystem::path(argv[0])).parent_path().string();
    CLI::App app{kHelp, "sandbox"};
    app.add_flag("--list-scenes", list, "name the scripted scenes and leave");
    addSceneOptions(app, options);
    addFrameOptions(app, options);
    addRenderOptions(app, options);
    try {
        app.parse(argc, argv);
        if (options.wantsFilm() && !options.bot && !app.count("--size")) options.size = kFilmSize;
        parseSize(options);
    } catch (const CLI::ParseError& error) {
        return app.exit(error);
    }
    if (list) return listScenes();
    if (!options.write.empty()) return writeLevel(options);
    if (!options.wantsWindow())
        if (const std::string wrong = makeOutFolder(options.out); !wrong.empty()) return logError("--out: " + wrong), 1;
    if (options.scene == "all") return runAllScenes(options);
    const bool isGame = options.scene.empty() && options.model.empty() && options.pass == "final";
    if (options.wantsFilm() && !options.bot) return playFilm(options);
    if (!options.fps) options.fps = 30;
    if (options.bot || (options.wantsWindow() && isGame)) return playGame(options);
    return options.wantsWindow() ? runWindow(options) : runHeadless(options);
}

}  // namespace
}  // namespace rubble

int main(int argc, char** argv) {
    return rubble::run(argc, argv);
}
