#pragma once
#include <functional>

#include "runtime/core/result.h"
#include "runtime/world/world.h"
#include "samples/sandbox/options.h"

namespace rubble {

/// A level, the script that breaks it, and the camera that watches.
struct SandboxStage {
    Level level;
    /// Paint is a layer of its own: soot and sprays keep their colours on full palettes.
    WorldSettings settings{.paint = {.mode = PaintMode::Layer}};
    std::function<Edits(int step)> script;       ///< edits of a step of 1/60 s, from 0
    std::function<Pose(double seconds)> camera;  ///< pose of the camera after so much game time
    float verticalFov = 0.7f;                    ///< radians
};

/// What the options ask for: a scripted scene, a model imported and put on the street, a level file, or the town, which
/// is built once, written as .vdb and read back. An error says which file or option is wrong.
Result<SandboxStage> loadStage(const SandboxOptions& options);

}  // namespace rubble
