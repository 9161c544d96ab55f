#pragma once
#include <cstdint>

#include "runtime/core/pose.h"
#include "runtime/world/edits/edit.h"

/// The scripted demolitions: what the tools do at each step of 1/60 s. Pure functions of their arguments.
namespace rubble {

inline constexpr float kDemolitionFov = 0.70f;  ///< vertical, radians: 40 degrees, 66 across at 16:9

/// Ten seconds in the town of makeTown(): paint, hammer, charges, torch, and what comes of them.
Edits demolition(int step, uint64_t seed);
/// Three-quarter view of the corner, drifting slightly.
Pose demolitionCamera(double seconds);

/// Ten seconds with any model that fills low..high (metres, on the stage of makeStreetStage()).
Edits demolishModel(int step, glm::dvec3 low, glm::dvec3 high, uint64_t seed);
/// A view that holds all of the model.
Pose modelCamera(glm::dvec3 low, glm::dvec3 high, double seconds);

}  // namespace rubble
