// Prints the state hash of a scripted scene every few steps. All modes must give the same hashes.

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "runtime/core/log.h"
#include "tests/determinism/scene_run.h"

int main(int argc, char** argv) {
    using namespace rubble;
    SceneRun run;
    CLI::App app{"Prints the state hashes of a scripted scene"};
    app.add_option("--scene", run.scene, "one of the scripted scenes, or town");
    app.add_option("--mode", run.mode, "play, load (a save half-way) or replay (a recording)")
        ->check(CLI::IsMember({"play", "load", "replay"}));
    app.add_option("--steps", run.steps, "steps of 1/60 s");
    app.add_option("--every", run.every, "steps between hashes")->check(CLI::Range(1, 1000000000));
    app.add_option("--threads", run.threads,
                   "of physics; from 2 on beside a shadow worker, from 3 on with further worlds at the same time");
    app.add_flag("--renderer", run.renderer, "draw every step at 64x36");
    app.add_option("--shaders", run.shaders, "folder of the shaders");
    CLI11_PARSE(app, argc, argv);
    if (!sceneExists(run.scene))
        return logError("--scene " + run.scene + ": no such scene; `sandbox --list-scenes` prints the names"), 2;
    const Result<Hashes> hashes = runScene(run);
    if (!hashes) return logError(run.scene + ": " + hashes.error()), 1;
    int step = 0;
    for (const uint64_t hash : hashes.value()) fmt::print("{} {:5} {:016x}\n", run.scene, step += run.every, hash);
    return 0;
}
