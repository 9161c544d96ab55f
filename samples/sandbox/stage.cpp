#include "samples/sandbox/stage.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/gtc/constants.hpp>
#include <string>

#include "runtime/assets/assets.h"
#include "runtime/core/log.h"
#include "samples/scenes/demolition.h"
#include "samples/scenes/district.h"
#include "samples/scenes/environment.h"
#include "samples/scenes/placement.h"
#include "samples/scenes/scene.h"
#include "samples/scenes/town.h"
#include "samples/scenes/yard.h"

namespace rubble {
namespace {

namespace fs = std::filesystem;

/// Path of the town's file; writes the file if it is missing or older than this program.
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
    if (!scene) return Error{"--scene " + options.scene + ": no such scene; --list-scenes prints the names"};
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
    if (options.yard || options.district) {
        SandboxStage stage;
        stage.level = options.yard ? makeYard(options.seed) : makeDistrict(options.seed);
        if (!options.yard) addDistrictVehicles(stage.level);
        stage.script = [](int) { return Edits(); };
        const Pose camera = options.yard ? scenes::lookAt({30.0, 9.0, 50.0}, {25.0, 1.0, 26.0})
                                         : scenes::lookAt({150.0, 46.0, 150.0}, {70.0, 0.0, 62.0});
        stage.camera = [camera](double) { return camera; };
        stage.verticalFov = kDemolitionFov;
        return stage;
    }
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

/// Puts the camera straight above the level, high enough to see all of it; north (-z) is up.
void lookFromAbove(SandboxStage& stage, double aspect) {
    glm::dvec3 low(1e30), high(-1e30);
    for (const LevelBody& body : stage.level.bodies)
        for (const LevelShape& shape : body.shapes)
            for (int corner = 0; corner < 8; ++corner) {
                const glm::dvec3 cell =
                    glm::dvec3(shape.grid.size()) * glm::dvec3(corner & 1, corner >> 1 & 1, corner >> 2);
                const glm::dvec3 inBody =
                    shape.local.position + shape.local.rotation * (cell * double(shape.voxelSize));
                const glm::dvec3 point = body.pose.position + body.pose.rotation * inBody;
                low = glm::min(low, point);
                high = glm::max(high, point);
            }
    if (low.x > high.x) return;
    const double half = std::max(0.5 * (high.z - low.z), 0.5 * (high.x - low.x) / aspect);
    const glm::dvec3 above(0.5 * (low.x + high.x), high.y + 1.05 * half / std::tan(0.5 * double(stage.verticalFov)),
                           0.5 * (low.z + high.z));
    const Pose camera{above, glm::angleAxis(-0.5 * glm::pi<double>(), glm::dvec3(1, 0, 0))};
    stage.camera = [camera](double) { return camera; };
    stage.level.environment.fogDistance *= 10.0f;  // a map without haze
}

}  // namespace

Result<SandboxStage> loadStage(const SandboxOptions& options) {
    Result<SandboxStage> stage = anyStage(options);
    if (stage && !options.time.empty()) {
        const glm::vec3 gravity = stage->level.environment.gravity;
        stage->level.environment = scenes::timeOfDay(options.time);
        stage->level.environment.gravity = gravity;
    }
    if (stage && options.map) lookFromAbove(*stage, double(options.width) / options.height);
    return stage;
}

}  // namespace rubble
