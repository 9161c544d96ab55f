#pragma once
#include "runtime/core/result.h"
#include "runtime/world/level.h"
#include "samples/sandbox/options.h"

namespace rubble {

/// The level that the options ask for, loaded from its file. The town is written once as .vdb by our own code and read
/// back; a model is imported and put on the street.
struct SandboxStage {
    Level level;
    bool hasModel = false;
    glm::dvec3 modelLow{0.0}, modelHigh{0.0};  ///< where it stands, metres
};
Result<SandboxStage> loadStage(const SandboxOptions& options);

}  // namespace rubble
