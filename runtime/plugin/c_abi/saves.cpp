#include "runtime/assets/recording_file.h"
#include "runtime/assets/save_file.h"
#include "runtime/plugin/c_abi/calls.h"
#include "runtime/plugin/c_abi/functions.h"
#include "runtime/plugin/c_abi/objects.h"
#include "runtime/plugin/c_abi/recordings.h"
#include "runtime/plugin/c_abi/waiting.h"

namespace rubble::abi {
namespace {

void requireDone(const Result<Done>& done) {
    if (!done) refuse(RUBBLE_ERROR_FILE, "{}", done.error());
}

rubble_result saveGame(rubble_world world, const char* path) {
    return inWorld("save_game", world, [&](HostedWorld& hosted) {
        requireNoWaitingUndo(hosted);
        isGiven(path, "path");
        if (!isRefused()) requireDone(saveTo(path, hosted.loop));
    });
}

rubble_result loadGame(rubble_world world, const char* path) {
    return inWorld("load_game", world, [&](HostedWorld& hosted) {
        if (!isGiven(path, "path")) return;
        Result<SavedGame> game = readSave(path, hosted.loop.world().id());
        if (!game) return refuse(RUBBLE_ERROR_FILE, "{}", game.error());
        change(hosted, [&] { hosted.loop.load(std::move(*game)); });
        hosted.forgetSteps();
    });
}

rubble_result translateHandle(rubble_world world, uint64_t handle, uint64_t* out) {
    return inWorld("translate_handle", world, [&](const HostedWorld& hosted) {
        if (!isGiven(out, "out")) return;
        *out = 0;
        const World& inside = hosted.loop.world();
        const uint64_t here = withWorld(handle, inside.id());
        if (!findObject(inside, here, Found::Reserved))
            return refuse(RUBBLE_ERROR_STALE, "handle names nothing in this world");
        *out = here;
    });
}

rubble_result startRecording(rubble_world world, const char* path) {
    return inWorld("start_recording", world, [&](HostedWorld& hosted) {
        if (isGiven(path, "path")) requireDone(hosted.loop.startRecording(path));
    });
}

rubble_result stopRecording(rubble_world world) {
    return inWorld("stop_recording", world, [](HostedWorld& hosted) { requireDone(hosted.loop.stopRecording()); });
}

/// Whether the host's physics moved the bodies of the world that was recorded.
bool hasHostMotion(const Recording& recording) {
    return recording.after || (!recording.steps.empty() && recording.steps.front().hostMotion);
}

rubble_result playRecording(rubble_world world, const char* path, uint64_t* steps) {
    if (steps) *steps = 0;
    return inWorld("play_recording", world, [&](HostedWorld& hosted) {
        if (isGiven(path, "path")) play(hosted, readRecording(path, hosted.loop.world().id()), path, steps);
    });
}

}  // namespace

void play(HostedWorld& hosted, Result<Recording> recording, const std::string& name, uint64_t* steps) {
    FrameLoop& loop = hosted.loop;
    if (!recording) return refuse(RUBBLE_ERROR_FILE, "{}", recording.error());
    if ((!recording->steps.empty() || recording->after) && hasHostMotion(*recording) != !loop.physics())
        return refuse(RUBBLE_ERROR_ARGUMENT,
                      "{}: expected a recording of a world {} physics of its own, as this one, found one {}", name,
                      loop.physics() ? "with" : "without", loop.physics() ? "without" : "with");
    change(hosted, [&] { loop.load(std::move(recording->start)); });
    hosted.forgetSteps();
    for (const RecordedStep& step : recording->steps) {
        change(hosted, [&] {
            loop.replay(step);
            hosted.listStep();
        });
        if (loop.world().hash() != step.hash)
            return refuse(RUBBLE_ERROR_FILE,
                          "{}: step {}: expected the recorded state hash, found another: the recording was made by "
                          "another build",
                          name, step.step);
        if (steps) ++*steps;
    }
    if (const auto& after = recording->after) change(hosted, [&] { loop.followHost(after->poses, {}, after->damage); });
}

void setSaveFunctions(rubble_api& api) {
    api.translate_handle = translateHandle;
    api.save_game = saveGame;
    api.load_game = loadGame;
    api.start_recording = startRecording;
    api.stop_recording = stopRecording;
    api.play_recording = playRecording;
}

}  // namespace rubble::abi
