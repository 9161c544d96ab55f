#include "runtime/assets/recording_file.h"
#include "runtime/assets/save_file.h"
#include "runtime/plugin/c_abi/calls.h"
#include "runtime/plugin/c_abi/functions.h"

namespace rubble::abi {
namespace {

void requireDone(const Result<Done>& done) {
    if (!done) throw ApiError{RUBBLE_ERROR_FILE, done.error()};
}

rubble_result saveGame(rubble_world world, const char* path) {
    return guarded("save_game",
                   [&] { requireDone(Registry::instance().world(world)->loop.save(&requireNotNull(path, "path"))); });
}

rubble_result loadGame(rubble_world world, const char* path) {
    return guarded("load_game", [&] {
        const auto hosted = Registry::instance().world(world);
        Result<SavedGame> game = readSave(&requireNotNull(path, "path"), hosted->loop.world().id());
        if (!game) throw ApiError{RUBBLE_ERROR_FILE, game.error()};
        hosted->loop.load(std::move(*game));
        hosted->events.clear();
    });
}

template <class Map>
bool isKnown(const Map& map, uint64_t bits) {
    return map.find({bits}) != nullptr;
}

/// Whether a handle names something in the World; those of worlds and renderers do not.
bool namesSomething(const World& world, uint64_t bits) {
    switch (Handle<HandleType::None>{bits}.type()) {
        case HandleType::Body:
            return isKnown(world.bodies(), bits);
        case HandleType::Shape:
            return isKnown(world.shapes(), bits);
        case HandleType::Light:
            return isKnown(world.lights(), bits);
        case HandleType::LightGroup:
            return isKnown(world.lightGroups(), bits);
        case HandleType::Water:
            return isKnown(world.waters(), bits);
        case HandleType::Trigger:
            return isKnown(world.triggers(), bits);
        case HandleType::Character:
            return isKnown(world.characters(), bits);
        case HandleType::Joint:
            return isKnown(world.joints(), bits);
        default:
            return false;
    }
}

rubble_result translateHandle(rubble_world world, uint64_t handle, uint64_t* out) {
    return guarded("translate_handle", [&] {
        requireNotNull(out, "out") = 0;
        const auto hosted = Registry::instance().world(world);
        const World& inside = hosted->loop.world();
        const uint64_t here = withWorld(handle, inside.id());
        if (!namesSomething(inside, here)) throw ApiError{RUBBLE_ERROR_STALE, "handle names nothing in this world"};
        *out = here;
    });
}

rubble_result startRecording(rubble_world world, const char* path) {
    return guarded("start_recording", [&] {
        requireDone(Registry::instance().world(world)->loop.startRecording(&requireNotNull(path, "path")));
    });
}

rubble_result stopRecording(rubble_world world) {
    return guarded("stop_recording", [&] { requireDone(Registry::instance().world(world)->loop.stopRecording()); });
}

rubble_result playRecording(rubble_world world, const char* path, uint64_t* steps) {
    return guarded("play_recording", [&] {
        if (steps) *steps = 0;
        const auto hosted = Registry::instance().world(world);
        FrameLoop& loop = hosted->loop;
        Result<Recording> recording = readRecording(&requireNotNull(path, "path"), loop.world().id());
        if (!recording) throw ApiError{RUBBLE_ERROR_FILE, recording.error()};
        loop.load(std::move(recording->start));
        hosted->events.clear();
        for (const RecordedStep& step : recording->steps) {
            loop.replay(step);
            hosted->events.fill(loop.changes());
            if (loop.world().hash() != step.hash)
                throw ApiError{RUBBLE_ERROR_FILE,
                               std::string(path) + ": step " + std::to_string(step.step) +
                                   ": expected the recorded state hash, found another: the recording "
                                   "was made by another build"};
            if (steps) ++*steps;
        }
    });
}

}  // namespace

void setSaveFunctions(rubble_api& api) {
    api.translate_handle = translateHandle;
    api.save_game = saveGame;
    api.load_game = loadGame;
    api.start_recording = startRecording;
    api.stop_recording = stopRecording;
    api.play_recording = playRecording;
}

}  // namespace rubble::abi
