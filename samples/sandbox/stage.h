#pragma once
#include <functional>

#include "runtime/core/result.h"
#include "runtime/world/world.h"
#include "samples/sandbox/options.h"

namespace rubble {

/// The level that the options ask for, what shall happen to it, and from where it is seen. The town is written once as
/// .vdb by our own code and read back; a model is imported and put on the street; a scene is made in place.
struct SandboxStage {
    Level level;
    WorldSettings settings{
        .paint = {.mode = PaintMode::Layer}};  ///< soot and sprays keep their colours on full palettes
    std::function<Edits(int step)> script;
    std::function<Pose(double seconds)> camera;
    float verticalFov = 0.7f;  ///< radians
};
Result<SandboxStage> loadStage(const SandboxOptions& options);

}  // namespace rubble
