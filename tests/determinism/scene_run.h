#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "runtime/core/result.h"

namespace rubble {

/// A scripted scene, and one of the ways to go through it that must all give the same.
struct SceneRun {
    std::string scene = "tower";  ///< one of allScenes(), or "town"
    std::string mode = "play";    ///< or "load" (from a save half-mode) or "replay" (of a recording)
    std::string shaders = RUBBLE_SOURCE_DIR "/shaders";
    int steps = 600, every = 60;  ///< steps between two hashes
    int threads = 2;              ///< 1: no worker; 2: a shadow worker; more: other worlds beside it
    bool renderer = false;        ///< draws every step at 64x36
};

using Hashes = std::vector<uint64_t>;

/// The hash of the World every few steps. Every mode saves half-mode, for saving is an event. An error if a save or a
/// recording does not come to the same as the run that it was made of.
Result<Hashes> runScene(const SceneRun& run);
bool sceneExists(const std::string& name);

}  // namespace rubble
