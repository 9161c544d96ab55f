#include "samples/sandbox/stage.h"

#include <filesystem>
#include <string>

#include "runtime/assets/assets.h"
#include "runtime/core/log.h"
#include "samples/scenes/demolition.h"
#include "samples/scenes/environment.h"
#include "samples/scenes/scene.h"
#include "samples/scenes/town.h"

namespace rubble {
namespace {

namespace fs = std::filesystem;

/// The town's file, written if it is missing or older than the program that authors it.
Result<std::string> townFile(const SandboxOptions& options, const std::string& vdbTool) {
    const fs::path folder = fs::path(options.tools).parent_path() / "levels";
    const fs::path path = folder / ("town-" + std::to_string(options.seed) + ".vdb");
    std::error_code error;
    const auto programTime = fs::last_write_time(fs::path(options.tools) / "sandbox", error);
    if (!error && fs::exists(path) && fs::last_write_time(path) > programTime) return path.string();
    fs::create_directories(folder, error);
    logInfo("building the town and writing it to " + path.string());
    Result<Done> written = writeVdb(path.string(), makeTown(options.seed), vdbTool);
    if (!written) return Error{written.error()};
    return path.string();
}

Result<SandboxStage> modelStage(const SandboxOptions& options, const std::string& vdbTool) {
    ImportReport report;
    Result<Level> model = readLevel(options.model, vdbTool, &report);
    if (!model) return Error{model.error()};
    for (const std::string& line : report.lines) logInfo(line);
    SandboxStage stage;
    glm::dvec3 low, high;
    stage.level = makeStreetStage(*model, options.seed, low, high);
    stage.script = [low, high, seed = options.seed](int step) { return demolishModel(step, low, high, seed); };
    stage.camera = [low, high](double seconds) { return modelCamera(low, high, seconds); };
    stage.verticalFov = kDemolitionFov;
    return stage;
}

Result<SandboxStage> sceneStage(const SandboxOptions& options) {
    const Scene* scene = findScene(options.scene);
    if (!scene) return Error{"--scene " + options.scene + ": no such scene; --list-scenes names them"};
    SandboxStage stage;
    stage.level = scene->level(options.seed);
    stage.settings = scene->settings;
    stage.script = [scene, seed = options.seed](int step) { return scene->script(step, seed); };
    stage.camera = scene->camera;
    stage.verticalFov = scene->verticalFov;
    return stage;
}

Result<SandboxStage> anyStage(const SandboxOptions& options) {
    const std::string vdbTool = options.tools + "/rubble-vdb";
    if (!options.scene.empty()) return sceneStage(options);
    if (!options.model.empty()) return modelStage(options, vdbTool);
    std::string path = options.level;
    if (path.empty()) {
        Result<std::string> town = townFile(options, vdbTool);
        if (!town) return Error{town.error()};
        path = *town;
    }
    Result<Level> level = readLevel(path, vdbTool);
    if (!level) return Error{level.error()};
    SandboxStage stage;
    stage.level = std::move(*level);
    stage.script = [seed = options.seed](int step) { return demolition(step, seed); };
    stage.camera = demolitionCamera;
    stage.verticalFov = kDemolitionFov;
    return stage;
}

}  // namespace

Result<SandboxStage> loadStage(const SandboxOptions& options) {
    Result<SandboxStage> stage = anyStage(options);
    if (!stage || options.time.empty()) return stage;
    const glm::vec3 gravity = stage->level.environment.gravity;
    stage->level.environment = scenes::timeOfDay(options.time);
    stage->level.environment.gravity = gravity;
    return stage;
}

}  // namespace rubble
