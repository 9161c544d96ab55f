#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "generated/paths.h"
#include "runtime/core/result.h"

namespace rubble {

/// How to run a scripted scene. All modes and numbers of threads must give the same hashes.
struct SceneRun {
    std::string scene = "tower";  ///< one of allScenes(), or "town"
    std::string mode = "play";    ///< or "load" (a save half-way) or "replay" (a recording)
    std::string shaders = RUBBLE_SOURCE_DIR "/shaders";
    int steps = 600, every = 60;  ///< steps; steps between hashes
    int threads = 2;              ///< of physics; 2: a shadow worker, too; more: further worlds with the same scene
    bool renderer = false;        ///< draws every step at 64x36
};

using Hashes = std::vector<uint64_t>;

/// Runs a scene and returns its state hash every `every` steps. An error if a recording or a world on another thread
/// gives other hashes than the run itself.
Result<Hashes> runScene(const SceneRun& run);
/// Whether there is a scripted scene of this name; "town" is one too.
bool sceneExists(const std::string& name);

}  // namespace rubble
