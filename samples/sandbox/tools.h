#pragma once
#include <array>

#include "runtime/world/world.h"

namespace rubble {

enum class HandTool { Hammer, Explosive, SprayCan };

/// Edits that a tool makes where its ray hits, for the next step; none if it hits nothing within the tool's range.
/// `directionWorld` need not be of length 1. `seed`: of the spray's noise, and its colour.
Edits useTool(HandTool tool, const World& world, glm::dvec3 originWorld, glm::dvec3 directionWorld, uint32_t seed);

}  // namespace rubble
