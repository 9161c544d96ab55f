// Levels that are read while the world plays on.
#include <utility>

#include "runtime/plugin/c_abi/calls.h"
#include "runtime/plugin/c_abi/functions.h"

namespace rubble::abi {
namespace {

/// Whether a level is being read; refuses the call if not.
bool isLoading(const HostedWorld& hosted) {
    if (!hosted.loading) refuse(RUBBLE_ERROR_ARGUMENT, "no level is being read: call start_loading() first");
    return hosted.loading != nullptr;
}

rubble_result startLoading(rubble_world world, const char* path, const char* vdbTool) {
    return inWorld("start_loading", world, [&](HostedWorld& hosted) {
        if (isGiven(path, "path")) hosted.loading = std::make_unique<LevelLoading>(path, vdbTool ? vdbTool : "");
    });
}

rubble_result getLoadingProgress(rubble_world world, double* out) {
    return inWorld("get_loading_progress", world, [&](const HostedWorld& hosted) {
        if (isGiven(out, "out") && isLoading(hosted)) *out = hosted.loading->progress();
    });
}

rubble_result finishLoading(rubble_world world) {
    return inWorld("finish_loading", world, [&](HostedWorld& hosted) {
        if (!isLoading(hosted)) return;
        const Result<Level> level = std::exchange(hosted.loading, nullptr)->take();
        if (!level) return refuse(RUBBLE_ERROR_FILE, "{}", level.error());
        change(hosted, [&] { hosted.loop.load(*level); });
        hosted.forgetSteps();
    });
}

}  // namespace

void setLoadingFunctions(rubble_api& api) {
    api.start_loading = startLoading;
    api.get_loading_progress = getLoadingProgress;
    api.finish_loading = finishLoading;
}

}  // namespace rubble::abi
