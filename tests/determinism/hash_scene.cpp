// Prints the hash of a scripted scene's World every few steps, made in one of the ways that must all give the same.

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "runtime/core/log.h"
#include "tests/determinism/scene_run.h"

int main(int argc, char** argv) {
    using namespace rubble;
    SceneRun run;
    CLI::App app{"The hash of a scripted scene, step by step"};
    app.add_option("--scene", run.scene, "one of the scripted scenes, or town");
    app.add_option("--mode", run.mode, "play, load (from a save half-mode) or replay (a recording)")
        ->check(CLI::IsMember({"play", "load", "replay"}));
    app.add_option("--steps", run.steps, "how many steps");
    app.add_option("--every", run.every, "steps between two hashes")->check(CLI::PositiveNumber);
    app.add_option("--threads", run.threads, "1: no worker; 2: a shadow worker; more: other worlds beside it");
    app.add_flag("--renderer", run.renderer, "draw every step at 64x36");
    app.add_option("--shaders", run.shaders, "where the shaders are");
    CLI11_PARSE(app, argc, argv);
    if (!sceneExists(run.scene)) return logError("no such scene: " + run.scene), 2;
    const Result<Hashes> hashes = runScene(run);
    if (!hashes) return logError(run.scene + ": " + hashes.error()), 1;
    int step = 0;
    for (const uint64_t hash : hashes.value()) fmt::print("{} {:5} {:016x}\n", run.scene, step += run.every, hash);
    return 0;
}
