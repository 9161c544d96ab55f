#include "samples/sandbox/stage.h"

#include <filesystem>
#include <string>

#include "runtime/assets/assets.h"
#include "runtime/core/log.h"
#include "samples/scenes/demolition.h"
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

}  // namespace

Result<SandboxStage> loadStage(const SandboxOptions& options) {
    const std::string vdbTool = options.tools + "/rubble-vdb";
    SandboxStage stage;
    if (!options.model.empty()) {
        ImportReport report;
        Result<Level> model = readLevel(options.model, vdbTool, &report);
        if (!model) return Error{model.error()};
        for (const std::string& line : report.lines) logInfo(line);
        stage.hasModel = true;
        stage.level = makeStreetStage(*model, options.seed, stage.modelLow, stage.modelHigh);
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
    stage.level = std::move(*level);
    return stage;
}

}  // namespace rubble
