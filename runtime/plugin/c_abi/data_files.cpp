// Levels, saved games and recordings from and to memory.
#include <algorithm>
#include <cstring>
#include <span>

#include "runtime/assets/assets.h"
#include "runtime/assets/chunk_file.h"
#include "runtime/assets/recording_file.h"
#include "runtime/assets/save_file.h"
#include "runtime/plugin/c_abi/calls.h"
#include "runtime/plugin/c_abi/functions.h"
#include "runtime/plugin/c_abi/recordings.h"
#include "runtime/plugin/c_abi/waiting.h"

namespace rubble::abi {
namespace {

/// The host's bytes. None, and the call is refused, if `data` is null.
std::span<const uint8_t> readData(const void* data, uint64_t size) {
    if (!isGiven(data, "data")) return {};
    return {static_cast<const uint8_t*>(data), size_t(size)};
}

rubble_result loadLevelData(rubble_world world, const void* data, uint64_t size) {
    return inWorld("load_level_data", world, [&](HostedWorld& hosted) {
        const std::span<const uint8_t> bytes = readData(data, size);
        if (isRefused()) return;
        const Result<Level> level = levelFromBytes(bytes, "data");
        if (!level) return refuse(RUBBLE_ERROR_FILE, "{}", level.error());
        change(hosted, [&] { hosted.loop.load(*level); });
        hosted.forgetSteps();
    });
}

rubble_result saveGameData(rubble_world world, uint8_t* out, uint64_t capacity, uint64_t* count) {
    return inWorld("save_game_data", world, [&](HostedWorld& hosted) {
        if (!isGiven(count, "count")) return;
        *count = 0;
        if (capacity) isGiven(out, "out");
        requireNoWaitingUndo(hosted);
        if (isRefused()) return;
        const Result<Done> written = hosted.loop.save([&](std::span<const uint8_t> bytes) -> Result<Done> {
            if (bytes.size() > kMaxFileBytes)
                return Error{fmt::format("the game has {} bytes, expected {} at most", bytes.size(), kMaxFileBytes)};
            *count = bytes.size();
            if (capacity < bytes.size()) return Error{"the array is too short"};
            std::memcpy(out, bytes.data(), bytes.size());
            return Done{};
        });
        if (written) return;
        if (!*count) return refuse(RUBBLE_ERROR_FILE, "{}", written.error());
        if (capacity) refuse(RUBBLE_ERROR_CAPACITY, "the game has {} bytes, the array holds {}", *count, capacity);
    });
}

rubble_result loadGameData(rubble_world world, const void* data, uint64_t size) {
    return inWorld("load_game_data", world, [&](HostedWorld& hosted) {
        const std::span<const uint8_t> bytes = readData(data, size);
        if (isRefused()) return;
        Result<SavedGame> game = gameFromBytes(bytes, "data", hosted.loop.world().id());
        if (!game) return refuse(RUBBLE_ERROR_FILE, "{}", game.error());
        change(hosted, [&] { hosted.loop.load(std::move(*game)); });
        hosted.forgetSteps();
    });
}

rubble_result playRecordingData(rubble_world world, const void* data, uint64_t size, uint64_t* steps) {
    if (steps) *steps = 0;
    return inWorld("play_recording_data", world, [&](HostedWorld& hosted) {
        const std::span<const uint8_t> bytes = readData(data, size);
        if (isRefused()) return;
        play(hosted, recordingFromBytes(bytes, "data", hosted.loop.world().id()), "data", steps);
    });
}

}  // namespace

void setDataFileFunctions(rubble_api& api) {
    api.load_level_data = loadLevelData;
    api.save_game_data = saveGameData;
    api.load_game_data = loadGameData;
    api.play_recording_data = playRecordingData;
}

}  // namespace rubble::abi
