#pragma once
#include <gtest/gtest.h>

#include <filesystem>

#include "runtime/assets/recording_file.h"
#include "runtime/plugin/frame_loop.h"

namespace rubble::test {

/// Of a FrameLoop that keeps no shadow volume and publishes nothing.
inline FrameLoopSettings headlessSettings() {
    FrameLoopSettings settings;
    settings.shadowVolume = settings.publish = false;
    return settings;
}

/// Replays a recording in a loop. Each step must have the hash that was recorded.
inline void expectReplay(FrameLoop& loop, const std::filesystem::path& path) {
    Result<Recording> recording = readRecording(path.string(), loop.world().id());
    ASSERT_TRUE(recording) << recording.error();
    loop.load(recording->start);
    for (const RecordedStep& step : recording->steps) {
        loop.replay(step);
        ASSERT_EQ(loop.world().hash(), step.hash) << step.step;
    }
}

}  // namespace rubble::test
