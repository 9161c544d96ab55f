#pragma once
#include <cstdint>

#include "runtime/core/pose.h"
#include "runtime/world/edits/edit.h"

/// The scripted demolitions: the edits of each step of 1/60 s. All functions are pure.
namespace rubble {

inline constexpr float kDemolitionFov = 0.70f;  ///< vertical, radians: 40 degrees, 66 across at 16:9

/// Ten seconds in the town of makeTown(): paint, hammer, charges and cuts.
Edits demolition(int step, uint64_t seed);
/// Three-quarter view of the corner, which drifts slowly.
Pose demolitionCamera(double seconds);

/// Ten seconds with any model whose bounds are low..high, in metres, on the stage of makeStreetStage().
Edits demolishModel(int step, glm::dvec3 low, glm::dvec3 high, uint64_t seed);
/// A view that contains all of the model.
Pose modelCamera(glm::dvec3 low, glm::dvec3 high, double seconds);

}  // namespace rubble
